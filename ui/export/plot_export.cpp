// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/plot_export.h"

#include <array>

#include "ui/export/paper_plots.h"

namespace drillwave {
namespace {

// Known before anything is drawn.
QString obstacle(const Impact& impact) {
    if (impact.outcome != Outcome::rebounded)
        return QStringLiteral("no plots written: the blow could not be solved: %1")
            .arg(QString::fromStdString(impact.reason));
    if (impact.force.empty())
        return QStringLiteral("no plots written: the blow was solved without its histories");
    return {};
}

}  // namespace

Pictures drawBlowPlots(const Scenario& scenario, const Impact& impact,
                       const std::vector<std::string>& formats, const std::stop_token& stop) {
    Pictures pictures{.files = {}, .problem = obstacle(impact)};
    if (!pictures.problem.isEmpty()) return pictures;

    struct Drawn {
        const char* name;
        PaperPlot paper;
    };
    const std::array all{Drawn{"blow", blowPaperPlot(scenario, impact)},
                         Drawn{"rock", rockPaperPlot(scenario, impact)},
                         Drawn{"rod", rodPaperPlot(scenario, impact, stop)}};
    const QString title = QString::fromStdString(scenario.title);
    for (const Drawn& drawn : all) {
        Pictures more =
            renderPictures(*drawn.paper.plot, drawn.paper.size, title, {drawn.name, formats, stop});
        if (!more.problem.isEmpty()) return {{}, more.problem};
        for (NamedFile& file : more.files) pictures.files.push_back(std::move(file));
    }
    return pictures;
}

}  // namespace drillwave

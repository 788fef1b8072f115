// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/plot_export.h"

namespace drillwave {
namespace {

// Known before anything is drawn.
QString obstacle(const Impact& impact) {
    if (!impact.isSolved())
        return QStringLiteral("no plots written: the blow could not be solved: %1")
            .arg(QString::fromStdString(impact.reason.text()));
    if (!impact.hasHistories())
        return QStringLiteral("no plots written: the blow was solved without its histories");
    return {};
}

struct Drawn {
    const char* name;
    PaperPlot paper;
};

Pictures render(const std::vector<Drawn>& all, const Scenario& scenario,
                const std::vector<std::string>& formats, const std::stop_token& stop) {
    Pictures pictures;
    const QString title = QString::fromStdString(scenario.title);
    for (const Drawn& drawn : all) {
        Pictures more =
            renderPictures(*drawn.paper.plot, drawn.paper.size, title, {drawn.name, formats, stop});
        if (!more.problem.isEmpty()) return {{}, more.problem};
        for (NamedFile& file : more.files) pictures.files.push_back(std::move(file));
    }
    return pictures;
}

}  // namespace

Pictures drawBlowPlots(const Blow& blow, const std::vector<std::string>& formats, const std::stop_token& stop,
                       const PaperReader& reader) {
    if (const QString problem = obstacle(blow.impact); !problem.isEmpty()) return {{}, problem};
    return render({{"blow", blowPaperPlot(blow, reader)},
                   {"rock", rockPaperPlot(blow, reader)},
                   {"wave_picture", wavePaperPlot(blow, reader)},
                   {"rod", rodPaperPlot(blow, stop, reader)}},
                  blow.scenario, formats, stop);
}

}  // namespace drillwave

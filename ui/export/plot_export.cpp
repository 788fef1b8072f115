// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/plot_export.h"

#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/pages/rod/rod_plot.h"

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

    const Problem problem = problemOf(scenario);
    const ShownUnits shown = shownUnits(naturalUnits(scenario), scalesOf(scenario));
    const PlotStyle style = PlotStyle::forPaper();
    QCustomPlot blowPlot;
    blowPlot.setLocale(QLocale::c());
    BlowPlots blow(&blowPlot);
    blow.setStyle(style);
    blow.present(blowCurves(impact, problem.hammer, shown, 0.5, Tail::cut));
    QCustomPlot rockPlot;
    rockPlot.setLocale(QLocale::c());
    RockPlot rock(&rockPlot);
    rock.setStyle(style);
    rock.present(rockCurve(impact, problem, shown));
    QCustomPlot rodPlot;
    rodPlot.setLocale(QLocale::c());
    RodPlot rod(&rodPlot);
    rod.setStyle(style);
    rod.present(rodCurves(impact, problem.hammer, scenario, shown, stop));

    struct Drawn {
        const char* name;
        QCustomPlot* plot;
        Millimetres size;
    };
    const QString title = QString::fromStdString(scenario.title);
    for (const Drawn& drawn : {Drawn{"blow", &blowPlot, {180, 240}}, Drawn{"rock", &rockPlot, {120, 90}},
                               Drawn{"rod", &rodPlot, {180, 110}}}) {
        Pictures more = renderPictures(*drawn.plot, drawn.size, title, {drawn.name, formats, stop});
        if (!more.problem.isEmpty()) return {{}, more.problem};
        for (NamedFile& file : more.files) pictures.files.push_back(std::move(file));
    }
    return pictures;
}

}  // namespace drillwave

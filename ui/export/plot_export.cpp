// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/plot_export.h"

#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/plot/plot_rendering.h"

namespace drillwave {
namespace {

// Reasons known before anything is drawn.
QString obstacle(const Impact& impact, const QStringList& formats) {
    if (impact.outcome != Outcome::rebounded)
        return QStringLiteral("no plots written: the blow could not be solved: %1")
            .arg(QString::fromStdString(impact.reason));
    if (impact.force.empty())
        return QStringLiteral("no plots written: the blow was solved without its histories");
    for (const QString& format : formats)
        if (!plotFormats().contains(format))
            return QStringLiteral("plot format \"%1\" is not known; use %2")
                .arg(format, plotFormats().join(QStringLiteral(", ")));
    return {};
}

}  // namespace

BlowPictures drawBlowPlots(const Scenario& scenario, const Impact& impact, const QStringList& formats,
                           const std::stop_token& stop) {
    BlowPictures pictures{.files = {}, .problem = obstacle(impact, formats)};
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

    struct Figure {
        const char* name;
        QCustomPlot* plot;
        Millimetres size;
    };
    const QString title = QString::fromStdString(scenario.title);
    for (const Figure& figure :
         {Figure{"blow.", &blowPlot, {180, 240}}, Figure{"rock.", &rockPlot, {120, 90}}})
        for (const QString& format : formats) {
            if (stop.stop_requested()) return pictures;
            const QString name = QLatin1String(figure.name) + format;
            const QByteArray bytes = renderPlot(*figure.plot, figure.size, format, title);
            if (bytes.isEmpty())
                return {{}, QStringLiteral("%1: not written, the plot could not be drawn").arg(name)};
            pictures.files.push_back({name.toStdString(), bytes.toStdString()});
        }
    return pictures;
}

}  // namespace drillwave

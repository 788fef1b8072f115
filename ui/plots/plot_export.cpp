#include "ui/plots/plot_export.h"

#include <QDir>
#include <QFileInfo>

#include "ui/export/whole_file.h"
#include "ui/plots/blow_plots.h"
#include "ui/plots/plot_rendering.h"
#include "ui/plots/rock_plot.h"

namespace drillwave {
namespace {

// Empty when written, otherwise the reason.
QString write(const QString& path, const QByteArray& bytes) {
    if (bytes.isEmpty()) return QStringLiteral("%1: not written, the plot could not be drawn").arg(path);
    return writeWholeFile(path, bytes);
}

// Reasons known before anything is drawn.
QString obstacle(const Impact& impact, const QDir& directory, const QStringList& formats, bool overwrite) {
    if (impact.outcome != Outcome::rebounded)
        return QStringLiteral("no plots written: the blow could not be solved: %1")
            .arg(QString::fromStdString(impact.reason));
    if (impact.force.empty())
        return QStringLiteral("no plots written: the blow was solved without its histories");
    for (const QString& format : formats)
        if (!plotFormats().contains(format))
            return QStringLiteral("plot format \"%1\" is not known; use %2")
                .arg(format, plotFormats().join(QStringLiteral(", ")));
    if (!directory.mkpath(QStringLiteral(".")))
        return QStringLiteral("%1: the folder cannot be made; choose another one").arg(directory.path());
    if (overwrite) return {};
    for (const QString& format : formats)
        for (const char* name : {"blow.", "rock."}) {
            const QString path = directory.filePath(QLatin1String(name) + format);
            if (QFileInfo::exists(path))
                return QStringLiteral(
                           "%1: exists already; choose another folder or ask for it to be overwritten")
                    .arg(path);
        }
    return {};
}

}  // namespace

QStringList plotFormats() {
    return {QStringLiteral("png"), QStringLiteral("svg"), QStringLiteral("pdf")};
}

QStringList writeBlowPlots(const Scenario& scenario, const Impact& impact, const QString& directory,
                           const QStringList& formats, bool overwrite, QString* problem) {
    return writeBlowPlots(scenario, impact, naturalUnits(scenario), directory, formats, overwrite, problem);
}

QStringList writeBlowPlots(const Scenario& scenario, const Impact& impact, UnitSystem units,
                           const QString& directory, const QStringList& formats, bool overwrite,
                           QString* problem) {
    const QDir folder(directory);
    *problem = obstacle(impact, folder, formats, overwrite);
    if (!problem->isEmpty()) return {};

    const ShownUnits shown = shownUnits(units, scalesOf(scenario));
    const PlotStyle style = PlotStyle::forPaper();
    QCustomPlot blowPlot;
    blowPlot.setLocale(QLocale::c());
    BlowPlots blow(&blowPlot);
    blow.setStyle(style);
    blow.show(blowCurves(impact, pulseForceOf(scenario), shown, 0.5, Tail::cut));
    QCustomPlot rockPlot;
    rockPlot.setLocale(QLocale::c());
    RockPlot rock(&rockPlot);
    rock.setStyle(style);
    rock.show(rockCurve(impact, groupsOf(scenario), shown));

    struct Figure {
        const char* name;
        QCustomPlot* plot;
        Millimetres size;
    };
    const QString title = QString::fromStdString(scenario.title);
    QStringList written;
    for (const Figure& figure :
         {Figure{"blow.", &blowPlot, {180, 240}}, Figure{"rock.", &rockPlot, {120, 90}}})
        for (const QString& format : formats) {
            const QString path = folder.filePath(QLatin1String(figure.name) + format);
            *problem = write(path, renderPlot(*figure.plot, figure.size, format, title));
            if (!problem->isEmpty()) return written;
            written.append(path);
        }
    return written;
}

}  // namespace drillwave

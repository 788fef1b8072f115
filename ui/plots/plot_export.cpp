#include "ui/plots/plot_export.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <cmath>

#include "ui/plots/blow_plots.h"
#include "ui/plots/rock_plot.h"

namespace drillwave {
namespace {

constexpr double layoutDpi = 96;  // the plots are laid out in these pixels in every format
constexpr double pngDpi = 200;
constexpr double millimetresPerInch = 25.4;

struct Millimetres {
    double width;
    double height;
    QSize pixels() const {
        return {static_cast<int>(std::lround(width / millimetresPerInch * layoutDpi)),
                static_cast<int>(std::lround(height / millimetresPerInch * layoutDpi))};
    }
};

void paint(QCustomPlot& plot, QCPPainter& painter, QSize size) {
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot.toPainter(&painter, size.width(), size.height());
}

QByteArray png(QCustomPlot& plot, Millimetres size) {
    const double scale = pngDpi / layoutDpi;
    const QSize pixels = size.pixels();
    QImage image = plot.toPixmap(pixels.width(), pixels.height(), scale).toImage();
    image.setDevicePixelRatio(1);
    image.setDotsPerMeterX(static_cast<int>(std::lround(pngDpi * 1000 / millimetresPerInch)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QBuffer buffer;
    QImageWriter(&buffer, "png").write(image);
    return buffer.data();
}

QByteArray svg(QCustomPlot& plot, Millimetres size, const QString& title) {
    QBuffer buffer;
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setTitle(title);
    generator.setDescription(QStringLiteral("Drillwave"));
    generator.setResolution(static_cast<int>(layoutDpi));
    generator.setSize(size.pixels());
    generator.setViewBox(QRect(QPoint(0, 0), size.pixels()));
    QCPPainter painter;
    painter.begin(&generator);
    paint(plot, painter, size.pixels());
    painter.end();
    // Readers that do not have the font shall take another one without serifs.
    const QByteArray family = PlotStyle::forPaper().font.family().toUtf8();
    QByteArray bytes = buffer.data();
    return bytes.replace("font-family=\"" + family + "\"", "font-family=\"" + family + ", sans-serif\"");
}

QByteArray pdf(QCustomPlot& plot, Millimetres size, const QString& title) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Drillwave"));
    writer.setResolution(static_cast<int>(layoutDpi));
    writer.setPageSize(QPageSize(QSizeF(size.width, size.height), QPageSize::Millimeter));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    QCPPainter painter;
    painter.begin(&writer);
    paint(plot, painter, size.pixels());
    painter.end();
    return buffer.data();
}

QByteArray rendered(QCustomPlot& plot, Millimetres size, const QString& format, const QString& title) {
    if (format == QLatin1String("png")) return png(plot, size);
    return format == QLatin1String("svg") ? svg(plot, size, title) : pdf(plot, size, title);
}

// Empty when written, otherwise the reason.
QString write(const QString& path, const QByteArray& bytes) {
    if (bytes.isEmpty()) return QStringLiteral("%1: not written, the plot could not be drawn").arg(path);
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) return {};
    return QStringLiteral("%1: cannot be written: %2; choose another folder or free some space")
        .arg(path, file.errorString());
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
            *problem = write(path, rendered(*figure.plot, figure.size, format, title));
            if (!problem->isEmpty()) return written;
            written.append(path);
        }
    return written;
}

}  // namespace drillwave

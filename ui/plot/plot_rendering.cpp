// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_rendering.h"

#include <qcustomplot.h>

#include <QBuffer>
#include <QDateTime>
#include <QImage>
#include <QImageWriter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <cmath>

#include "core/archive/result_files.h"
#include "core/report/html_text.h"
#include "core/text/name_text.h"
#include "ui/plot/curve_clip.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/svg_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double millimetresPerInch = 25.4;

QSize pixelsOf(Millimetres size) {
    return {static_cast<int>(std::lround(size.width / millimetresPerInch * layoutDpi)),
            static_cast<int>(std::lround(size.height / millimetresPerInch * layoutDpi))};
}

QByteArray png(QCustomPlot& plot, Millimetres size, double dpi, const QString& creator) {
    const double scale = dpi / layoutDpi;
    const QSize pixels = pixelsOf(size);
    QImage image = plot.toPixmap(pixels.width(), pixels.height(), scale).toImage();
    image.setDevicePixelRatio(1);
    image.setDotsPerMeterX(static_cast<int>(std::lround(dpi * 1000 / millimetresPerInch)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QBuffer buffer;
    QImageWriter writer(&buffer, "png");
    writer.setText(QStringLiteral("Software"), creator);
    writer.write(image);
    return buffer.data();
}

// Returns an element with the visible words of the text. Qt 6.4 writes titles and descriptions unescaped.
QByteArray svgElement(const QByteArray& name, const QString& text) {
    return QByteArray::fromStdString(htmlElement(name.toStdString(), text.toStdString()));
}

QByteArray svg(QCustomPlot& plot, Millimetres size, const QString& title, const QString& creator) {
    const CurveClip clip(plot);
    QBuffer buffer;
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    const QString placeholder = QStringLiteral("text");
    generator.setTitle(placeholder);
    generator.setDescription(placeholder);
    generator.setResolution(static_cast<int>(layoutDpi));
    generator.setSize(pixelsOf(size));
    generator.setViewBox(QRect(QPoint(0, 0), pixelsOf(size)));
    QCPPainter painter;
    painter.begin(&generator);
    paintPlot(plot, painter, size);
    painter.end();
    QByteArray bytes = withCommonText(buffer.data(), PlotStyle::forPaper().font.family());
    bytes.replace(svgElement("title", placeholder), svgElement("title", title));
    bytes.replace(svgElement("desc", placeholder), svgElement("desc", creator));
    return bytes;
}

// Writes the time of SOURCE_DATE_EPOCH [s since 1970] instead of the present one, for documents that must
// have the same bytes tomorrow (reproducible-builds.org). Keeps the length, as the file counts its bytes.
void fixCreationDate(QByteArray& pdf) {
    bool isNumber = false;
    const qint64 seconds = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&isNumber);
    const QByteArray key = QByteArrayLiteral("/CreationDate (D:");
    const qsizetype begin = pdf.indexOf(key) + key.size();
    const qsizetype length = pdf.indexOf(')', begin) + 1 - begin;
    const QDateTime time = QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC);
    const QByteArray date = time.toString(QStringLiteral("yyyyMMddHHmmss")).toLatin1() + "Z)";
    if (!isNumber || !time.isValid() || begin < key.size() || date.size() > length) return;
    pdf.replace(begin, length, date.leftJustified(length, ' '));
}

QByteArray pdf(QCustomPlot& plot, Millimetres size, const QString& title, const QString& creator) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(printableLine(title.toStdString())));
    writer.setCreator(creator);
    writer.setResolution(static_cast<int>(layoutDpi));
    writer.setPageSize(QPageSize(QSizeF(size.width, size.height), QPageSize::Millimeter));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    QCPPainter painter;
    painter.begin(&writer);
    paintPlot(plot, painter, size);
    painter.end();
    QByteArray bytes = buffer.data();
    fixCreationDate(bytes);
    return bytes;
}

}  // namespace

QStringList plotFormats() {
    QStringList formats;
    for (const std::string_view format : pictureFormats) formats << fromView(format);
    return formats;
}

void paintPlot(QCustomPlot& plot, QCPPainter& painter, Millimetres size) {
    const QSize pixels = pixelsOf(size);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot.toPainter(&painter, pixels.width(), pixels.height());
}

QByteArray renderPlot(QCustomPlot& plot, Millimetres size, const QString& format, const QString& title,
                      double dpi, const QString& creator) {
    // Legends and captions break for the width of the file, as they do for that of a window before a replot.
    const QRect shown = plot.viewport();
    plot.setViewport(QRect(QPoint(), pixelsOf(size)));
    emit plot.beforeReplot();
    plot.setViewport(shown);
    if (format == QLatin1String("png")) return png(plot, size, dpi, creator);
    return format == QLatin1String("svg") ? svg(plot, size, title, creator) : pdf(plot, size, title, creator);
}

}  // namespace drillwave

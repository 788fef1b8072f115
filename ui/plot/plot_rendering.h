// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as the bytes of a file.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

class QCPPainter;
class QCustomPlot;

namespace drillwave {

/// Returns the names of the supported file formats, as in pictureFormats: "png", "svg" and so on.
QStringList plotFormats();

/// Size on paper [mm].
struct Millimetres {
    double width;
    double height;
};

/// Default resolution of PNG files [dots per inch].
inline constexpr double standardDpi = 200;

/// Returns the plot as bytes of a file; empty if it could not be drawn. `format` is one of plotFormats(),
/// `dpi` the resolution of PNG. Curves are clipped at their axes in every format; `title` and `creator` go
/// into the file's properties. On one machine the same plot gives the same bytes as PNG and SVG, and as PDF
/// if the environment variable SOURCE_DATE_EPOCH is set.
QByteArray renderPlot(QCustomPlot& plot, Millimetres size, const QString& format, const QString& title,
                      double dpi = standardDpi, const QString& creator = QStringLiteral("Drillwave"));

/// Draws the plot at the origin of a painter with layoutDpi units per inch.
void paintPlot(QCustomPlot& plot, QCPPainter& painter, Millimetres size);

/// Layout units per inch, in which the plot is laid out for paper.
inline constexpr double layoutDpi = 96;

}  // namespace drillwave

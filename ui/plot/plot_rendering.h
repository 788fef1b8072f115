// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as the bytes of a file.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

class QCPPainter;
class QCustomPlot;

namespace drillwave {

/// Returns the names of the file formats in which plots can be saved, as in pictureFormats: "png", "svg" and
/// so on.
QStringList plotFormats();

/// Size of a plot on paper [mm].
struct Millimetres {
    double width;
    double height;
};

/// Default resolution of PNG files [dots per inch].
inline constexpr double standardDpi = 200;

/// Returns the plot as bytes of a file; empty if it could not be drawn. `format` is one of plotFormats(),
/// `dpi` the resolution of PNG. Curves are clipped at their axes in every format. `creator` (and in SVG and
/// PDF also `title`) goes into the properties of the file. On one machine the same plot gives the same bytes
/// as PNG and SVG. PDF does so only if the environment variable SOURCE_DATE_EPOCH is set.
QByteArray renderPlot(QCustomPlot& plot, Millimetres size, const QString& format, const QString& title,
                      double dpi = standardDpi, const QString& creator = QStringLiteral("Drillwave"));

/// Draws the plot with this size on paper. Its top left corner is at the origin of `painter`, which must have
/// layoutDpi units per inch.
void paintPlot(QCustomPlot& plot, QCPPainter& painter, Millimetres size);

/// Number of layout units per inch of paper. A plot for a file is laid out as on a screen with this
/// resolution, so that lines and fonts have the usual size.
inline constexpr double layoutDpi = 96;

}  // namespace drillwave

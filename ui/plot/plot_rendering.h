// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as the bytes of a file.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

class QCPPainter;
class QCustomPlot;

namespace drillwave {

/// Returns the supported file formats: the pictureFormats.
QStringList plotFormats();

/// Size on paper.
struct Millimetres {
    double width;
    double height;
};

/// Default resolution of PNG.
inline constexpr double standardDpi = 200;

/// The plot in a format of plotFormats(); `dpi` is that of PNG. PNG and SVG are the same bytes for the same
/// plot on one machine, PDF with the environment's SOURCE_DATE_EPOCH too; curves that leave their axes are
/// cut there in every format. `title` and `creator` go into the file's properties. Empty when it could not be
/// drawn.
QByteArray renderPlot(QCustomPlot& plot, Millimetres size, const QString& format, const QString& title,
                      double dpi = standardDpi, const QString& creator = QStringLiteral("Drillwave"));

/// Draws the plot at the origin of a painter whose unit is that of the layout.
void paintPlot(QCustomPlot& plot, QCPPainter& painter, Millimetres size);

/// Units of the layout in an inch.
inline constexpr double layoutDpi = 96;

}  // namespace drillwave

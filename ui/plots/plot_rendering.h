// A plot as the bytes of a file.
#pragma once

#include <QByteArray>
#include <QString>

class QCustomPlot;

namespace drillwave {

/// Size on paper.
struct Millimetres {
    double width;
    double height;
};

/// The plot in a format of plotFormats(), PNG at 200 dpi. PNG and SVG are the same bytes for the same plot on
/// one machine. `title` goes into the file's properties. Empty when it could not be drawn.
QByteArray renderPlot(QCustomPlot& plot, Millimetres size, const QString& format, const QString& title);

}  // namespace drillwave

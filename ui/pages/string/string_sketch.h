// SPDX-License-Identifier: GPL-3.0-or-later
// Hammer and string to scale, for paper.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <vector>

#include "core/model/scenario.h"
#include "ui/plot/plot_style.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// A drill string to draw, with the units of the axes for values in SI.
struct SketchedString {
    DrillString drillString;
    ShownUnit length;  ///< along the string
    ShownUnit across;  ///< of diameters
};

/// Draws the sections of a hammer and a string along their common axis: lengths and diameters each to a scale
/// of its own, the bore dashed, the hammer darker and below 0, its face a thick line, the rock at the right.
/// Sections carry their place and, where there is room, their name. Lives as a child of the plot.
class StringSketch : public QObject {
    Q_OBJECT

  public:
    explicit StringSketch(QCustomPlot* plot);

    void present(const SketchedString& shown);
    void setStyle(const PlotStyle& style);

  private:
    struct Piece {
        double rear = 0, front = 0;     ///< from the face of the hammer, as shown
        double diameter = 0, bore = 0;  ///< as shown, the diameter where it is largest
        double rearDiameter = 0, frontDiameter = 0;
        int place = 1;  ///< in the hammer or the string
        QString name;
        bool isHammer = false;
    };
    static std::vector<Piece> piecesOf(const SketchedString& shown);
    void addBar(double left, double right, double half, const QBrush& brush, const QPen& pen);
    void addCone(const Piece& piece, const QColor& shade);
    void addLine(QPointF from, QPointF to, const QPen& pen);
    void addText(QPointF at, const QString& text);
    void addPiece(const Piece& piece);
    void addWords(const std::vector<Piece>& pieces);
    void setScale(double rear, double front, double largest);

    QCustomPlot* m_plot;
    PlotStyle m_style;
};

}  // namespace drillwave

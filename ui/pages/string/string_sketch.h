// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of hammer and string to scale, for paper.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <vector>

#include "core/model/scenario.h"
#include "ui/plot/plot_style.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Drill string to draw, with the units of its axes: shown value = SI value · factor.
struct SketchedString {
    DrillString drillString;
    ShownUnit length;  ///< unit of lengths along the string
    ShownUnit across;  ///< unit of diameters
};

/// Drawing of the sections of hammer and string along their axis, with different scales for lengths and
/// diameters. The bore is dashed; the hammer is darker and at negative positions, its face a thick line; the
/// rock is at the right. Sections have their number and, where there is space, their name. The plot owns the
/// object.
class StringSketch : public QObject {
    Q_OBJECT

  public:
    explicit StringSketch(QCustomPlot* plot);

    void present(const SketchedString& shown);
    void setStyle(const PlotStyle& style);

  private:
    struct Piece {
        /// Ends of the section, measured from the hammer's face, in the unit shown.
        double rear = 0, front = 0;
        double diameter = 0, bore = 0;  ///< in the unit shown; `diameter` is the largest one
        double rearDiameter = 0, frontDiameter = 0;
        int place = 1;  ///< number of the section in hammer or string (from 1)
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

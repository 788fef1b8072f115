// SPDX-License-Identifier: GPL-3.0-or-later
// Field of a figure: values over two axes as colours, with their scale, and paths that are seen on them.
#pragma once

#include <qcustomplot.h>

#include <QImage>

#include "core/report/figure.h"
#include "ui/plot/colour_scale.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Mapping of the values of a colour map to colours. Colours run from the smallest to the largest value, or
/// differ below and above a given level.
struct FieldColours {
    double least = 0;
    double largest = 1;           ///< largest value; greater than `least`
    std::optional<double> level;  ///< level with almost no colour, in the units of the field

    /// Maps a value of the colour map to −1 … 1, the argument of ColourScale::colour(); NaN stays NaN.
    double share(double value) const;
    const ColourScale& scale() const;
};

/// Colour map of a panel: each grid point colours the rectangle around it. The colour bar is to the right of
/// the axes. A point that is not computed yet has the colour of a coarser grid; a point without a value is
/// hatched. The time for drawing depends on the pixels in view, not on the number of points.
class FieldItem : public QCPAbstractItem {
    Q_OBJECT

  public:
    /// Creates an item without a colour map and without a colour bar; present() adds both. `rect` must be in
    /// a QCPLayoutGrid, which gets a column for the bar.
    explicit FieldItem(QCPAxisRect* rect);

    /// Shows the colour map (field) of a panel, or nothing if the panel has none. A coordinate of the map
    /// times `xFactor` or `yFactor` is a value on the axis. A value of the map times `factor` is a number on
    /// the colour bar, whose title is `label`.
    void present(const StudyPanel& panel, double xFactor, double yFactor, double factor,
                 const QString& label);
    const std::optional<FigureField>& field() const { return m_field; }
    const FieldColours& colours() const { return m_colours; }
    /// Returns the grid point of the colour map that is nearest to `place` (coordinates of the axes). Nothing
    /// if `place` is more than half a grid step outside the map.
    std::optional<MapGrid::Place> pointAt(QPointF place) const;
    /// Returns the place of a grid point of the colour map, in coordinates of the axes.
    QPointF placeOf(MapGrid::Place point) const;
    void setStyle(const PlotStyle& style);
    double selectTest(const QPointF&, bool, QVariant* = nullptr) const override { return -1; }

  protected:
    void draw(QCPPainter* painter) override;

  private:
    void showBar(bool isShown);
    std::optional<std::size_t> nearest(QCPAxis::AxisType side, double coordinate) const;
    std::vector<int> pointsAt(QCPAxis::AxisType side, int pixels) const;
    QImage imageOf(QSize size, double ratio) const;

    QCPAxisRect* m_rect;
    QCPColorScale* m_bar;
    std::optional<FigureField> m_field;
    FieldColours m_colours;
    double m_xFactor = 1, m_yFactor = 1;
    QRgb m_background = 0, m_hatch = 0;
};

/// Curve that is visible on any background colour, because a wider line of the pen set by setHalo() is drawn
/// below it.
class HaloPath : public QCPCurve {
    Q_OBJECT

  public:
    using QCPCurve::QCPCurve;
    void setHalo(const QPen& pen) { m_halo = pen; }

  protected:
    void drawCurveLine(QCPPainter* painter, const QVector<QPointF>& lines) const override;

  private:
    QPen m_halo = Qt::NoPen;
};

}  // namespace drillwave

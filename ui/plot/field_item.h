// SPDX-License-Identifier: GPL-3.0-or-later
// Field of a figure: values over two axes as colours, with their scale, and paths that are seen on them.
#pragma once

#include <qcustomplot.h>

#include <QImage>

#include "core/report/figure.h"
#include "ui/plot/colour_scale.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Mapping of values to colours: from the smallest to the largest value, or with different colours below and
/// above a level.
struct FieldColours {
    double least = 0;
    double largest = 1;           ///< largest value; greater than `least`
    std::optional<double> level;  ///< level with almost no colour, in the units of the field

    /// Maps a value to −1 … 1 for ColourScale::colour(); NaN stays NaN.
    double share(double value) const;
    const ColourScale& scale() const;
};

/// Rectangles of one colour around the points of a field, cut off at the ends of the axes, and a bar with the
/// colours at the right of the axis rect. A point that is not computed yet has the colour of a coarser one;
/// one without a value is hatched. Drawing takes time for the pixels in view, however many points there are.
class FieldItem : public QCPAbstractItem {
    Q_OBJECT

  public:
    /// Creates an empty field without a bar. `rect` must be in a QCPLayoutGrid.
    explicit FieldItem(QCPAxisRect* rect);

    /// Shows the field of a panel, or nothing if it has none. A value of x or y times its factor is a value
    /// of the axis; a value of the field times its factor is a number at the bar, whose title is `label`.
    void present(const StudyPanel& panel, double xFactor, double yFactor, double factor,
                 const QString& label);
    const std::optional<FigureField>& field() const { return m_field; }
    const FieldColours& colours() const { return m_colours; }
    /// Returns the point of the field that is nearest to a place (coordinates of the axes); nothing more than
    /// half a step outside.
    std::optional<MapGrid::Place> pointAt(QPointF place) const;
    /// Returns the place of a point of the field, in coordinates of the axes.
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

/// Path that can be seen on any colour: with a halo, it is drawn over a wider line.
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

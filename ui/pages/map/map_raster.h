// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of a map.
#pragma once

#include <qcustomplot.h>

#include <QImage>

#include "ui/pages/map/map_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Places of pixels and values along an axis.
class AxisPlaces {
  public:
    AxisPlaces() = default;
    explicit AxisPlaces(const SweepAxis& axis) : m_axis(axis) {}

    /// Returns the index of the value nearest to a place (SI), by ratio on a logarithmic axis; nullopt more
    /// than half a step beyond the ends.
    std::optional<std::size_t> nearest(double si) const;

  private:
    SweepAxis m_axis;
};

/// A map as rectangles of one colour around its points, cut off at the ends of its axes. A point that is not
/// computed yet has the colour of a coarser one; one without a value is hatched. The work is that of the
/// pixels in view, however many points there are.
class MapRaster : public QCPAbstractItem {
    Q_OBJECT

  public:
    MapRaster(QCustomPlot* plot, QCPAxisRect* rect);

    /// nullptr for nothing.
    void present(const MapPicture* picture);
    void setStyle(const PlotStyle& style);
    double selectTest(const QPointF&, bool, QVariant* = nullptr) const override { return -1; }

  protected:
    void draw(QCPPainter* painter) override;

  private:
    QImage imageOf(QSize size, double ratio) const;
    std::vector<int> placesOf(const QCPAxis& axis, const AxisPlaces& places, double factor, int pixels) const;

    QCPAxisRect* m_rect;
    std::optional<MapPicture> m_picture;
    AxisPlaces m_xPlaces, m_yPlaces;
    ColourScale m_colours = ColourScale::ramp();
    QRgb m_background = 0, m_hatch = 0;
};

}  // namespace drillwave

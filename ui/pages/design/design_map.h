// SPDX-License-Identifier: GPL-3.0-or-later
// Map of the first objective over two design variables: colours instead of many curves.
#pragma once

#include <optional>

#include "ui/pages/design/design_picture.h"
#include "ui/pages/map/map_raster.h"

namespace drillwave {

/// Least number of values of the first design variable for a map. With fewer values, curves with a band show
/// more.
inline constexpr std::uint64_t leastRowsOfMap = 4;

/// Returns whether a map can show the study: it has exactly two design variables, both numeric ranges with
/// enough values.
bool hasMap(const DesignStudy& study);

/// Returns the map of a study for which hasMap() is true, in the units shown. The last design variable is on
/// the horizontal axis, the first on the vertical one. Colours show the statistic of the first objective;
/// `value` is its output with its unit.
MapPicture designMap(const DesignReport& report, const DesignUnits& units, const AimedOutput& value);

/// Returns the place of a design (index from 0) in the coordinates of the axes.
QPointF placeOnMap(const MapPicture& map, std::uint64_t design);

/// Coloured map of designs with its colour bar. While a map is shown, the bar has its own column in the
/// layout of the plot. The plot must outlive the object.
class DesignMap {
  public:
    DesignMap(QCustomPlot* plot, QCPAxisRect* rect);

    /// Shows a map; nullptr removes it. The picture must stay valid until the next call.
    void present(const MapPicture* picture);
    bool isShown() const { return m_picture != nullptr; }
    /// Sets the label of the colour bar: `name` of the statistic with its unit.
    void setLabel(const QString& name) { m_bar->setLabel(name); }
    void setStyle(const PlotStyle& style);
    /// Sets the axis ranges to the whole map, including the half cells at its edges. Requires a map.
    void setRanges() const;
    /// Returns the index of the design whose cell contains a place (coordinates of the axes); nothing outside
    /// the map. Requires a map.
    std::optional<std::uint64_t> designAt(QPointF place) const;

  private:
    QCustomPlot* m_plot;
    QCPAxisRect* m_rect;
    MapRaster* m_raster;
    QCPColorScale* m_bar;
    QCPMarginGroup* m_ends;  // aligns map and bar at top and bottom
    const MapPicture* m_picture = nullptr;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Map of the first objective over two design variables: colours instead of many curves.
#pragma once

#include <optional>

#include "ui/pages/design/design_picture.h"
#include "ui/pages/map/map_raster.h"

namespace drillwave {

/// Least number of values of the first variable for a map; curves with a band show more of fewer.
inline constexpr std::uint64_t leastRowsOfMap = 4;

/// Whether what is chosen are two numbers along ranges, which a map can have as its axes.
bool hasMap(const DesignStudy& study);

/// Returns the map of a study that hasMap(), in shown units: the last variable across, the first one upward,
/// and the statistic of the first objective, which is `value`, in colours.
MapPicture designMap(const DesignReport& report, const DesignUnits& units, const AimedOutput& value);

/// Returns the place of a design on the map.
QPointF placeOnMap(const MapPicture& map, std::uint64_t design);

/// The colours and the bar that explains them, which has a column of the plot's layout of its own while there
/// is a map. Lives as long as the plot.
class DesignMap {
  public:
    DesignMap(QCustomPlot* plot, QCPAxisRect* rect);

    /// nullptr for no map. The picture must outlive the next call.
    void present(const MapPicture* picture);
    bool isShown() const { return m_picture != nullptr; }
    /// Sets the label of the bar: `name` of the statistic, with the unit.
    void setLabel(const QString& name) { m_bar->setLabel(name); }
    void setStyle(const PlotStyle& style);
    /// The whole map, with the cells at its edges.
    void setRanges() const;
    /// The design whose cell is there; nothing outside.
    std::optional<std::uint64_t> designAt(QPointF place) const;

  private:
    QCustomPlot* m_plot;
    QCPAxisRect* m_rect;
    MapRaster* m_raster;
    QCPColorScale* m_bar;
    QCPMarginGroup* m_ends;  // of both
    const MapPicture* m_picture = nullptr;
};

}  // namespace drillwave

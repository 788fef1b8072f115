// SPDX-License-Identifier: GPL-3.0-or-later
// The contours of a map with their levels at the lines.
#pragma once

#include <qcustomplot.h>

#include <QVector>
#include <optional>

#include "ui/pages/map/map_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Lines that are seen on any colour, the first level solid and the next ones dashed. The rect must outlive
/// it.
class MapContours {
  public:
    explicit MapContours(QCPAxisRect* map) : m_map(map) {}

    /// Replaces the contours by those of a map; none without a map.
    void present(const std::optional<MapPicture>& picture, const PlotStyle& style);

  private:
    void add(const Contour& contour, int number, const MapPicture& picture, const PlotStyle& style);

    QCPAxisRect* m_map;
    QVector<QCPCurve*> m_lines;  // each with its halo before it
    QVector<QCPItemText*> m_levels;
};

}  // namespace drillwave

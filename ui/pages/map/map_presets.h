// SPDX-License-Identifier: GPL-3.0-or-later
// The presets that lie in a map, with their names.
#pragma once

#include <qcustomplot.h>

#include <QVector>
#include <optional>

#include "ui/pages/map/map_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// The rect must outlive it.
class MapPresets {
  public:
    explicit MapPresets(QCPAxisRect* map) : m_map(map) {}

    /// Replaces the presets by those of a map; none without a map.
    void present(const std::optional<MapPicture>& picture, const PlotStyle& style);

  private:
    void add(const PresetPoint& preset, Qt::Alignment side, const MapPicture& picture,
             const PlotStyle& style);

    QCPAxisRect* m_map;
    QVector<QCPAbstractItem*> m_items;
};

}  // namespace drillwave

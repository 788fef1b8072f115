// SPDX-License-Identifier: GPL-3.0-or-later
// Axis rects of a layout, and the items that are drawn in them.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <optional>

namespace drillwave {

/// Whether the axes on opposite sides follow each other.
enum class Sides { linked, free };

/// Makes a rect with axes on all sides, for a layout of the plot.
QCPAxisRect* newAxisRect(QCustomPlot& plot, Sides sides);

/// Places an item in coordinates of the rect, cut at its axes, on the layer of that name (default: the usual
/// one); nobody can select it.
void placeItem(QCPAbstractItem& item, QCPAxisRect* rect, const QString& layer = {});

template <class Item>
Item* addItem(QCPAxisRect* rect, const QString& layer = {}) {
    auto* item = new Item(rect->parentPlot());
    placeItem(*item, rect, layer);
    return item;
}

/// x as a share of the width, and y in coordinates.
void setAcross(QCPItemPosition& position);
/// A line across the rect at a value of its y axis.
QCPItemStraightLine* addLevel(QCPAxisRect* rect, const QString& layer = {});
/// Hidden without a value.
void setLevel(QCPItemStraightLine& line, const std::optional<double>& value);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Axis rects of a layout, and the items that are drawn in them.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <optional>

namespace drillwave {

/// Behaviour of the axes on opposite sides of a rect. With `linked`, the top and right axes take the ranges
/// of the bottom and left axes. With `free`, all ranges are independent.
enum class Sides { linked, free };

/// Returns a new axis rect with axes on all four sides. The caller adds it to the layout of the plot.
QCPAxisRect* newAxisRect(QCustomPlot& plot, Sides sides);

/// Places an item in the coordinates of the bottom and left axes of `rect`, and clips it at these axes.
/// `layer` names the QCustomPlot layer of the item (default: the current layer of the plot). The user cannot
/// select the item.
void placeItem(QCPAbstractItem& item, QCPAxisRect* rect, const QString& layer = {});

/// Adds a new item to the plot and places it in `rect`; see placeItem(). Returns the item, which the plot
/// owns.
template <class Item>
Item* addItem(QCPAxisRect* rect, const QString& layer = {}) {
    auto* item = new Item(rect->parentPlot());
    placeItem(*item, rect, layer);
    return item;
}

/// Makes the x coordinate of `position` a share of the axis rect's width, from 0 (left) to 1 (right). The
/// type of its y coordinate does not change.
void setAcross(QCPItemPosition& position);
/// Adds a horizontal line across the rect, which is hidden until setLevel() places it. Returns the line,
/// which the plot owns.
QCPItemStraightLine* addLevel(QCPAxisRect* rect, const QString& layer = {});
/// Moves a horizontal line made by addLevel() to a value of the vertical axis. Hides the line if `value` is
/// empty.
void setLevel(QCPItemStraightLine& line, const std::optional<double>& value);

}  // namespace drillwave

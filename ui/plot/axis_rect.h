// SPDX-License-Identifier: GPL-3.0-or-later
// Axis rects of a layout, and the items that are drawn in them.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <optional>

namespace drillwave {

/// Linking of the axes on opposite sides of a rect: `linked` axes take over each other's ranges, `free` ones
/// do not.
enum class Sides { linked, free };

/// Returns a new axis rect with axes on all four sides. The caller adds it to the layout of the plot.
QCPAxisRect* newAxisRect(QCustomPlot& plot, Sides sides);

/// Places an item in the coordinates of the bottom and left axes of `rect` and clips it there. `layer` names
/// the QCustomPlot layer of the item (default: the current layer of the plot). The user cannot select the
/// item.
void placeItem(QCPAbstractItem& item, QCPAxisRect* rect, const QString& layer = {});

/// Adds a new item to the plot and places it in `rect`; see placeItem(). Returns the item, which the plot
/// owns.
template <class Item>
Item* addItem(QCPAxisRect* rect, const QString& layer = {}) {
    auto* item = new Item(rect->parentPlot());
    placeItem(*item, rect, layer);
    return item;
}

/// Sets the x of a position as a share of the axis rect's width, from 0 (left) to 1 (right). Its y stays as
/// it was.
void setAcross(QCPItemPosition& position);
/// Adds a horizontal line across the rect, which is hidden until setLevel() places it. Returns the line,
/// which the plot owns.
QCPItemStraightLine* addLevel(QCPAxisRect* rect, const QString& layer = {});
/// Moves a line of addLevel() to a value on the vertical axis. Hides the line if `value` is empty.
void setLevel(QCPItemStraightLine& line, const std::optional<double>& value);

}  // namespace drillwave

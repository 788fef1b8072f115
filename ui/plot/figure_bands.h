// SPDX-License-Identifier: GPL-3.0-or-later
// Named bands of x, shaded behind the curves of one axis rect.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Named range of x to be shaded in a plot, in the unit of the axis.
struct ShownBand {
    QString name;
    QCPRange range;
    std::optional<double> at = {};  ///< x of the name, at the foot; empty if the name is at the top
};

/// Shaded bands over the whole height of an axis rect. Names at the top are in the middle of their bands.
/// Names at the bottom are in two rows; a name is left out if both rows are occupied there. A band with only
/// one value is a vertical line, with its name in the lower half where it covers least. The plot owns the
/// items.
class FigureBands {
  public:
    explicit FigureBands(QCPAxisRect* rect) : m_rect(rect) {}

    void present(std::vector<ShownBand> bands);
    /// Places the bands and their names within the present view. Call this after every change of the view,
    /// because file formats do not clip them.
    void place();
    void setStyle(const PlotStyle& style);

  private:
    struct Item {
        QCPItemRect* area;
        QCPItemText* name;
        QCPItemStraightLine* line;
    };
    void placeAtFoot(const ShownBand& band, QCPItemText& name, std::span<double> taken) const;
    void placeLineNames();
    QCPRange rangeOf(std::size_t index) const;

    QCPAxisRect* m_rect;
    std::vector<ShownBand> m_bands;
    std::vector<Item> m_items;
    PlotStyle m_style;
};

}  // namespace drillwave

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

/// Named range of x, in the unit of the axis.
struct ShownBand {
    QString name;
    QCPRange range;
    std::optional<double> at = {};  ///< x of the name, at the foot; empty if the name is at the top
};

/// Shaded bands over the whole height of an axis rect. Names at the top are in the middle of their bands;
/// names at the foot are in two rows, clear of each other, and a name that fits in neither row is left out.
/// A band of one value is a line, with its name in the lower half where it covers least. The plot owns the
/// items.
class FigureBands {
  public:
    explicit FigureBands(QCPAxisRect* rect) : m_rect(rect) {}

    void present(std::vector<ShownBand> bands);
    /// Places the bands within the present view, because file formats do not clip them. Call this after a
    /// change of the view.
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Named bands of x behind the curves of one axis rect.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// A band in coordinates of the axes.
struct ShownBand {
    QString name;
    QCPRange range;
    std::optional<double> at = {};  ///< x of a name at the foot; nothing: the name is at the top
};

/// Shaded from bottom to top. Names at the top are in the middle of their bands; those at the foot are in two
/// rows, clear of each other, and one that fits in neither is left out. The plot owns the items.
class FigureBands {
  public:
    explicit FigureBands(QCPAxisRect* rect) : m_rect(rect) {}

    void present(std::vector<ShownBand> bands);
    /// Cuts the bands at the view: files do not clip.
    void place();
    void setStyle(const PlotStyle& style);

  private:
    struct Item {
        QCPItemRect* area;
        QCPItemText* name;
    };
    void placeAtFoot(const ShownBand& band, QCPItemText& name, std::span<double> taken) const;
    QCPRange rangeOf(std::size_t index) const;

    QCPAxisRect* m_rect;
    std::vector<ShownBand> m_bands;
    std::vector<Item> m_items;
    PlotStyle m_style;
};

}  // namespace drillwave

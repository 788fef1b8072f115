// SPDX-License-Identifier: GPL-3.0-or-later
// Named bands of x behind the curves of one axis rect.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <vector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// A band in coordinates of the axes.
struct ShownBand {
    QString name;
    QCPRange range;
};

/// Shaded from bottom to top, each with its name at the top; a band of one value is a line with its name at
/// the foot, where it covers least. The plot owns the items.
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
        QCPItemStraightLine* line;
    };
    void placeLineNames();

    QCPAxisRect* m_rect;
    std::vector<ShownBand> m_bands;
    std::vector<Item> m_items;
};

}  // namespace drillwave

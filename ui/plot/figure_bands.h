// SPDX-License-Identifier: GPL-3.0-or-later
// Named bands of x, shaded behind the curves of one axis rect.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <vector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Named range of x, in the unit of the axis.
struct ShownBand {
    QString name;
    QCPRange range;
};

/// Shaded bands over the whole height of an axis rect, each with its name at the top. The plot owns the
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
    };
    QCPAxisRect* m_rect;
    std::vector<ShownBand> m_bands;
    std::vector<Item> m_items;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Marks on the colour bar of the wave picture: the extremes in view, and whether the colours end before them.
#pragma once

#include "ui/pages/wave_picture/wave_picture_items.h"

namespace drillwave {

/// Lines across the bar at the least and the largest value in view; an arrow head beyond each end of the bar
/// where there are values that have the colour of that end but are larger.
class ScaleMarksItem : public WavePictureItem {
    Q_OBJECT

  public:
    /// The bar must outlive the item.
    ScaleMarksItem(QCustomPlot* plot, const QCPColorScale* bar);

  protected:
    void draw(QCPPainter* painter) override;

  private:
    const QCPColorScale* m_bar;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Marks on the colour bar of the wave picture: the extremes in view, and whether they exceed the scale.
#pragma once

#include "ui/pages/wave_picture/wave_picture_items.h"

namespace drillwave {

/// Lines across the colour bar at the smallest and largest value in view. An arrow head beyond an end of the
/// bar shows that values in view exceed the scale there.
class ScaleMarksItem : public WavePictureItem {
    Q_OBJECT

  public:
    /// Creates the marks. The colour bar must outlive them.
    ScaleMarksItem(QCustomPlot* plot, const QCPColorScale* bar);

  protected:
    void draw(QCPPainter* painter) override;

  private:
    const QCPColorScale* m_bar;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The place of the present scenario as a crosshair that the user can drag.
#pragma once

#include <vector>

#include "ui/plot/here_mark.h"

namespace drillwave {

/// Mark of the present scenario with a vertical and a horizontal line through it, which continue in other
/// axis rects. The mouse drags the ring, both values at once, or one of the lines. Ctrl with the arrow keys
/// moves it by a two-hundredth of the view while the plot has the focus. The plot owns it.
class Crosshair : public HereMark {
    Q_OBJECT

  public:
    /// Creates the crosshair in `rect`. Its vertical line continues in the axis rects `below`, its horizontal
    /// line in the axis rects `beside`.
    Crosshair(QCPAxisRect* rect, const std::vector<QCPAxisRect*>& below,
              const std::vector<QCPAxisRect*>& beside);

    void setPlace(std::optional<double> x, std::optional<double> y) override;
    void setStyle(const PlotStyle& style) override;

  signals:
    /// Reports that the user begins to drag the crosshair with the mouse. A step with an arrow key also
    /// counts as a drag.
    void held();
    /// Reports that the user has dragged the crosshair to a place within the view, in the units of the axes.
    void dragged(QPointF place);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Part { none, x, y, both };
    Part partAt(QPointF at) const;
    QPointF pixel() const;
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool step(const QKeyEvent& event);
    void moveTo(QPointF to);

    QCustomPlot* m_plot;
    QCPAxisRect* m_rect;
    std::vector<QCPItemStraightLine*> m_up, m_across;
    QCPItemTracer* m_halo;
    Part m_dragged = Part::none;
    bool m_ownsPointer = false;  // whether the pointer shows that something can be dragged
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The line of the feed in the hand.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>

namespace drillwave {

class PlotWidget;
class ThrustPlot;

/// Lets the line of the feed be dragged up and down, which takes the place of panning there. Lives as a child
/// of the plot.
class ThrustDrag : public QObject {
    Q_OBJECT

  public:
    ThrustDrag(PlotWidget& widget, const ThrustPlot& plot);

    /// A line that follows from what is on the other axis is not dragged.
    void setEnabled(bool enabled);

  signals:
    /// The user has taken hold of the line where it is at that force, in shown units: the moves that follow
    /// belong together.
    void begun(double force);
    /// That point of the line has been moved to that force.
    void moved(double force);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isNear(QPointF pixel) const;
    void showHand(bool near);

    PlotWidget& m_widget;
    const ThrustPlot& m_plot;
    bool m_enabled = false;
    bool m_dragging = false;
    bool m_hand = false;     // shown at the pointer
    double m_grabbedAt = 0;  // height above the line [px]
};

}  // namespace drillwave

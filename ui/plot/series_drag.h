// SPDX-License-Identifier: GPL-3.0-or-later
// A curve in the hand.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

namespace drillwave {

/// Lets a curve be dragged up and down, which takes the place of panning there. Lives as a child of the plot.
class SeriesDrag : public QObject {
    Q_OBJECT

  public:
    explicit SeriesDrag(QCustomPlot& plot);

    /// Drags that curve of the plot; nullptr for none.
    void setCurve(QCPGraph* curve);
    /// How far above (negative: below) the curve a pixel is [px]; nothing where there is no curve.
    std::optional<double> heightAbove(QPointF pixel) const;

  signals:
    /// The user has taken hold of the curve where it is at that y: the moves that follow belong together.
    void begun(double y);
    /// That point of the curve has been moved to that y.
    void moved(double y);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isNear(QPointF pixel) const;
    void showHand(bool near);
    double valueAt(QPointF pixel) const;

    QCustomPlot& m_plot;
    QCPGraph* m_curve = nullptr;
    bool m_dragging = false;
    bool m_hand = false;     // shown at the pointer
    double m_grabbedAt = 0;  // height above the curve [px]
};

}  // namespace drillwave

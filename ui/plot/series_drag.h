// SPDX-License-Identifier: GPL-3.0-or-later
// Dragging of a curve with the mouse.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

namespace drillwave {

/// Handler that lets the user drag a curve up and down. Dragging that starts on the curve does not pan the
/// plot. The plot owns it.
class SeriesDrag : public QObject {
    Q_OBJECT

  public:
    explicit SeriesDrag(QCustomPlot& plot);

    /// Sets the curve that the user can drag; nullptr for none.
    void setCurve(QCPGraph* curve);
    /// Returns how far a pixel is above the curve [px], negative if it is below. Nothing if the curve has no
    /// point at this x, or the pixel is outside the axes.
    std::optional<double> heightAbove(QPointF pixel) const;

  signals:
    /// Reports that the user begins to drag the curve, at a point with the value y (unit of the axis). All
    /// signals moved() until the release of the mouse belong to this drag.
    void begun(double y);
    /// Reports that the user has dragged the curve. The point of the curve where the drag began should now be
    /// at the value `y` (unit of the axis).
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
    bool m_hand = false;     // whether the pointer has the shape for dragging
    double m_grabbedAt = 0;  // height above the curve where the drag began [px]
};

}  // namespace drillwave

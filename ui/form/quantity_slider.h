// SPDX-License-Identifier: GPL-3.0-or-later
// A slider over the plausible range of a parameter, linear or logarithmic.
#pragma once

#include <QSlider>
#include <QTimer>

#include "core/model/parameter.h"

namespace drillwave {

/// Keys and turns of the wheel closer in time than this are one edit [ms].
inline constexpr int stepSeriesMilliseconds = 800;

/// A click in the groove brings the handle there; with Shift a drag is ten times finer.
class QuantitySlider : public QSlider {
    Q_OBJECT

  public:
    /// A logarithmic scale requires a range above zero.
    QuantitySlider(const Range& range, SliderScale scale, QWidget* parent = nullptr);

    /// Moves the handle to a value (SI) without a signal. A value outside the range puts it at the end, where
    /// an arrow then shows that the value lies beyond.
    void present(double si);
    /// −1 or 1 when the value lies beyond the low or high end, else 0.
    int beyond() const { return m_beyond; }

  signals:
    void valueDragged(double si);
    /// A double click: the user wants the value back that is in the file.
    void resetRequested();
    /// The handle was let go, or a series of keys or turns of the wheel has come to its end.
    void dragEnded();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    double valueAt(int position) const;
    QRect handle() const;
    double positionsPerPixel() const;
    void hold(double pixel, bool fine);
    void endSteps();

    Range m_range;
    SliderScale m_scale;
    int m_beyond = 0;
    QTimer m_stepTimer;
    // While it is held: where hand and handle were when it was grabbed, or Shift pressed or let go.
    double m_heldPixel = 0;
    double m_heldPosition = 0;
    bool m_fine = false;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// A slider over the plausible range of a parameter, linear or logarithmic.
#pragma once

#include <QSlider>
#include <QTimer>

#include "core/model/parameter.h"

namespace drillwave {

class QuantitySlider : public QSlider {
    Q_OBJECT

  public:
    /// A logarithmic scale requires a range above zero.
    QuantitySlider(const Range& range, SliderScale scale, QWidget* parent = nullptr);

    /// Moves the handle to a value (SI) without a signal. A value outside the range puts it at the end, where
    /// an arrow then says that the value lies beyond.
    void present(double si);
    /// −1 or 1 when the value lies beyond the low or high end, else 0.
    int beyond() const { return m_beyond; }

  signals:
    void valueDragged(double si);
    /// The handle was let go, or a series of keys or turns of the wheel has come to its end.
    void dragEnded();

  protected:
    void wheelEvent(QWheelEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    double valueAt(int position) const;
    void endSteps();

    Range m_range;
    SliderScale m_scale;
    int m_beyond = 0;
    QTimer m_stepTimer;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Slider over the typical range of a parameter, linear or logarithmic.
#pragma once

#include <QSlider>
#include <QTimer>

#include "core/model/parameter.h"

namespace drillwave {

/// Longest time between two key presses or wheel turns that belong to one edit [ms].
inline constexpr int stepSeriesMilliseconds = 800;

/// Slider whose handle jumps to a click in the groove; with Shift, dragging is ten times finer.
class QuantitySlider : public QSlider {
    Q_OBJECT

  public:
    /// Makes a slider over `range` (SI). A logarithmic scale requires a range above zero.
    QuantitySlider(const Range& range, SliderScale scale, QWidget* parent = nullptr);

    /// Moves the handle to a value (SI) without emitting a signal. For a value outside the range, the handle
    /// is at the end and an arrow is shown.
    void present(double si);
    /// Returns −1 if the value lies below the slider's range, 1 if above, else 0.
    int beyond() const { return m_beyond; }

  signals:
    void valueDragged(double si);
    /// Emitted on a double click: the user wants to restore the value in the file.
    void resetRequested();
    /// Emitted when the handle is released, or a series of key presses or wheel turns has ended.
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
    // Positions of mouse [px] and handle when the drag began, or when Shift was last pressed or released.
    double m_heldPixel = 0;
    double m_heldPosition = 0;
    bool m_fine = false;
};

}  // namespace drillwave

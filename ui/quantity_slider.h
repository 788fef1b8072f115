// A slider over the plausible range of a parameter, linear or logarithmic.
#pragma once

#include <QSlider>

#include "core/model/parameter.h"

namespace drillwave {

class QuantitySlider : public QSlider {
    Q_OBJECT

  public:
    /// A logarithmic scale requires a range above zero.
    QuantitySlider(const Range& range, SliderScale scale, QWidget* parent = nullptr);

    /// Moves the handle to a value (SI) without a signal; values outside the range put it at the end.
    void show(double si);

  signals:
    void valueDragged(double si);
    /// The handle was let go, or moved by a key or the wheel.
    void dragEnded();

  protected:
    void wheelEvent(QWheelEvent* event) override;

  private:
    double valueAt(int position) const;

    Range m_range;
    SliderScale m_scale;
};

}  // namespace drillwave

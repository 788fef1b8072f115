#include "ui/quantity_slider.h"

#include <QSignalBlocker>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {
constexpr int positions = 1000;
}

QuantitySlider::QuantitySlider(const Range& range, SliderScale scale, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), m_range(range), m_scale(scale) {
    setRange(0, positions);
    setSingleStep(5);
    setPageStep(50);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QSlider::valueChanged, this,
            [this](int position) { emit valueDragged(valueAt(position)); });
    connect(this, &QSlider::sliderReleased, this, &QuantitySlider::dragEnded);
}

double QuantitySlider::valueAt(int position) const {
    const double share = static_cast<double>(position) / positions;
    if (m_scale == SliderScale::linear) return m_range.low + share * (m_range.high - m_range.low);
    return m_range.low * std::pow(m_range.high / m_range.low, share);
}

void QuantitySlider::show(double si) {
    if (isSliderDown()) return;  // the hand decides, not the rounded value
    const double inside = std::clamp(si, m_range.low, m_range.high);
    const double share = m_scale == SliderScale::linear
                             ? (inside - m_range.low) / (m_range.high - m_range.low)
                             : std::log(inside / m_range.low) / std::log(m_range.high / m_range.low);
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::lround(share * positions)));
}

void QuantitySlider::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QSlider::wheelEvent(event);
    else
        event->ignore();
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/quantity_slider.h"

#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyleOption>
#include <QStylePainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {
constexpr int positions = 10000;  // a fine drag moves by less than a pixel
constexpr double fineness = 10;
constexpr int beyondArrowSize = 9;
}  // namespace

QuantitySlider::QuantitySlider(const Range& range, SliderScale scale, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), m_range(range), m_scale(scale) {
    setRange(0, positions);
    setSingleStep(positions / 200);
    setPageStep(positions / 20);
    setFocusPolicy(Qt::StrongFocus);
    m_stepTimer.setSingleShot(true);
    m_stepTimer.setInterval(stepSeriesMilliseconds);
    connect(&m_stepTimer, &QTimer::timeout, this, &QuantitySlider::dragEnded);
    connect(this, &QSlider::valueChanged, this, [this](int position) {
        if (!isSliderDown()) m_stepTimer.start();
        emit valueDragged(valueAt(position));
    });
    connect(this, &QSlider::sliderReleased, this, &QuantitySlider::dragEnded);
}

double QuantitySlider::valueAt(int position) const {
    const double share = static_cast<double>(position) / positions;
    if (m_scale == SliderScale::linear) return m_range.low + share * (m_range.high - m_range.low);
    return m_range.low * std::pow(m_range.high / m_range.low, share);
}

void QuantitySlider::present(double si) {
    m_beyond = si < m_range.low ? -1 : si > m_range.high ? 1 : 0;
    update();
    if (isSliderDown()) return;  // the hand decides, not the rounded value
    const double inside = std::clamp(si, m_range.low, m_range.high);
    const double share = m_scale == SliderScale::linear
                             ? (inside - m_range.low) / (m_range.high - m_range.low)
                             : std::log(inside / m_range.low) / std::log(m_range.high / m_range.low);
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::lround(share * positions)));
}

QRect QuantitySlider::handle() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
}

double QuantitySlider::positionsPerPixel() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int groove =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this).width();
    return double(positions) / std::max(1, groove - handle().width());
}

void QuantitySlider::hold(double pixel, bool fine) {
    m_heldPixel = pixel;
    m_heldPosition = sliderPosition();
    m_fine = fine;
}

void QuantitySlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QSlider::mousePressEvent(event);
    event->accept();
    setSliderDown(true);
    const bool inGroove = !handle().contains(event->position().toPoint());
    if (inGroove) {
        const double away = event->position().x() - handle().center().x();
        setSliderPosition(sliderPosition() + static_cast<int>(std::lround(away * positionsPerPixel())));
    }
    hold(event->position().x(), event->modifiers() & Qt::ShiftModifier);
}

void QuantitySlider::mouseMoveEvent(QMouseEvent* event) {
    if (!isSliderDown()) return event->ignore();
    event->accept();
    const bool fine = event->modifiers() & Qt::ShiftModifier;
    if (fine != m_fine) hold(event->position().x(), fine);
    const double away = (event->position().x() - m_heldPixel) * positionsPerPixel();
    setSliderPosition(static_cast<int>(std::lround(m_heldPosition + away / (fine ? fineness : 1))));
}

void QuantitySlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QSlider::mouseReleaseEvent(event);
    event->accept();
    setSliderDown(false);
}

void QuantitySlider::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QSlider::mouseDoubleClickEvent(event);
    event->accept();
    emit resetRequested();
}

void QuantitySlider::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QSlider::wheelEvent(event);
    else
        event->ignore();
}

// A handle that is hidden while it is held is released: receivers would otherwise wait for ever.
void QuantitySlider::hideEvent(QHideEvent* event) {
    setSliderDown(false);
    endSteps();
    QSlider::hideEvent(event);
}

void QuantitySlider::focusOutEvent(QFocusEvent* event) {
    endSteps();
    QSlider::focusOutEvent(event);
}

void QuantitySlider::endSteps() {
    if (!m_stepTimer.isActive()) return;
    m_stepTimer.stop();
    emit dragEnded();
}

void QuantitySlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    if (m_beyond == 0) return;
    QStylePainter painter(this);
    QStyleOption arrow;
    arrow.initFrom(this);
    arrow.rect = QRect(m_beyond < 0 ? 0 : width() - beyondArrowSize, 0, beyondArrowSize, beyondArrowSize);
    painter.drawPrimitive(m_beyond < 0 ? QStyle::PE_IndicatorArrowLeft : QStyle::PE_IndicatorArrowRight,
                          arrow);
}

}  // namespace drillwave

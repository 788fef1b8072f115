// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/rod_strip.h"

#include <QEvent>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/wave/field/bit_motion.h"
#include "core/wave/field/wave_field.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int rodHeight = 20, margin = 4;
constexpr int bitWidth = 10, rockWidth = 26, hammerWidth = 30;
constexpr int mostGapShown = 14;  // [px]
constexpr int enoughForOneLine = 640;

}  // namespace

RodStrip::RodStrip(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    nameColours();
    m_colours = ColourScale::forBackground(palette().color(QPalette::Base));
}

QSize RodStrip::sizeHint() const {
    const int lines = width() < enoughForOneLine ? 2 : 1;
    return {600, rodHeight + lines * fontMetrics().height() + 5 * margin};
}

void RodStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    compute();
    updateGeometry();
}

void RodStrip::setBlow(const SolvedBlowPtr& blow) {
    m_blow = blow;
    nameColours();
    compute();
    setAccessibleDescription(stateText());
}

void RodStrip::setTime(double t) {
    if (m_time == t) return;
    m_time = t;
    compute();
    setAccessibleDescription(stateText());
}

void RodStrip::setRodEnds(int left, int right) {
    if (m_left == left && m_right == right) return;
    m_left = left;
    m_right = right;
    compute();
}

void RodStrip::nameColours() {
    const bool isForce = !m_blow || picture().raster.quantity == WaveQuantity::force;
    setAccessibleName(isForce ? tr("The rod at the time cursor, coloured by its stress")
                              : tr("The rod at the time cursor, coloured by its velocity"));
    setToolTip(
        isForce ? tr("The rod at the time cursor: hammer, rod, bit and rock. Blue is compressed, orange is "
                     "in tension.")
                : tr("The rod at the time cursor: hammer, rod, bit and rock. Orange moves towards the rock, "
                     "blue away from it; as on the colour bar above."));
}

QRect RodStrip::rodRect() const {
    const int right = m_right > 0 ? m_right : width() - rockWidth - mostGapShown - bitWidth - margin;
    return {m_left, 2 * margin, std::max(1, right - m_left), rodHeight};
}

void RodStrip::compute() {
    m_values.clear();
    if (m_blow) {
        const int columns =
            std::max(1, static_cast<int>(std::lround(rodRect().width() * devicePixelRatioF())));
        m_values =
            waveRaster(m_blow->impact, picture().raster.quantity, {0, 1, columns, m_time, m_time, 1}).values;
    }
    update();
}

QString RodStrip::stateText() const {
    if (!m_blow) return {};
    const PictureUnits& units = picture().units;
    const ShownUnit& depth = m_blow->units.penetration;
    const BitState bit = bitState(m_blow->impact, picture().contacts, m_blow->solved.gap, m_time);
    const auto text = [this](double value, const ShownUnit& unit) {
        return quantityText(value, unit, locale());
    };
    const double force = WaveField(m_blow->impact).impactForce(m_time);
    const QString state = bit.touching ? tr("contact, penetration %1, impact force %2")
                                             .arg(text(bit.penetration, depth), text(force, units.force))
                          : bit.gap > 0 ? tr("apart, gap %1").arg(text(bit.gap, depth))
                                        : tr("bit at the rock, no force");
    float least = 0, most = 0;
    for (const float value : m_values) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    const bool isForce = picture().raster.quantity == WaveQuantity::force;
    const ShownUnit& unit = isForce ? units.stress : units.velocity;
    return (isForce ? tr("t = %1 · %2 · stress %3 … %4") : tr("t = %1 · %2 · velocity %3 … %4"))
        .arg(timeText(m_time, picture().interesting, units.time, locale()), state, text(double(least), unit),
             text(double(most), unit));
}

void RodStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QRect rod = rodRect();
    paintRod(painter, rod);
    if (!m_blow) return;
    paintHammer(painter, rod);
    paintRock(painter, rod);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(
        QRect(margin, rod.bottom() + margin, width() - 2 * margin, height() - rod.bottom() - margin),
        Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, stateText());
}

void RodStrip::paintRod(QPainter& painter, const QRect& rod) const {
    if (!m_values.empty()) {
        QImage line(static_cast<int>(m_values.size()), 1, QImage::Format_RGB32);
        const double scale = 1 / picture().limit;
        std::transform(m_values.begin(), m_values.end(), reinterpret_cast<QRgb*>(line.scanLine(0)),
                       [&](float value) { return m_colours.colour(value * scale); });
        painter.drawImage(rod, line);
    }
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rod.adjusted(-1, -1, 0, 0));
}

// It touches the rod while it pushes.
void RodStrip::paintHammer(QPainter& painter, const QRect& rod) const {
    const PulseForce& pulse = m_blow->solved.hammer;
    if (pulse.isRigidBody()) return;
    const double force = pulse(m_time) / pulse.peak;
    const int away = force > 0 || m_time < 0 ? 0 : 6;
    const QRect hammer(rod.left() - 1 - away - hammerWidth, rod.top() - 3, hammerWidth, rod.height() + 6);
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(force > 0 ? QBrush(QColor::fromRgb(m_colours.colour(-force)))
                               : QBrush(palette().color(QPalette::Mid)));
    painter.drawRect(hammer);
}

void RodStrip::paintRock(QPainter& painter, const QRect& rod) const {
    const BitState bit = bitState(m_blow->impact, picture().contacts, m_blow->solved.gap, m_time);
    const QColor line = palette().color(QPalette::Text);
    painter.setPen(line);
    painter.setBrush(palette().color(QPalette::Mid));
    const QRect head(rod.right() + 1, rod.top() - 4, bitWidth, rod.height() + 8);
    painter.drawRect(head);
    // Any gap can be seen, one of d0 or more at its widest.
    const int gap = bit.touching ? 0 : 1 + static_cast<int>((mostGapShown - 1) * std::min(1.0, bit.gap));
    const QRect rock(head.right() + 1 + gap, margin / 2, rockWidth, rod.bottom() + margin);
    painter.fillRect(rock, QBrush(line, Qt::BDiagPattern));
    painter.setPen(QPen(line, bit.touching ? 3 : 1));
    painter.drawLine(rock.topLeft(), rock.bottomLeft());
}

void RodStrip::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_colours = ColourScale::forBackground(palette().color(QPalette::Base));
        update();
    }
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/rod_strip.h"
#include <QEvent>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/model/section_pieces.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int rodHeight = 20, stripMargin = 4;
constexpr int bitWidth = 10, rockWidth = 26, hammerWidth = 30;
constexpr int mostGapShown = 14;  // [px]
constexpr int hammerAway = 4;     // from the string while they do not touch [px]
constexpr int enoughForOneLine = 640, enoughOfString = 780;
constexpr int textColumns = 1000;  // in which the extremes are looked for, whatever the width

}  // namespace

RodStrip::RodStrip(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    nameColours();
}

const ColourScale& RodStrip::colours() const {
    return ColourScale::forBackground(palette().color(QPalette::Base));
}

QSize RodStrip::sizeHint() const {
    const int enough = m_blow && picture().string ? enoughOfString : enoughForOneLine;
    const int lines = width() < enough ? 2 : 1;
    return {600, rodHeight + lines * fontMetrics().height() + 5 * stripMargin};
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
    updateGeometry();
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
    const bool isForce = isStress();
    setAccessibleName(isForce ? tr("The rod at the time cursor, coloured by its stress")
                              : tr("The rod at the time cursor, coloured by its velocity"));
    setToolTip(
        isForce ? tr("The rod at the time cursor: hammer, rod, bit and rock. Blue is compressed, orange is "
                     "in tension.")
                : tr("The rod at the time cursor: hammer, rod, bit and rock. Orange moves towards the rock, "
                     "blue away from it; as on the colour bar above."));
}

QRect RodStrip::rodRect() const {
    const int right = m_right > 0 ? m_right : width() - rockWidth - mostGapShown - bitWidth - stripMargin;
    return {m_left, 2 * stripMargin, std::max(1, right - m_left), rodHeight};
}

void RodStrip::compute() {
    m_values.clear();
    m_least = m_most = 0;
    if (m_blow) {
        m_values =
            valuesAt(std::max(1, static_cast<int>(std::lround(rodRect().width() * devicePixelRatioF()))));
        for (const float value : valuesAt(textColumns)) {
            m_least = std::min(m_least, value);
            m_most = std::max(m_most, value);
        }
    }
    update();
}

std::vector<float> RodStrip::valuesAt(int columns) const {
    const RasterGrid grid{picture().rear, 1, columns, m_time, m_time, 1};
    std::vector<float> values = BlowWaves(*m_blow).raster(picture().raster.quantity, grid).values;
    if (picture().string && isStress()) toStress(grid, values);
    return values;
}

void RodStrip::toStress(const RasterGrid& grid, std::vector<float>& values) const {
    const StringRod& rod = picture().string->rod;
    for (int i = 0; i < grid.columns; ++i) {
        float& value = values[static_cast<std::size_t>(i)];
        const RodStretch& stretch = rod.stretches[rod.sectionAt(grid.xi(i))];
        value = static_cast<float>(stressOf(stretch, double(value), stretch.shareAt(grid.xi(i))));
    }
}

bool RodStrip::hammerTouches() const {
    return std::ranges::any_of(picture().string->faceContacts, [this](const ContactInterval& contact) {
        return contact.begin <= m_time && m_time <= contact.end;
    });
}

QString RodStrip::stateText() const {
    if (!m_blow) return {};
    const PictureUnits& units = picture().units;
    const ShownUnit& depth = m_blow->units.penetration;
    const BlowWaves waves(*m_blow);
    if (m_time > waves.end())
        return tr("t = %1 · after the end of the computed time, %2")
            .arg(timeText(m_time, picture().interesting, units.time, locale()),
                 timeText(waves.end(), picture().interesting, units.time, locale()));
    const BitState bit = waves.bit(picture().contacts, m_time);
    const auto text = [this](double value, const ShownUnit& unit) {
        return quantityText(value, unit, locale());
    };
    const double force = waves.impactForce(m_time);
    QString state = bit.touching ? tr("contact, penetration %1, impact force %2")
                                       .arg(text(bit.penetration, depth), text(force, units.force))
                    : bit.gap > 0 ? tr("apart, gap %1").arg(text(bit.gap, depth))
                                  : tr("bit at the rock, no force");
    if (picture().string) state += hammerTouches() ? tr(" · hammer pushes") : tr(" · hammer not in contact");
    const ShownUnit& unit = isStress() ? units.stress : units.velocity;
    return (isStress() ? tr("t = %1 · %2 · stress %3 … %4") : tr("t = %1 · %2 · velocity %3 … %4"))
        .arg(timeText(m_time, picture().interesting, units.time, locale()), state,
             text(double(m_least), unit), text(double(m_most), unit));
}

void RodStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QRect rod = rodRect();
    if (m_blow && picture().string) {
        paintSections(painter, rod);
    } else {
        paintRod(painter, rod);
        if (!m_blow) return;
        paintHammer(painter, rod);
    }
    paintRock(painter, rod);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(stripMargin, rod.bottom() + stripMargin, width() - 2 * stripMargin,
                           height() - rod.bottom() - stripMargin),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, stateText());
}

void RodStrip::paintRod(QPainter& painter, const QRect& rod) const {
    if (!m_values.empty()) painter.drawImage(rod, colouredLine());
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rod.adjusted(-1, -1, 0, 0));
}

QImage RodStrip::colouredLine() const {
    QImage line(static_cast<int>(m_values.size()), 1, QImage::Format_ARGB32_Premultiplied);
    const double scale =
        1 / (picture().string && isStress() ? picture().string->largestStress : picture().limit);
    std::transform(m_values.begin(), m_values.end(), reinterpret_cast<QRgb*>(line.scanLine(0)),
                   [&, &shades = colours()](float value) { return shades.colour(value * scale); });
    return line;
}

// The hammer is moved away from the string while they do not touch.
void RodStrip::paintSections(QPainter& painter, const QRect& rod) const {
    const std::vector<RodStretch>& stretches = picture().string->rod.stretches;
    const double rear = picture().rear;
    double largest = 0;
    for (const RodStretch& stretch : stretches) largest = std::max(largest, largestDiameter(stretch.section));
    const QImage line = colouredLine();
    const int away = hammerTouches() ? 0 : hammerAway;
    const double middle = rod.center().y() + 0.5;
    const auto share = [rear](double x) { return (x - rear) / (1 - rear); };
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(Qt::NoBrush);
    for (const RodStretch& stretch : stretches) {
        const double from = share(stretch.rear), to = share(stretch.front);
        const auto halfAt = [&](double end) {
            return std::max(3.0, rod.height() * outerDiameterAt(stretch.section, end) / largest) / 2;
        };
        const double rearHalf = halfAt(0), frontHalf = halfAt(1), half = std::max(rearHalf, frontHalf);
        const double left = rod.left() + from * rod.width() - (stretch.number < 0 ? away : 0);
        const QRectF box(left, middle - half, (to - from) * rod.width(), 2 * half);
        const QPolygonF outline({{box.left(), middle - rearHalf},
                                 {box.right(), middle - frontHalf},
                                 {box.right(), middle + frontHalf},
                                 {box.left(), middle + rearHalf}});
        painter.save();
        if (rearHalf != frontHalf) {
            QPainterPath cone;
            cone.addPolygon(outline);
            painter.setClipPath(cone, Qt::IntersectClip);
        }
        painter.drawImage(box, line, QRectF(from * line.width(), 0, (to - from) * line.width(), 1));
        painter.restore();
        painter.drawPolygon(outline);
    }
}

// It touches the rod while it pushes.
void RodStrip::paintHammer(QPainter& painter, const QRect& rod) const {
    const PulseForce& pulse = m_blow->problem.force();
    if (pulse.isRigidBody()) return;
    const double force = pulse(m_time) / pulse.peak;
    const int away = force > 0 || m_time < 0 ? 0 : 6;
    const QRect hammer(rod.left() - 1 - away - hammerWidth, rod.top() - 3, hammerWidth, rod.height() + 6);
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(force > 0 ? QBrush(QColor::fromRgb(colours().colour(-force)))
                               : QBrush(palette().color(QPalette::Mid)));
    painter.drawRect(hammer);
}

void RodStrip::paintRock(QPainter& painter, const QRect& rod) const {
    const BitState bit = BlowWaves(*m_blow).bit(picture().contacts, m_time);
    const QColor line = palette().color(QPalette::Text);
    painter.setPen(line);
    painter.setBrush(palette().color(QPalette::Mid));
    const bool hasBit = picture().string.has_value();  // among its sections
    const QRect head(rod.right() + 1, rod.top() - 4, hasBit ? 0 : bitWidth, rod.height() + 8);
    if (!hasBit) painter.drawRect(head);
    // Any gap can be seen, one of d0 or more at its widest.
    const int gap = bit.touching ? 0 : 1 + static_cast<int>((mostGapShown - 1) * std::min(1.0, bit.gap));
    const QRect rock(head.right() + 1 + gap, stripMargin / 2, rockWidth, rod.bottom() + stripMargin);
    painter.fillRect(rock, QBrush(line, Qt::BDiagPattern));
    painter.setPen(QPen(line, bit.touching ? 3 : 1));
    painter.drawLine(rock.topLeft(), rock.bottomLeft());
}

}  // namespace drillwave

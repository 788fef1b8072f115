// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/energy_bar.h"

#include <QPainter>
#include <algorithm>
#include <numeric>

#include "ui/text/lightness.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

std::size_t index(EnergyPart part) {
    return static_cast<std::size_t>(part);
}

QColor colourOf(EnergyPart part, const QPalette& palette) {
    const bool dark = isDark(palette.color(QPalette::Base));
    switch (part) {
        case EnergyPart::rock:
            return dark ? QColor(0xd9, 0xa4, 0x6a) : QColor(0x8a, 0x55, 0x20);
        case EnergyPart::rebound:
            return dark ? QColor(0x7f, 0xbd, 0xee) : QColor(0x1f, 0x63, 0xa0);
        case EnergyPart::hammer:
            return dark ? QColor(0xc9, 0xa6, 0xe4) : QColor(0x6e, 0x3f, 0x96);
        case EnergyPart::losses:
            return dark ? QColor(0xb8, 0xb8, 0xb8) : QColor(0x5a, 0x5a, 0x5a);
        case EnergyPart::waves:
            break;
    }
    return dark ? QColor(0x9f, 0xd6, 0x9b) : QColor(0x2f, 0x74, 0x35);
}

// Solid, hatched, striped and dotted, so that parts differ without colour.
Qt::BrushStyle patternOf(EnergyPart part) {
    switch (part) {
        case EnergyPart::rock:
            return Qt::SolidPattern;
        case EnergyPart::rebound:
            return Qt::BDiagPattern;
        case EnergyPart::hammer:
            return Qt::HorPattern;
        case EnergyPart::losses:
            return Qt::Dense6Pattern;
        case EnergyPart::waves:
            break;
    }
    return Qt::VerPattern;
}

void drawPart(QPainter& painter, const QRectF& rect, EnergyPart part, const QPalette& palette) {
    const QColor colour = colourOf(part, palette);
    painter.fillRect(rect, palette.color(QPalette::Base));
    painter.setPen(QPen(colour, 1));
    painter.setBrush(QBrush(colour, patternOf(part)));
    painter.drawRect(rect);
}

QString shareText(double share) {
    return percentText(std::round(1000 * share) / 1000, 3, QLocale());
}

}  // namespace

QString energyPartName(EnergyPart part) {
    switch (part) {
        case EnergyPart::rock:
            return EnergyBar::tr("rock");
        case EnergyPart::rebound:
            return EnergyBar::tr("rebound");
        case EnergyPart::hammer:
            return EnergyBar::tr("hammer");
        case EnergyPart::losses:
            return EnergyBar::tr("losses");
        case EnergyPart::waves:
            break;
    }
    return EnergyBar::tr("waves");
}

double energyShare(const ImpactSummary& summary, EnergyPart part) {
    const EnergyLedger& ledger = summary.energy;
    const std::array values{ledger.rockWork, ledger.reboundEnergy, ledger.residualWaveEnergy,
                            summary.hammerReboundEnergy + summary.hammerWaveEnergy,
                            summary.jointLoss + summary.rodLoss + summary.faceEnergy};
    return std::max(0.0, values[index(part)]);
}

EnergyBar::EnergyBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe();
}

void EnergyBar::present(const ImpactSummary& summary) {
    for (const EnergyPart part : energyParts) m_shares[index(part)] = energyShare(summary, part);
    const double sum = std::accumulate(m_shares.begin(), m_shares.end(), 0.0);
    if (!(sum > 0)) return clear();
    for (double& share : m_shares) share /= sum;
    describe();
    update();
}

void EnergyBar::clear() {
    m_shares = {};
    describe();
    update();
}

void EnergyBar::describe() {
    QStringList parts;
    for (const EnergyPart part : energyParts)
        if (m_shares[index(part)] > 0)
            parts << energyPartName(part) + QLatin1Char(' ') + shareText(m_shares[index(part)]);
    const QString text = parts.isEmpty() ? tr("Energy: no result") : tr("Energy: %1").arg(parts.join(", "));
    setAccessibleName(text);
    setToolTip(text);
}

QRectF EnergyBar::partRect(EnergyPart part) const {
    const QRectF all = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    const double before = std::accumulate(m_shares.begin(), m_shares.begin() + index(part), 0.0);
    return {all.left() + before * all.width(), all.top(), m_shares[index(part)] * all.width(), all.height()};
}

QString EnergyBar::labelOf(EnergyPart part) const {
    const double share = m_shares[index(part)];
    const double room = partRect(part).width() - 10;
    const QString number = shareText(share);
    for (const QString& text : {energyPartName(part) + QLatin1Char(' ') + number, energyPartName(part)})
        if (fontMetrics().horizontalAdvance(text) <= room) return text;
    return {};
}

QSize EnergyBar::sizeHint() const {
    return {180, fontMetrics().height() + 10};
}

QSize EnergyBar::minimumSizeHint() const {
    return {60, sizeHint().height()};
}

void EnergyBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    for (const EnergyPart part : energyParts) {
        if (!(m_shares[index(part)] > 0)) continue;
        const QRectF area = partRect(part);
        drawPart(painter, area, part, palette());
        const QString label = labelOf(part);
        if (label.isEmpty()) continue;
        // The letters have a plain background: patterns would run through them.
        QRectF plate = fontMetrics().boundingRect(label).adjusted(-3, -1, 3, 1);
        plate.moveCenter(area.center());
        painter.fillRect(plate, palette().color(QPalette::Base));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(plate, Qt::AlignCenter, label);
    }
}

EnergySwatch::EnergySwatch(EnergyPart part, QWidget* parent) : QWidget(parent), m_part(part) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize EnergySwatch::sizeHint() const {
    const int side = fontMetrics().ascent();
    return {side, side};
}

void EnergySwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawPart(painter, QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), m_part, palette());
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/preset_bands.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drillwave {
namespace {

constexpr std::size_t rows = 2;  // of names

}  // namespace

PresetBands::PresetBands(QCPAxisRect* rect)
    : QObject(rect->parentPlot()), m_rect(rect), m_style(PlotStyle::forPaper()) {
    connect(rect->parentPlot(), &QCustomPlot::afterLayout, this, &PresetBands::place);
}

void PresetBands::prepare(QCPAbstractItem& item, const QString& layer) {
    item.setLayer(layer);
    item.setSelectable(false);
    item.setClipAxisRect(m_rect);
    for (QCPItemPosition* position : item.positions()) {
        position->setAxes(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
        position->setAxisRect(m_rect);
        position->setTypeX(QCPItemPosition::ptPlotCoords);
        position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
}

void PresetBands::present(const QVector<PresetBand>& bands) {
    QCustomPlot* plot = m_rect->parentPlot();
    for (const Drawn& drawn : std::as_const(m_drawn)) {
        plot->removeItem(drawn.area);
        plot->removeItem(drawn.name);
    }
    m_drawn.clear();
    for (const PresetBand& band : bands) {
        auto* area = new QCPItemRect(plot);
        prepare(*area, QStringLiteral("background"));
        area->setPen(Qt::NoPen);
        auto* name = new QCPItemText(plot);
        prepare(*name, QStringLiteral("axes"));
        name->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        name->setText(band.name);
        name->setPadding(QMargins(3, 2, 3, 2));
        name->setPositionAlignment(Qt::AlignBottom | Qt::AlignLeft);
        m_drawn.append({band, area, name});
    }
    std::ranges::stable_sort(m_drawn, {}, [](const Drawn& drawn) { return drawn.band.at; });
    applyStyle();
}

// Clips the bands to the view: files do not clip.
void PresetBands::place() {
    const QCPRange view = m_rect->axis(QCPAxis::atBottom)->range();
    std::array<double, rows> taken;
    taken.fill(-HUGE_VAL);
    for (const Drawn& drawn : std::as_const(m_drawn)) {
        const double from = std::max(drawn.band.from, view.lower), to = std::min(drawn.band.to, view.upper);
        drawn.area->setVisible(from < to);
        drawn.area->topLeft->setCoords(from, 0);
        drawn.area->bottomRight->setCoords(to, 1);
        drawn.name->setVisible(view.contains(drawn.band.at));
        if (drawn.name->visible()) placeName(drawn, taken);
    }
}

// Places the name in the lowest free row; `taken` is the end of the names in each row.
void PresetBands::placeName(const Drawn& drawn, std::span<double> taken) const {
    const QFontMetricsF metrics(drawn.name->font());
    const QMargins padding = drawn.name->padding();
    const double words = metrics.boundingRect(QRectF(), Qt::TextDontClip, drawn.band.name).width();
    const double width = std::ceil(words) + padding.left() + padding.right();
    const double at = m_rect->axis(QCPAxis::atBottom)->coordToPixel(drawn.band.at);
    const double left = std::clamp<double>(at - width / 2, m_rect->left(),
                                           std::max<double>(m_rect->left(), m_rect->right() - width));
    const auto row = std::ranges::find_if(taken, [left](double end) { return end <= left; });
    drawn.name->setVisible(row != taken.end());
    if (row == taken.end()) return;
    *row = left + width;
    constexpr double rowGap = 4, footGap = 0.2;  // [px], and of a row
    const double up = (double(row - taken.begin()) + footGap) * (metrics.lineSpacing() + rowGap);
    drawn.name->position->setCoords((left - m_rect->left()) / std::max(1, m_rect->width()),
                                    1 - up / std::max(1, m_rect->height()));
}

void PresetBands::setStyle(const PlotStyle& style) {
    m_style = style;
    applyStyle();
}

void PresetBands::applyStyle() {
    for (const Drawn& drawn : std::as_const(m_drawn)) {
        drawn.area->setBrush(m_style.areaBrush(2));
        drawn.name->setFont(m_style.font);
        drawn.name->setColor(m_style.text);
        drawn.name->setBrush(m_style.behindWords());
    }
}

}  // namespace drillwave

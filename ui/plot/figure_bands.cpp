// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_bands.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/plot/axis_rect.h"

namespace drillwave {
namespace {

constexpr std::size_t nameRows = 2;  // of names at the foot

}  // namespace

void FigureBands::present(std::vector<ShownBand> bands) {
    m_bands = std::move(bands);
    while (m_items.size() < m_bands.size()) {
        Item item{addItem<QCPItemRect>(m_rect, QStringLiteral("background")), addItem<QCPItemText>(m_rect)};
        for (QCPItemPosition* corner : item.area->positions())
            corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
        item.name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        item.name->setPadding(QMargins(2, 2, 2, 2));
        m_items.push_back(item);
    }
    setStyle(m_style);
    place();
}

QCPRange FigureBands::rangeOf(std::size_t index) const {
    const QCPRange view = m_rect->axis(QCPAxis::atBottom)->range();
    if (index >= m_bands.size()) return {};
    const double from = std::max(view.lower, m_bands[index].range.lower);
    const double to = std::min(view.upper, m_bands[index].range.upper);
    QCPRange range;
    if (from < to) range.lower = from, range.upper = to;
    return range;
}

void FigureBands::place() {
    const QCPRange view = m_rect->axis(QCPAxis::atBottom)->range();
    std::array<double, nameRows> taken;
    taken.fill(-HUGE_VAL);
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        auto [area, name] = m_items[i];
        const QCPRange range = rangeOf(i);
        const bool isThere = range.lower < range.upper;
        area->setVisible(isThere);
        name->setVisible(isThere);
        if (!isThere) continue;
        area->topLeft->setCoords(range.lower, 0);
        area->bottomRight->setCoords(range.upper, 1);
        name->setText(m_bands[i].name);
        if (!m_bands[i].at) {
            name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
            name->position->setCoords(range.center(), 0);
        } else if (view.contains(*m_bands[i].at)) {
            placeAtFoot(m_bands[i], *name, taken);
        } else {
            name->setVisible(false);
        }
    }
}

// Places the name in the lowest free row; `taken` is the end of the names in each row.
void FigureBands::placeAtFoot(const ShownBand& band, QCPItemText& name, std::span<double> taken) const {
    const QCPAxis& x = *m_rect->axis(QCPAxis::atBottom);
    const QFontMetricsF metrics(name.font());
    const QMargins padding = name.padding();
    const double words = metrics.boundingRect(QRectF(), Qt::TextDontClip, band.name).width();
    const double width = std::ceil(words) + padding.left() + padding.right();
    const double left = std::clamp<double>(x.coordToPixel(*band.at) - width / 2, m_rect->left(),
                                           std::max<double>(m_rect->left(), m_rect->right() - width));
    const auto row = std::ranges::find_if(taken, [left](double end) { return end <= left; });
    name.setVisible(row != taken.end());
    if (row == taken.end()) return;
    *row = left + width;
    constexpr double rowGap = 4, footGap = 0.2;  // [px], and of a row
    const double up = (double(row - taken.begin()) + footGap) * (metrics.lineSpacing() + rowGap);
    name.setPositionAlignment(Qt::AlignBottom | Qt::AlignLeft);
    name.position->setCoords(x.pixelToCoord(left), 1 - up / std::max(1, m_rect->height()));
}

void FigureBands::setStyle(const PlotStyle& style) {
    m_style = style;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        const bool isAtFoot = i < m_bands.size() && m_bands[i].at;
        m_items[i].area->setPen(Qt::NoPen);
        QColor colour = style.lines[isAtFoot ? 2 : i % PlotStyle::lineKinds];
        colour.setAlpha(28);
        m_items[i].area->setBrush(colour);
        m_items[i].name->setBrush(isAtFoot ? style.behindWords() : QBrush());
        m_items[i].name->setFont(style.font);
        m_items[i].name->setColor(style.text);
    }
}

}  // namespace drillwave

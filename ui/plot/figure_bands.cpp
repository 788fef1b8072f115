// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_bands.h"

#include <algorithm>

#include "ui/plot/axis_rect.h"

namespace drillwave {

void FigureBands::present(std::vector<ShownBand> bands) {
    m_bands = std::move(bands);
    while (m_items.size() < m_bands.size()) {
        Item item{addItem<QCPItemRect>(m_rect, QStringLiteral("background")), addItem<QCPItemText>(m_rect)};
        for (QCPItemPosition* corner : item.area->positions())
            corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
        item.name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        item.name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
        item.name->setPadding(QMargins(2, 2, 2, 2));
        m_items.push_back(item);
    }
    place();
}

void FigureBands::place() {
    const QCPRange view = m_rect->axis(QCPAxis::atBottom)->range();
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        const bool isThere = i < m_bands.size();
        const double from = isThere ? std::max(view.lower, m_bands[i].range.lower) : 0;
        const double to = isThere ? std::min(view.upper, m_bands[i].range.upper) : 0;
        m_items[i].area->setVisible(from < to);
        m_items[i].name->setVisible(from < to);
        if (!(from < to)) continue;
        m_items[i].area->topLeft->setCoords(from, 0);
        m_items[i].area->bottomRight->setCoords(to, 1);
        m_items[i].name->position->setCoords((from + to) / 2, 0);
        m_items[i].name->setText(m_bands[i].name);
    }
}

void FigureBands::setStyle(const PlotStyle& style) {
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        m_items[i].area->setPen(Qt::NoPen);
        QColor colour = style.lines[i % PlotStyle::lineKinds];
        colour.setAlpha(28);
        m_items[i].area->setBrush(colour);
        m_items[i].name->setFont(style.font);
        m_items[i].name->setColor(style.text);
    }
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_bands.h"

#include <algorithm>

#include "ui/plot/axis_rect.h"
#include "ui/plot/label_places.h"

namespace drillwave {

void FigureBands::present(std::vector<ShownBand> bands) {
    m_bands = std::move(bands);
    while (m_items.size() < m_bands.size()) {
        Item item{addItem<QCPItemRect>(m_rect, QStringLiteral("background")), addItem<QCPItemText>(m_rect),
                  addItem<QCPItemStraightLine>(m_rect, QStringLiteral("grid"))};
        for (QCPItemPosition* end : item.line->positions()) end->setTypeY(QCPItemPosition::ptAxisRectRatio);
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
        const bool isLine = isThere && m_bands[i].range.size() == 0 && view.contains(from);
        m_items[i].area->setVisible(from < to);
        m_items[i].name->setVisible(from < to || isLine);
        m_items[i].line->setVisible(isLine);
        m_items[i].line->point1->setCoords(from, 0);
        m_items[i].line->point2->setCoords(from, 1);
        if (isThere) m_items[i].name->setText(m_bands[i].name);
        if (!(from < to)) continue;
        m_items[i].area->topLeft->setCoords(from, 0);
        m_items[i].area->bottomRight->setCoords(to, 1);
        m_items[i].name->position->setCoords((from + to) / 2, 0);
    }
    placeLineNames();
}

// In the lower half, as low as it covers no other name, curve or line; lines weigh less than curves.
void FigureBands::placeLineNames() {
    QVector<QPointF> curves;
    for (const QCPGraph* graph : m_rect->graphs())
        if (graph->lineStyle() != QCPGraph::lsNone) curves += pointsAlong(*graph);
    QVector<PlacedLabel> labels;
    for (const Item& item : m_items) {
        if (!item.line->visible()) continue;
        PlacedLabel label{item.name, {}};
        const double x = item.line->point1->pixelPosition().x();
        const int height = QFontMetrics(item.name->font()).height();
        for (int y = m_rect->bottom(); y > m_rect->top(); y -= 9) curves.append({x, double(y)});
        for (int y = m_rect->bottom() - 2; y > m_rect->center().y(); y -= height)
            for (const Qt::Alignment side : {Qt::AlignLeft, Qt::AlignRight})
                label.places.append([name = item.name, at = QPointF(x, y), side] {
                    name->setPositionAlignment(side | Qt::AlignBottom);
                    name->position->setPixelPosition(at);
                });
        labels.append(label);
    }
    placeLabels(labels, m_rect->rect(), {}, curves);
}

void FigureBands::setStyle(const PlotStyle& style) {
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        m_items[i].area->setPen(Qt::NoPen);
        QColor colour = style.lines[i % PlotStyle::lineKinds];
        colour.setAlpha(28);
        m_items[i].area->setBrush(colour);
        m_items[i].name->setFont(style.font);
        m_items[i].name->setColor(style.text);
        m_items[i].line->setPen(QPen(style.frame, 1, Qt::DashLine));
        m_items[i].name->setBrush(m_items[i].line->visible() ? style.behindWords() : QBrush());
    }
}

}  // namespace drillwave

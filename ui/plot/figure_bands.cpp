// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_bands.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/plot/axis_rect.h"
#include "ui/plot/label_places.h"

namespace drillwave {
namespace {

constexpr std::size_t nameRows = 2;  // of names at the foot

}  // namespace

void FigureBands::present(std::vector<ShownBand> bands) {
    m_bands = std::move(bands);
    while (m_items.size() < m_bands.size()) {
        Item item{addItem<QCPItemRect>(m_rect, QStringLiteral("background")), addItem<QCPItemText>(m_rect),
                  addItem<QCPItemStraightLine>(m_rect, QStringLiteral("grid"))};
        for (QCPItemPosition* end : item.line->positions()) end->setTypeY(QCPItemPosition::ptAxisRectRatio);
        for (QCPItemPosition* corner : item.area->positions())
            corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
        item.name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        item.name->setPadding(QMargins(2, 2, 2, 2));
        item.name->setObjectName(QLatin1String(fixedLabel));
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
        auto [area, name, line] = m_items[i];
        const QCPRange range = rangeOf(i);
        const bool isThere = range.lower < range.upper;
        const bool isLine =
            i < m_bands.size() && m_bands[i].range.size() == 0 && view.contains(m_bands[i].range.lower);
        area->setVisible(isThere);
        name->setVisible(isThere || isLine);
        line->setVisible(isLine);
        if (isThere || isLine) name->setText(m_bands[i].name);
        if (isLine) {
            line->point1->setCoords(m_bands[i].range.lower, 0);
            line->point2->setCoords(m_bands[i].range.lower, 1);
        }
        if (!isThere) continue;
        area->topLeft->setCoords(range.lower, 0);
        area->bottomRight->setCoords(range.upper, 1);
        if (!m_bands[i].at) {
            name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
            name->position->setCoords(range.center(), 0);
        } else if (view.contains(*m_bands[i].at)) {
            placeAtFoot(m_bands[i], *name, taken);
        } else {
            name->setVisible(false);
        }
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
        const bool isLine = i < m_bands.size() && m_bands[i].range.size() == 0;
        m_items[i].area->setPen(Qt::NoPen);
        QColor colour = style.lines[isAtFoot ? 2 : i % PlotStyle::lineKinds];
        colour.setAlpha(28);
        m_items[i].area->setBrush(colour);
        m_items[i].name->setFont(style.font);
        m_items[i].name->setColor(style.text);
        m_items[i].line->setPen(QPen(style.frame, 1, Qt::DashLine));
        m_items[i].name->setBrush(isAtFoot || isLine ? style.behindWords() : QBrush());
    }
}

}  // namespace drillwave

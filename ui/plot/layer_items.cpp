// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/layer_items.h"

#include <algorithm>
#include <cmath>

#include "ui/plot/axis_rect.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int shades[] = {44, 28, 14, 6, 0};  // alpha of the text's colour: the lower, the darker

}  // namespace

LayerItems::LayerItems(QCPAxisRect* rect)
    : QObject(rect->parentPlot()),
      m_x(rect->axis(QCPAxis::atBottom)),
      m_y(rect->axis(QCPAxis::atLeft)),
      m_style(PlotStyle::forPaper()) {
    connect(rect->parentPlot(), &QCustomPlot::afterLayout, this, &LayerItems::place);
}

void LayerItems::addLayer() {
    Item item{new QCPCurve(m_x, m_y), addItem<QCPItemText>(m_x->axisRect(), QStringLiteral("axes"))};
    item.area->removeFromLegend();
    item.area->setSelectable(QCP::stNone);
    item.area->setLayer(QStringLiteral("background"));
    item.area->setPen(Qt::NoPen);
    item.name->setPadding(QMargins(6, 1, 6, 1));
    item.name->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_items.push_back(item);
}

void LayerItems::present(const FigureLayers& layers, double xFactor, double yFactor) {
    m_layers = layers;
    for (double& x : m_layers.x) x *= xFactor;
    for (double& y : m_layers.clear) y *= yFactor;
    for (std::vector<double>& edge : m_layers.edges)
        for (double& y : edge) y *= yFactor;
    while (m_items.size() < layers.names.size()) addLayer();
    setStyle(m_style);
    place();
}

// As far as it is in view: files do not clip.
QVector<QPointF> LayerItems::edge(std::size_t above, double level) const {
    QVector<QPointF> line;
    const QCPRange view = m_y->range();
    for (std::size_t i = 0; i < m_layers.x.size(); ++i) {
        const double y = above < m_layers.edges.size() ? m_layers.edges[above][i] : level;
        if (m_x->range().contains(m_layers.x[i]))
            line.append({m_layers.x[i], std::clamp(y, view.lower, view.upper)});
    }
    return line;
}

void LayerItems::place() {
    const std::size_t count = m_layers.names.size();
    QVector<QPointF> floor = edge(count, m_y->range().lower);
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        const QVector<QPointF> ceiling = edge(i, m_y->range().upper);
        QVector<QCPCurveData> outline;
        const auto add = [&](QPointF at) { outline.append({double(outline.size()), at.x(), at.y()}); };
        if (i < count) {
            std::ranges::for_each(floor, add);
            std::for_each(ceiling.rbegin(), ceiling.rend(), add);
            m_items[i].name->setText(translated(m_layers.names[i]));
        }
        m_items[i].area->data()->set(outline, true);
        placeName(*m_items[i].name, i < count ? floor : QVector<QPointF>(), ceiling);
        floor = ceiling;
    }
}

// As far to the right as there is room: layers may become wider along x.
void LayerItems::placeName(QCPItemText& name, const QVector<QPointF>& floor,
                           const QVector<QPointF>& ceiling) {
    name.setVisible(false);
    for (const double share : {0.98, 0.8, 0.6, 0.4}) {
        const auto at = static_cast<qsizetype>(share * double(floor.size() - 1));
        if (floor.size() < 2 || !hasRoom(name, floor[at], ceiling[at])) continue;
        name.setVisible(true);
        name.position->setCoords(floor[at].x(), (floor[at].y() + ceiling[at].y()) / 2);
        return;
    }
}

bool LayerItems::hasRoom(const QCPItemText& name, QPointF floor, QPointF ceiling) const {
    const double bottom = m_y->coordToPixel(floor.y()), top = m_y->coordToPixel(ceiling.y());
    const double height = QFontMetricsF(name.font()).height();
    if (bottom - top < height) return false;
    if (m_layers.clear.empty()) return true;
    const auto at = std::ranges::find(m_layers.x, floor.x()) - m_layers.x.begin();
    return std::abs(m_y->coordToPixel(m_layers.clear[std::size_t(at)]) - (bottom + top) / 2) > height;
}

void LayerItems::setStyle(const PlotStyle& style) {
    m_style = style;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        QColor shade = style.text;
        shade.setAlpha(shades[std::min(i, std::size(shades) - 1)]);
        m_items[i].area->setBrush(shade);
        m_items[i].name->setFont(style.font);
        m_items[i].name->setColor(style.text);
        m_items[i].name->setBrush(style.behindWords());  // curves may pass there
    }
}

}  // namespace drillwave

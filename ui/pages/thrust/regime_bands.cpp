// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/regime_bands.h"

#include <algorithm>
#include <cmath>

#include "core/report/feed_words.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr FeedState states[] = {FeedState::pushedBack, FeedState::belowRequired, FeedState::requiredAtThisGap,
                                FeedState::requiredMet, FeedState::returnMet};
constexpr int shades[] = {44, 28, 14, 6, 0};  // alpha of the text's colour: the worse, the darker

}  // namespace

RegimeBands::RegimeBands(QCustomPlot* plot) : QObject(plot), m_plot(plot) {
    for (std::size_t i = 0; i < bandCount; ++i) {
        m_bands[i] = new QCPCurve(plot->xAxis, plot->yAxis);
        m_bands[i]->removeFromLegend();
        m_bands[i]->setSelectable(QCP::stNone);
        m_bands[i]->setLayer(QStringLiteral("background"));
        m_bands[i]->setPen(Qt::NoPen);
        m_names[i] = new QCPItemText(plot);
        m_names[i]->setSelectable(false);
        m_names[i]->setText(coreText(feedWord(states[i])));
        m_names[i]->setPadding(QMargins(6, 1, 6, 1));
        m_names[i]->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_names[i]->setLayer(QStringLiteral("axes"));  // above the curves
        m_names[i]->setVisible(false);
    }
    connect(plot, &QCustomPlot::afterLayout, this, &RegimeBands::place);
}

void RegimeBands::present(const ThrustPicture& picture) {
    m_thresholds = {picture.balance, picture.ofThisBlow, picture.largest, picture.largestReturn};
    m_feed = picture.feed;
    place();
}

// As far as the bands are in view: files do not clip.
void RegimeBands::place() {
    const QCPRange view = m_plot->yAxis->range();
    const QCPRange along = m_plot->xAxis->range();
    const auto edge = [&](std::size_t i, double level) {
        QVector<QPointF> line;
        for (const QPointF& point : m_thresholds[std::min(i, bandCount - 2)]) {
            if (!along.contains(point.x())) continue;
            line.append(
                {point.x(), std::clamp(i < bandCount - 1 ? point.y() : level, view.lower, view.upper)});
        }
        return line;
    };
    QVector<QPointF> floor = edge(bandCount - 1, view.lower);
    for (std::size_t i = 0; i < bandCount; ++i) {
        const QVector<QPointF> ceiling = edge(i, view.upper);
        QVector<QCPCurveData> outline;
        for (const QPointF& point : floor) outline.append({double(outline.size()), point.x(), point.y()});
        for (auto point = ceiling.rbegin(); point != ceiling.rend(); ++point)
            outline.append({double(outline.size()), point->x(), point->y()});
        m_bands[i]->data()->set(outline, true);
        placeName(i, floor, ceiling);
        floor = ceiling;
    }
}

// As far to the right as there is room: along a frequency the bands are widest there.
void RegimeBands::placeName(std::size_t band, const QVector<QPointF>& floor,
                            const QVector<QPointF>& ceiling) {
    QCPItemText* name = m_names[band];
    name->setVisible(false);
    for (const double share : {0.98, 0.8, 0.6, 0.4}) {
        const auto at = static_cast<qsizetype>(share * double(floor.size() - 1));
        if (floor.size() < 2 || !hasRoom(*name, floor[at], ceiling[at])) continue;
        name->setVisible(true);
        name->position->setCoords(floor[at].x(), (floor[at].y() + ceiling[at].y()) / 2);
        return;
    }
}

bool RegimeBands::hasRoom(const QCPItemText& name, QPointF floor, QPointF ceiling) const {
    const auto pixel = [&](double force) { return m_plot->yAxis->coordToPixel(force); };
    const double height = QFontMetricsF(name.font()).height();
    if (pixel(floor.y()) - pixel(ceiling.y()) < height) return false;
    const auto feed = std::ranges::find(m_feed, floor.x(), &QPointF::x);
    const double middle = (pixel(floor.y()) + pixel(ceiling.y())) / 2;
    return feed == m_feed.end() || std::abs(pixel(feed->y()) - middle) > height;
}

void RegimeBands::setStyle(const PlotStyle& style) {
    QColor behind = style.background;
    behind.setAlpha(190);
    for (std::size_t i = 0; i < bandCount; ++i) {
        QColor shade = style.text;
        shade.setAlpha(shades[i]);
        m_bands[i]->setBrush(shade);
        m_names[i]->setFont(style.font);
        m_names[i]->setColor(style.text);
        m_names[i]->setBrush(behind);  // curves may pass there
    }
}

}  // namespace drillwave

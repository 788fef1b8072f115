// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_crosshair.h"

#include <algorithm>
#include <cmath>

#include "ui/plot/overlay.h"

namespace drillwave {
namespace {

constexpr double ringReach = 11, lineReach = 4;  // [px]
constexpr double stepsOfView = 200;

}  // namespace

MapCrosshair::MapCrosshair(QCustomPlot* plot, QCPAxisRect* map, QCPAxisRect* below, QCPAxisRect* beside)
    : QObject(plot), m_plot(plot), m_map(map) {
    const auto addLine = [plot](QCPAxisRect* rect, bool across) {
        auto* line = new QCPItemStraightLine(plot);
        line->setLayer(QStringLiteral("overlay"));
        line->setSelectable(false);
        line->setVisible(false);
        line->setClipAxisRect(rect);
        for (QCPItemPosition* end : {line->point1, line->point2}) {
            end->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
            end->setAxisRect(rect);
            end->setTypeX(across ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
            end->setTypeY(across ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
        }
        return line;
    };
    m_lines[0] = addLine(map, true);
    m_lines[1] = addLine(map, false);
    m_lines[2] = addLine(below, false);
    m_lines[3] = addLine(beside, true);
    for (QCPItemTracer** ring : {&m_halo, &m_ring}) {
        *ring = new QCPItemTracer(plot);
        (*ring)->setLayer(QStringLiteral("overlay"));
        (*ring)->setSelectable(false);
        (*ring)->setVisible(false);
        (*ring)->setClipAxisRect(map);
        (*ring)->setStyle(QCPItemTracer::tsCircle);
        (*ring)->setSize(13);
        (*ring)->position->setAxes(map->axis(QCPAxis::atBottom), map->axis(QCPAxis::atLeft));
        (*ring)->position->setAxisRect(map);
        (*ring)->position->setType(QCPItemPosition::ptPlotCoords);
    }
    plot->installEventFilter(this);
}

void MapCrosshair::setPlace(const std::optional<QPointF>& place) {
    if (place == m_place) return;
    m_place = place;
    for (QCPItemStraightLine* line : m_lines) line->setVisible(place.has_value());
    for (QCPItemTracer* ring : {m_halo, m_ring}) ring->setVisible(place.has_value());
    if (place) {
        for (const int across : {0, 3}) {
            m_lines[across]->point1->setCoords(0, place->y());
            m_lines[across]->point2->setCoords(1, place->y());
        }
        for (const int up : {1, 2}) {
            m_lines[up]->point1->setCoords(place->x(), 0);
            m_lines[up]->point2->setCoords(place->x(), 1);
        }
        for (QCPItemTracer* ring : {m_halo, m_ring}) ring->position->setCoords(*place);
    }
    redrawOverlay(*m_plot);
}

void MapCrosshair::setStyle(const PlotStyle& style) {
    for (QCPItemStraightLine* line : m_lines) line->setPen(QPen(style.text, 1, Qt::DotLine));
    // Seen on dark colours and on light ones.
    m_halo->setPen(QPen(style.background, 5));
    m_halo->setBrush(Qt::NoBrush);
    m_ring->setPen(QPen(style.text, 2.2));
    m_ring->setBrush(Qt::NoBrush);
}

QPointF MapCrosshair::pixel() const {
    return {m_map->axis(QCPAxis::atBottom)->coordToPixel(m_place->x()),
            m_map->axis(QCPAxis::atLeft)->coordToPixel(m_place->y())};
}

MapCrosshair::Part MapCrosshair::partAt(QPointF at) const {
    if (!m_place || !QRectF(m_map->rect()).adjusted(-2, -2, 2, 2).contains(at)) return Part::none;
    const QPointF away = at - pixel();
    if (std::hypot(away.x(), away.y()) <= ringReach) return Part::both;
    if (std::abs(away.x()) <= lineReach) return Part::x;
    return std::abs(away.y()) <= lineReach ? Part::y : Part::none;
}

void MapCrosshair::moveTo(QPointF to) {
    const QRectF rect = m_map->rect();
    QPointF place = *m_place;
    if (m_dragged != Part::y)
        place.setX(
            m_map->axis(QCPAxis::atBottom)->pixelToCoord(std::clamp(to.x(), rect.left(), rect.right())));
    if (m_dragged != Part::x)
        place.setY(m_map->axis(QCPAxis::atLeft)->pixelToCoord(std::clamp(to.y(), rect.top(), rect.bottom())));
    emit dragged(place);
}

bool MapCrosshair::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
    m_dragged = partAt(event.position());
    if (m_dragged == Part::none) return false;
    m_plot->setFocus(Qt::MouseFocusReason);
    emit dragStarted();
    return true;
}

bool MapCrosshair::move(const QMouseEvent& event) {
    if (m_dragged != Part::none) {
        if (m_place) moveTo(event.position());
        return true;
    }
    const Part part = event.buttons() == Qt::NoButton ? partAt(event.position()) : Part::none;
    if (part != Part::none)
        m_plot->setCursor(part == Part::both ? Qt::SizeAllCursor
                          : part == Part::x  ? Qt::SplitHCursor
                                             : Qt::SplitVCursor);
    else if (m_ownsPointer)
        m_plot->unsetCursor();
    m_ownsPointer = part != Part::none;
    return false;
}

bool MapCrosshair::release() {
    if (std::exchange(m_dragged, Part::none) == Part::none) return false;
    emit dragEnded();
    return true;
}

bool MapCrosshair::step(const QKeyEvent& event) {
    if (event.modifiers() != Qt::ControlModifier || !m_place) return false;
    QPointF to = pixel();
    const double across = m_map->width() / stepsOfView, up = m_map->height() / stepsOfView;
    switch (event.key()) {
        case Qt::Key_Left:
            to.rx() -= across;
            break;
        case Qt::Key_Right:
            to.rx() += across;
            break;
        case Qt::Key_Up:
            to.ry() -= up;
            break;
        case Qt::Key_Down:
            to.ry() += up;
            break;
        default:
            return false;
    }
    m_dragged = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right ? Part::x : Part::y;
    emit dragStarted();
    moveTo(to);
    release();
    return true;
}

bool MapCrosshair::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            return release();
        case QEvent::KeyPress:
            return step(*static_cast<QKeyEvent*>(event));
        default:
            return QObject::eventFilter(watched, event);
    }
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/crosshair.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plot/axis_rect.h"
#include "ui/plot/overlay.h"

namespace drillwave {
namespace {

constexpr double ringReach = 11, lineReach = 4;  // [px]
constexpr double stepsOfView = 200;
const QString overlay = QStringLiteral("overlay");

}  // namespace

Crosshair::Crosshair(QCPAxisRect* rect, const std::vector<QCPAxisRect*>& below,
                     const std::vector<QCPAxisRect*>& beside)
    : HereMark(rect->parentPlot(), rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)),
      m_plot(rect->parentPlot()),
      m_rect(rect),
      m_across{addLevel(rect, overlay)},
      m_halo(addItem<QCPItemTracer>(rect, overlay)) {
    for (QCPAxisRect* each : beside) m_across.push_back(addLevel(each, overlay));
    for (QCPAxisRect* each : below) {
        m_up.push_back(addItem<QCPItemStraightLine>(each, overlay));
        for (QCPItemPosition* end : m_up.back()->positions()) end->setTypeY(QCPItemPosition::ptAxisRectRatio);
        m_up.back()->setVisible(false);
    }
    m_halo->setStyle(QCPItemTracer::tsCircle);
    m_halo->setVisible(false);
    for (QCPItemTracer* each : {m_halo, ring()}) each->setSize(13);
    ring()->setLayer(overlay);  // over the halo
    m_plot->installEventFilter(this);
}

void Crosshair::setPlace(std::optional<double> x, std::optional<double> y) {
    const bool isShown = x && y;
    m_halo->setVisible(isShown);
    if (isShown) m_halo->position->setCoords(*x, *y);
    for (QCPItemStraightLine* line : m_across) setLevel(*line, y);
    for (QCPItemStraightLine* line : m_up) {
        line->setVisible(x.has_value());
        line->point1->setCoords(x.value_or(0), 0);
        line->point2->setCoords(x.value_or(0), 1);
    }
    HereMark::setPlace(x, y);
}

void Crosshair::setStyle(const PlotStyle& style) {
    HereMark::setStyle(style);
    for (const auto& lines : {m_up, m_across})
        for (QCPItemStraightLine* line : lines) line->setPen(QPen(style.text, 1, Qt::DotLine));
    // Seen on dark colours and on light ones.
    m_halo->setPen(QPen(style.background, 5));
    ring()->setPen(QPen(style.text, 2.2));
    for (QCPItemTracer* each : {m_halo, ring()}) each->setBrush(Qt::NoBrush);
}

QPointF Crosshair::pixel() const {
    return {m_rect->axis(QCPAxis::atBottom)->coordToPixel(place()->x()),
            m_rect->axis(QCPAxis::atLeft)->coordToPixel(place()->y())};
}

Crosshair::Part Crosshair::partAt(QPointF at) const {
    if (!place() || !QRectF(m_rect->rect()).adjusted(-2, -2, 2, 2).contains(at)) return Part::none;
    const QPointF away = at - pixel();
    if (std::hypot(away.x(), away.y()) <= ringReach) return Part::both;
    if (std::abs(away.x()) <= lineReach) return Part::x;
    return std::abs(away.y()) <= lineReach ? Part::y : Part::none;
}

void Crosshair::moveTo(QPointF to) {
    const QRectF rect = m_rect->rect();
    QPointF at = *place();
    if (m_dragged != Part::y)
        at.setX(m_rect->axis(QCPAxis::atBottom)->pixelToCoord(std::clamp(to.x(), rect.left(), rect.right())));
    if (m_dragged != Part::x)
        at.setY(m_rect->axis(QCPAxis::atLeft)->pixelToCoord(std::clamp(to.y(), rect.top(), rect.bottom())));
    emit dragged(at);
}

bool Crosshair::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
    m_dragged = partAt(event.position());
    if (m_dragged == Part::none) return false;
    m_plot->setFocus(Qt::MouseFocusReason);
    emit held();
    return true;
}

bool Crosshair::move(const QMouseEvent& event) {
    if (m_dragged != Part::none) {
        if (place()) moveTo(event.position());
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

bool Crosshair::step(const QKeyEvent& event) {
    if (event.modifiers() != Qt::ControlModifier || !place()) return false;
    const int key = event.key();
    const int right = (key == Qt::Key_Right) - (key == Qt::Key_Left);
    const int down = (key == Qt::Key_Down) - (key == Qt::Key_Up);
    if (right == 0 && down == 0) return false;
    m_dragged = right != 0 ? Part::x : Part::y;
    emit held();
    moveTo(pixel() + QPointF(right * m_rect->width(), down * m_rect->height()) / stepsOfView);
    m_dragged = Part::none;
    return true;
}

bool Crosshair::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            return std::exchange(m_dragged, Part::none) != Part::none;
        case QEvent::KeyPress:
            return step(*static_cast<QKeyEvent*>(event));
        default:
            return HereMark::eventFilter(watched, event);
    }
}

}  // namespace drillwave

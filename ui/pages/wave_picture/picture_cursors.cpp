// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/picture_cursors.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "ui/plot/overlay.h"

namespace drillwave {
namespace {

constexpr double lineReach = 5;  // of the mouse around a line [px]

}  // namespace

PictureCursors::PictureCursors(QCustomPlot* plot, WavePicturePlot* picture)
    : QObject(plot), m_plot(plot), m_picture(picture), m_sectionLine(addLine()), m_timeLine(addLine()) {
    m_sectionLine.label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_timeLine.label->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
    plot->setMouseTracking(true);
    plot->installEventFilter(this);
    connect(plot, &QCustomPlot::afterLayout, this, &PictureCursors::place);
}

PictureCursors::DrawnLine PictureCursors::addLine() {
    DrawnLine drawn{new QCPItemLine(m_plot), new QCPItemLine(m_plot), new QCPItemText(m_plot)};
    for (QCPItemLine* line : {drawn.halo, drawn.line}) {
        line->setLayer(QStringLiteral("overlay"));
        line->setSelectable(false);
        line->setAntialiased(false);
        for (QCPItemPosition* end : {line->start, line->end}) end->setType(QCPItemPosition::ptAbsolute);
    }
    drawn.label->setLayer(QStringLiteral("overlay"));
    drawn.label->setSelectable(false);
    drawn.label->position->setType(QCPItemPosition::ptAbsolute);
    drawn.label->setPadding(QMargins(4, 1, 4, 1));
    return drawn;
}

void PictureCursors::setStyle(const PlotStyle& style) {
    QColor halo = style.background;
    halo.setAlpha(200);
    for (const DrawnLine& drawn : {m_sectionLine, m_timeLine}) {
        drawn.halo->setPen(QPen(halo, 4));
        drawn.line->setPen(QPen(style.text, 1.5));
        drawn.label->setFont(style.font);
        drawn.label->setColor(style.text);
        drawn.label->setBrush(halo);
    }
    // Distinguishes the lines by dashes as well as by direction.
    QPen dashed(style.text, 1.5);
    dashed.setDashPattern({6, 3});
    m_sectionLine.line->setPen(dashed);
}

void PictureCursors::setSection(double xi) {
    m_section = xi;
    place();
    redraw();
}

void PictureCursors::setTime(double t) {
    m_time = t;
    place();
    redraw();
}

void PictureCursors::redraw() {
    redrawOverlay(*m_plot);
}

double PictureCursors::sectionPixel() const {
    const double factor = m_picture->picture() ? m_picture->picture()->units.position.factor : 1;
    return m_plot->xAxis->coordToPixel(m_section * factor);
}

double PictureCursors::timePixel() const {
    const double factor = m_picture->picture() ? m_picture->picture()->units.time.factor : 1;
    return m_plot->yAxis->coordToPixel(m_time * factor);
}

void PictureCursors::place() {
    const QRectF rect = m_plot->axisRect()->rect();
    const double x = sectionPixel(), y = timePixel();
    const bool shown = m_picture->shown() != nullptr;
    const auto show = [shown](const DrawnLine& drawn, QPointF from, QPointF to, bool inside) {
        for (QCPItemLine* line : {drawn.halo, drawn.line}) {
            line->start->setCoords(from);
            line->end->setCoords(to);
            line->setVisible(shown && inside);
        }
        drawn.label->setVisible(shown && inside);
    };
    show(m_sectionLine, {x, rect.bottom()}, {x, rect.top()}, x >= rect.left() && x <= rect.right() + 1);
    show(m_timeLine, {rect.left(), y}, {rect.right(), y}, y >= rect.top() && y <= rect.bottom() + 1);
    if (!shown) return;
    const QLocale locale = m_plot->locale();
    m_sectionLine.label->setText(sectionText(locale));
    const bool leftward = x > rect.center().x();
    // They are at the bottom if names of sections are at the top.
    const bool atBottom = m_picture->picture()->string.has_value();
    m_sectionLine.label->setPositionAlignment((leftward ? Qt::AlignRight : Qt::AlignLeft) |
                                              (atBottom ? Qt::AlignBottom : Qt::AlignTop));
    m_sectionLine.label->position->setCoords(x + (leftward ? -4 : 4),
                                             atBottom ? rect.bottom() - 4 : rect.top() + 4);
    m_timeLine.label->setText(tr("t = %1").arg(
        timeText(m_time, m_picture->timeInView(), m_picture->picture()->units.time, locale)));
    const bool below = y < rect.top() + 24;
    m_timeLine.label->setPositionAlignment(Qt::AlignRight | (below ? Qt::AlignTop : Qt::AlignBottom));
    m_timeLine.label->position->setCoords(rect.right() - 4, y + (below ? 4 : -4));
}

QString PictureCursors::sectionText(const QLocale& locale) const {
    const QString place = tr("x/L = %1").arg(locale.toString(m_section, 'g', 4));
    const std::optional<StringPicture>& string = m_picture->picture()->string;
    if (!string) return place;
    const RodStretch& section = string->rod.stretches[string->rod.sectionAt(m_section)];
    return section.name.isEmpty() ? place : place + QStringLiteral(" · ") + section.name;
}

PictureCursors::Line PictureCursors::lineAt(const QPointF& pixel) const {
    if (!m_picture->shown() || !QRectF(m_plot->axisRect()->rect()).adjusted(-2, -2, 2, 2).contains(pixel))
        return Line::none;
    if (std::abs(pixel.y() - timePixel()) <= lineReach) return Line::time;
    return std::abs(pixel.x() - sectionPixel()) <= lineReach ? Line::section : Line::none;
}

void PictureCursors::moveTo(const QPointF& pixel) {
    const PictureUnits& units = m_picture->picture()->units;
    const QRectF rect = m_plot->axisRect()->rect();
    if (m_dragged == Line::section) {
        const double x = std::clamp(pixel.x(), rect.left(), rect.right() + 1);
        emit sectionMoved(std::clamp(m_plot->xAxis->pixelToCoord(x) / units.position.factor, 0.0, 1.0));
    } else {
        const double y = std::clamp(pixel.y(), rect.top(), rect.bottom() + 1);
        emit timeMoved(m_plot->yAxis->pixelToCoord(y) / units.time.factor);
    }
}

bool PictureCursors::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
    m_dragged = lineAt(event.position());
    if (m_dragged == Line::none) return false;
    m_plot->setFocus(Qt::MouseFocusReason);
    return true;
}

bool PictureCursors::move(const QMouseEvent& event) {
    if (m_dragged != Line::none) {
        if (m_picture->shown()) moveTo(event.position());
        return true;
    }
    const Line line = event.buttons() == Qt::NoButton ? lineAt(event.position()) : Line::none;
    if (line != Line::none)
        m_plot->setCursor(line == Line::section ? Qt::SplitHCursor : Qt::SplitVCursor);
    else if (m_ownsCursor)
        m_plot->unsetCursor();
    m_ownsCursor = line != Line::none;
    return false;
}

bool PictureCursors::step(const QKeyEvent& event) {
    if (event.modifiers() != Qt::ControlModifier || !m_picture->shown()) return false;
    const TimeSpan view = m_picture->timeInView();
    const double timeStep = (view.end - view.begin) / 200;
    switch (event.key()) {
        case Qt::Key_Left:
            emit sectionMoved(std::max(0.0, m_section - 0.01));
            return true;
        case Qt::Key_Right:
            emit sectionMoved(std::min(1.0, m_section + 0.01));
            return true;
        case Qt::Key_Up:
            emit timeMoved(m_time + timeStep);
            return true;
        case Qt::Key_Down:
            emit timeMoved(m_time - timeStep);
            return true;
        default:
            return false;
    }
}

bool PictureCursors::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            return std::exchange(m_dragged, Line::none) != Line::none;
        case QEvent::KeyPress:
            return step(*static_cast<QKeyEvent*>(event));
        default:
            return QObject::eventFilter(watched, event);
    }
}

}  // namespace drillwave

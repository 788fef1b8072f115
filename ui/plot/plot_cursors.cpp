// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_cursors.h"

#include <cmath>

namespace drillwave {
namespace {

constexpr double grabDistance = 5;  // [px]

struct Look {
    QString name;
    QVector<qreal> dashes;
    double width;
};

const Look& lookOf(PlotCursor cursor) {
    static const Look looks[] = {
        {QStringLiteral("A"), {}, 1.2},
        {QStringLiteral("B"), {7, 3}, 1.2},
        {QStringLiteral("t"), {2, 2}, 1.6},
    };
    return looks[static_cast<int>(cursor)];
}

}  // namespace

QList<QCPAxisRect*> PlotCursors::rects() const {
    QList<QCPAxisRect*> rects;
    for (QCPAxisRect* rect : m_plot.axisRects())
        if (!rect->graphs().isEmpty()) rects.append(rect);
    return rects;
}

void PlotCursors::place(PlotCursor cursor, std::optional<double> x) {
    if (x && !std::isfinite(*x)) x.reset();
    Cursor& placed = of(cursor);
    placed.x = x;
    if (x && placed.lines.isEmpty()) addItems(cursor);
    for (const auto& line : placed.lines) {
        if (!line) continue;
        line->setVisible(x.has_value());
        if (!x) continue;
        line->point1->setCoords(*x, 0);
        line->point2->setCoords(*x, 1);
    }
    if (!placed.label) return;
    placed.label->setVisible(x.has_value());
    if (x) placed.label->position->setCoords(*x, cursor == PlotCursor::time ? 1 : 0);
}

void PlotCursors::addItems(PlotCursor cursor) {
    Cursor& placed = of(cursor);
    const auto follow = [](QCPItemPosition& position, QCPAxisRect* rect) {
        position.setAxisRect(rect);
        position.setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
        position.setTypeX(QCPItemPosition::ptPlotCoords);
        position.setTypeY(QCPItemPosition::ptAxisRectRatio);
    };
    for (QCPAxisRect* rect : rects()) {
        auto* line = new QCPItemStraightLine(&m_plot);
        line->setLayer(QStringLiteral("overlay"));
        line->setSelectable(false);
        line->setClipAxisRect(rect);
        follow(*line->point1, rect);
        follow(*line->point2, rect);
        placed.lines.append(line);
    }
    if (placed.lines.isEmpty()) return;
    QCPAxisRect* rect = cursor == PlotCursor::time ? rects().last() : rects().first();
    placed.label = new QCPItemText(&m_plot);
    placed.label->setLayer(QStringLiteral("overlay"));
    placed.label->setSelectable(false);
    placed.label->setClipAxisRect(rect);
    placed.label->setText(lookOf(cursor).name);
    placed.label->setPadding(QMargins(3, 0, 3, 0));
    placed.label->setPositionAlignment((cursor == PlotCursor::time ? Qt::AlignBottom : Qt::AlignTop) |
                                       Qt::AlignHCenter);
    follow(*placed.label->position, rect);
    applyStyle(cursor);
}

std::optional<PlotCursor> PlotCursors::cursorAt(QPointF point) const {
    const QCPAxisRect* rect = m_plot.axisRectAt(point);
    if (!rect || rect->graphs().isEmpty()) return std::nullopt;
    for (const PlotCursor cursor : {PlotCursor::a, PlotCursor::b, PlotCursor::time}) {
        const std::optional<double> x = position(cursor);
        if (x && std::abs(rect->axis(QCPAxis::atBottom)->coordToPixel(*x) - point.x()) <= grabDistance)
            return cursor;
    }
    return std::nullopt;
}

void PlotCursors::setStyle(const PlotStyle& style) {
    m_style = style;
    for (const PlotCursor cursor : {PlotCursor::a, PlotCursor::b, PlotCursor::time}) applyStyle(cursor);
}

void PlotCursors::applyStyle(PlotCursor cursor) {
    const Look& look = lookOf(cursor);
    QPen pen(m_style.text, look.width);
    if (!look.dashes.isEmpty()) pen.setDashPattern(look.dashes);
    for (const auto& line : of(cursor).lines)
        if (line) line->setPen(pen);
    QCPItemText* label = of(cursor).label;
    if (!label) return;
    label->setFont(m_style.font);
    label->setColor(m_style.background);
    label->setBrush(m_style.text);
    label->setPen(Qt::NoPen);
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/run_marks.h"

#include <QHash>
#include <algorithm>
#include <cmath>

#include "ui/plot/run_pen.h"

namespace drillwave {
namespace {

constexpr double pointSize = 9;  // [px]

// Results that are alike differ by the errors of their solutions all the same.
bool isSamePlace(const QPointF& a, const QPointF& b) {
    constexpr double alike = 1e-9;
    const auto isNear = [](double one, double other) {
        return std::abs(one - other) <= alike * std::max(std::abs(one), std::abs(other));
    };
    return isNear(a.x(), b.x()) && isNear(a.y(), b.y());
}

// Runs at one place are one mark, with their letters.
QVector<RunMark> together(const QVector<RunMark>& marks) {
    QVector<RunMark> places;
    QHash<qsizetype, QStringList> letters;
    for (const RunMark& mark : marks) {
        const auto same =
            std::ranges::find_if(places, [&](const RunMark& each) { return isSamePlace(each.at, mark.at); });
        const qsizetype place = same - places.begin();
        if (same == places.end()) places.append(mark);
        letters[place] << mark.title.left(1);
    }
    for (qsizetype i = 0; i < places.size(); ++i)
        if (letters[i].size() > 1) places[i].title = letters[i].join(QStringLiteral(", "));
    return places;
}

}  // namespace

RunMarks::RunMarks(QCustomPlot* plot, QCPAxis* x, QCPAxis* y)
    : QObject(plot), m_plot(plot), m_x(x), m_y(y), m_style(PlotStyle::forPaper()) {}

bool RunMarks::present(const QVector<RunMark>& marks) {
    if (marks == m_marks) return false;
    m_marks = marks;
    draw();
    return true;
}

void RunMarks::setStyle(const PlotStyle& style) {
    m_style = style;
    draw();
}

void RunMarks::draw() {
    for (QCPAbstractItem* item : std::as_const(m_items)) m_plot->removeItem(item);
    m_items.clear();
    QColor behind = m_style.background;
    behind.setAlpha(190);
    for (const RunMark& mark : together(m_marks)) {
        const QColor colour = runPen(mark.number, m_style).color();
        auto* point = new QCPItemTracer(m_plot);
        point->setStyle(QCPItemTracer::tsSquare);
        point->setSize(pointSize);
        point->setPen(QPen(m_style.background, 1));
        point->setBrush(colour);
        auto* text = new QCPItemText(m_plot);
        text->setText(mark.title);
        text->setFont(m_style.font);
        text->setColor(colour);
        text->setBrush(behind);
        text->setPadding(QMargins(3, 1, 3, 1));
        text->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
        for (QCPItemPosition* position : {point->position, text->position}) {
            position->setType(QCPItemPosition::ptPlotCoords);
            position->setAxes(m_x, m_y);
            position->setAxisRect(m_x->axisRect());
            position->setCoords(mark.at);
        }
        for (QCPAbstractItem* item :
             {static_cast<QCPAbstractItem*>(text), static_cast<QCPAbstractItem*>(point)}) {
            item->setLayer(QStringLiteral("legend"));  // above the curves
            item->setSelectable(false);
            item->setClipAxisRect(m_x->axisRect());
            m_items.append(item);
        }
    }
}

}  // namespace drillwave

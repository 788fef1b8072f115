// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/run_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/label_places.h"
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

// Marks at one place.
struct Place {
    RunMark mark;
    QStringList letters;
};

// Runs at one place are one mark, with their letters.
QVector<Place> together(const QVector<RunMark>& marks) {
    QVector<Place> places;
    for (const RunMark& mark : marks) {
        const auto isSame = [&mark](const Place& place) { return isSamePlace(place.mark.at, mark.at); };
        auto same = std::ranges::find_if(places, isSame);
        if (same == places.end()) {
            places.append({mark, {}});
            same = std::prev(places.end());
        }
        same->letters << mark.title.left(1);
    }
    for (Place& place : places)
        if (place.letters.size() > 1) place.mark.title = place.letters.join(QStringLiteral(", "));
    return places;
}

double overlap(const QRectF& rect, const QVector<QRectF>& others) {
    double area = 0;
    for (const QRectF& other : others) {
        const QRectF both = rect & other;
        area += both.width() * both.height();
    }
    return area;
}

}  // namespace

RunMarks::RunMarks(QCustomPlot* plot, QCPAxis* x, QCPAxis* y)
    : QObject(plot), m_plot(plot), m_x(x), m_y(y), m_style(PlotStyle::forPaper()) {
    connect(plot, &QCustomPlot::afterLayout, this, &RunMarks::placeNames);
}

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
    for (const Drawn& drawn : std::as_const(m_drawn)) {
        m_plot->removeItem(drawn.point);
        m_plot->removeItem(drawn.name);
    }
    m_drawn.clear();
    for (const auto& [mark, letters] : together(m_marks)) {
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
        text->setBrush(m_style.behindWords());
        text->setPadding(QMargins(8, 2, 8, 2));  // clear of the ring of the present scenario
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
        }
        m_drawn.append({mark, letters.join(QStringLiteral(", ")), point, text});
    }
}

// Returns the rects of other texts on the axes of the marks, and of the points themselves.
QVector<QRectF> RunMarks::taken() const {
    QVector<QRectF> rects;
    const QCPAxisRect* axes = m_x->axisRect();
    const auto isOwn = [this](const QCPItemText* text) {
        return std::ranges::any_of(m_drawn, [text](const Drawn& each) { return each.name == text; });
    };
    for (int i = 0; i < m_plot->itemCount(); ++i) {
        const auto* text = qobject_cast<QCPItemText*>(m_plot->item(i));
        if (text && text->realVisibility() && text->clipAxisRect() == axes && !isOwn(text))
            rects.append(rectOf(*text));
    }
    for (const QCPLayoutElement* element : axes->insetLayout()->elements(false))
        if (element && element->realVisibility()) rects.append(element->outerRect());
    for (const Drawn& drawn : m_drawn) {
        const QPointF at = drawn.point->position->pixelPosition();
        rects.append(QRectF(at, at).adjusted(-pointSize / 2, -pointSize / 2, pointSize / 2, pointSize / 2));
    }
    return rects;
}

// Places the names for the present view: marks that are apart in one view may coincide in another.
void RunMarks::placeNames() {
    if (m_drawn.isEmpty()) return;
    QVector<QRectF> rects = taken();
    const QRectF room = m_x->axisRect()->rect();
    for (const Drawn& drawn : std::as_const(m_drawn)) {
        double least = std::numeric_limits<double>::infinity();
        QString text;
        Qt::Alignment side;
        for (const QString& name : {drawn.mark.title, drawn.letters}) {
            for (const Qt::Alignment each :
                 {Qt::AlignLeft | Qt::AlignBottom, Qt::AlignRight | Qt::AlignBottom,
                  Qt::AlignLeft | Qt::AlignTop, Qt::AlignRight | Qt::AlignTop}) {
                drawn.name->setText(name);
                drawn.name->setPositionAlignment(each);
                const QRectF rect = rectOf(*drawn.name);
                const QRectF inside = rect & room;
                const double cut = rect.width() * rect.height() - inside.width() * inside.height();
                // Each name also overlaps its own point.
                const double lost = cut + overlap(rect, rects);
                if (lost < least - 1) {
                    least = lost;
                    text = name;
                    side = each;
                }
            }
            if (least <= pointSize * pointSize / 4 + 1) break;
        }
        drawn.name->setText(text);
        drawn.name->setPositionAlignment(side);
        rects.append(rectOf(*drawn.name));
    }
}

}  // namespace drillwave

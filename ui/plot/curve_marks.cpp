// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_marks.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "ui/plot/label_places.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int mostNamed = 6;  // of kinks, and of crossings
constexpr int mostNamedExtremes = 8;
constexpr int gapToPoint = 5;              // [px]
constexpr char goalProperty[] = "isGoal";  // of points, which are filled then
constexpr int unreadable = 1000;           // words over other words, worse than over any curve

// Possible places of words at their point, the best first: QCPItemText puts its own corner there.
constexpr Qt::Alignment alignments[] = {Qt::AlignLeft | Qt::AlignBottom,    Qt::AlignRight | Qt::AlignBottom,
                                        Qt::AlignLeft | Qt::AlignTop,       Qt::AlignRight | Qt::AlignTop,
                                        Qt::AlignHCenter | Qt::AlignBottom, Qt::AlignHCenter | Qt::AlignTop};

QRectF boxOf(QPointF at, QSizeF size, Qt::Alignment alignment) {
    const double left = alignment & Qt::AlignLeft    ? at.x()
                        : alignment & Qt::AlignRight ? at.x() - size.width()
                                                     : at.x() - size.width() / 2;
    return {QPointF(left, alignment & Qt::AlignTop ? at.y() : at.y() - size.height()), size};
}

// Counts what words would hide there: points, and other words at the weight `unreadable`.
int hitsOf(const QRectF& box, const QPolygonF& curve, const QVector<QRectF>& taken, const QRectF& inside) {
    const QRectF words = box.adjusted(gapToPoint, gapToPoint, -gapToPoint, -gapToPoint);
    int hits = inside.contains(words) ? 0 : 2 * unreadable;
    for (const QRectF& other : taken) hits += other.intersects(words) ? unreadable : 0;
    return hits + static_cast<int>(std::ranges::count_if(
                      curve, [&](const QPointF& point) { return words.contains(point); }));
}

// Returns all curves in view of the rect, along their lines as well: words could hide lines between points.
QPolygonF inPixels(const QCPAxisRect& rect) {
    constexpr double step = 4;  // [px], less than a letter
    const QRectF inside = rect.rect();
    QPolygonF points;
    for (const QCPGraph* graph : rect.graphs()) {
        if (!graph->realVisibility()) continue;
        std::optional<QPointF> before;
        for (auto point = graph->data()->constBegin(); point != graph->data()->constEnd(); ++point) {
            const QPointF at = graph->coordsToPixels(point->key, point->value);
            if (before && QRectF(*before, at).normalized().adjusted(-1, -1, 1, 1).intersects(inside)) {
                const double way = std::min(QLineF(*before, at).length(), 10 * inside.width());
                for (double gone = step; gone < way; gone += step)
                    points.append(*before + gone / way * (at - *before));
            }
            points.append(at);
            before = at;
        }
    }
    return points;
}

// Returns markers of other things in the rect, and labels with a fixed place, which words must not cover.
QVector<QRectF> markersIn(QCPAxisRect& rect, const QVector<QCPItemTracer*>& own) {
    QVector<QRectF> found;
    const QCustomPlot& plot = *rect.parentPlot();
    for (int i = 0; i < plot.itemCount(); ++i) {
        const auto* label = qobject_cast<QCPItemText*>(plot.item(i));
        if (label && label->visible() && label->objectName() == QLatin1String(fixedLabel) &&
            label->clipAxisRect() == &rect)
            found.append(rectOf(*label));
        auto* marker = qobject_cast<QCPItemTracer*>(plot.item(i));
        if (!marker || !marker->visible() || own.contains(marker)) continue;
        if (marker->clipAxisRect() != &rect) continue;
        const double half = marker->size() / 2;
        const QPointF at = marker->position->pixelPosition();
        found.append({at - QPointF(half, half), QSizeF(2 * half, 2 * half)});
    }
    return found;
}

QString wordsOf(const CurveMark& mark, const ShownUnit& xUnit, const ShownUnit& yUnit,
                const QLocale& locale) {
    const auto shown = [&](double value, const ShownUnit& unit) {
        const QString number = numberText(value, 5, locale);
        return unit.unit.isEmpty() || unit.dimensionless ? number : number + QChar(QChar::Nbsp) + unit.unit;
    };
    const QString place = shown(mark.at.x(), xUnit);
    switch (mark.kind) {
        case CurveMark::Kind::extreme:
            return CurveMarks::tr("%1 at %2").arg(shown(mark.at.y(), yUnit), place);
        case CurveMark::Kind::goal:
        case CurveMark::Kind::crossing:
            return place;
        case CurveMark::Kind::kink:
            break;
    }
    return CurveMarks::tr("kink %1").arg(place);
}

}  // namespace

CurveMarks::CurveMarks(QCPGraph* graph)
    : QObject(graph->parentPlot()), m_graph(graph), m_style(PlotStyle::forPaper()) {
    connect(graph->parentPlot(), &QCustomPlot::afterLayout, this, &CurveMarks::placeWords);
}

void CurveMarks::present(const QVector<CurveMark>& marks, const ShownUnit& x, const ShownUnit& y) {
    clear();
    const auto isNamed = [&](CurveMark::Kind kind) {
        const auto count = std::ranges::count(marks, kind, &CurveMark::kind);
        return count <= (kind == CurveMark::Kind::extreme ? mostNamedExtremes : mostNamed);
    };
    const QLocale locale = m_graph->parentPlot()->locale();
    QVector<CurveMark> byWeight = marks;  // later ones lose their words if there is no room
    std::ranges::stable_sort(byWeight, {}, &CurveMark::kind);
    for (const CurveMark& mark : byWeight)
        add(mark, isNamed(mark.kind) ? wordsOf(mark, x, y, locale) : QString());
    applyStyle();
}

void CurveMarks::clear() {
    for (QCPItemTracer* point : m_points) m_graph->parentPlot()->removeItem(point);
    for (QCPItemText* words : m_words) m_graph->parentPlot()->removeItem(words);
    m_points.clear();
    m_words.clear();
}

void CurveMarks::add(const CurveMark& mark, const QString& words) {
    const auto prepare = [&](QCPAbstractItem& item, QCPItemPosition& position) {
        item.setSelectable(false);
        item.setClipAxisRect(m_graph->keyAxis()->axisRect());
        position.setAxes(m_graph->keyAxis(), m_graph->valueAxis());
        position.setCoords(mark.at);
    };
    auto* point = new QCPItemTracer(m_graph->parentPlot());
    prepare(*point, *point->position);
    point->setStyle(mark.kind == CurveMark::Kind::kink ? QCPItemTracer::tsSquare : QCPItemTracer::tsCircle);
    point->setSize(mark.kind == CurveMark::Kind::kink ? 5 : mark.kind == CurveMark::Kind::goal ? 9 : 7);
    point->setProperty(goalProperty, mark.kind == CurveMark::Kind::goal);
    m_points.append(point);
    if (words.isEmpty()) return;
    auto* text = new QCPItemText(m_graph->parentPlot());
    prepare(*text, *text->position);
    text->setPadding(QMargins(gapToPoint, gapToPoint, gapToPoint, gapToPoint));
    text->setText(words);
    m_words.append(text);
}

void CurveMarks::setStyle(const PlotStyle& style) {
    m_style = style;
    applyStyle();
}

void CurveMarks::applyStyle() {
    for (QCPItemTracer* point : m_points) {
        point->setPen(QPen(m_graph->pen().color(), 1.5));
        point->setBrush(point->property(goalProperty).toBool() ? QBrush(m_graph->pen().color())
                                                               : QBrush(m_style.background));
    }
    for (QCPItemText* words : m_words) {
        words->setFont(m_style.font);
        words->setColor(m_style.text);
        words->setBrush(m_style.behindWords());
    }
}

// Returns the points that words must not cover: all except the one that they name.
QVector<QRectF> CurveMarks::ownPointsBut(QPointF named) const {
    QVector<QRectF> found;
    for (const QCPItemTracer* point : m_points) {
        const QPointF at = point->position->pixelPosition();
        const double half = point->size() / 2;
        if (at != named) found.append({at - QPointF(half, half), QSizeF(2 * half, 2 * half)});
    }
    return found;
}

void CurveMarks::placeWords() {
    if (m_words.isEmpty()) return;
    const QPolygonF curve = inPixels(*m_graph->keyAxis()->axisRect());
    const QRectF inside = m_graph->keyAxis()->axisRect()->rect();
    QVector<QRectF> taken = markersIn(*m_graph->keyAxis()->axisRect(), m_points);
    for (QCPItemText* words : m_words) {
        const QPointF at = words->position->pixelPosition();
        const bool isInView = inside.adjusted(-1, -1, 1, 1).contains(at);
        words->setVisible(isInView);
        if (!isInView) continue;
        const QSizeF size =
            QFontMetricsF(words->font()).size(0, words->text()) + QSizeF(2 * gapToPoint, 2 * gapToPoint);
        const QVector<QRectF> others = taken + ownPointsBut(at);
        int least = std::numeric_limits<int>::max();
        QRectF best;
        for (const Qt::Alignment alignment : alignments) {
            const QRectF box = boxOf(at, size, alignment);
            const int hits = hitsOf(box, curve, others, inside);
            if (hits >= least) continue;
            least = hits;
            best = box;
            words->setPositionAlignment(alignment);
        }
        words->setVisible(least < unreadable);
        if (words->visible()) taken.append(best);
    }
}

}  // namespace drillwave

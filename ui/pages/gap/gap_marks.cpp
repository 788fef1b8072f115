// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_marks.h"

#include <algorithm>
#include <limits>

#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int mostNamedKinks = 6;
constexpr int gapToPoint = 5;     // [px]
constexpr int unreadable = 1000;  // worse than any curve behind words

// Where words may stand beside their point, the best first: QCPItemText aligns that corner of itself with it.
constexpr Qt::Alignment alignments[] = {Qt::AlignLeft | Qt::AlignBottom,    Qt::AlignRight | Qt::AlignBottom,
                                        Qt::AlignLeft | Qt::AlignTop,       Qt::AlignRight | Qt::AlignTop,
                                        Qt::AlignHCenter | Qt::AlignBottom, Qt::AlignHCenter | Qt::AlignTop};

QRectF boxOf(QPointF at, QSizeF size, Qt::Alignment alignment) {
    const double left = alignment & Qt::AlignLeft    ? at.x()
                        : alignment & Qt::AlignRight ? at.x() - size.width()
                                                     : at.x() - size.width() / 2;
    return {QPointF(left, alignment & Qt::AlignTop ? at.y() : at.y() - size.height()), size};
}

// How much would be hidden behind words there.
int hitsOf(const QRectF& box, const QPolygonF& curve, const QVector<QRectF>& taken, const QRectF& inside) {
    const QRectF words = box.adjusted(gapToPoint, gapToPoint, -gapToPoint, -gapToPoint);
    int hits = inside.contains(words) ? 0 : 2 * unreadable;
    for (const QRectF& other : taken) hits += other.intersects(words) ? unreadable : 0;
    return hits + static_cast<int>(std::ranges::count_if(
                      curve, [&](const QPointF& point) { return words.contains(point); }));
}

QPolygonF inPixels(const QCPGraph& graph) {
    QPolygonF points;
    for (auto point = graph.data()->constBegin(); point != graph.data()->constEnd(); ++point)
        points.append(graph.coordsToPixels(point->key, point->value));
    return points;
}

QString wordsOf(const GapMark& mark, const GapPicture& picture, const QLocale& locale) {
    const auto shown = [&](double value, const ShownUnit& unit) {
        const QString number = numberText(value, 4, locale);
        return unit.unit.isEmpty() || unit.dimensionless ? number : number + QChar(QChar::Nbsp) + unit.unit;
    };
    const QString gap = shown(mark.at.x(), picture.gap);
    switch (mark.kind) {
        case GapMark::Kind::extreme:
            return GapMarks::tr("%1 at %2").arg(shown(mark.at.y(), picture.value), gap);
        case GapMark::Kind::crossing:
            return gap;
        case GapMark::Kind::kink:
            break;
    }
    return GapMarks::tr("kink %1").arg(gap);
}

}  // namespace

GapMarks::GapMarks(QCPGraph* graph)
    : QObject(graph->parentPlot()), m_graph(graph), m_style(PlotStyle::forPaper()) {
    connect(graph->parentPlot(), &QCustomPlot::afterLayout, this, &GapMarks::placeWords);
}

void GapMarks::present(const GapPicture& picture) {
    clear();
    const auto isKink = [](const GapMark& mark) { return mark.kind == GapMark::Kind::kink; };
    const bool namesKinks = std::ranges::count_if(picture.marks, isKink) <= mostNamedKinks;
    const QLocale locale = m_graph->parentPlot()->locale();
    // Where there is no room for all words, those of extremes are the last to go.
    QVector<GapMark> marks = picture.marks;
    std::ranges::stable_sort(marks, {}, &GapMark::kind);
    for (const GapMark& mark : std::as_const(marks))
        add(mark, isKink(mark) && !namesKinks ? QString() : wordsOf(mark, picture, locale));
    applyStyle();
}

void GapMarks::clear() {
    for (QCPItemTracer* point : m_points) m_graph->parentPlot()->removeItem(point);
    for (QCPItemText* words : m_words) m_graph->parentPlot()->removeItem(words);
    m_points.clear();
    m_words.clear();
}

void GapMarks::add(const GapMark& mark, const QString& words) {
    const auto prepare = [&](QCPAbstractItem& item, QCPItemPosition& position) {
        item.setSelectable(false);
        item.setClipAxisRect(m_graph->keyAxis()->axisRect());
        position.setAxes(m_graph->keyAxis(), m_graph->valueAxis());
        position.setCoords(mark.at);
    };
    auto* point = new QCPItemTracer(m_graph->parentPlot());
    prepare(*point, *point->position);
    point->setStyle(mark.kind == GapMark::Kind::kink ? QCPItemTracer::tsSquare : QCPItemTracer::tsCircle);
    point->setSize(mark.kind == GapMark::Kind::kink ? 5 : 7);
    m_points.append(point);
    if (words.isEmpty()) return;
    auto* text = new QCPItemText(m_graph->parentPlot());
    prepare(*text, *text->position);
    text->setPadding(QMargins(gapToPoint, gapToPoint, gapToPoint, gapToPoint));
    text->setText(words);
    m_words.append(text);
}

void GapMarks::setStyle(const PlotStyle& style) {
    m_style = style;
    applyStyle();
}

void GapMarks::applyStyle() {
    for (QCPItemTracer* point : m_points) {
        point->setPen(QPen(m_style.lines[0], 1.5));
        point->setBrush(m_style.background);
    }
    for (QCPItemText* words : m_words) {
        words->setFont(m_style.font);
        words->setColor(m_style.text);
    }
}

void GapMarks::placeWords() {
    if (m_words.isEmpty()) return;
    const QPolygonF curve = inPixels(*m_graph);
    const QRectF inside = m_graph->keyAxis()->axisRect()->rect();
    QVector<QRectF> taken;
    for (QCPItemText* words : m_words) {
        const QPointF at = words->position->pixelPosition();
        const bool isInView = inside.adjusted(-1, -1, 1, 1).contains(at);
        words->setVisible(isInView);
        if (!isInView) continue;
        const QSizeF size =
            QFontMetricsF(words->font()).size(0, words->text()) + QSizeF(2 * gapToPoint, 2 * gapToPoint);
        int least = std::numeric_limits<int>::max();
        QRectF best;
        for (const Qt::Alignment alignment : alignments) {
            const QRectF box = boxOf(at, size, alignment);
            const int hits = hitsOf(box, curve, taken, inside);
            if (hits >= least) continue;
            least = hits;
            best = box;
            words->setPositionAlignment(alignment);
        }
        words->setVisible(least < unreadable);
        if (least < unreadable) taken.append(best);
    }
}

}  // namespace drillwave

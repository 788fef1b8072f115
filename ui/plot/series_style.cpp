// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/series_style.h"

#include <algorithm>
#include <iterator>

namespace drillwave {
namespace {

enum class Filling { none, paper, ink };

/// Marks that are the same for all series of a kind.
struct MarkLook {
    SeriesPoints points;
    QCPScatterStyle::ScatterShape shape;
    double pen;  // [px]
    Filling filling;
    double size;  // [px]
};
constexpr MarkLook markLooks[] = {
    {SeriesPoints::beads, QCPScatterStyle::ssDisc, 1, Filling::ink, 4},
    {SeriesPoints::stars, QCPScatterStyle::ssStar, 2, Filling::none, 15},
    {SeriesPoints::dots, QCPScatterStyle::ssDisc, 1, Filling::ink, 3},
    {SeriesPoints::discs, QCPScatterStyle::ssDisc, 1, Filling::ink, 7},
    {SeriesPoints::rings, QCPScatterStyle::ssCircle, 1, Filling::paper, 5},
    {SeriesPoints::circles, QCPScatterStyle::ssCircle, 1.2, Filling::none, 12},
    {SeriesPoints::diamonds, QCPScatterStyle::ssDiamond, 1.4, Filling::ink, 12},
    {SeriesPoints::openDiamonds, QCPScatterStyle::ssDiamond, 1.4, Filling::paper, 12},
    {SeriesPoints::squares, QCPScatterStyle::ssSquare, 1.5, Filling::paper, 7},
    {SeriesPoints::here, QCPScatterStyle::ssCircle, 2, Filling::paper, 10}};

QPen dashedPen(const QColor& colour, double width, const QList<qreal>& dashes) {
    QPen pen(colour, width);
    pen.setDashPattern(dashes);
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

}  // namespace

QCPScatterStyle scatterOf(SeriesPoints points, std::size_t index, const QColor& colour,
                          const PlotStyle& style) {
    using Look = QCPScatterStyle;
    // Shape, colour and filling of series differ, never only the colour.
    constexpr Look::ScatterShape shapes[] = {Look::ssDisc,    Look::ssSquare,          Look::ssTriangle,
                                             Look::ssDiamond, Look::ssCross,           Look::ssPlus,
                                             Look::ssCircle,  Look::ssTriangleInverted};
    if (points == SeriesPoints::none) return {};
    const auto look = std::ranges::find(markLooks, points, &MarkLook::points);
    if (look == std::end(markLooks))
        return {shapes[index % std::size(shapes)], QPen(colour, 1.3), style.background,
                points == SeriesPoints::joined ? 6.0 : 5.0};
    const QColor& ink = points <= SeriesPoints::discs ? colour : style.text;
    const QBrush filling = look->filling == Filling::ink     ? QBrush(ink)
                           : look->filling == Filling::paper ? QBrush(style.background)
                                                             : QBrush(Qt::NoBrush);
    return {look->shape, QPen(ink, look->pen), filling, look->size};
}

QPen penOf(const FigureSeries& series, const PlotStyle& style) {
    const auto role = static_cast<int>(series.role);
    QPen pen = series.isFaint ? style.ghostPen(role) : style.linePen(role);
    switch (series.stroke) {
        case SeriesStroke::usual:
            break;
        case SeriesStroke::wide:
            pen.setWidthF(1.6 * pen.widthF());
            break;
        case SeriesStroke::dotted:
            return dashedPen(pen.color(), 0.6 * pen.widthF(), {2, 3});
        case SeriesStroke::dashed:
            return dashedPen(style.text, pen.widthF(), {7, 5});
        case SeriesStroke::strong:
            return {style.text, 2.4};
        case SeriesStroke::shortDashed:
            return dashedPen(style.text, pen.widthF(), {2, 2});
        case SeriesStroke::none:
            pen.setStyle(Qt::NoPen);
    }
    return pen;
}

bool isLine(const FigureSeries& series) {
    const bool hasLine = series.points == SeriesPoints::none || series.points == SeriesPoints::joined ||
                         series.points == SeriesPoints::beads;
    return hasLine && (series.stroke != SeriesStroke::none || !series.upper.empty());
}

}  // namespace drillwave

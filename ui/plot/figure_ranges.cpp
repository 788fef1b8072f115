// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of the axes of a figure that have all of it in view.
#include "ui/plot/figure_frame.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

QCPRange withMargin(QCPRange range, double share, bool isLogarithmic) {
    if (isLogarithmic && range.lower > 0) {
        const double factor = std::pow(range.upper / range.lower, share);
        return {range.lower / factor, range.upper * factor};
    }
    return {range.lower - share * range.size(), range.upper + share * range.size()};
}

// Leaves room around points on a logarithmic axis, and beyond them a factor for words beside them.
QCPRange aroundPoints(QCPRange range, const StudyPanel& panel, double forWords) {
    constexpr double room = 3;
    const bool hasTexts =
        std::ranges::any_of(panel.series, [](const auto& each) { return !each.texts.empty(); });
    return {range.lower / room, range.upper * (hasTexts ? room * forWords : room)};
}

void expand(std::optional<QCPRange>& all, const QCPRange& more, bool isThere) {
    if (!isThere) return;
    if (all)
        all->expand(more);
    else
        all = more;
}

}  // namespace

bool FigureFrame::hasPoints(const StudyPanel& panel) {
    return std::ranges::any_of(panel.series, [](const auto& each) {
        return each.points != SeriesPoints::none && each.points != SeriesPoints::rings;
    });
}

void FigureFrame::setRanges() {
    if (isEmpty()) return;
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        if (i == 0 || !panelOf(i).sharesX) setKeyRange(i);
        if (hasFirstY(i)) setValueRange(i, QCPAxis::atLeft);
        if (panelOf(i).right) setValueRange(i, QCPAxis::atRight);
    }
}

void FigureFrame::setKeyRange(std::size_t index) {
    const StudyPanel& panel = panelOf(index);
    std::optional<QCPRange> keys;
    bool isFromZero = false;
    for (std::size_t each = 0; each < panel.series.size(); ++each) {
        const Drawn& drawn = m_panels[index].series[each];
        bool isThere = false;
        const QCPRange along =
            drawn.line ? drawn.line->getKeyRange(isThere) : drawn.path->getKeyRange(isThere);
        if (!panel.series[each].isOnTop) expand(keys, along, isThere);
        isFromZero |= panel.series[each].kind == SeriesKind::area && along.lower == 0;
    }
    QCPAxis* bottom = axisOf(index, QCPAxis::atBottom);
    const double factor = xFactorOf(index);
    if (panel.x.range)
        bottom->setRange(panel.x.range->first * factor, panel.x.range->second * factor);
    else if (isFromZero)
        bottom->setRange(0, keys && keys->upper > 0 ? 1.05 * keys->upper : 100);
    else if (keys)
        bottom->setRange(hasPoints(panel) ? aroundPoints(*keys, panel, 12)
                                          : withMargin(*keys, 0.02, panel.x.isLogarithmic));
    if (panel.top && panel.top->range)
        axisOf(index, QCPAxis::atTop)->setRange(panel.top->range->first, panel.top->range->second);
}

// All values of a row and its levels; of the first one those of pinned runs too.
std::optional<QCPRange> FigureFrame::valuesOf(std::size_t first, bool isRight) const {
    std::optional<QCPRange> values;
    bool isThere = false;
    for (std::size_t i = first; i <= m_panels[first].last; ++i)
        for (std::size_t each = 0; each < panelOf(i).series.size(); ++each) {
            if (panelOf(i).series[each].isOnRight != isRight) continue;
            const Drawn& drawn = m_panels[i].series[each];
            const QCPRange range =
                drawn.line ? drawn.line->getValueRange(isThere) : drawn.path->getValueRange(isThere);
            expand(values, range, isThere);
            if (!drawn.upper) continue;
            const QCPRange upper = drawn.upper->getValueRange(isThere);
            expand(values, upper, isThere);
        }
    if (isRight) return values;
    if (m_panels[first].runs)
        for (const RunMark& run : m_panels[first].runs->marks())
            expand(values, QCPRange(run.at.y(), run.at.y()), true);
    for (const FigureLevel& level : m_shown.figure.levels)
        if (level.row == panelOf(first).row && level.isInView)
            expand(values, QCPRange(level.y * yFactorOf(first), level.y * yFactorOf(first)), true);
    for (QCPGraph* run : first > 0 ? QVector<QCPGraph*>() : runCurves()) {
        const QCPRange range = run->getValueRange(isThere);
        expand(values, range, isThere);
    }
    for (const FigureLevel& level : m_shown.figure.levels) {
        if (level.row != panelOf(first).row || level.isInView || !values) continue;
        const double y = level.y * yFactorOf(first);
        if (values->expanded(QCPRange(y, y)).size() <= 2 * values->size()) values->expand(y);
    }
    return values;
}

void FigureFrame::setValueRange(std::size_t first, QCPAxis::AxisType side) {
    const bool isRight = side == QCPAxis::atRight;
    QCPRange shown = valuesOf(first, isRight).value_or(QCPRange(0, 1));
    QCPAxis* drawn = axisOf(first, side);
    const FigureAxis& axis = isRight ? *panelOf(first).right : panelOf(first).y;
    const double factor = isRight ? rightFactorOf(first) : yFactorOf(first);
    if (axis.range) return drawn->setRange(axis.range->first * factor, axis.range->second * factor);
    if (axis.isFromZero) {
        const double top = shown.upper > 0 ? shown.upper : 1;
        const auto isDot = [](const FigureSeries& each) { return each.points == SeriesPoints::dots; };
        // A dot at zero is drawn on the axis, where it must be visible.
        const bool hasDots = std::ranges::any_of(panelOf(first).series, isDot);
        return drawn->setRange(hasDots ? -0.06 * top : 0, 1.06 * top);
    }
    if (axis.isLogarithmic)
        return drawn->setRange(hasPoints(panelOf(first)) ? aroundPoints(shown, panelOf(first), 4)
                                                         : withMargin(shown, 0.1, true));
    const double size = std::max(shown.size(), 0.02 * std::abs(shown.upper));
    // Where a zone begins, if that leaves the curves most of the height.
    constexpr double share = 0.25;
    if (const std::optional<FigureZone>& zone = panelOf(first).zone) {
        const double from = zone->from * factor;
        if (shown.upper > from - share * size && shown.lower < from + share * size) shown.expand(from);
    }
    const bool hasNamesBelow =
        std::ranges::any_of(panelOf(first).bands, [](const FigureBand& band) { return band.at.has_value(); });
    drawn->setRange(shown.lower - (hasNamesBelow ? 0.18 : 0.1) * size, shown.upper + 0.1 * size);
}

}  // namespace drillwave

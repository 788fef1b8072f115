// SPDX-License-Identifier: GPL-3.0-or-later
// Places of a figure that the pointer and the keys can take, and their meanings.
#include <algorithm>
#include <cmath>

#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

const AxisTarget* FigureFrame::targetIn(const QCPAxisRect* rect) const {
    const std::optional<std::size_t> panel = panelIn(rect);
    return panel && panelOf(*panel).x.target ? &*panelOf(*panel).x.target : nullptr;
}

void FigureFrame::giveMeanings(PlotWidget& plot) const {
    if (isEmpty()) return;
    CurveMeaning meaning{.xUnit = m_xUnit.dimensionless ? QString() : m_xUnit.unit, .yUnit = m_yUnit.unit};
    if (std::holds_alternative<KeptParameter>(panelOf(0).x.quantity) || !panelOf(0).x.names.empty())
        meaning = CurveMeaning::overParameter(meaning.xUnit, meaning.yUnit);
    for (const FigureText& name : panelOf(0).x.names) meaning.xWords << textOf(name);
    for (const QCPGraph* run : runCurves()) plot.setMeaning(run, meaning);
    for (std::size_t i = 1; i < m_panels.size(); ++i) {
        if (!panelOf(i).sharesX) continue;
        CurveMeaning other = meaning;
        other.yUnit = m_shown.units.of(panelOf(m_panels[i].first).y.quantity).unit;
        for (const Drawn& drawn : m_panels[i].series)
            if (drawn.line) plot.setMeaning(drawn.line, other);
    }
    for (std::size_t i = 0; i < panelOf(0).series.size(); ++i) {
        CurveMeaning exact = meaning;
        if (panelOf(0).series[i].isOnRight) exact.yUnit = m_shown.units.of(panelOf(0).right->quantity).unit;
        if (const auto& value = panelOf(0).series[i].value)
            exact.value = [value, x = m_xUnit.factor, y = m_yUnit.factor](double shown) {
                return value(shown / x) * y;
            };
        if (!exact.xWords.isEmpty())
            exact.value = [x = panelOf(0).series[i].x, y = panelOf(0).series[i].y,
                           unit = m_yUnit.factor](double shown) {
                const auto found = std::ranges::find(x, std::round(shown));
                return found == x.end() ? std::nan("") : y[std::size_t(found - x.begin())] * unit;
            };
        if (const QCPGraph* line = m_panels.front().series[i].line) plot.setMeaning(line, exact);
    }
}

std::optional<std::size_t> FigureFrame::rowAt(QPointF place, std::size_t panel) const {
    if (isEmpty() || !isThere(panel)) return std::nullopt;
    const StudyPanel& shown = panelOf(panel);
    if (shown.field) {
        const std::optional<MapGrid::Place> point = m_panels[panel].field->pointAt(place);
        return point && shown.field->hasRows
                   ? std::optional(point->row * shown.field->grid->columns() + point->column)
                   : std::nullopt;
    }
    constexpr double nearby = 14;  // [px]
    double least = shown.hasRowsAlongX ? HUGE_VAL : nearby;
    std::optional<std::size_t> found;
    const QCPAxis &x = *axisOf(panel, QCPAxis::atBottom), &y = *axisOf(panel, QCPAxis::atLeft);
    for (const FigureSeries& series : shown.series)
        for (std::size_t i = 0; i < series.rows.size(); ++i) {
            const double along = x.coordToPixel(series.x[i] * xFactorOf(panel)) - x.coordToPixel(place.x());
            const double up = y.coordToPixel(series.y[i] * yFactorOf(panel)) - y.coordToPixel(place.y());
            const double distance = shown.hasRowsAlongX ? std::abs(along) : std::hypot(along, up);
            if (!(distance < least)) continue;
            least = distance;
            found = series.rows[i];
        }
    return found;
}

QString FigureFrame::fieldWords(QPointF place) const {
    const std::optional<MapGrid::Place> point = field() ? field()->pointAt(place) : std::nullopt;
    if (!point) return {};
    const FigureField& shown = *panelOf(0).field;
    const MapGrid& grid = *shown.grid;
    const auto numberOn = [&](const FigureAxis& axis, double value) {
        return titleOf(axis) + QStringLiteral(" = ") + numberOf({value, axis.quantity, 5});
    };
    const double value = grid.value(point->column, point->row);
    QString result = numberOn(shown.scale, value * shown.perValue);
    if (!grid.isThere(point->column, point->row))
        result = drillwave::tr("not solved yet");
    else if (const Message& reason = grid.reason(point->column, point->row); !reason.isEmpty())
        result = drillwave::tr("not solved: %1").arg(translated(reason));
    else if (std::isnan(value))
        result = drillwave::tr("no such result here");
    return drillwave::tr("%1 · %2 · %3")
        .arg(numberOn(panelOf(0).x, grid.xs()[point->column]), numberOn(panelOf(0).y, grid.ys()[point->row]),
             result);
}

FigureFrame::Target FigureFrame::targetAt(QPointF place) const {
    constexpr double nearby = 9;  // [px]
    Target target{.x = place.x()};
    if (isEmpty()) return target;
    double least = nearby;
    const auto isNearer = [&](QPointF other) {
        const QPointF way = pixelOf(other) - pixelOf(place);
        const double distance = std::hypot(way.x(), way.y());
        if (!(distance < least)) return false;
        least = distance;
        return true;
    };
    for (const FigureMark& mark : panelOf(0).marks) {
        const QPointF at(mark.x * m_xUnit.factor, mark.y * m_yUnit.factor);
        if (isNearer(at)) target = {at.x(), panelOf(0).series[panelOf(0).marked].target, true};
    }
    if (target.isMark) return target;
    for (std::size_t i = 0; i < panelOf(0).series.size(); ++i) {
        const FigureSeries& series = panelOf(0).series[i];
        if (!series.target || !graph(0, i)->realVisibility()) continue;
        const auto data = graph(0, i)->data();
        const auto after = data->findBegin(place.x(), false);
        if (after == data->constEnd()) continue;
        const auto before = after == data->constBegin() ? after : std::prev(after);
        const double width = after->key - before->key;
        const double share = width > 0 ? (place.x() - before->key) / width : 0;
        if (isNearer({place.x(), before->value + share * (after->value - before->value)}))
            target.series = series.target;
    }
    return target;
}

KeyPlaces FigureFrame::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    if (hasPoints(panelOf(0))) places.on = KeyPlaces::On::points;
    if (panelOf(0).field) places.on = KeyPlaces::On::area;
    places.start = [this] {
        return here().x() ? std::optional(QPointF(*here().x(), here().y().value_or(y()->range().center())))
                          : std::nullopt;
    };
    places.marks = [this] {
        QVector<QPointF> marks;
        if (isEmpty()) return marks;
        const StudyPanel& panel = panelOf(0);
        for (std::size_t i = 0; i < panel.series.size(); ++i) {
            const FigureSeries& series = panel.series[i];
            if (i == panel.marked && graph(0, i) && graph(0, i)->visible())
                for (const FigureMark& mark : panel.marks)
                    marks.append({mark.x * m_xUnit.factor, mark.y * m_yUnit.factor});
            if (series.points == SeriesPoints::diamonds || series.points == SeriesPoints::openDiamonds ||
                series.points == SeriesPoints::squares)
                for (std::size_t k = 0; k < series.x.size(); ++k)
                    marks.append({series.x[k] * m_xUnit.factor, series.y[k] * m_yUnit.factor});
        }
        return marks;
    };
    places.targets = [this] {
        QVector<QPointF> points;
        if (field() && panelOf(0).field->hasRows)
            for (std::size_t i = 0; i < panelOf(0).field->grid->size(); ++i)
                points.append(field()->placeOf(
                    {i % panelOf(0).field->grid->columns(), i / panelOf(0).field->grid->columns()}));
        return points;
    };
    // As narrow as possible: the words are beside the point.
    places.words = [this](QPointF place) {
        return fieldWords(place).replace(QStringLiteral(" · "), QStringLiteral("\n"));
    };
    return places;
}

}  // namespace drillwave

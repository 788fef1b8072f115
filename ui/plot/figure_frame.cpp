// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_frame.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/number_ticks.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

const QString betweenParts = QStringLiteral(" · ");  // parts of a caption
constexpr int mostLegendColumns = 3;
constexpr double narrow = 0.5;  // a panel of that width has room for few numbers

template <class... Each>
struct Visitor : Each... {
    using Each::operator()...;
};

const ShownUnit& unitOf(BlowScale scale, const ShownUnits& units) {
    switch (scale) {
        case BlowScale::time:
            return units.time;
        case BlowScale::force:
            return units.force;
        case BlowScale::impulse:
            return units.impulse;
        case BlowScale::penetration:
            return units.penetration;
        case BlowScale::stiffness:
            return units.stiffness;
        case BlowScale::energy:
            return units.energy;
        case BlowScale::stress:
            return units.stress;
        case BlowScale::length:
            return units.length;
        case BlowScale::velocity:
            break;
    }
    return units.velocity;
}

QSharedPointer<QCPAxisTicker> ticker(bool isLogarithmic, int count) {
    QSharedPointer<QCPAxisTicker> ticks;
    if (isLogarithmic)
        ticks.reset(new NumberTicks<QCPAxisTickerLog>);
    else
        ticks.reset(new NumberTicks<QCPAxisTicker>);
    ticks->setTickCount(count);
    return ticks;
}

QCPRange withMargin(QCPRange range, double share, bool isLogarithmic) {
    if (isLogarithmic && range.lower > 0) {
        const double factor = std::pow(range.upper / range.lower, share);
        return {range.lower / factor, range.upper * factor};
    }
    return {range.lower - share * range.size(), range.upper + share * range.size()};
}

void expand(std::optional<QCPRange>& all, const QCPRange& more, bool isThere) {
    if (!isThere) return;
    if (all)
        all->expand(more);
    else
        all = more;
}

}  // namespace

ShownUnit FigureUnits::of(const FigureQuantity& quantity) const {
    return std::visit(
        Visitor{[](PlainNumber plain) {
                    return plain == PlainNumber::percent ? ShownUnit{1, QStringLiteral("%")} : ShownUnit{};
                },
                [&](BlowScale scale) { return unitOf(scale, units); },
                [&](const SiValues& si) {
                    const auto row = std::ranges::find(unitKinds(), si.quantity, &UnitKindRow::quantity);
                    return row == unitKinds().end() ? ShownUnit{} : units.of(row->kind, si.size);
                },
                [&](const KeptParameter& parameter) { return shownUnit(unitFor(*parameter)); }},
        quantity);
}

FigureFrame::FigureFrame(QCustomPlot* plot) : StudyFrame(plot) {
    setAxesVisible(false);
    connect(plot, &QCustomPlot::afterLayout, this, &FigureFrame::placeZones);
    connect(plot, &QCustomPlot::beforeReplot, this, [this] {
        if (isEmpty()) return;
        wrapLegend(*m_legend, m_plot->viewport().width(), mostLegendColumns);
        breakCaption();
    });
    setStyle(PlotStyle::forPaper());
}

// Once, for the panels of the first figure.
void FigureFrame::build() {
    layOutAnew();
    addHeader(4);
    m_legend->setWrap(mostLegendColumns);
    auto* row = new QCPLayoutGrid;
    m_plot->plotLayout()->addElement(1, 0, row);
    row->setColumnSpacing(0);
    auto* margins = new QCPMarginGroup(m_plot);
    m_panels.resize(m_shown.figure.panels.size());
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        QCPAxisRect* rect = m_panels[i].rect = newAxisRect(*m_plot, Sides::free);
        row->addElement(0, int(i), rect);
        row->setColumnStretchFactor(int(i), panelOf(i).width);
        rect->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
        rect->setMinimumMargins(QMargins(4, 4, 14, 4));
        rect->axis(QCPAxis::atRight)->setTicks(false);
        rect->axis(QCPAxis::atTop)->setTickLabels(panelOf(i).top.has_value());
        rect->axis(QCPAxis::atTop)->setTicks(panelOf(i).top.has_value());
        if (i == 0) view(rect);
        if (i > 0) rect->axis(QCPAxis::atLeft)->setTickLabels(false);
        addZone(m_panels[i]);
    }
    linkAxes();
    for (std::size_t i = 0; i < m_panels.size(); ++i) showSeries(i);
    showLevels();
    addHere();
    addRunCurves();
    addRunMarks();
    setStyle(PlotStyle(m_style));
}

// All panels have one axis of values.
void FigureFrame::linkAxes() {
    using Changed = void (QCPAxis::*)(const QCPRange&);
    constexpr auto changed = static_cast<Changed>(&QCPAxis::rangeChanged);
    for (std::size_t i = 1; i < m_panels.size(); ++i) {
        QCPAxis* same = m_panels[i].rect->axis(QCPAxis::atLeft);
        connect(y(), changed, same, [same](const QCPRange& range) { same->setRange(range); });
        connect(same, changed, y(), [values = y()](const QCPRange& range) { values->setRange(range); });
    }
    connect(x(), changed, this, &FigureFrame::followTopAxes);
}

void FigureFrame::followTopAxes() {
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        if (panelOf(i).topPerX == 0) continue;
        const double factor = panelOf(i).topPerX * m_shown.units.of(panelOf(i).top->quantity).factor /
                              m_shown.units.of(panelOf(i).x.quantity).factor;
        const QCPRange range = m_panels[i].rect->axis(QCPAxis::atBottom)->range();
        m_panels[i].rect->axis(QCPAxis::atTop)->setRange(factor * range.lower, factor * range.upper);
    }
}

void FigureFrame::addZone(Panel& panel) {
    panel.zone = addItem<QCPItemRect>(panel.rect, QStringLiteral("background"));
    for (QCPItemPosition* corner : panel.zone->positions()) setAcross(*corner);
    panel.zoneName = addText(panel.rect, QMargins(6, 3, 6, 3), Qt::AlignHCenter | Qt::AlignTop);
    panel.zoneName->position->setType(QCPItemPosition::ptAxisRectRatio);
    panel.zoneName->position->setCoords(0.5, 0);
}

void FigureFrame::present(const ShownFigure& shown) {
    const bool hasOther = m_isCleared || hasOtherAxes(shown);
    m_shown = shown;
    m_isCleared = false;
    m_xUnit = shown.units.of(panelOf(0).x.quantity);
    m_yUnit = shown.units.of(panelOf(0).y.quantity);
    if (m_panels.empty()) build();
    setAxesVisible(true);
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        showSeries(i);
        showAxes(i);
    }
    showLevels();
    standRunsLast();
    restyle();
    showCaption();
    finish(hasOther);
    followTopAxes();
}

bool FigureFrame::hasOtherAxes(const ShownFigure& shown) const {
    const auto same = [&](const FigureAxis& a, const FigureAxis& b) {
        return a.title == b.title && a.isLogarithmic == b.isLogarithmic && a.range == b.range &&
               m_shown.units.of(a.quantity).unit == shown.units.of(b.quantity).unit;
    };
    const auto ends = [](const StudyPanel& panel) {
        const auto& x = panel.series.front().x;
        return x.empty() ? std::pair(0.0, 0.0) : std::pair(x.front(), x.back());
    };
    const StudyPanel& before = panelOf(0);
    const StudyPanel& now = shown.figure.panels.front();
    return !same(before.x, now.x) || !same(before.y, now.y) || ends(before) != ends(now);
}

void FigureFrame::showSeries(std::size_t index) {
    Panel& panel = m_panels[index];
    const std::vector<FigureSeries>& series = panelOf(index).series;
    while (panel.series.size() > series.size()) {
        const Drawn& last = panel.series.back();
        QCPAbstractPlottable* gone = last.line ? static_cast<QCPAbstractPlottable*>(last.line) : last.path;
        gone->removeFromLegend(m_legend);
        m_plot->removePlottable(gone);
        panel.series.pop_back();
    }
    for (std::size_t i = 0; i < series.size(); ++i) {
        const FigureSeries& each = series[i];
        QCPAxis* keys = panel.rect->axis(each.isOnTop ? QCPAxis::atTop : QCPAxis::atBottom);
        if (i == panel.series.size()) {
            Drawn drawn;
            if (each.kind == SeriesKind::line) {
                drawn.line = addCurve(keys, panel.rect->axis(QCPAxis::atLeft));
                drawn.line->setAdaptiveSampling(false);
            } else {
                drawn.path = new QCPCurve(keys, panel.rect->axis(QCPAxis::atLeft));
            }
            panel.series.push_back(drawn);
        }
        const Drawn& drawn = panel.series[i];
        QCPAbstractPlottable* plottable =
            drawn.line ? static_cast<QCPAbstractPlottable*>(drawn.line) : drawn.path;
        plottable->setName(translated(each.legend));
        if (each.legend.isEmpty())
            plottable->removeFromLegend(m_legend);
        else
            plottable->addToLegend(m_legend);
        const StudyPanel& of = panelOf(index);
        const double xFactor = m_shown.units.of(each.isOnTop ? of.top->quantity : of.x.quantity).factor;
        if (drawn.line) {
            QVector<QCPGraphData> points;
            for (std::size_t point = 0; point < each.x.size(); ++point)
                appendFinite(points, each.x[point] * xFactor, each.y[point] * m_yUnit.factor);
            drawn.line->setData(graphData(points));
        } else {
            QVector<QCPCurveData> points;
            for (std::size_t point = 0; point < each.x.size(); ++point)
                points.append({double(point), each.x[point] * xFactor, each.y[point] * m_yUnit.factor});
            drawn.path->data()->set(points, true);
        }
    }
    if (!panel.marks && !panel.series.empty() && panel.series.front().line)
        panel.marks = new CurveMarks(panel.series.front().line);
}

void FigureFrame::showAxes(std::size_t index) {
    const StudyPanel& panel = panelOf(index);
    QCPAxisRect& rect = *m_panels[index].rect;
    const auto show = [&](const FigureAxis& axis, QCPAxis& drawn) {
        const ShownUnit unit = m_shown.units.of(axis.quantity);
        drawn.setScaleType(axis.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        drawn.setTicker(ticker(axis.isLogarithmic, panel.width < narrow ? 2 : 5));
        drawn.setLabel(unit.axisLabel(translated(axis.title)));
    };
    show(panel.x, *rect.axis(QCPAxis::atBottom));
    if (index == 0) show(panel.y, *rect.axis(QCPAxis::atLeft));
    if (!panel.top) return;
    QCPAxis& top = *rect.axis(QCPAxis::atTop);
    show(*panel.top, top);
    // The same numbers twice say nothing.
    const bool isSame = panel.topPerX != 0 && m_shown.units.of(panel.x.quantity).dimensionless;
    top.setTickLabels(!isSame);
    if (isSame) top.setLabel({});
}

void FigureFrame::showLevels() {
    const std::vector<FigureLevel>& levels = m_shown.figure.levels;
    for (Panel& panel : m_panels)
        while (panel.levels.size() < levels.size())
            panel.levels.push_back(addLevel(panel.rect, QStringLiteral("grid")));
    while (m_levelNames.size() < levels.size()) {
        QCPItemText* name =
            addText(m_panels.back().rect, QMargins(4, 1, 4, 1), Qt::AlignRight | Qt::AlignVCenter);
        name->setLayer(QStringLiteral("legend"));  // above the curves
        setAcross(*name->position);
        name->setFont(m_style.font);
        name->setColor(m_style.text);
        m_levelNames.push_back(name);
    }
    for (std::size_t i = 0; i < m_levelNames.size(); ++i) {
        const bool isShown = i < levels.size() && !m_isCleared;
        const double at = i < levels.size() ? levels[i].y * m_yUnit.factor : 0;
        for (Panel& panel : m_panels) setLevel(*panel.levels[i], isShown ? std::optional(at) : std::nullopt);
        m_levelNames[i]->setVisible(isShown);
        if (!isShown) continue;
        m_levelNames[i]->setText(translated(levels[i].name));
        m_levelNames[i]->position->setCoords(1, at);
    }
}

// Numbers as the plot writes them, which in files is another way.
void FigureFrame::showCaption() {
    if (isEmpty()) return;
    QStringList parts;
    for (const FigureText& text : m_shown.figure.caption) {
        QString part = translated(text.pattern);
        QStringList numbers;
        for (const FigureNumber& number : text.numbers) {
            const ShownUnit unit = m_shown.units.of(number.quantity);
            const QString value = numberText(number.value * unit.factor, number.digits, m_plot->locale());
            numbers << (unit.unit.isEmpty() ? value : value + QChar(QChar::Nbsp) + unit.unit);
        }
        for (qsizetype i = 0; i < numbers.size(); ++i)
            part.replace(QLatin1Char('%') + QString::number(i + 1), numbers[i]);
        parts << part;
    }
    m_summary = parts.join(betweenParts);
    m_caption->setText(m_summary);
}

// One part below the other where they are too long for one line.
void FigureFrame::breakCaption() {
    const double width = QFontMetricsF(m_caption->font()).horizontalAdvance(m_summary);
    QString text = m_summary;
    if (width > m_plot->viewport().width() - 20) text.replace(betweenParts, QStringLiteral("\n"));
    m_caption->setText(text);
}

// As far as they are in view: files do not clip.
void FigureFrame::placeZones() {
    if (m_panels.empty()) return;
    const QCPRange range = y()->range();
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const std::optional<FigureZone>& zone = panelOf(i).zone;
        const double from = zone ? zone->from * m_yUnit.factor : 0;
        const bool isShown = !m_isCleared && zone && range.upper > from;
        m_panels[i].zone->setVisible(isShown);
        m_panels[i].zoneName->setVisible(isShown);
        if (!isShown) continue;
        m_panels[i].zone->topLeft->setCoords(0, range.upper);
        m_panels[i].zone->bottomRight->setCoords(1, std::max(from, range.lower));
        m_panels[i].zoneName->setText(translated(zone->name));
    }
}

void FigureFrame::clear() {
    m_isCleared = true;
    for (Panel& panel : m_panels) {
        for (const Drawn& drawn : panel.series) {
            if (drawn.line) drawn.line->data()->clear();
            if (drawn.path) drawn.path->data()->clear();
        }
        if (panel.marks) panel.marks->clear();
    }
    showLevels();
    setAxesVisible(false);
}

// Axes of nothing would only be behind the message.
void FigureFrame::setAxesVisible(bool visible) {
    for (const QCPAxisRect* rect : m_plot->axisRects())
        for (QCPAxis* axis : rect->axes()) axis->setVisible(visible);
    if (m_legend) m_legend->setVisible(visible);
}

void FigureFrame::restyle() {
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const Panel& panel = m_panels[i];
        for (std::size_t each = 0; each < panel.series.size(); ++each) {
            const auto role = static_cast<int>(panelOf(i).series[each].role);
            const Drawn& drawn = panel.series[each];
            if (drawn.line) drawn.line->setPen(m_style.linePen(role));
            if (!drawn.path) continue;
            const bool isArea = panelOf(i).series[each].kind == SeriesKind::area;
            drawn.path->setPen(isArea ? QPen(m_style.lines[role], 1) : m_style.linePen(role));
            drawn.path->setBrush(isArea ? m_style.areaBrush(role) : QBrush(Qt::NoBrush));
        }
        for (std::size_t level = 0; level < m_shown.figure.levels.size(); ++level)
            panel.levels[level]->setPen(QPen(
                m_style.zeroLine, 1, m_shown.figure.levels[level].isMain ? Qt::DashDotLine : Qt::DashLine));
        if (!panelOf(i).top || panelOf(i).topPerX == 0)
            panel.rect->axis(QCPAxis::atTop)->grid()->setVisible(false);
        panel.zone->setPen(Qt::NoPen);
        panel.zone->setBrush(m_style.areaBrush(2));
        if (!panel.marks || m_isCleared) continue;
        panel.marks->setStyle(m_style);
        QVector<CurveMark> marks;
        for (const FigureMark& mark : panelOf(i).marks)
            marks.append({mark.kind, QPointF(mark.x * m_xUnit.factor, mark.y * m_yUnit.factor)});
        panel.marks->present(marks, m_xUnit, m_yUnit);
    }
    for (QCPItemText* name : m_levelNames) name->setBrush(m_style.behindWords());
    if (m_legend) m_style.applyTo(*m_legend);
    if (!isEmpty()) showCaption();  // files have another locale
}

void FigureFrame::setRanges() {
    if (isEmpty()) return;
    std::optional<QCPRange> values;
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        std::optional<QCPRange> keys;
        bool isFromZero = false;
        for (std::size_t each = 0; each < m_panels[i].series.size(); ++each) {
            const Drawn& drawn = m_panels[i].series[each];
            const FigureSeries& series = panelOf(i).series[each];
            bool isThere = false;
            const QCPRange along =
                drawn.line ? drawn.line->getKeyRange(isThere) : drawn.path->getKeyRange(isThere);
            if (!series.isOnTop) expand(keys, along, isThere);
            isFromZero |= series.kind == SeriesKind::area && along.lower == 0;
            expand(values,
                   drawn.line ? drawn.line->getValueRange(isThere) : drawn.path->getValueRange(isThere),
                   isThere);
        }
        const FigureAxis& axis = panelOf(i).x;
        QCPAxis* bottom = m_panels[i].rect->axis(QCPAxis::atBottom);
        const double factor = m_shown.units.of(axis.quantity).factor;
        if (axis.range)
            bottom->setRange(axis.range->first * factor, axis.range->second * factor);
        else if (isFromZero)
            bottom->setRange(0, keys && keys->upper > 0 ? 1.05 * keys->upper : 100);
        else if (keys)
            bottom->setRange(withMargin(*keys, 0.02, axis.isLogarithmic));
        if (panelOf(i).top && panelOf(i).top->range)
            m_panels[i]
                .rect->axis(QCPAxis::atTop)
                ->setRange(panelOf(i).top->range->first, panelOf(i).top->range->second);
    }
    for (QCPGraph* run : runCurves()) {
        bool isThere = false;
        const QCPRange range = run->getValueRange(isThere);
        expand(values, range, isThere);
    }
    QCPRange shown = values.value_or(QCPRange(0, 1));
    const FigureAxis& axis = panelOf(0).y;
    if (axis.range)
        return y()->setRange(axis.range->first * m_yUnit.factor, axis.range->second * m_yUnit.factor);
    if (axis.isLogarithmic) return y()->setRange(withMargin(shown, 0.1, true));
    const double size = std::max(shown.size(), 0.02 * std::abs(shown.upper));
    // Where a zone begins, if that leaves the curves most of the height.
    constexpr double share = 0.25;
    if (const std::optional<FigureZone>& zone = panelOf(0).zone) {
        const double from = zone->from * m_yUnit.factor;
        if (shown.upper > from - share * size && shown.lower < from + share * size) shown.expand(from);
    }
    y()->setRange(shown.lower - 0.1 * size, shown.upper + 0.1 * size);
}

QCPGraph* FigureFrame::graph(std::size_t panel, std::size_t series) const {
    return m_panels.at(panel).series.at(series).line;
}

const AxisTarget* FigureFrame::targetIn(const QCPAxisRect* rect) const {
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        if (m_panels[i].rect == rect) return panelOf(i).x.target ? &*panelOf(i).x.target : nullptr;
    return nullptr;
}

void FigureFrame::giveMeanings(PlotWidget& plot) const {
    if (isEmpty()) return;
    CurveMeaning meaning{.xUnit = m_xUnit.dimensionless ? QString() : m_xUnit.unit, .yUnit = m_yUnit.unit};
    if (std::holds_alternative<KeptParameter>(panelOf(0).x.quantity))
        meaning = CurveMeaning::overParameter(meaning.xUnit, meaning.yUnit);
    for (const QCPGraph* run : runCurves()) plot.setMeaning(run, meaning);
    for (std::size_t i = 0; i < m_panels.front().series.size(); ++i) {
        CurveMeaning exact = meaning;
        if (const auto& value = panelOf(0).series[i].value)
            exact.value = [value, x = m_xUnit.factor, y = m_yUnit.factor](double shown) {
                return value(shown / x) * y;
            };
        if (const QCPGraph* line = m_panels.front().series[i].line) plot.setMeaning(line, exact);
    }
}

KeyPlaces FigureFrame::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] { return here().place(); };
    places.marks = [this] {
        QVector<QPointF> marks;
        if (!isEmpty() && !panelOf(0).series.empty() && graph()->visible())
            for (const FigureMark& mark : panelOf(0).marks)
                marks.append({mark.x * m_xUnit.factor, mark.y * m_yUnit.factor});
        return marks;
    };
    return places;
}

}  // namespace drillwave

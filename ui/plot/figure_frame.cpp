// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/model/parameter.h"
#include "ui/plot/crosshair.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/number_ticks.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/series_style.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int mostLegendColumns = 3;
constexpr double narrow = 0.5;  // a panel of that width has room for few numbers
constexpr int leastPanel = 50;  // width and height [px]
const QMargins panelMargins(4, 4, 14, 4);

/// Returns the points of a line. At the names of an axis, each is a short level stroke.
GraphData pointsOf(const StudyPanel& panel, const FigureSeries& series, const std::vector<double>& values,
                   double xFactor, double yFactor) {
    constexpr double ofPoint = 1e-3;  // the pointer finds the point as a part of a curve
    const double half =
        series.points == SeriesPoints::none ? (panel.x.names.size() > 1 ? 0.3 : 0.4) : ofPoint;
    QVector<QCPGraphData> points;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = series.x[i] * xFactor, y = values[i] * yFactor;
        const bool isStroke = !panel.x.names.empty() && isLine(series);
        if (isStroke && !points.isEmpty()) points.append({x - 0.5, std::nan("")});
        if (isStroke) appendFinite(points, x - half, y);
        appendFinite(points, x, y);
        if (isStroke) appendFinite(points, x + half, y);
    }
    if (series.points != SeriesPoints::none) std::ranges::stable_sort(points, {}, &QCPGraphData::key);
    return graphData(points);
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

}  // namespace

FigureFrame::FigureFrame(QCustomPlot* plot) : StudyFrame(plot), m_seriesDrag(new SeriesDrag(*plot)) {
    setAxesVisible(false);
    connect(m_seriesDrag, &SeriesDrag::begun, this,
            [this](double y) { emit seriesHeld(y / m_yUnit.factor); });
    connect(m_seriesDrag, &SeriesDrag::moved, this,
            [this](double y) { emit seriesMoved(y / m_yUnit.factor); });
    connect(plot, &QCustomPlot::beforeReplot, this, &FigureFrame::followLines);
    connect(plot, &QCustomPlot::afterLayout, this, &FigureFrame::placeZones);
    connect(plot, &QCustomPlot::afterLayout, this, &FigureFrame::placeTexts);
    connect(plot, &QCustomPlot::beforeReplot, this, [this] {
        if (isEmpty()) return;
        wrapLegend(*m_legend, m_plot->viewport().width() - m_legend->margins().left(), mostLegendColumns);
        breakCaption();
    });
    setStyle(PlotStyle::forPaper());
}

// Once, for the panels of the first figure.
void FigureFrame::build() {
    layOutAnew();
    addHeader(4);
    m_legend->setWrap(mostLegendColumns);
    addPanels();
    connect(x(), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &FigureFrame::followTopAxes);
    for (std::size_t i = 0; i < m_panels.size(); ++i) showSeries(i);
    showLevels();
    if (m_shown.figure.hasCrosshair)
        addCrosshair();
    else
        addHere();
    addRunCurves();
    addRunMarks();
    setStyle(PlotStyle(m_style));
}

// Adds the panels that no figure before had.
void FigureFrame::addPanels() {
    const std::size_t begin = m_panels.size();
    const std::vector<StudyPanel>& panels = m_shown.figure.panels;
    m_panels.resize(panels.size());
    QCPLayoutGrid* row = nullptr;
    QCPMarginGroup* margins = nullptr;
    QCPMarginGroup* sides = nullptr;
    for (std::size_t i = begin; i < m_panels.size(); ++i) {
        const bool begins = i == 0 || panels[i].row != panels[i - 1].row;
        m_panels[i].first = begins || panels[i].hasOwnY ? i : m_panels[i - 1].first;
        if (begins) margins = new QCPMarginGroup(m_plot);
        if (begins && !(panels[i].sharesX && panels[0].field)) {
            row = new QCPLayoutGrid;
            const int place = 1 + static_cast<int>(panels[i].row);
            m_plot->plotLayout()->addElement(place, 0, row);
            row->setColumnSpacing(0);
        }
        for (std::size_t k = m_panels[i].first; k <= i; ++k) m_panels[k].last = i;
        addPanel(i, *row, begins);
        m_panels[i].rect->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
        if (panelOf(i).sharesX) {
            if (!sides) sides = new QCPMarginGroup(m_plot);
            for (const std::size_t k : {std::size_t{0}, i})
                m_panels[k].rect->setMarginGroup(QCP::msLeft | QCP::msRight, sides);
        }
    }
    linkAxes(begin);
}

const StudyPanel& FigureFrame::panelOf(std::size_t index) const {
    static const StudyPanel none{.row = std::numeric_limits<std::size_t>::max()};
    return isThere(index) ? m_shown.figure.panels[index] : none;
}

/// Leaves no room for a panel that only an earlier figure had.
void FigureFrame::showPanel(std::size_t index) {
    QCPAxisRect& rect = *m_panels[index].rect;
    const bool isShown = isThere(index);
    bool isRowShown = false;
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        isRowShown |= isThere(i) && m_panels[i].rect->layout() == rect.layout();
    const int least = isShown ? leastPanel : 0;
    rect.setVisible(isShown);
    rect.setMinimumSize(least, least);
    rect.setMaximumSize(isShown || !isRowShown ? QWIDGETSIZE_MAX : 0, isRowShown ? QWIDGETSIZE_MAX : 0);
    rect.setMinimumMargins(isShown ? panelMargins : QMargins());
    if (!isShown || index == 0 || !hasFirstY(index)) return;
    auto* section = qobject_cast<QCPLayoutGrid*>(rect.layout());
    if (section->rowCount() > 1)
        section->setRowStretchFactor(section->rowCount() - 1, panelOf(index).height);
    else
        m_plot->plotLayout()->setRowStretchFactor(1 + static_cast<int>(panelOf(index).row),
                                                  panelOf(index).height);
}

// Sections of a field are in the grid of its row, so that their sides are in line.
void FigureFrame::addPanel(std::size_t index, QCPLayoutGrid& row, bool begins) {
    Panel& panel = m_panels[index];
    QCPAxisRect* rect = panel.rect = newAxisRect(*m_plot, Sides::free);
    const StudyPanel& shown = m_shown.figure.panels[index];
    const int column = begins ? 0 : row.columnCount();
    row.addElement(begins ? row.rowCount() : 0, column, rect);
    row.setColumnStretchFactor(column, shown.width);
    // In a file; on the screen, the number follows the length of the axis.
    constexpr int few = 2;
    const bool isCrowded = std::ranges::count(m_shown.figure.panels, shown.row, &StudyPanel::row) > 2;
    for (QCPAxis* axis : rect->axes())
        if (shown.width < narrow || (isCrowded && axis->orientation() == Qt::Horizontal))
            axis->ticker()->setTickCount(few);
    rect->axis(QCPAxis::atTop)->setTickLabels(shown.top.has_value());
    rect->axis(QCPAxis::atTop)->setTicks(shown.top.has_value());
    if (index == 0) view(rect);
    if (!hasFirstY(index)) rect->axis(QCPAxis::atLeft)->setTickLabels(false);
    addZone(panel);
    panel.bands = FigureBands(rect);
    panel.layers = new LayerItems(rect);
    if (shown.handle) addHandle(index);
}

void FigureFrame::addCrosshair() {
    std::vector<QCPAxisRect*> below, beside;
    for (std::size_t i = 1; i < m_panels.size(); ++i) {
        if (panelOf(i).sharesX) below.push_back(m_panels[i].rect);
        if (m_panels[i].first == 0) beside.push_back(m_panels[i].rect);
    }
    auto* crosshair = new Crosshair(m_rect, below, beside);
    connect(crosshair, &Crosshair::held, this, &FigureFrame::crosshairHeld);
    connect(crosshair, &Crosshair::dragged, this, &FigureFrame::crosshairDragged);
    addHere(crosshair);
}

void FigureFrame::addHandle(std::size_t index) {
    DragLine* line = m_panels[index].handle = new DragLine(*m_plot, m_panels[index].rect);
    connect(line, &DragLine::moved, this,
            [this, index](double x) { emit handleMoved(x / xFactorOf(index)); });
    connect(line, &DragLine::released, this,
            [this, index](double x) { emit handleReleased(x / xFactorOf(index)); });
}

// Panels of a row have one axis of values, and those that share x one axis of keys.
void FigureFrame::linkAxes(std::size_t begin) {
    using Changed = void (QCPAxis::*)(const QCPRange&);
    constexpr auto changed = static_cast<Changed>(&QCPAxis::rangeChanged);
    const auto link = [](QCPAxis* one, QCPAxis* other) {
        connect(one, changed, other, [other](const QCPRange& range) { other->setRange(range); });
        connect(other, changed, one, [one](const QCPRange& range) { one->setRange(range); });
    };
    for (std::size_t i = std::max<std::size_t>(begin, 1); i < m_panels.size(); ++i) {
        if (!hasFirstY(i))
            link(axisOf(m_panels[i].first, QCPAxis::atLeft), axisOf(i, QCPAxis::atLeft));
        else
            m_view->watch(axisOf(i, QCPAxis::atLeft));
        if (panelOf(i).sharesX)
            link(x(), axisOf(i, QCPAxis::atBottom));
        else if (hasFirstY(i))
            m_view->watch(axisOf(i, QCPAxis::atBottom));
    }
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
    const bool hasMore = m_panels.size() < m_shown.figure.panels.size();
    if (hasMore) addPanels();
    setAxesVisible(true);
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        showPanel(i);
        showSeries(i);
        showAxes(i);
        showBands(i);
    }
    showLevels();
    showDrag();
    standRunsLast();
    if (hasMore)
        setStyle(PlotStyle(m_style));
    else
        restyle();
    showTexts();
    finish(hasOther);
    followTopAxes();
    if (!panelOf(0).field) return;
    m_view->adjust([this] {  // the values of the sections, whatever part of the field is in view
        for (std::size_t i = 1; i < m_panels.size(); ++i)
            if (panelOf(i).sharesX)
                setValueRange(i, QCPAxis::atLeft);
            else if (!hasFirstY(i))
                setKeyRange(i);
    });
}

bool FigureFrame::hasOtherAxes(const ShownFigure& shown) const {
    const auto same = [&](const FigureAxis& a, const FigureAxis& b, std::size_t panel) {
        return a.title == b.title && a.isLogarithmic == b.isLogarithmic &&
               (panel > 0 || a.range == b.range) &&
               m_shown.units.of(a.quantity).unit == shown.units.of(b.quantity).unit;
    };
    const auto ends = [](const StudyPanel& panel) {
        if (panel.x.range) return *panel.x.range;
        if (panel.series.empty() || hasPoints(panel)) return std::pair(0.0, 0.0);
        const auto& x = panel.series.front().x;
        return x.empty() ? std::pair(0.0, 0.0) : std::pair(x.front(), x.back());
    };
    if (shown.figure.panels.size() != m_shown.figure.panels.size()) return true;
    for (std::size_t i = 0; i < shown.figure.panels.size(); ++i) {
        const StudyPanel &before = m_shown.figure.panels[i], &now = shown.figure.panels[i];
        if (!same(before.x, now.x, i) || !same(before.y, now.y, i)) return true;
    }
    return ends(m_shown.figure.panels.front()) != ends(shown.figure.panels.front());
}

void FigureFrame::showSeries(std::size_t index) {
    Panel& panel = m_panels[index];
    const std::vector<FigureSeries>& series = panelOf(index).series;
    const bool isMarked = panelOf(index).marked < std::min(series.size(), panel.series.size());
    if (panel.marks && !(isMarked && panel.marks->graph() == panel.series[panelOf(index).marked].line)) {
        panel.marks->clear();
        delete std::exchange(panel.marks, nullptr);
    }
    if (!isThere(index)) {
        for (const Drawn& drawn : panel.series) {
            drawn.clear();
            drawn.plottable()->removeFromLegend(m_legend);
        }
        return;
    }
    while (panel.series.size() > series.size()) {
        const Drawn& last = panel.series.back();
        QCPAbstractPlottable* gone = last.plottable();
        gone->removeFromLegend(m_legend);
        m_plot->removePlottable(gone);
        if (last.upper) m_plot->removePlottable(last.upper);
        for (QCPItemText* text : last.texts) m_plot->removeItem(text);
        panel.series.pop_back();
    }
    for (std::size_t i = 0; i < series.size(); ++i) {
        const FigureSeries& each = series[i];
        QCPAxis* keys = panel.rect->axis(each.isOnTop ? QCPAxis::atTop : QCPAxis::atBottom);
        QCPAxis* values = panel.rect->axis(each.isOnRight ? QCPAxis::atRight : QCPAxis::atLeft);
        if (i == panel.series.size()) {
            Drawn drawn;
            if (each.kind == SeriesKind::line) {
                drawn.line = addCurve(keys, values);
                drawn.line->setAdaptiveSampling(false);
            } else {
                drawn.path = new HaloPath(keys, values);
            }
            panel.series.push_back(drawn);
        }
        const Drawn& drawn = panel.series[i];
        QCPAbstractPlottable* plottable = drawn.plottable();
        plottable->setValueAxis(values);
        // A hidden line stays hidden as long as it is the same.
        if (const QString name = translated(each.legend); plottable->name() != name) {
            plottable->setName(name);
            plottable->setVisible(true);
        }
        plottable->setLayer(each.isFaint ? ghostLayer(*m_plot) : m_plot->layer(QStringLiteral("main")));
        if (each.legend.isEmpty())
            plottable->removeFromLegend(m_legend);
        else
            plottable->addToLegend(m_legend);
        const StudyPanel& of = panelOf(index);
        const double xFactor = m_shown.units.of(each.isOnTop ? of.top->quantity : of.x.quantity).factor;
        const double yFactor = each.isOnRight ? rightFactorOf(index) : yFactorOf(index);
        if (drawn.line) {
            drawn.line->setData(pointsOf(of, each, each.y, xFactor, yFactor));
            showStrip(index, i);
        } else {
            QVector<QCPCurveData> points;
            for (std::size_t point = 0; point < each.x.size(); ++point)
                points.append({double(point), each.x[point] * xFactor, each.y[point] * yFactor});
            drawn.path->data()->set(points, true);
        }
    }
    const std::size_t marked = panelOf(index).marked;
    if (!panel.marks && marked < panel.series.size() && panel.series[marked].line)
        panel.marks = new CurveMarks(panel.series[marked].line);
}

void FigureFrame::showStrip(std::size_t index, std::size_t series) {
    const FigureSeries& shown = panelOf(index).series[series];
    Drawn& drawn = m_panels[index].series[series];
    if (!drawn.upper && !shown.upper.empty())
        drawn.upper = addCurve(drawn.line->keyAxis(), drawn.line->valueAxis());
    if (drawn.upper) {
        drawn.upper->setSelectable(QCP::stNone);
        drawn.upper->setData(
            pointsOf(panelOf(index), shown, shown.upper, xFactorOf(index), yFactorOf(index)));
    }
    while (drawn.texts.size() < shown.texts.size()) {
        drawn.texts.push_back(addText(m_panels[index].rect, QMargins(6, 2, 6, 2), {}));
        if (panelOf(index).field) drawn.texts.back()->setLayer(QStringLiteral("legend"));  // above the lines
        drawn.texts.back()->setFont(m_style.font);
        drawn.texts.back()->setColor(m_style.text);
    }
}

// Both edges of a strip are one entry of the legend.
void FigureFrame::followLines() {
    for (const Panel& panel : m_panels)
        for (const Drawn& drawn : panel.series) {
            if (drawn.upper) drawn.upper->setVisible(drawn.line->visible());
            for (QCPItemText* text : drawn.texts)
                text->setVisible(drawn.line->visible() && !text->text().isEmpty() &&
                                 !drawn.line->data()->isEmpty());
        }
}

void FigureFrame::showDrag() {
    const auto found = std::ranges::find_if(
        panelOf(0).series, [](const FigureSeries& series) { return series.dragged.has_value(); });
    const auto index = static_cast<std::size_t>(found - panelOf(0).series.begin());
    m_seriesDrag->setCurve(found == panelOf(0).series.end() ? nullptr : graph(0, index));
}

const AxisTarget* FigureFrame::dragged() const {
    if (isEmpty()) return nullptr;
    for (const FigureSeries& series : panelOf(0).series)
        if (series.dragged) return &*series.dragged;
    return nullptr;
}

void FigureFrame::showAxes(std::size_t index) {
    const StudyPanel& panel = panelOf(index);
    QCPAxisRect& rect = *m_panels[index].rect;
    const auto show = [&](const FigureAxis& axis, QCPAxis& drawn) {
        const ShownUnit unit = m_shown.units.of(axis.quantity);
        drawn.setScaleType(axis.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        drawn.setTicker(ticker(axis.isLogarithmic, drawn.ticker()->tickCount()));
        if (axis.quantity == FigureQuantity(PlainNumber::magnitude)) {
            drawn.setNumberFormat(QStringLiteral("eb"));
            drawn.setNumberPrecision(0);
        }
        drawn.setLabel(unit.axisLabel(titleOf(axis)));
    };
    show(panel.x, *rect.axis(QCPAxis::atBottom));
    show(panelOf(m_panels[index].first).y, *rect.axis(QCPAxis::atLeft));
    if (!hasFirstY(index)) rect.axis(QCPAxis::atLeft)->setLabel({});
    QCPAxis& right = *rect.axis(QCPAxis::atRight);
    right.setTicks(panel.right.has_value());
    right.setTickLabels(panel.right.has_value());
    show(panel.right.value_or(FigureAxis()), right);
    const auto isBelow = [&](const StudyPanel& other) { return other.sharesX && other.row > panel.row; };
    if ((index == 0 || panel.sharesX) && std::ranges::any_of(m_shown.figure.panels, isBelow)) {
        rect.axis(QCPAxis::atBottom)->setTickLabels(false);
        rect.axis(QCPAxis::atBottom)->setLabel({});
    }
    if (!panel.top) return;
    QCPAxis& top = *rect.axis(QCPAxis::atTop);
    FigureAxis above = *panel.top;
    above.isLogarithmic |= panel.topPerX != 0 && panel.x.isLogarithmic;
    show(above, top);
    // The same numbers twice say nothing.
    const bool isSame = panel.topPerX != 0 && m_shown.units.of(panel.x.quantity).dimensionless;
    top.setTickLabels(!isSame);
    if (isSame) top.setLabel({});
}

void FigureFrame::showBands(std::size_t index) {
    std::vector<ShownBand> bands;
    const double factor = xFactorOf(index);
    for (const FigureBand& band : panelOf(index).bands)
        bands.push_back({translated(band.name), QCPRange(band.from * factor, band.to * factor),
                         band.at ? std::optional(*band.at * factor) : std::nullopt});
    m_panels[index].bands.present(std::move(bands));
    m_panels[index].layers->present(panelOf(index).layers, factor, yFactorOf(index));
    if (panelOf(index).field && !m_panels[index].field) {
        m_panels[index].field = new FieldItem(m_panels[index].rect);
        m_panels[index].field->setStyle(m_style);
    }
    if (FieldItem* field = m_panels[index].field) {
        const FigureField& shown = panelOf(index).field.value_or(FigureField());
        const ShownUnit unit = m_shown.units.of(shown.scale.quantity);
        field->present(panelOf(index), factor, yFactorOf(index), shown.perValue * unit.factor,
                       unit.axisLabel(translated(shown.scale.title)));
    }
    if (!m_panels[index].handle) return;
    const std::optional<FigureHandle>& handle = panelOf(index).handle;
    if (handle)
        m_panels[index].handle->present(translated(handle->name), handle->x * factor,
                                        handle->snap ? std::optional(*handle->snap * factor) : std::nullopt);
    else
        m_panels[index].handle->hide();
}

void FigureFrame::Drawn::clear() const {
    if (line) line->data()->clear();
    if (path) path->data()->clear();
    if (upper) upper->data()->clear();
}

void FigureFrame::clear() {
    m_isCleared = true;
    for (Panel& panel : m_panels) {
        for (const Drawn& drawn : panel.series) drawn.clear();
        if (panel.marks) panel.marks->clear();
        panel.bands.present({});
        panel.layers->present({}, 1, 1);
        if (panel.field) panel.field->present({}, 1, 1, 1, {});
        if (panel.handle) panel.handle->hide();
        if (panel.runs) panel.runs->present({});
    }
    m_seriesDrag->setCurve(nullptr);
    showLevels();
    setAxesVisible(false);
}

// Axes of nothing would only be behind the message.
void FigureFrame::setAxesVisible(bool visible) {
    for (const QCPAxisRect* rect : m_plot->axisRects())
        for (QCPAxis* axis : rect->axes()) axis->setVisible(visible);
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        for (QCPAxis* axis : m_panels[i].rect->axes()) axis->setVisible(visible && isThere(i));
    if (m_legend) m_legend->setVisible(visible);
}

void FigureFrame::restyle() {
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const Panel& panel = m_panels[i];
        for (std::size_t each = 0; each < panelOf(i).series.size(); ++each) {
            const FigureSeries& series = panelOf(i).series[each];
            const Drawn& drawn = panel.series[each];
            const QPen pen = penOf(series, m_style);
            if (drawn.line) styleLine(drawn, each, series, pen);
            if (!drawn.path) continue;
            const auto role = static_cast<int>(series.role);
            const QColor& colour = m_style.lines[role % PlotStyle::lineKinds];
            const bool isArea = series.kind == SeriesKind::area;
            drawn.path->setPen(isArea && series.isFaint ? Qt::NoPen : isArea ? QPen(colour, 1) : pen);
            drawn.path->setBrush(!isArea                                 ? QBrush(Qt::NoBrush)
                                 : series.stroke == SeriesStroke::strong ? QBrush(colour)
                                                                         : m_style.areaBrush(role));
            drawn.path->setHalo(panelOf(i).field ? QPen(m_style.behindWords().color(), pen.widthF() + 2.2)
                                                 : QPen(Qt::NoPen));
        }
        for (std::size_t level = 0; level < m_shown.figure.levels.size(); ++level)
            panel.levels[level]->setPen(m_shown.figure.levels[level].isMain
                                            ? QPen(m_style.text, 1, Qt::DashDotLine)
                                            : QPen(m_style.zeroLine, 1, Qt::DashLine));
        if (!panelOf(i).top || panelOf(i).topPerX == 0)
            panel.rect->axis(QCPAxis::atTop)->grid()->setVisible(false);
        panel.zone->setPen(Qt::NoPen);
        panel.zone->setBrush(m_style.areaBrush(2));
        m_panels[i].bands.setStyle(m_style);
        panel.layers->setStyle(m_style);
        if (panel.field) panel.field->setStyle(m_style);
        if (const std::size_t names = panelOf(i).y.names.size(); names > 0)
            panel.rect->setMinimumSize(
                leastPanel, std::max(leastPanel, int(double(names) * QFontMetricsF(m_style.font).height())));
        if (panel.handle) panel.handle->setStyle(m_style);
        if (panel.runs) panel.runs->setStyle(m_style);
        if (!panel.marks || m_isCleared) continue;
        panel.marks->setStyle(m_style);
        QVector<CurveMark> marks;
        for (const FigureMark& mark : panelOf(i).marks)
            marks.append({mark.kind, QPointF(mark.x * xFactorOf(i), mark.y * yFactorOf(i))});
        panel.marks->present(marks, m_shown.units.of(panelOf(i).x.quantity),
                             m_shown.units.of(panelOf(panel.first).y.quantity));
    }
    for (QCPItemText* name : m_levelNames) name->setBrush(m_style.behindWords());
    if (m_legend) m_style.applyTo(*m_legend);
    showTexts();  // files have another locale
}

void FigureFrame::styleLine(const Drawn& drawn, std::size_t index, const FigureSeries& series,
                            const QPen& pen) const {
    const auto role = static_cast<int>(series.role);
    drawn.line->setPen(pen);
    drawn.line->setLineStyle(isLine(series) ? QCPGraph::lsLine : QCPGraph::lsNone);
    drawn.line->setScatterStyle(scatterOf(series.points, index, pen.color(), m_style));
    drawn.line->setBrush(series.isFilled ? m_style.areaBrush(role) : QBrush(Qt::NoBrush));
    drawn.line->setChannelFillGraph(series.isFilled ? drawn.upper : nullptr);
    if (!drawn.upper) return;
    QPen thin = series.stroke == SeriesStroke::none ? pen : m_style.linePen(role);
    thin.setWidthF(0.8);
    drawn.upper->setPen(thin);
}

QCPGraph* FigureFrame::graph(std::size_t panel, std::size_t series) const {
    return m_panels.at(panel).series.at(series).line;
}

std::optional<std::size_t> FigureFrame::panelIn(const QCPAxisRect* rect) const {
    const auto found = std::ranges::find(m_panels, rect, &Panel::rect);
    return found == m_panels.end() ? std::nullopt : std::optional<std::size_t>(found - m_panels.begin());
}

void FigureFrame::setRunsIn(std::size_t panel, const QVector<RunMark>& marks) {
    RunMarks*& runs = m_panels.at(panel).runs;
    if (!runs) {
        runs = new RunMarks(m_plot, axisOf(panel, QCPAxis::atBottom), axisOf(panel, QCPAxis::atLeft));
        runs->setStyle(m_style);
    }
    if (!runs->present(marks)) return;
    fitUnlessZoomed();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
constexpr int leastPanel = 50;  // width and height [px]
const QMargins panelMargins(4, 4, 14, 4);

bool isPlain(const FigureQuantity& quantity, PlainNumber kind) {
    const auto* plain = std::get_if<PlainNumber>(&quantity);
    return plain && *plain == kind;
}

// Shape, colour and filling differ, never only the colour.
QCPScatterStyle scatterOf(SeriesPoints points, std::size_t index, const QColor& colour,
                          const PlotStyle& style) {
    using Shape = QCPScatterStyle::ScatterShape;
    constexpr Shape shapes[] = {QCPScatterStyle::ssDisc,     QCPScatterStyle::ssSquare,
                                QCPScatterStyle::ssTriangle, QCPScatterStyle::ssDiamond,
                                QCPScatterStyle::ssCross,    QCPScatterStyle::ssPlus,
                                QCPScatterStyle::ssCircle,   QCPScatterStyle::ssTriangleInverted};
    if (points == SeriesPoints::none) return {};
    if (points == SeriesPoints::stars)
        return QCPScatterStyle(QCPScatterStyle::ssStar, QPen(colour, 2), Qt::NoBrush, 15);
    if (points == SeriesPoints::dots) return QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, 3);
    const double size = points == SeriesPoints::joined ? 6 : 5;
    if (points == SeriesPoints::rings)
        return QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.text, 1), style.background, size);
    return QCPScatterStyle(shapes[index % std::size(shapes)], QPen(colour, 1.3), QBrush(style.background),
                           size);
}

QPen dashedPen(const QColor& colour, double width, const QList<qreal>& dashes) {
    QPen pen(colour, width);
    pen.setDashPattern(dashes);
    pen.setCapStyle(Qt::FlatCap);
    return pen;
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

/// The last panel of a row.
std::size_t lastOfRow(const StudyFigure& figure, std::size_t row) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i)
        if (figure.panels[i].row == row) last = i;
    return last;
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
    addPanels();
    connect(x(), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &FigureFrame::followTopAxes);
    for (std::size_t i = 0; i < m_panels.size(); ++i) showSeries(i);
    showLevels();
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
        if (begins) {
            row = new QCPLayoutGrid;
            const int place = 1 + static_cast<int>(panels[i].row);
            m_plot->plotLayout()->addElement(place, 0, row);
            row->setColumnSpacing(0);
            margins = new QCPMarginGroup(m_plot);
        }
        for (std::size_t k = m_panels[i].first; k <= i; ++k) m_panels[k].last = i;
        addPanel(i, *row);
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
    if (isShown && index > 0 && hasFirstY(index))
        m_plot->plotLayout()->setRowStretchFactor(1 + static_cast<int>(panelOf(index).row),
                                                  panelOf(index).height);
}

void FigureFrame::addPanel(std::size_t index, QCPLayoutGrid& row) {
    Panel& panel = m_panels[index];
    QCPAxisRect* rect = panel.rect = newAxisRect(*m_plot, Sides::free);
    const StudyPanel& shown = m_shown.figure.panels[index];
    const int column = row.columnCount();
    row.addElement(0, column, rect);
    row.setColumnStretchFactor(column, shown.width);
    rect->axis(QCPAxis::atTop)->setTickLabels(shown.top.has_value());
    rect->axis(QCPAxis::atTop)->setTicks(shown.top.has_value());
    if (index == 0) view(rect);
    if (!hasFirstY(index)) rect->axis(QCPAxis::atLeft)->setTickLabels(false);
    addZone(panel);
    panel.bands = FigureBands(rect);
    panel.layers = new LayerItems(rect);
    if (shown.handle) addHandle(index);
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
}

bool FigureFrame::hasOtherAxes(const ShownFigure& shown) const {
    const auto same = [&](const FigureAxis& a, const FigureAxis& b, std::size_t row) {
        return a.title == b.title && a.isLogarithmic == b.isLogarithmic && (row > 0 || a.range == b.range) &&
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
        if (!same(before.x, now.x, now.row) || !same(before.y, now.y, now.row)) return true;
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
                drawn.path = new QCPCurve(keys, values);
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
            QVector<QCPGraphData> points;
            for (std::size_t point = 0; point < each.x.size(); ++point)
                appendFinite(points, each.x[point] * xFactor, each.y[point] * yFactor);
            if (each.points != SeriesPoints::none)
                std::ranges::stable_sort(points, {}, [](const QCPGraphData& point) { return point.key; });
            drawn.line->setData(graphData(points));
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
        QVector<QCPGraphData> points;
        for (std::size_t point = 0; point < shown.upper.size(); ++point)
            appendFinite(points, shown.x[point] * xFactorOf(index), shown.upper[point] * yFactorOf(index));
        drawn.upper->setData(graphData(points));
    }
    while (drawn.texts.size() < shown.texts.size()) {
        drawn.texts.push_back(addText(m_panels[index].rect, QMargins(6, 2, 6, 2), {}));
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
    const bool isCrowded = std::ranges::count(m_shown.figure.panels, panel.row, &StudyPanel::row) > 2;
    const auto show = [&](const FigureAxis& axis, QCPAxis& drawn) {
        const ShownUnit unit = m_shown.units.of(axis.quantity);
        drawn.setScaleType(axis.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        const bool hasFew = panel.width < narrow || (isCrowded && drawn.orientation() == Qt::Horizontal);
        drawn.setTicker(ticker(axis.isLogarithmic, hasFew ? 2 : 5));
        if (isPlain(axis.quantity, PlainNumber::magnitude)) {
            drawn.setNumberFormat(QStringLiteral("eb"));
            drawn.setNumberPrecision(0);
        }
        const auto* parameter = std::get_if<KeptParameter>(&axis.quantity);
        const bool isUntitled = parameter && axis.title.isEmpty();
        drawn.setLabel(unit.axisLabel(isUntitled ? parameterTitle(**parameter) : translated(axis.title)));
    };
    show(panel.x, *rect.axis(QCPAxis::atBottom));
    if (hasFirstY(index)) show(panel.y, *rect.axis(QCPAxis::atLeft));
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
    if (!m_panels[index].handle) return;
    const std::optional<FigureHandle>& handle = panelOf(index).handle;
    if (handle)
        m_panels[index].handle->present(translated(handle->name), handle->x * factor,
                                        handle->snap ? std::optional(*handle->snap * factor) : std::nullopt);
    else
        m_panels[index].handle->hide();
}

void FigureFrame::showLevels() {
    const std::vector<FigureLevel>& levels = m_shown.figure.levels;
    for (Panel& panel : m_panels)
        while (panel.levels.size() < levels.size())
            panel.levels.push_back(addLevel(panel.rect, QStringLiteral("grid")));
    while (m_levelNames.size() < levels.size()) {
        const std::size_t last = lastOfRow(m_shown.figure, levels[m_levelNames.size()].row);
        QCPItemText* name =
            addText(m_panels[last].rect, QMargins(4, 1, 4, 1), Qt::AlignRight | Qt::AlignVCenter);
        name->setLayer(QStringLiteral("legend"));  // above the curves
        setAcross(*name->position);
        name->setFont(m_style.font);
        name->setColor(m_style.text);
        m_levelNames.push_back(name);
    }
    for (std::size_t i = 0; i < m_levelNames.size(); ++i) {
        const bool isShown = i < levels.size() && !m_isCleared;
        for (std::size_t k = 0; k < m_panels.size(); ++k) {
            const bool isThere = isShown && panelOf(k).row == levels[i].row;
            setLevel(*m_panels[k].levels[i],
                     isThere ? std::optional(levels[i].y * yFactorOf(k)) : std::nullopt);
        }
        m_levelNames[i]->setVisible(isShown && !levels[i].name.isEmpty());
        if (!isShown) continue;
        m_levelNames[i]->setText(translated(levels[i].name));
        m_levelNames[i]->position->setCoords(
            1, levels[i].y * yFactorOf(lastOfRow(m_shown.figure, levels[i].row)));
    }
}

// As the plot writes it, which in files is another way.
QString FigureFrame::numberOf(const FigureNumber& number) const {
    if (!number.words.isEmpty()) return translated(number.words);
    if (isPlain(number.quantity, PlainNumber::magnitude))
        return magnitudeText(number.value, m_plot->locale());
    if (isPlain(number.quantity, PlainNumber::runTime)) return runTimeText(number.value, m_plot->locale());
    const ShownUnit unit = m_shown.units.of(number.quantity);
    const QString value = numberText(number.value * unit.factor, number.digits, m_plot->locale());
    return unit.unit.isEmpty() ? value : value + QChar(QChar::Nbsp) + unit.unit;
}

QString FigureFrame::textOf(const FigureText& text) const {
    QString words = translated(text.pattern);
    for (std::size_t i = 0; i < text.numbers.size(); ++i)
        words.replace(QLatin1Char('%') + QString::number(i + 1), numberOf(text.numbers[i]));
    return words;
}

void FigureFrame::showTexts() {
    if (isEmpty()) return;
    QStringList parts;
    for (const FigureText& text : m_shown.figure.caption) parts << textOf(text);
    m_captionText = parts.join(betweenParts);
    m_caption->setText(m_captionText);
    const Message& summary = m_shown.figure.summary;
    m_summary = summary.isEmpty() ? m_captionText : translated(summary);
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
        for (const FigureText& name : panelOf(i).y.names)
            names->addTick(double(names->ticks().size()), textOf(name));
        axisOf(i, QCPAxis::atLeft)->grid()->setVisible(names->ticks().isEmpty());
        if (!names->ticks().isEmpty()) axisOf(i, QCPAxis::atLeft)->setTicker(names);
        for (std::size_t each = 0; each < panelOf(i).series.size(); ++each) {
            const FigureSeries& series = panelOf(i).series[each];
            const std::vector<QCPItemText*>& texts = m_panels[i].series[each].texts;
            for (std::size_t point = 0; point < texts.size(); ++point) {
                const bool isShown = point < series.texts.size() && point < series.x.size();
                texts[point]->setText(isShown ? textOf(series.texts[point]) : QString());
                if (isShown)
                    texts[point]->position->setCoords(series.x[point] * xFactorOf(i),
                                                      series.y[point] * yFactorOf(i));
            }
        }
    }
}

// On the other side of its point where a text would end beyond the axes.
void FigureFrame::placeTexts() {
    constexpr auto above = Qt::AlignLeft | Qt::AlignBottom, below = Qt::AlignRight | Qt::AlignTop;
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        for (std::size_t each = 0; each < panelOf(i).series.size(); ++each)
            for (QCPItemText* text : m_panels[i].series[each].texts) {
                const double at = text->position->pixelPosition().x();
                const double before = at - m_panels[i].rect->left(), behind = m_panels[i].rect->right() - at;
                const double width = QFontMetricsF(text->font()).horizontalAdvance(text->text()) +
                                     text->padding().left() + text->padding().right();
                const bool isAbove = panelOf(i).series[each].isTextBelow ? width > before && behind > before
                                                                         : width < behind || behind > before;
                text->setPositionAlignment(isAbove ? above : below);
            }
}

// One part below the other where they are too long for one line, and in as many lines as a part needs.
void FigureFrame::breakCaption() {
    const double room = m_plot->viewport().width() - 20;
    const auto fits = [&, metrics = QFontMetricsF(m_caption->font())](const QString& text) {
        return metrics.horizontalAdvance(text) <= room;
    };
    QStringList lines = fits(m_captionText) ? QStringList(m_captionText) : m_captionText.split(betweenParts);
    for (int i = 0; i < lines.size(); ++i)
        for (qsizetype end = lines[i].size(); !fits(lines[i]) && end > 0;) {
            end = lines[i].lastIndexOf(QLatin1Char(' '), end - 1);
            if (end <= 0 || !fits(lines[i].left(end))) continue;
            lines.insert(i + 1, lines[i].mid(end + 1));
            lines[i].truncate(end);
        }
    m_caption->setText(lines.join(QLatin1Char('\n')));
}

// As far as they are in view: files do not clip.
void FigureFrame::placeZones() {
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        if (!m_isCleared) m_panels[i].bands.place();
        const QCPRange range = axisOf(i, QCPAxis::atLeft)->range();
        const std::optional<FigureZone>& zone = panelOf(i).zone;
        const double from = zone ? zone->from * yFactorOf(i) : 0;
        const bool isShown = !m_isCleared && zone && range.upper > from;
        m_panels[i].zone->setVisible(isShown);
        m_panels[i].zoneName->setVisible(isShown);
        if (!isShown) continue;
        m_panels[i].zone->topLeft->setCoords(0, range.upper);
        m_panels[i].zone->bottomRight->setCoords(1, std::max(from, range.lower));
        m_panels[i].zoneName->setText(translated(zone->name));
    }
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
            const auto role = static_cast<int>(panelOf(i).series[each].role);
            const Drawn& drawn = panel.series[each];
            const QPen pen = panelOf(i).series[each].isFaint ? m_style.ghostPen(role) : m_style.linePen(role);
            if (drawn.line) drawn.line->setPen(pen);
            if (drawn.line) styleLine(panel, each, panelOf(i).series[each]);
            if (!drawn.path) continue;
            const bool isArea = panelOf(i).series[each].kind == SeriesKind::area;
            const bool isFaint = panelOf(i).series[each].isFaint;
            drawn.path->setPen(isArea && isFaint ? Qt::NoPen : isArea ? QPen(m_style.lines[role], 1) : pen);
            drawn.path->setBrush(isArea ? m_style.areaBrush(role) : QBrush(Qt::NoBrush));
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

void FigureFrame::styleLine(const Panel& panel, std::size_t index, const FigureSeries& series) const {
    const auto role = static_cast<int>(series.role);
    const Drawn& drawn = panel.series[index];
    QPen pen = drawn.line->pen();
    const QColor colour = series.stroke >= SeriesStroke::dashed ? m_style.text : pen.color();
    if (series.stroke == SeriesStroke::wide) pen.setWidthF(1.6 * pen.widthF());
    if (series.stroke == SeriesStroke::dotted) pen = dashedPen(colour, 0.6 * pen.widthF(), {2, 3});
    if (series.stroke == SeriesStroke::dashed) pen = dashedPen(colour, pen.widthF(), {7, 5});
    if (series.stroke == SeriesStroke::strong) pen = QPen(colour, 2.4);
    drawn.line->setPen(pen);
    const bool isLine = series.points == SeriesPoints::none || series.points == SeriesPoints::joined;
    drawn.line->setLineStyle(isLine ? QCPGraph::lsLine : QCPGraph::lsNone);
    drawn.line->setScatterStyle(scatterOf(series.points, index, drawn.line->pen().color(), m_style));
    drawn.line->setBrush(series.isFilled ? m_style.areaBrush(role) : QBrush(Qt::NoBrush));
    drawn.line->setChannelFillGraph(series.isFilled ? drawn.upper : nullptr);
    if (!drawn.upper) return;
    QPen thin = m_style.linePen(role);
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

const AxisTarget* FigureFrame::targetIn(const QCPAxisRect* rect) const {
    const std::optional<std::size_t> panel = panelIn(rect);
    return panel && panelOf(*panel).x.target ? &*panelOf(*panel).x.target : nullptr;
}

void FigureFrame::giveMeanings(PlotWidget& plot) const {
    if (isEmpty()) return;
    CurveMeaning meaning{.xUnit = m_xUnit.dimensionless ? QString() : m_xUnit.unit, .yUnit = m_yUnit.unit};
    if (std::holds_alternative<KeptParameter>(panelOf(0).x.quantity))
        meaning = CurveMeaning::overParameter(meaning.xUnit, meaning.yUnit);
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
        if (const QCPGraph* line = m_panels.front().series[i].line) plot.setMeaning(line, exact);
    }
}

std::optional<std::size_t> FigureFrame::rowAt(QPointF place) const {
    constexpr double nearby = 10;  // [px]
    double least = nearby;
    std::optional<std::size_t> found;
    for (const FigureSeries& series : panelOf(0).series)
        for (std::size_t i = 0; i < series.rows.size(); ++i) {
            const QPointF way =
                pixelOf({series.x[i] * m_xUnit.factor, series.y[i] * m_yUnit.factor}) - pixelOf(place);
            const double distance = std::hypot(way.x(), way.y());
            if (distance > least) continue;
            least = distance;
            found = series.rows[i];
        }
    return found;
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
    places.start = [this] {
        return here().x() ? std::optional(QPointF(*here().x(), here().y().value_or(y()->range().center())))
                          : std::nullopt;
    };
    places.marks = [this] {
        QVector<QPointF> marks;
        if (!isEmpty() && !panelOf(0).series.empty() && graph(0, panelOf(0).marked)->visible())
            for (const FigureMark& mark : panelOf(0).marks)
                marks.append({mark.x * m_xUnit.factor, mark.y * m_yUnit.factor});
        return marks;
    };
    return places;
}

}  // namespace drillwave

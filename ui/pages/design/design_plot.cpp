// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/pages/study/output_box.h"
#include "ui/plot/axis_view.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"

namespace drillwave {
namespace {

constexpr int mostColumnsOfDesigns = 4;  // of the legend
constexpr double nearDesignPixels = 14;
constexpr int mostMarkedDesigns = 40;  // beyond, points would be a line
constexpr double halfWidthOfOne = 0.4;
constexpr double halfWidthOfWord = 0.3;
constexpr double halfWidthOfPoint = 1e-3;  // a point that the pointer finds as part of a curve
constexpr double barWidth = 0.8;
constexpr int leastSide = 50;  // of any rectangle of axes [px]

bool haveSameAxes(const DesignPicture& a, const DesignPicture& b) {
    if (a.map || b.map) return a.map && b.map && haveSameAxes(*a.map, *b.map);
    return a.xName == b.xName && a.x == b.x && a.isLogarithmic == b.isLogarithmic &&
           a.value.output == b.value.output && a.value.unit.unit == b.value.unit.unit &&
           a.series.size() == b.series.size() &&
           (a.series.isEmpty() || (a.series[0].aim.first().x() == b.series[0].aim.first().x() &&
                                   a.series[0].aim.last().x() == b.series[0].aim.last().x()));
}

// Words have nothing between them: each value has a width of its own, or its band could not be seen.
void setWidened(QCPGraph& graph, const QVector<QPointF>& points, double halfWidth) {
    QVector<QCPGraphData> data;
    for (const QPointF& point : points) {
        if (!data.isEmpty()) data.append({point.x() - 0.5, std::nan("")});
        data.append({point.x() - halfWidth, point.y()});
        data.append({point.x(), point.y()});
        data.append({point.x() + halfWidth, point.y()});
    }
    graph.data()->set(data, true);
}

void setJoined(QCPGraph& graph, const QVector<QPointF>& points) {
    QVector<QCPGraphData> data;
    for (const QPointF& point : points) data.append({point.x(), point.y()});
    graph.data()->set(data);
}

void setPoint(QCPGraph& graph, const std::optional<QPointF>& point) {
    graph.data()->clear();
    if (point) graph.addData(point->x(), point->y());
}

// Gives the room of axes that are not shown to the others.
void setShown(QCPAxisRect& rect, bool isShown) {
    rect.setVisible(isShown);
    rect.setMinimumSize(isShown ? leastSide : 0, isShown ? leastSide : 0);
    rect.setMaximumSize(isShown ? QWIDGETSIZE_MAX : 0, isShown ? QWIDGETSIZE_MAX : 0);
    rect.setAutoMargins(isShown ? QCP::msAll : QCP::msNone);
    if (!isShown) rect.setMargins(QMargins());
}

// More names are upright, or they would overlap.
constexpr qsizetype mostWordsAbreast = 8;

}  // namespace

QString inLines(const QString& name, qsizetype count) {
    constexpr qsizetype lettersAbreast = 60, leastLetters = 8;
    const qsizetype most =
        count > mostWordsAbreast ? 2 * leastLetters : std::max(leastLetters, lettersAbreast / count);
    QString text;
    qsizetype line = 0;
    for (const QString& word : name.split(QLatin1Char(' '))) {
        const bool isNew = line > 0 && line + 1 + word.size() > most;
        if (line > 0) text += isNew ? QLatin1Char('\n') : QLatin1Char(' ');
        line = isNew || line == 0 ? word.size() : line + 1 + word.size();
        text += word;
    }
    return text;
}

DesignPlot::DesignPlot(QCustomPlot* plot) : StudyFrame(plot) {
    layOutAnew();
    addRects();
    m_map = std::make_unique<DesignMap>(m_plot, m_rect);
    const auto curve = [&](const QString& name) {
        QCPGraph* graph = addCurve(x(), y());
        graph->setAdaptiveSampling(false);
        graph->setName(name);
        return graph;
    };
    m_low = curve(QString());
    m_high = curve(tr("5 % to 95 %"));
    m_high->setChannelFillGraph(m_low);
    for (QCPGraph* edge : {m_low, m_high}) edge->setSelectable(QCP::stNone);
    m_mean = curve(tr("mean"));
    m_nominal = curve(tr("values entered"));
    const auto mark = [&](const QString& name) {
        QCPGraph* graph = m_plot->addGraph(x(), y());
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setName(name);
        graph->setSelectable(QCP::stNone);
        return graph;
    };
    m_ties = mark(tr("equally good"));
    m_nominalMark = mark({});
    m_robustMark = mark({});
    m_presentMark = mark({});  // only for the legend: HereMark draws it
    addHere();
    addRunMarks();
    connect(plot, &QCustomPlot::beforeReplot, this,
            [this] { wrapLegend(*m_legend, m_plot->viewport().width(), mostColumnsOfDesigns); });
    setStyle(PlotStyle::forPaper());
    showNothing({});
}

DesignPlot::~DesignPlot() = default;

void DesignPlot::addRects() {
    useLegend(QMargins(7, 6, 7, 4));
    m_plot->plotLayout()->addElement(1, 0, m_legend);
    m_plot->plotLayout()->setRowStretchFactor(1, 1e-3);
    m_legend->setLayer(QStringLiteral("legend"));
    m_legend->setWrap(mostColumnsOfDesigns);  // files are drawn without a replot
    view(newAxisRect(*m_plot, Sides::linked));
    m_rect->setMinimumMargins(QMargins(4, 4, 14, 4));
    m_plot->plotLayout()->addElement(0, 0, m_rect);
    m_below = new QCPLayoutGrid;
    m_below->setColumnSpacing(6);
    m_plot->plotLayout()->addElement(2, 0, m_below);
    m_scatterRect = newAxisRect(*m_plot, Sides::linked);
    m_barRect = newAxisRect(*m_plot, Sides::linked);
    m_below->addElement(0, 0, m_scatterRect);
    m_below->addElement(0, 1, m_barRect);
    const auto points = [&] {
        QCPGraph* graph =
            m_plot->addGraph(m_scatterRect->axis(QCPAxis::atBottom), m_scatterRect->axis(QCPAxis::atLeft));
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setSelectable(QCP::stNone);
        return graph;
    };
    m_all = points();
    m_pareto = points();
    m_best = points();
    constexpr int fewTicks = 3;  // of long numbers in a narrow plot
    m_scatterRect->axis(QCPAxis::atBottom)->ticker()->setTickCount(fewTicks);
    m_barRect->axis(QCPAxis::atBottom)->setLabel(tr("share of the scatter\n(filled: by itself)"));
    m_barRect->axis(QCPAxis::atBottom)->setNumberPrecision(2);
}

void DesignPlot::present(const DesignPicture& picture) {
    const bool otherAxes =
        (m_picture.series.isEmpty() && !m_picture.map) || !haveSameAxes(m_picture, picture);
    m_picture = picture;
    m_summary = picture.summary;
    makeGraphs();
    fillLegend();
    m_view->adjust([&] {
        m_map->present(isMap() ? &*m_picture.map : nullptr);
        if (isMap()) return;
        setScale(*y(), QCPAxis::stLinear);
        const auto scale = picture.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear;
        if (x()->scaleType() != scale && !picture.series.isEmpty())
            x()->setRange(picture.series[0].aim.first().x(), picture.series[0].aim.last().x());
        setScale(*x(), scale);
    });
    nameAxes();
    showMarks();
    showScatter();
    showBars();
    setStyle(m_style);
    finish(otherAxes);
}

void DesignPlot::nameAxes() {
    if (m_picture.words.isEmpty()) {
        if (x()->scaleType() == QCPAxis::stLinear) x()->setTicker(QSharedPointer<QCPAxisTicker>::create());
    } else {
        const auto words = QSharedPointer<QCPAxisTickerText>::create();
        for (int i = 0; i < m_picture.words.size(); ++i)
            words->addTick(i, inLines(m_picture.words[i], m_picture.words.size()));
        x()->setTicker(words);
    }
    x()->setTickLabelRotation(m_picture.words.size() > mostWordsAbreast ? -90 : 0);
    x()->setLabel(m_picture.xName.isEmpty() ? tr("this scenario") : m_picture.x.axisLabel(m_picture.xName));
    x()->setTickLabels(!m_picture.xName.isEmpty());
    const QString value = m_picture.value.output
                              ? m_picture.value.unit.axisLabel(outputName(*m_picture.value.output))
                              : QString();
    y()->setLabel(isMap() ? m_picture.map->yLabel() : value);
    if (isMap()) m_map->setLabel(m_picture.value.unit.axisLabel(m_picture.aimName));
}

void DesignPlot::clear() {
    m_map->present(nullptr);
    m_picture = {};
    makeGraphs();
    fillLegend();
    showMarks();
    showScatter();
    showBars();
}

// The series of the best design has its band, the others only their first aim.
void DesignPlot::makeGraphs() {
    const auto nameOf = [&](const DesignSeries& series) {
        return series.name.isEmpty() ? m_picture.statisticName : series.name;
    };
    const bool sameNames = m_aims.size() == m_picture.series.size() &&
                           std::equal(m_aims.begin(), m_aims.end(), m_picture.series.begin(),
                                      [&](const QCPGraph* graph, const DesignSeries& series) {
                                          return graph->name() == nameOf(series);
                                      });
    if (!sameNames) {
        for (QCPGraph* graph : m_aims) m_plot->removeGraph(graph);
        m_aims.clear();
        for (const DesignSeries& series : m_picture.series) {
            QCPGraph* graph = addCurve(x(), y());
            graph->setAdaptiveSampling(false);
            graph->setName(nameOf(series));
            m_aims.append(graph);
        }
    }
    const bool ofWords = !m_picture.words.isEmpty(), isOne = m_picture.words.size() == 1;
    const auto set = [&](QCPGraph& graph, const QVector<QPointF>& points, double halfWidth) {
        if (ofWords)
            setWidened(graph, points, isOne ? halfWidthOfOne : halfWidth);
        else
            setJoined(graph, points);
    };
    for (int i = 0; i < m_aims.size(); ++i) set(*m_aims[i], m_picture.series[i].aim, halfWidthOfPoint);
    const DesignSeries marked =
        m_picture.series.isEmpty() ? DesignSeries() : m_picture.series[m_picture.marked];
    set(*m_low, marked.low, halfWidthOfWord);
    set(*m_high, marked.high, halfWidthOfWord);
    set(*m_mean, marked.mean, halfWidthOfWord);
    set(*m_nominal, marked.nominal, halfWidthOfWord);
}

// A map has no curves. Each mark is named with its design.
void DesignPlot::fillLegend() {
    QVector<QCPGraph*> entries;
    const auto add = [&](QCPGraph* mark, const QString& words, const QString& design) {
        mark->setName(design.isEmpty() ? words : QStringLiteral("%1: %2").arg(words, design));
        entries.append(mark);
    };
    if (!m_picture.presentName.isEmpty()) add(m_presentMark, tr("present design"), m_picture.presentName);
    add(m_robustMark, tr("best for uncertain rock"), m_picture.robustName);
    if (!m_picture.ties.isEmpty()) entries.append(m_ties);
    if (m_picture.nominal) add(m_nominalMark, tr("best for the values entered"), m_picture.nominalName);
    if (!isMap()) entries = QVector<QCPGraph*>{m_high, m_mean, m_nominal} + entries + m_aims;
    QVector<QCPGraph*> present;
    for (int i = 0; i < m_legend->itemCount(); ++i)
        if (auto* item = qobject_cast<QCPPlottableLegendItem*>(m_legend->item(i)))
            present.append(qobject_cast<QCPGraph*>(item->plottable()));
    if (present == entries) return;
    m_legend->clearItems();
    for (QCPGraph* graph : entries) graph->addToLegend(m_legend);
}

void DesignPlot::showMarks() {
    setPoint(*m_robustMark, m_picture.robust);
    setPoint(*m_nominalMark, m_picture.nominal);
    m_ties->data()->clear();
    for (const QPointF& tie : m_picture.ties) m_ties->addData(tie.x(), tie.y());
}

void DesignPlot::showScatter() {
    const bool isShown = !m_picture.secondAim.isEmpty();
    setShown(*m_scatterRect, isShown);
    m_below->setColumnStretchFactor(0, isShown ? 1 : 1e-3);
    for (QCPGraph* graph : {m_all, m_pareto, m_best}) graph->data()->clear();
    for (qsizetype d = 0; d < m_picture.designs.size(); ++d) {
        const QPointF& at = m_picture.designs[d];
        if (!std::isfinite(at.x()) || !std::isfinite(at.y())) continue;
        (m_picture.pareto[d] ? m_pareto : m_all)->addData(at.x(), at.y());
        if (d == m_picture.robustNumber) m_best->addData(at.x(), at.y());
    }
    m_scatterRect->axis(QCPAxis::atBottom)->setLabel(m_picture.firstAim);
    m_scatterRect->axis(QCPAxis::atLeft)->setLabel(m_picture.secondAim);
    // Either may be empty, and the best design is in one of them.
    bool isScaled = false;
    for (QCPGraph* graph : {m_all, m_pareto}) {
        if (graph->data()->isEmpty()) continue;
        graph->rescaleAxes(isScaled);
        isScaled = true;
    }
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
        QCPAxis* axis = m_scatterRect->axis(side);
        QCPRange range = axis->range();
        const double room = std::max(0.08 * range.size(), 0.01 * std::abs(range.center()));
        axis->setRange(range.lower - room, range.upper + room);
    }
}

// Shows one group of bars below the other, each with its output's name above.
void DesignPlot::showBars() {
    for (const BarPair& pair : m_bars)
        for (QCPBars* bars : {pair.total, pair.first}) m_plot->removePlottable(bars);
    m_bars.clear();
    for (QCPItemText* name : m_barNames) m_plot->removeItem(name);
    m_barNames.clear();
    QCPAxis *key = m_barRect->axis(QCPAxis::atLeft), *value = m_barRect->axis(QCPAxis::atBottom);
    const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
    double place = 0;
    for (const DesignPicture::Bars& output : m_picture.bars) {
        auto* name = addItem<QCPItemText>(m_barRect);
        name->setText(output.bars.isEmpty() ? tr("%1: no scatter").arg(output.output) : output.output);
        name->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        name->position->setCoords(0.01, place);
        m_barNames.append(name);
        BarPair pair{new QCPBars(key, value), new QCPBars(key, value)};
        for (QCPBars* bars : {pair.total, pair.first}) {
            bars->setWidth(barWidth);
            bars->setSelectable(QCP::stNone);
        }
        for (const SobolBar& bar : output.bars) {
            place -= 1;
            names->addTick(place, bar.name);
            pair.total->addData(place, bar.total);
            pair.first->addData(place, bar.first);
        }
        m_bars.append(pair);
        place -= 1;
    }
    setShown(*m_barRect, !m_picture.bars.isEmpty());
    m_below->setColumnStretchFactor(1, m_picture.bars.isEmpty() ? 1e-3 : 1);
    constexpr double heightBelow = 0.8;  // over that of the first axes
    m_plot->plotLayout()->setRowStretchFactor(2, hasRowBelow() ? heightBelow : 1e-3);
    key->setTicker(names);
    key->setRange(place + 0.4, 0.6);
    value->setRange(0, 1.02);
}

void DesignPlot::restyle() {
    const PlotStyle& style = m_style;
    style.applyTo(*m_scatterRect);
    style.applyTo(*m_barRect);
    m_map->setStyle(style);
    const bool isFew = !m_picture.series.isEmpty() && m_picture.series[0].aim.size() <= mostMarkedDesigns;
    for (int i = 0; i < m_aims.size(); ++i) {
        QPen pen = style.linePen(i);
        if (i == m_picture.marked) pen.setWidthF(1.5 * pen.widthF());
        m_aims[i]->setPen(pen);
        m_aims[i]->setScatterStyle(isFew ? QCPScatterStyle(QCPScatterStyle::ssDisc, pen.color(), 4)
                                         : QCPScatterStyle());
    }
    m_low->setPen(Qt::NoPen);
    m_high->setPen(Qt::NoPen);
    m_high->setBrush(style.areaBrush(m_picture.marked));
    QPen mean(style.text, style.lineWidth, Qt::DashLine);
    m_mean->setPen(mean);
    QPen nominal(style.text, style.lineWidth, Qt::DotLine);
    m_nominal->setPen(nominal);
    const auto diamond = [&](const QBrush& brush, double size) {
        return QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(style.text, 1.4), brush, size);
    };
    m_robustMark->setScatterStyle(diamond(style.text, 12));
    m_nominalMark->setScatterStyle(diamond(style.background, 12));
    m_ties->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.text, 1.2), Qt::NoBrush, 12));
    m_all->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.frame, 1), Qt::NoBrush, 5));
    m_pareto->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(style.lines[0], 1), style.lines[0], 7));
    m_best->setScatterStyle(diamond(style.text, 11));
    for (int i = 0; i < m_bars.size(); ++i) {
        m_bars[i].total->setPen(QPen(style.lines[i % PlotStyle::lineKinds], 1));
        m_bars[i].total->setBrush(style.areaBrush(i));
        m_bars[i].first->setPen(Qt::NoPen);
        m_bars[i].first->setBrush(style.lines[i % PlotStyle::lineKinds]);
    }
    for (QCPItemText* name : m_barNames) {
        name->setFont(style.font);
        name->setColor(style.text);
    }
    m_presentMark->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.text, 2), style.background, 10));
    const double rows = m_barRect->axis(QCPAxis::atLeft)->range().size();
    const int needed = m_barNames.isEmpty() ? 0 : int(std::ceil(rows * QFontMetricsF(style.font).height()));
    if (!m_barNames.isEmpty()) m_barRect->setMinimumSize(leastSide, std::max(leastSide, needed));
}

int DesignPlot::barLines() const {
    return m_barNames.isEmpty() ? 0 : int(std::ceil(m_barRect->axis(QCPAxis::atLeft)->range().size()));
}

void DesignPlot::setRanges() {
    if (isMap()) return m_map->setRanges();
    if (m_picture.series.isEmpty()) return;
    QCPRange along, values;
    bool isFirst = true;
    const auto take = [&](const QCPGraph* graph) {
        for (const QCPGraphData& point : *graph->data()) {
            if (!std::isfinite(point.value)) continue;
            if (isFirst) {
                along = QCPRange(point.key, point.key);
                values = QCPRange(point.value, point.value);
            }
            isFirst = false;
            along.expand(point.key);
            values.expand(point.value);
        }
    };
    for (const QCPGraph* graph : curves()) take(graph);
    const double room = 0.03;
    const double ratio = m_picture.isLogarithmic ? std::pow(along.upper / along.lower, room) : 1;
    const double step = m_picture.isLogarithmic ? 0 : room * along.size();
    x()->setRange(along.lower / ratio - step, along.upper * ratio + step);
    // Leaves room for whole names: one beyond the edge is not drawn.
    if (m_picture.words.size() > 1) x()->setRange(-0.5, double(m_picture.words.size()) - 0.5);
    const double size = std::max(values.size(), 0.02 * std::abs(values.upper));
    y()->setRange(values.lower - 0.06 * size, values.upper + 0.06 * size);
}

std::function<double(double x)> DesignPlot::atWords(const QCPGraph& graph) {
    return [points = graph.data()](double x) {
        const auto at = points->findBegin(std::round(x) - halfWidthOfPoint / 2, false);
        return at == points->constEnd() ? std::nan("") : at->value;
    };
}

QVector<QCPGraph*> DesignPlot::curves() const {
    return m_aims + QVector<QCPGraph*>{m_low, m_high, m_mean, m_nominal};
}

KeyPlaces DesignPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.on = isMap() ? KeyPlaces::On::area : KeyPlaces::On::points;
    places.words = [this](QPointF place) {
        return mapWords(place).replace(QStringLiteral(" · "), QStringLiteral("\n"));
    };
    places.start = [this] { return m_picture.robust; };
    places.targets = [this] {
        QVector<QPointF> designs;
        if (isMap())
            for (std::uint64_t d = 0; d < m_picture.map->grid().size(); ++d)
                designs.append(placeOnMap(*m_picture.map, d));
        return designs;
    };
    places.marks = [this] {
        QVector<QPointF> marks;
        for (const auto& mark : {m_picture.robust, m_picture.nominal})
            if (mark) marks.append(*mark);
        return marks;
    };
    return places;
}

QString DesignPlot::mapWords(QPointF place) const {
    const auto point = isMap() ? m_picture.map->pointAt(place) : std::nullopt;
    return point ? m_picture.map->textAt(*point, m_plot->locale()) : QString();
}

std::optional<std::uint64_t> DesignPlot::designAt(const QCPAxisRect* rect, QPointF coordinates) const {
    std::optional<std::uint64_t> found;
    double nearest = nearDesignPixels;
    const auto pixelIn = [](const QCPAxisRect* of, QPointF at) {
        return QPointF(of->axis(QCPAxis::atBottom)->coordToPixel(at.x()),
                       of->axis(QCPAxis::atLeft)->coordToPixel(at.y()));
    };
    if (rect == m_scatterRect && !m_picture.secondAim.isEmpty()) {
        for (qsizetype d = 0; d < m_picture.designs.size(); ++d) {
            const double away =
                QLineF(pixelIn(rect, m_picture.designs[d]), pixelIn(rect, coordinates)).length();
            if (!(away < nearest)) continue;
            nearest = away;
            found = static_cast<std::uint64_t>(d);
        }
        return found;
    }
    if (rect != m_rect) return {};
    if (isMap()) return m_map->designAt(coordinates);
    // Along the choice any height will do while there is one series; of several the nearest point.
    const bool isOne = m_picture.series.size() == 1;
    if (isOne) nearest = std::numeric_limits<double>::infinity();
    for (const DesignSeries& series : m_picture.series)
        for (qsizetype i = 0; i < series.aim.size(); ++i) {
            const QPointF away = pixelIn(rect, series.aim[i]) - pixelIn(rect, coordinates);
            const double distance = isOne ? std::abs(away.x()) : std::hypot(away.x(), away.y());
            if (!(distance < nearest)) continue;
            nearest = distance;
            found = series.designs[i];
        }
    return found;
}

}  // namespace drillwave

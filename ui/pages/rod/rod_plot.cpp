// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/rod_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int usualColumns = 2;     // of the legend: compression and tension
constexpr int mostColumns = 6;      // of that of runs
constexpr double markReach = 12;    // of a click around a mark [px]
constexpr double sameHeight = 0.5;  // of two marks or curves [px]
/// A strength this many times the largest stress would squeeze the curves.
constexpr double strengthInView = 2.5;
/// Of the waves left, a peak that is not above that of the blow by this needs no number of its own.
constexpr double tellingDifference = 1.02;

// By name: their factors follow the scenario.
bool sameUnits(const ShownUnits& a, const ShownUnits& b) {
    return a.stress.unit == b.stress.unit && a.length.unit == b.length.unit;
}

QString nameOf(RodLine line) {
    switch (line) {
        case RodLine::compression:
            return RodPlot::tr("largest compression in the blow");
        case RodLine::tension:
            return RodPlot::tr("largest tension in the blow");
        case RodLine::compressionAfter:
            return RodPlot::tr("compression of the waves left");
        case RodLine::tensionAfter:
            return RodPlot::tr("tension of the waves left");
    }
    return {};
}

/// Compression and tension in two colours, the waves left thinner and dashed.
QPen penOf(const PlotStyle& style, RodLine line) {
    QPen pen = style.linePen(0);
    pen.setColor(style.lines[isTension(line) ? 1 : 0]);
    if (isAfter(line)) {
        pen.setDashPattern({5, 3});
        pen.setCapStyle(Qt::FlatCap);
    }
    return pen;
}

/// Along the compression to the bit, and back along the tension: two lines.
QSharedPointer<QCPCurveDataContainer> outlineOf(const RodCurves& curves) {
    QVector<QCPCurveData> points;
    const auto append = [&](const QCPGraphData& point) {
        points.append({double(points.size()), point.key, point.value});
    };
    const QCPGraphDataContainer& compression = *curves.curve(RodLine::compression);
    const QCPGraphDataContainer& tension = *curves.curve(RodLine::tension);
    std::for_each(compression.constBegin(), compression.constEnd(), append);
    if (!points.isEmpty()) append({points.last().key, std::numeric_limits<double>::quiet_NaN()});
    for (auto point = tension.constEnd(); point != tension.constBegin();) append(*--point);
    auto outline = QSharedPointer<QCPCurveDataContainer>::create();
    outline->set(points, true);
    return outline;
}

}  // namespace

RodPlot::RodPlot(QCustomPlot* plot) : StudyFrame(plot) {
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 12, 4));
    view(plot->axisRect());
    m_header = addHeader(2);
    m_legend->setWrap(usualColumns);
    addRunLegend();
    m_runs = new RunPaths(x(), y(), m_runLegend, RunPaths::thin);
    for (const RodLine line : rodLines) {
        QCPGraph* graph = addCurve(x(), y());
        graph->setName(nameOf(line));
        m_graphs[static_cast<std::size_t>(line)] = graph;
    }
    addStrength(m_yield);
    addStrength(m_fatigue);
    for (Mark& mark : m_marks) addMark(mark);
    addHere();
    connect(plot, &QCustomPlot::beforeReplot, this, &RodPlot::followLegend);
    connect(plot, &QCustomPlot::beforeReplot, this, [this] {
        wrapLegend(*m_legend, m_plot->width(), usualColumns);
        wrapLegend(*m_runLegend, m_plot->width(), mostColumns);
    });
    setStyle(PlotStyle::forPaper());
    showNothing({});
}

// Below that of the page, above the caption.
void RodPlot::addRunLegend() {
    m_runLegend = new QCPLegend;
    m_runLegend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_runLegend->setMargins(QMargins(7, 0, 0, 0));
    m_header->insertRow(1);
    m_header->addElement(1, 0, m_runLegend);
    m_runLegend->setLayer(QStringLiteral("legend"));
}

void RodPlot::addStrength(Strength& strength) {
    for (QCPItemStraightLine*& line : strength.lines) line = addLevel(m_rect);
    strength.name = addText(m_rect, QMargins(6, 1, 6, 1), Qt::AlignCenter);
    setAcross(*strength.name->position);
}

void RodPlot::addMark(Mark& mark) {
    mark.ring = addItem<QCPItemTracer>(m_rect);
    mark.ring->setStyle(QCPItemTracer::tsCircle);
    mark.number = addText(m_rect, QMargins(6, 3, 6, 3), Qt::AlignCenter);
}

void RodPlot::present(const RodCurves& curves) {
    const bool unitsChanged = !sameUnits(m_curves.units, curves.units);
    const bool hasOtherRuns = m_curves.runs != curves.runs;
    if (unitsChanged) setGhost(nullptr);
    m_curves = curves;
    if (hasOtherRuns) showRuns();
    for (const RodLine line : rodLines) graph(line)->setData(curves.curve(line));
    showLegendOf(curves);
    showSections();
    nameAxes();
    placeMarks();
    nameNumbers();
    summarize();
    finish(unitsChanged);
}

void RodPlot::nameAxes() {
    const ShownUnits& units = m_curves.units;
    const bool isString = m_curves.string.has_value();
    x()->setLabel(units.length.axisLabel(isString ? tr("position x from the shank, hammer below 0")
                                                  : tr("position x from the struck end")));
    const QString stress = !units.stress.dimensionless ? tr("stress (tension positive)")
                           : isString                  ? tr("stress, as force in the rod (tension positive)")
                                                       : tr("force N (tension positive)");
    y()->setLabel(units.stress.axisLabel(stress));
}

// Only of lines that are there.
void RodPlot::showLegendOf(const RodCurves& curves) {
    const bool isWanted = curves.lines().size() == rodLines.size();
    for (const RodLine line : {RodLine::compressionAfter, RodLine::tensionAfter}) {
        const bool isThere = m_legend->hasItemWithPlottable(graph(line));
        if (!isWanted && isThere) graph(line)->removeFromLegend();
        if (isWanted && !isThere) graph(line)->addToLegend();
    }
}

// Neighbours of one strength have one line.
void RodPlot::showSections() {
    for (QCPItemStraightLine* joint : std::as_const(m_joints)) m_plot->removeItem(joint);
    for (QCPItemLine* step : m_yieldSteps + m_fatigueSteps) m_plot->removeItem(step);
    m_joints.clear();
    m_yieldSteps.clear();
    m_fatigueSteps.clear();
    if (!m_curves.string || !m_curves.string->waves) return;
    const std::vector<RodStretch>& stretches = m_curves.string->stretches;
    const double length = m_curves.units.length.factor;
    for (std::size_t j = 1; j < stretches.size(); ++j) {
        auto* joint = addItem<QCPItemStraightLine>(m_rect, QStringLiteral("grid"));
        joint->point1->setCoords(stretches[j].rear * length, 0);
        joint->point2->setCoords(stretches[j].rear * length, 1);
        m_joints.append(joint);
    }
    const auto addSteps = [&](QVector<QCPItemLine*>& steps, std::optional<double> RodStretch::*strength,
                              bool alsoCompression) {
        for (std::size_t from = 0, to; from < stretches.size(); from = to) {
            for (to = from + 1;
                 to < stretches.size() && stretches[to].*strength == stretches[from].*strength;)
                ++to;
            if (!(stretches[from].*strength)) continue;
            const double shown = *m_curves.shownStrength(stretches[from].*strength);
            for (const double sign : {1.0, -1.0}) {
                if (sign < 0 && !alsoCompression) continue;
                auto* step = addItem<QCPItemLine>(m_rect);
                step->start->setCoords(stretches[from].rear * length, sign * shown);
                step->end->setCoords(stretches[to - 1].front * length, sign * shown);
                steps.append(step);
            }
        }
    };
    addSteps(m_yieldSteps, &RodStretch::yieldStrength, true);
    addSteps(m_fatigueSteps, &RodStretch::fatigueStrength, false);
    styleSections();
}

void RodPlot::styleSections() {
    for (qsizetype i = 0; i < m_joints.size(); ++i) {
        const bool isFace =
            m_curves.string && m_curves.string->stretches[static_cast<std::size_t>(i) + 1].number == 1;
        QColor color = m_style.text;
        color.setAlphaF(isFace ? 0.8F : 0.35F);
        m_joints[i]->setPen(QPen(color, 1));
    }
    for (QCPItemLine* step : std::as_const(m_yieldSteps))
        step->setPen(QPen(m_style.text, 1, Qt::DashDotLine));
    for (QCPItemLine* step : std::as_const(m_fatigueSteps)) step->setPen(QPen(m_style.text, 1, Qt::DotLine));
}

void RodPlot::clear() {
    m_curves = {};
    showRuns();
    for (QCPGraph* graph : m_graphs) graph->setData(GraphData::create());
    showSections();
    placeMarks();
    placeStrength(m_yield, {}, {});
    placeStrength(m_fatigue, {}, {});
}

// What stays in the rod after the blow is left out: with it there would be four lines for each run.
void RodPlot::showRuns() {
    QVector<RunPath> paths;
    for (const RunOverlay<RodCurves>& run : m_curves.runs)
        paths.append({run.number, run.title, outlineOf(*run.curves)});
    m_runs->present(paths);
    // An empty legend has no width, and lets the plot below it have none.
    m_runLegend->setVisible(!paths.isEmpty());
    const bool isThere = m_runLegend->layout();
    if (paths.isEmpty() && isThere) {
        m_header->take(m_runLegend);
        m_header->simplify();
    } else if (!paths.isEmpty() && !isThere) {
        m_header->insertRow(1);
        m_header->addElement(1, 0, m_runLegend);
    }
}

void RodPlot::setGhost(const RodCurves* before) {
    for (QCPGraph* ghost : std::as_const(m_ghosts)) m_plot->removeGraph(ghost);
    m_ghosts.clear();
    if (before && sameUnits(before->units, m_curves.units)) {
        for (const RodLine line : {RodLine::compression, RodLine::tension}) {
            QCPGraph* ghost = addCurve(x(), y());
            ghost->removeFromLegend();
            ghost->setLayer(ghostLayer(*m_plot));
            ghost->setSelectable(QCP::stNone);
            ghost->setPen(m_style.ghostPen(isTension(line) ? 1 : 0));
            ghost->setData(before->curve(line));
            m_ghosts.append(ghost);
        }
    }
    fitUnlessZoomed();
}

QString RodPlot::stressText(double stress) const {
    return numberText(stress, 4, m_plot->locale()) + QChar(QChar::Nbsp) + m_curves.units.stress.unit;
}

void RodPlot::placeStrength(const Strength& strength, const std::optional<double>& value,
                            const QString& name) {
    setLevel(*strength.lines[0], value);
    setLevel(*strength.lines[1], value && &strength == &m_yield ? std::optional(-*value) : std::nullopt);
    strength.name->setVisible(value.has_value());
    if (!value) return;
    strength.name->setText(name.arg(stressText(*value)));
    strength.name->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    // On the side where the rod is not pulled most.
    const bool pulledAtRight = m_curves.largest(RodLine::tension).section > 0.5;
    strength.name->setPositionAlignment((pulledAtRight ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
    strength.name->position->setCoords(pulledAtRight ? 0 : 1, *value);
}

// By its longest section.
void RodPlot::nameSteps(const Strength& strength, std::optional<double> RodStretch::*value,
                        const QString& one, const QString& several) {
    placeStrength(strength, {}, {});
    const RodStretch* longest = nullptr;
    bool differ = false;
    for (const RodStretch& stretch : m_curves.string->stretches) {
        if (!(stretch.*value)) continue;
        if (!longest) longest = &stretch;
        differ = differ || stretch.*value != longest->*value;
        if (stretch.front - stretch.rear > 1.001 * (longest->front - longest->rear)) longest = &stretch;
    }
    strength.name->position->setTypeX(longest ? QCPItemPosition::ptPlotCoords
                                              : QCPItemPosition::ptAxisRectRatio);
    strength.name->setVisible(longest);
    if (!longest) return;
    const double shown = *m_curves.shownStrength(longest->*value);
    strength.name->setText(differ ? several : one.arg(stressText(shown)));
    strength.name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
    strength.name->position->setCoords((longest->rear + longest->front) / 2 * m_curves.units.length.factor,
                                       shown);
}

bool RodPlot::isNumbered(RodLine line) const {
    const double size = m_curves.largest(line).size;
    if (!isAfter(line)) return size > 0;
    const RodLine blow = isTension(line) ? RodLine::tension : RodLine::compression;
    return size > tellingDifference * m_curves.largest(blow).size;
}

// Outside of the curves, towards the middle of the rod.
void RodPlot::placeMarks() {
    for (const RodLine line : rodLines) {
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        const RodForce& largest = m_curves.largest(line);
        const QPointF at(m_curves.position(largest), m_curves.stress(line, largest));
        mark.ring->position->setCoords(at);
        mark.number->position->setCoords(at);
        const Qt::AlignmentFlag side = largest.section < 0.2   ? Qt::AlignLeft
                                       : largest.section > 0.8 ? Qt::AlignRight
                                                               : Qt::AlignHCenter;
        mark.number->setPositionAlignment(side | (isTension(line) ? Qt::AlignBottom : Qt::AlignTop));
    }
    followLegend();
}

// What is hidden by the legend has no mark either.
void RodPlot::followLegend() {
    for (const RodLine line : rodLines) {
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        const bool shown = graph(line)->visible() && m_curves.largest(line).size > 0;
        mark.ring->setVisible(shown);
        mark.number->setVisible(shown && isNumbered(line));
    }
}

void RodPlot::nameNumbers() {
    for (const RodLine line : rodLines)
        m_marks[static_cast<std::size_t>(line)].number->setText(
            stressText(m_curves.stress(line, m_curves.largest(line))));
    if (m_curves.string) {
        nameSteps(m_yield, &RodStretch::yieldStrength, tr("yield strength %1"), tr("yield strengths"));
        nameSteps(m_fatigue, &RodStretch::fatigueStrength, tr("fatigue strength %1"),
                  tr("fatigue strengths"));
    } else {
        placeStrength(m_yield, m_curves.yieldStrength, tr("yield strength %1"));
        placeStrength(m_fatigue, m_curves.fatigueStrength, tr("fatigue strength %1"));
    }
    const double missed = m_curves.envelope.missed * m_curves.units.stress.factor;
    m_caption->setText(
        m_curves.string ? tr("of uniform sections; threads and changes of diameter raise stresses locally")
        : missed > 0
            ? tr("so many waves that between the peaks a curve may be too low by %1").arg(stressText(missed))
            : tr("of the uniform rod; couplings and threads raise stresses locally, nothing "
                 "damps the waves left"));
}

void RodPlot::summarize() {
    const QLocale locale = m_plot->locale();
    QStringList extremes;
    for (const RodLine line : m_curves.lines()) {
        const RodForce& largest = m_curves.largest(line);
        extremes << tr("%1 up to %2 at %3, %4")
                        .arg(nameOf(line), stressText(m_curves.stress(line, largest)),
                             quantityText(largest.section, m_curves.units.length, locale),
                             quantityText(largest.time, m_curves.units.time, locale));
    }
    m_summary = tr("Largest stresses along the rod, tension positive: %1.").arg(extremes.join(u"; "));
}

void RodPlot::restyle() {
    const PlotStyle& style = m_style;
    m_runs->setStyle(style);
    for (const RodLine line : rodLines) {
        const QPen pen = penOf(style, line);
        graph(line)->setPen(pen);
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        mark.ring->setSize(isAfter(line) ? 6 : 8);
        mark.ring->setPen(QPen(pen.color(), 1.5));
        mark.ring->setBrush(style.background);
        mark.number->setBrush(style.behindWords());
    }
    for (qsizetype i = 0; i < m_ghosts.size(); ++i) m_ghosts[i]->setPen(style.ghostPen(static_cast<int>(i)));
    for (const Strength* strength : {&m_yield, &m_fatigue}) {
        for (QCPItemStraightLine* line : strength->lines)
            line->setPen(QPen(style.text, 1, strength == &m_yield ? Qt::DashDotLine : Qt::DotLine));
        strength->name->setBrush(style.behindWords());
    }
    styleSections();
    if (m_curves.curves.front()) nameNumbers();  // files have another locale
}

void RodPlot::setRanges() {
    double low = 0, high = 0;
    double length = m_curves.curves.front() ? m_curves.units.length.factor : 1;
    double rear = m_curves.curves.front() ? m_curves.rear() * length : 0;
    for (QCPCurve* run : m_runs->graphs()) {
        bool found = false;
        const QCPRange values = run->getValueRange(found);
        if (!found || !run->visible()) continue;
        low = std::min(low, values.lower);
        high = std::max(high, values.upper);
        length = std::max(length, run->getKeyRange(found).upper);
        rear = std::min(rear, run->getKeyRange(found).lower);
    }
    for (const auto& graphs : {QVector<QCPGraph*>(m_graphs.begin(), m_graphs.end()), m_ghosts})
        for (const QCPGraph* graph : graphs)
            for (const QCPGraphData& point : *graph->data()) {
                low = std::min(low, point.value);
                high = std::max(high, point.value);
            }
    const double largest = std::max(-low, high);
    const auto take = [&](const std::optional<double>& strength, bool alsoCompression) {
        if (!strength || *strength > strengthInView * largest) return;
        high = std::max(high, *strength);
        if (alsoCompression) low = std::min(low, -*strength);
    };
    take(m_curves.yieldStrength, true);
    take(m_curves.fatigueStrength, false);
    if (m_curves.string)
        for (const RodStretch& stretch : m_curves.string->stretches) {
            take(m_curves.shownStrength(stretch.yieldStrength), true);
            take(m_curves.shownStrength(stretch.fatigueStrength), false);
        }
    const double size = high - low;
    x()->setRange(rear, length);
    if (size > 0)
        y()->setRange(low - 0.1 * size, high + 0.1 * size);
    else
        y()->setRange(-1, 1);
}

KeyPlaces RodPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] {
        return here().x() ? std::optional(QPointF(*here().x(), here().y().value_or(0))) : std::nullopt;
    };
    places.marks = [this] {
        QVector<QPointF> marks;
        for (const RodLine line : rodLines)
            if (const RodForce& largest = m_curves.largest(line); graph(line)->visible() && largest.size > 0)
                marks.append({m_curves.position(largest), m_curves.stress(line, largest)});
        return marks;
    };
    return places;
}

std::optional<RodForce> RodPlot::forceAt(QPointF coordinates) const {
    if (!m_curves.curves.front()) return {};
    const QPointF pixel = pixelOf(coordinates);
    std::optional<RodForce> nearest;
    double distance = markReach;
    const auto offer = [&](const RodForce& force, double away) {
        // Of marks and curves at one place those of the blow.
        if (!(away < distance - sameHeight)) return;
        nearest = force;
        distance = away;
    };
    for (const RodLine line : rodLines) {
        const RodForce& largest = m_curves.largest(line);
        if (!graph(line)->visible() || !(largest.size > 0)) continue;
        const QPointF mark = pixelOf({m_curves.position(largest), m_curves.stress(line, largest)});
        offer(largest, std::hypot(mark.x() - pixel.x(), mark.y() - pixel.y()));
    }
    if (nearest) return nearest;
    const double section = coordinates.x() / m_curves.units.length.factor;
    if (section < m_curves.rear() || section > 1) return {};
    distance = std::numeric_limits<double>::infinity();
    for (const RodLine line : m_curves.lines()) {
        if (!graph(line)->visible()) continue;
        RodForce force = m_curves.forceAt(line, section);
        const QPointF there = pixelOf({coordinates.x(), m_curves.stress(line, force)});
        force.section = section;
        offer(force, std::abs(there.y() - pixel.y()));
    }
    return nearest;
}

}  // namespace drillwave

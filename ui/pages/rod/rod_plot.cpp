// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/rod_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/curve_graph.h"
#include "ui/plot/label_places.h"
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
/// A peak of the residual waves up to this many times that of the blow needs no number of its own.
constexpr double tellingDifference = 1.02;

// Compares by name: factors follow the scenario.
bool sameUnitsOfStresses(const ShownUnits& a, const ShownUnits& b) {
    return a.stress.unit == b.stress.unit && a.length.unit == b.length.unit;
}

QString nameOf(Load line) {
    switch (line) {
        case Load::compression:
            return RodPlot::tr("largest compression in the blow");
        case Load::tension:
            return RodPlot::tr("largest tension in the blow");
        case Load::compressionAfter:
            return RodPlot::tr("compression of residual waves");
        case Load::tensionAfter:
            return RodPlot::tr("tension of residual waves");
    }
    return {};
}

/// Compression and tension in two colours, the waves left thinner and dashed.
QPen penOf(const PlotStyle& style, Load line) {
    QPen pen = style.linePen(0);
    pen.setColor(style.lines[isTension(line) ? 1 : 0]);
    if (isAfter(line)) {
        pen.setDashPattern({5, 3});
        pen.setCapStyle(Qt::FlatCap);
    }
    return pen;
}

/// Side of the number of a mark: towards the middle of the rod.
Qt::AlignmentFlag sideOf(const RodForce& largest) {
    return largest.section < 0.2 ? Qt::AlignLeft : largest.section > 0.8 ? Qt::AlignRight : Qt::AlignHCenter;
}

/// Along the compression to the bit, and back along the tension: two lines.
QSharedPointer<QCPCurveDataContainer> outlineOf(const RodCurves& curves) {
    QVector<QCPCurveData> points;
    const auto append = [&](const QCPGraphData& point) {
        points.append({double(points.size()), point.key, point.value});
    };
    const QCPGraphDataContainer& compression = *curves.curve(Load::compression);
    const QCPGraphDataContainer& tension = *curves.curve(Load::tension);
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
    for (const Load line : loads) {
        QCPGraph* graph = addCurve(x(), y());
        graph->setName(nameOf(line));
        m_graphs[static_cast<std::size_t>(line)] = graph;
    }
    for (StrengthLines& strength : m_strengths) {
        strength.addLines(m_rect);
        strength.addName(addText(m_rect, QMargins(6, 1, 6, 1), Qt::AlignCenter));
    }
    for (Mark& mark : m_marks) addMark(mark);
    addHere();
    connect(plot, &QCustomPlot::beforeReplot, this, &RodPlot::followLegend);
    connect(plot, &QCustomPlot::beforeReplot, this, [this] {
        wrapLegend(*m_legend, m_plot->width(), usualColumns);
        wrapLegend(*m_runLegend, m_plot->width(), mostColumns);
    });
    connect(plot, &QCustomPlot::afterLayout, this, &RodPlot::placeNames);
    setStyle(PlotStyle::forPaper());
    showNothing({});
}

// Adds it below the legend of the page, above the caption.
void RodPlot::addRunLegend() {
    m_runLegend = new QCPLegend;
    m_runLegend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_runLegend->setMargins(QMargins(7, 0, 0, 0));
    m_header->insertRow(1);
    m_header->addElement(1, 0, m_runLegend);
    m_runLegend->setLayer(QStringLiteral("legend"));
}

void RodPlot::addMark(Mark& mark) {
    mark.ring = addItem<QCPItemTracer>(m_rect);
    mark.ring->setStyle(QCPItemTracer::tsCircle);
    mark.number = addText(m_rect, QMargins(6, 3, 6, 3), Qt::AlignCenter);
}

void RodPlot::present(const RodCurves& curves) {
    const bool unitsChanged = !sameUnitsOfStresses(m_curves.units, curves.units);
    const bool hasOtherRuns = m_curves.runs != curves.runs;
    if (unitsChanged) setGhost(nullptr);
    m_curves = curves;
    if (hasOtherRuns) showRuns();
    for (const Load line : loads) graph(line)->setData(curves.curve(line));
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
    const bool hasSections = m_curves.string.has_value();
    x()->setLabel(units.length.axisLabel(hasSections ? tr("position x from the struck end, hammer at x < 0")
                                                     : tr("position x from the struck end")));
    const QString stress = !units.stress.dimensionless ? tr("stress (tension positive)")
                           : hasSections               ? tr("stress, as force in the rod (tension positive)")
                                                       : tr("force N (tension positive)");
    y()->setLabel(units.stress.axisLabel(stress));
}

// Shows only entries of lines that exist.
void RodPlot::showLegendOf(const RodCurves& curves) {
    const bool isWanted = curves.lines().size() == loads.size();
    for (const Load line : {Load::compressionAfter, Load::tensionAfter}) {
        const bool isThere = m_legend->hasItemWithPlottable(graph(line));
        if (!isWanted && isThere) graph(line)->removeFromLegend();
        if (isWanted && !isThere) graph(line)->addToLegend();
    }
}

void RodPlot::showSections() {
    for (QCPItemStraightLine* joint : std::as_const(m_joints)) m_plot->removeItem(joint);
    m_joints.clear();
    if (m_curves.string && m_curves.string->waves) {
        const std::vector<RodStretch>& stretches = m_curves.string->stretches;
        for (std::size_t j = 1; j < stretches.size(); ++j) {
            const double at = stretches[j].rear * m_curves.units.length.factor;
            auto* joint = addItem<QCPItemStraightLine>(m_rect, QStringLiteral("grid"));
            joint->point1->setCoords(at, 0);
            joint->point2->setCoords(at, 1);
            m_joints.append(joint);
        }
    }
    for (StrengthLines& strength : m_strengths) strength.showSteps(m_curves);
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
}

void RodPlot::clear() {
    m_curves = {};
    showRuns();
    for (QCPGraph* graph : m_graphs) graph->setData(GraphData::create());
    showSections();
    placeMarks();
    for (StrengthLines& strength : m_strengths) strength.clear();
}

// Draws no residual waves: with them there would be four lines for each run.
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
    if (before && sameUnitsOfStresses(before->units, m_curves.units)) {
        for (const Load line : {Load::compression, Load::tension}) {
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

bool RodPlot::isNumbered(Load line) const {
    const double size = m_curves.largest(line).size;
    if (!isAfter(line)) return size > 0;
    const Load blow = isTension(line) ? Load::tension : Load::compression;
    return size > tellingDifference * m_curves.largest(blow).size;
}

// Outside of the curves, towards the middle of the rod.
void RodPlot::placeMarks() {
    for (const Load line : loads) {
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        const RodForce& largest = m_curves.largest(line);
        const QPointF at(m_curves.position(largest), m_curves.stress(line, largest));
        mark.ring->position->setCoords(at);
        mark.number->position->setCoords(at);
        mark.number->setPositionAlignment(sideOf(largest) |
                                          (isTension(line) ? Qt::AlignBottom : Qt::AlignTop));
    }
    followLegend();
}

// Places names at any zoom and size: numbers next to their marks, outside of the curves if there is room,
// names of strengths along their lines.
void RodPlot::placeNames() {
    QVector<PlacedLabel> labels;
    QVector<QRectF> rings;
    QVector<QPointF> points;
    for (const Load line : loads) {
        points += pointsAlong(*graph(line));
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        if (mark.ring->visible()) {
            QRectF ring({}, QSizeF(mark.ring->size(), mark.ring->size()));
            ring.moveCenter(mark.ring->position->pixelPosition());
            rings.append(ring);
        }
        if (!mark.number->visible()) continue;
        PlacedLabel label{mark.number, {}};
        const Qt::AlignmentFlag usual = sideOf(m_curves.largest(line));
        const bool isAbove = isTension(line);
        for (const Qt::AlignmentFlag beyond : {isAbove ? Qt::AlignBottom : Qt::AlignTop, Qt::AlignVCenter,
                                               isAbove ? Qt::AlignTop : Qt::AlignBottom})
            for (const Qt::AlignmentFlag side : {usual, Qt::AlignHCenter, Qt::AlignLeft, Qt::AlignRight})
                if (beyond != Qt::AlignVCenter || side != Qt::AlignHCenter)
                    label.places.append([number = mark.number, side, beyond] {
                        number->setPositionAlignment(side | beyond);
                    });
        labels.append(label);
    }
    for (const StrengthLines& strength : m_strengths)
        if (PlacedLabel label = strength.label(m_curves); !label.places.isEmpty()) labels.append(label);
    placeLabels(labels, m_rect->rect(), rings, points);
}

// A curve hidden by the legend has no mark either.
void RodPlot::followLegend() {
    for (const Load line : loads) {
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        const bool shown = graph(line)->visible() && m_curves.largest(line).size > 0;
        mark.ring->setVisible(shown);
        mark.number->setVisible(shown && isNumbered(line));
    }
}

void RodPlot::nameNumbers() {
    for (const Load line : loads)
        m_marks[static_cast<std::size_t>(line)].number->setText(
            stressText(m_curves.stress(line, m_curves.largest(line))));
    for (StrengthLines& strength : m_strengths)
        strength.showName(m_curves, [this](double stress) { return stressText(stress); });
    const double missed = m_curves.envelope.missed * m_curves.units.stress.factor;
    m_caption->setText(
        m_curves.string ? tr("without local stresses at threads and changes of diameter")
        : missed > 0 ? tr("many waves: between peaks the curve may be too low by %1").arg(stressText(missed))
                     : tr("without local stresses at threads; residual waves undamped"));
}

void RodPlot::summarize() {
    const QLocale locale = m_plot->locale();
    QStringList extremes;
    for (const Load line : m_curves.lines()) {
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
    for (const Load line : loads) {
        const QPen pen = penOf(style, line);
        graph(line)->setPen(pen);
        const Mark& mark = m_marks[static_cast<std::size_t>(line)];
        mark.ring->setSize(isAfter(line) ? 6 : 8);
        mark.ring->setPen(QPen(pen.color(), 1.5));
        mark.ring->setBrush(style.background);
        mark.number->setBrush(style.behindWords());
    }
    for (qsizetype i = 0; i < m_ghosts.size(); ++i) m_ghosts[i]->setPen(style.ghostPen(static_cast<int>(i)));
    for (StrengthLines& strength : m_strengths) strength.setStyle(style);
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
    for (const StrengthLines& strength : m_strengths)
        for (const double value : strength.values(m_curves)) {
            if (value > strengthInView * largest) continue;
            high = std::max(high, value);
            if (strength.isOfBoth()) low = std::min(low, -value);
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
        for (const Load line : loads)
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
        // The marks and curves of the blow win over those of others at the same place.
        if (!(away < distance - sameHeight)) return;
        nearest = force;
        distance = away;
    };
    for (const Load line : loads) {
        const RodForce& largest = m_curves.largest(line);
        if (!graph(line)->visible() || !(largest.size > 0)) continue;
        const QPointF mark = pixelOf({m_curves.position(largest), m_curves.stress(line, largest)});
        offer(largest, std::hypot(mark.x() - pixel.x(), mark.y() - pixel.y()));
    }
    if (nearest) return nearest;
    const double section = coordinates.x() / m_curves.units.length.factor;
    if (section < m_curves.rear() || section > 1) return {};
    distance = std::numeric_limits<double>::infinity();
    for (const Load line : m_curves.lines()) {
        if (!graph(line)->visible()) continue;
        RodForce force = m_curves.forceAt(line, section);
        const QPointF there = pixelOf({coordinates.x(), m_curves.stress(line, force)});
        force.section = section;
        offer(force, std::abs(there.y() - pixel.y()));
    }
    return nearest;
}

}  // namespace drillwave

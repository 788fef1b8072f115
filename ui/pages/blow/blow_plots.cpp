// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_plots.h"

#include <cmath>
#include <limits>

#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int farBelow = 1 << 20;  // [px]

enum PlotIndex : std::size_t { waves, force, impulse, momentumOfRod };

// The sum, the first waves, and all later ones by their heading.
const QStringList waveNames{QStringLiteral("N"),   QStringLiteral("N₀ₚ"), QStringLiteral("N₁ₙ"),
                            QStringLiteral("N₂ₚ"), QStringLiteral("N₃ₙ"), QStringLiteral("N₄ₚ…"),
                            QStringLiteral("N₅ₙ…")};

// The sum is a broad band below the waves, which cover it where only one is present; later ones are muted.
QPen wavePen(const PlotStyle& style, int index) {
    QPen pen = style.linePen(std::max(0, index - 1));
    const auto mute = [&pen](const QColor& color, int alpha, double width) {
        pen.setColor(QColor(color.red(), color.green(), color.blue(), alpha));
        pen.setWidthF(width);
    };
    if (index == 0) {
        mute(style.text, 80, 4);
        pen.setCapStyle(Qt::FlatCap);
    } else if (index > BlowCurves::waveCount) {
        const int heading = index - 1 - BlowCurves::waveCount;
        pen = style.linePen(heading);
        mute(style.lines[2 + heading], 190, 1);
    }
    return pen;
}

// Compares by name: factors follow the scenario.
bool sameUnitsOfHistories(const ShownUnits& a, const ShownUnits& b) {
    return a.time.unit == b.time.unit && a.force.unit == b.force.unit && a.impulse.unit == b.impulse.unit;
}

// Formats two decimals, or three if they differ.
QString sectionText(double section, const QLocale& locale) {
    const bool twoDo = std::abs(100 * section - std::round(100 * section)) < 0.05;
    return locale.toString(section, 'f', twoDo ? 2 : 3);
}

// The range of all graphs of a plot with zero in it and room to spare, so that flat curves are readable too.
QCPRange valueRange(const QVector<QCPGraph*>& graphs) {
    double low = 0;
    double high = 0;
    for (const QCPGraph* graph : graphs)
        for (auto point = graph->data()->constBegin(); point != graph->data()->constEnd(); ++point) {
            low = std::min(low, point->value);
            high = std::max(high, point->value);
        }
    const double size = high - low;
    if (!(size > std::numeric_limits<float>::min())) return {-1, 1};
    return {low - 0.08 * size, high + 0.08 * size};
}

double largestMagnitude(const GraphData& data) {
    double largest = 0;
    for (auto point = data->constBegin(); point != data->constEnd(); ++point)
        if (std::abs(point->value) > std::abs(largest)) largest = point->value;
    return largest;
}

// Adaptive sampling draws steep parts of a curve as a saw; only very long curves are worth that.
void setData(QCPGraph& graph, const GraphData& data) {
    constexpr int manyPoints = 50000;
    graph.setAdaptiveSampling(data->size() > manyPoints);
    graph.setData(data);
}

}  // namespace

BlowPlots::BlowPlots(QCustomPlot* plot) : StudyFrame(plot) {
    layOutAnew();
    auto* margins = new QCPMarginGroup(plot);
    for (const std::size_t index : {waves, force, impulse, momentumOfRod}) addPlot(index, margins);
    linkTimeAxes();
    connect(plot, &QCustomPlot::beforeReplot, this, &BlowPlots::wrapLegends);
    setStyle(PlotStyle::forPaper());
}

// Names of the graphs of a plot.
QStringList BlowPlots::namesOf(std::size_t plot) {
    switch (plot) {
        case waves:
            return waveNames;
        case force:
            return {tr("impact force F"), tr("closed form"), tr("force of the hammer on the string")};
        case impulse:
            return {tr("impulse of the impact force I")};
        default:
            return {tr("momentum of the rod p")};
    }
}

void BlowPlots::name() {
    for (std::size_t plot = 0; plot < m_plots.size(); ++plot) {
        const QStringList names = namesOf(plot);
        for (qsizetype i = 0; i < names.size(); ++i) m_plots[plot].graphs[i]->setName(names[i]);
    }
    nameWaves();
    setLabels();
}

void BlowPlots::addPlot(std::size_t index, QCPMarginGroup* margins) {
    Plot& added = m_plots[index];
    const int row = 2 * static_cast<int>(index);
    auto* header = new QCPLayoutGrid;
    m_plot->plotLayout()->addElement(row, 0, header);
    header->setColumnSpacing(0);
    // Begins where the axes do.
    header->setMinimumMargins(QMargins(0, 2, 0, 0));
    header->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    added.title = new QCPTextElement(m_plot);
    added.title->setTextFlags(Qt::AlignLeft | Qt::AlignTop);
    added.title->setMargins(QMargins(0, 0, 0, 0));
    added.legend = new QCPLegend;
    added.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    added.legend->setMargins(QMargins(index == waves ? 10 : 0, 0, 0, 0));
    added.legend->setColumnSpacing(8);
    added.legend->setIconSize(20, 12);
    header->addElement(0, 0, added.title);
    header->addElement(0, 1, added.legend);
    auto* rest = new QCPTextElement(m_plot);  // takes what width is left
    header->addElement(0, 2, rest);
    // A text would keep the legend beside it as low as its own line.
    for (QCPTextElement* text : {added.title, rest}) text->setMaximumSize(farBelow, farBelow);
    header->setColumnStretchFactor(0, 1e-3);
    header->setColumnStretchFactor(1, 1e-3);
    added.legend->setLayer(QStringLiteral("legend"));

    added.rect = newAxisRect(*m_plot, Sides::linked);
    added.rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    added.rect->setMinimumMargins(QMargins(4, 2, 10, 2));
    // The lowest plot alone carries the numbers of the common time axis.
    added.rect->axis(QCPAxis::atBottom)->setTickLabels(index + 1 == plotCount);
    m_plot->plotLayout()->addElement(row + 1, 0, added.rect);
    m_plot->plotLayout()->setRowStretchFactor(row, 1e-3);

    const QStringList names = namesOf(index);
    for (const QString& name : names) {
        QCPGraph* graph = addCurve(added.rect->axis(QCPAxis::atBottom), added.rect->axis(QCPAxis::atLeft));
        graph->setName(name);
        graph->addToLegend(added.legend);
        added.graphs.append(graph);
    }
    // Broad as the sum of the present blow: thin ones would look like its waves.
    added.runs = new RunGraphs(added.rect->axis(QCPAxis::atBottom), added.rect->axis(QCPAxis::atLeft),
                               index == force || index == waves ? added.legend : nullptr);
    if (index == waves) added.runs->setBands(names.first());
}

// Wraps the legends right of the titles. Runs get letters where names have no room, before a line is added.
void BlowPlots::wrapLegends() {
    for (const Plot& plot : m_plots) {
        QStringList names;
        for (QCPGraph* run : plot.runs->graphs()) {
            names.append(run->name());
            if (&plot == &m_plots[force]) run->setName(run->name().left(1));
        }
        const double title = QFontMetricsF(plot.title->font()).horizontalAdvance(plot.title->text());
        const double left = plot.rect->margins().left() + plot.legend->margins().left() + title;
        wrapLegend(*plot.legend, m_plot->viewport().width() - left - plot.rect->margins().right(),
                   plot.legend->itemCount());
        for (qsizetype i = 0; i < names.size(); ++i) plot.runs->graphs()[i]->setName(names[i]);
    }
}

int BlowPlots::legendRows() const {
    int rows = 0;
    for (const Plot& plot : m_plots) rows += std::max(1, plot.legend->rowCount());
    return rows;
}

void BlowPlots::linkTimeAxes() {
    for (const Plot& from : m_plots) {
        QCPAxis* axis = from.rect->axis(QCPAxis::atBottom);
        connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
                [this](const QCPRange& range) {
                    for (const Plot& to : m_plots) to.rect->axis(QCPAxis::atBottom)->setRange(range);
                });
        for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) m_view->watch(from.rect->axis(side));
    }
}

void BlowPlots::present(const BlowCurves& curves) {
    const bool unitsChanged = !sameUnitsOfHistories(m_curves.units, curves.units);
    const bool hasOtherRuns = m_curves.runs != curves.runs;
    m_curves = curves;
    if (hasOtherRuns) showRuns();
    if (unitsChanged) setGhost(nullptr);
    setData(*sectionForceGraph(), curves.sectionForce);
    nameWaves();
    for (std::size_t i = 0; i < curves.waves.size(); ++i)
        showWhereThere(waves, *waveGraph(static_cast<int>(i)), curves.waves[i], !curves.place);
    for (std::size_t i = 0; i < curves.laterWaves.size(); ++i)
        showWhereThere(waves, *laterGraph(static_cast<int>(i)), curves.laterWaves[i]);
    showWhereThere(force, *faceForceGraph(), curves.faceForce);
    setData(*forceGraph(), curves.force);
    setData(*impulseGraph(), curves.impulse);
    setData(*momentumGraph(), curves.momentum);
    showClosedForm();
    m_timeEnd = curves.timeEnd > 0 ? curves.timeEnd : 1;
    setLabels();
    summarize();
    finish(unitsChanged);
}

void BlowPlots::showClosedForm() {
    const std::optional<ClosedFormCurve>& closedForm = m_curves.closedForm;
    showWhereThere(force, *closedFormGraph(), closedForm ? closedForm->force : GraphData::create());
}

// A string has two waves at a place, one either way; those of a rod are numbered.
void BlowPlots::nameWaves() {
    const bool ofString = m_curves.place.has_value();
    waveGraph(0)->setName(ofString ? tr("Nₚ to the bit") : waveNames[1]);
    waveGraph(1)->setName(ofString ? tr("Nₙ from the bit") : waveNames[2]);
    momentumGraph()->setName(ofString ? tr("momentum of the string p") : tr("momentum of the rod p"));
}

QString BlowPlots::placeText(const BlowCurves& curves, const QLocale& locale) {
    const QString length =
        quantityText(curves.fromRear, curves.units.of(UnitKind::length, curves.fromRear), locale);
    return tr("%1, %2 from its rear").arg(curves.sectionWords, length);
}

void BlowPlots::showWhereThere(std::size_t index, QCPGraph& graph, const GraphData& data, bool always) {
    QCPLegend* legend = m_plots[index].legend;
    setData(graph, data);
    if (data->isEmpty() && !always)
        graph.removeFromLegend(legend);
    else if (graph.addToLegend(legend))
        m_style.applyTo(*legend);
}

// Shows only the sum of the waves: all of them would be too many to distinguish.
void BlowPlots::showRuns() {
    QVector<RunCurve> sums, forces, impulses, momenta;
    m_runsEnd = 0;
    for (const RunOverlay<BlowCurves>& run : m_curves.runs) {
        sums.append({run.number, run.title, run.curves->sectionForce});
        forces.append({run.number, run.title, run.curves->force});
        impulses.append({run.number, run.title, run.curves->impulse});
        momenta.append({run.number, run.title, run.curves->momentum});
        m_runsEnd = std::max(m_runsEnd, run.curves->timeEnd);
    }
    m_plots[waves].runs->present(sums);
    m_plots[force].runs->present(forces);
    m_plots[impulse].runs->present(impulses);
    m_plots[momentumOfRod].runs->present(momenta);
}

void BlowPlots::setGhost(const BlowCurves* before) {
    for (Plot& plot : m_plots) {
        for (QCPGraph* ghost : std::as_const(plot.ghosts)) m_plot->removeGraph(ghost);
        plot.ghosts.clear();
    }
    m_ghostEnd = 0;
    if (before && sameUnitsOfHistories(before->units, m_curves.units)) {
        for (int i = 0; i < BlowCurves::waveCount; ++i)
            addGhost(waves, i, before->waves[static_cast<std::size_t>(i)]);
        addGhost(force, 0, before->force);
        addGhost(impulse, 0, before->impulse);
        addGhost(momentumOfRod, 0, before->momentum);
        m_ghostEnd = before->timeEnd;
    }
    fitUnlessZoomed();
}

void BlowPlots::addGhost(std::size_t index, int kind, const GraphData& data) {
    Plot& plot = m_plots[index];
    QCPGraph* ghost = addCurve(plot.rect->axis(QCPAxis::atBottom), plot.rect->axis(QCPAxis::atLeft));
    ghost->setLayer(ghostLayer(*m_plot));
    ghost->setSelectable(QCP::stNone);
    ghost->setPen(m_style.ghostPen(kind));
    setData(*ghost, data);
    plot.ghosts.append(ghost);
}

QCPGraph* BlowPlots::addOverlay(Kind kind, const QString& name) {
    Plot& plot = m_plots[kind == Kind::waves ? waves : force];
    QCPGraph* overlay = addCurve(plot.rect->axis(QCPAxis::atBottom), plot.rect->axis(QCPAxis::atLeft));
    overlay->setName(name);
    overlay->addToLegend(plot.legend);
    m_style.applyTo(*plot.legend);
    plot.overlays.append(overlay);
    return overlay;
}

void BlowPlots::removeOverlay(QCPGraph* overlay) {
    for (Plot& plot : m_plots)
        if (plot.overlays.removeOne(overlay)) overlay->removeFromLegend(plot.legend);
    m_plot->removeGraph(overlay);
}

void BlowPlots::clear() {
    for (const Plot& plot : m_plots)
        for (QCPGraph* graph : plot.graphs) graph->setData(GraphData::create());
    m_curves.runs.clear();
    showRuns();
}

void BlowPlots::setLabels() {
    const ShownUnits& units = m_curves.units;
    const QLocale locale = m_plot->locale();
    if (m_curves.closedForm)
        closedFormGraph()->setName(
            tr("closed form, error of e < %1").arg(boundText(m_curves.closedForm->error, locale)));
    m_plots[waves].title->setText(
        m_curves.place
            ? placeText(m_curves, locale)
            : tr("waves at x/L = %1 (p to the bit, n from it)").arg(sectionText(m_curves.section, locale)));
    m_plots[waves].rect->axis(QCPAxis::atLeft)->setLabel(units.force.axisLabel(tr("N, tension +")));
    m_plots[force].rect->axis(QCPAxis::atLeft)->setLabel(units.force.axisLabel(QStringLiteral("F")));
    m_plots[impulse].rect->axis(QCPAxis::atLeft)->setLabel(units.impulse.axisLabel(QStringLiteral("I")));
    m_plots[momentumOfRod]
        .rect->axis(QCPAxis::atLeft)
        ->setLabel(units.impulse.axisLabel(QStringLiteral("p")));
    m_plots[momentumOfRod].rect->axis(QCPAxis::atBottom)->setLabel(units.time.axisLabel(tr("time t")));
}

void BlowPlots::summarizeString() {
    const BlowCurves& curves = m_curves;
    const QLocale locale = m_plot->locale();
    const auto shown = [&locale](double value, const ShownUnit& unit) {
        return locale.toString(value, 'g', 4) + QLatin1Char(' ') + unit.unit;
    };
    m_summary =
        tr("Four plots over time from 0 to %1. %2: largest N %3, wave to the bit %4, from the bit %5. "
           "Impact force up to %6, force of the hammer on the string up to %7. Impulse up to %8. Momentum of "
           "the string up to %9.")
            .arg(shown(curves.timeEnd, curves.units.time), placeText(curves, locale),
                 shown(largestMagnitude(curves.sectionForce), curves.units.force),
                 shown(largestMagnitude(curves.waves[0]), curves.units.force),
                 shown(largestMagnitude(curves.waves[1]), curves.units.force),
                 shown(largestMagnitude(curves.force), curves.units.force),
                 shown(largestMagnitude(curves.faceForce), curves.units.force),
                 shown(largestMagnitude(curves.impulse), curves.units.impulse),
                 shown(largestMagnitude(curves.momentum), curves.units.impulse));
}

void BlowPlots::summarize() {
    if (m_curves.place) return summarizeString();
    const BlowCurves& curves = m_curves;
    const QLocale locale = m_plot->locale();
    const auto shown = [&locale](double value, const ShownUnit& unit) {
        return locale.toString(value, 'g', 4) + QLatin1Char(' ') + unit.unit;
    };
    m_summary =
        tr("Four plots over time from 0 to %1. Largest values at x/L = %2: normal force N %10, incident wave "
           "N0p %3, its reflection from the bit N1n %4, then from the rear end N2p %5 and again from the bit "
           "N3n %6. Impact force up to %7. Impulse up to %8. Momentum of the rod up to %9.")
            .arg(shown(curves.timeEnd, curves.units.time), sectionText(curves.section, locale),
                 shown(largestMagnitude(curves.waves[0]), curves.units.force),
                 shown(largestMagnitude(curves.waves[1]), curves.units.force),
                 shown(largestMagnitude(curves.waves[2]), curves.units.force),
                 shown(largestMagnitude(curves.waves[3]), curves.units.force),
                 shown(largestMagnitude(curves.force), curves.units.force),
                 shown(largestMagnitude(curves.impulse), curves.units.impulse),
                 shown(largestMagnitude(curves.momentum), curves.units.impulse))
            .arg(shown(largestMagnitude(curves.sectionForce), curves.units.force));
}

void BlowPlots::restyle() {
    for (const Plot& plot : m_plots) {
        m_style.applyTo(*plot.legend);
        m_style.applyTo(*plot.title);
        const bool isWaves = &plot == &m_plots[waves];
        for (int i = 0; i < plot.graphs.size(); ++i)
            plot.graphs[i]->setPen(isWaves ? wavePen(m_style, i) : m_style.linePen(i));
        for (int i = 0; i < plot.ghosts.size(); ++i) plot.ghosts[i]->setPen(m_style.ghostPen(i));
        plot.runs->setStyle(m_style);
    }
    if (m_curves.force) setLabels();  // files have another locale
}

void BlowPlots::setRanges() {
    m_plots[waves].rect->axis(QCPAxis::atBottom)->setRange(0, std::max({m_timeEnd, m_ghostEnd, m_runsEnd}));
    for (const Plot& plot : m_plots)
        plot.rect->axis(QCPAxis::atLeft)
            ->setRange(valueRange(plot.graphs + plot.ghosts + plot.overlays + plot.runs->graphs()));
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rock/rock_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/pages/rock/loading_lines.h"
#include "ui/plot/curve_graph.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

QString shown(double value, const ShownUnit& unit, const QLocale& locale) {
    return numberText(value, 4, locale) + QChar(QChar::Nbsp) + unit.unit;
}

// The area of an elastic rock is nothing but rounding.
QString energyText(const RockCurve& curve, const QLocale& locale) {
    constexpr double rounding = 1e-9;
    if (std::abs(curve.energyShare) < rounding) return RockPlot::tr("no energy left in the rock");
    return RockPlot::tr("energy left in the rock: %1 (%2 of the blow)")
        .arg(shown(curve.energy, curve.units.energy, locale), percentText(curve.energyShare, 3, locale));
}

// Compares by name: factors follow the scenario.
bool sameUnitsOfPenetration(const ShownUnits& a, const ShownUnits& b) {
    return a.force.unit == b.force.unit && a.penetration.unit == b.penetration.unit;
}

}  // namespace

RockPlot::RockPlot(QCustomPlot* plot) : StudyFrame(plot) {
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 12, 4));
    view(plot->axisRect());
    m_path = new CurvePath(x(), y());
    m_path->setName(tr("impact force F"));
    addHeader(4);
    m_runs = new RunPaths(x(), y(), m_legend);
    m_lines = new LoadingLines(m_rect);
    // Lines from the peak to both axes, where its numbers are read off.
    m_toForceAxis = addItem<QCPItemLine>(m_rect);
    m_toPenetrationAxis = addItem<QCPItemLine>(m_rect);
    const QMargins padding(5, 2, 5, 2);
    m_peakName = addText(m_rect, padding, Qt::AlignRight | Qt::AlignBottom);
    m_peakName->setTextAlignment(Qt::AlignRight);
    m_residualName = addText(m_rect, padding, Qt::AlignCenter);
    m_loadingName = addText(m_rect, padding, Qt::AlignHCenter | Qt::AlignBottom);
    m_unloadingName = addText(m_rect, padding, Qt::AlignHCenter | Qt::AlignTop);
    for (QCPItemTracer** tracer : {&m_peak, &m_residual, &m_point}) {
        *tracer = addItem<QCPItemTracer>(m_rect);
        (*tracer)->setStyle(QCPItemTracer::tsCircle);
    }
    m_point->setLayer(QStringLiteral("overlay"));
    m_point->setVisible(false);
    connect(plot, &QCustomPlot::afterLayout, this, &RockPlot::placeLabels);
    setStyle(PlotStyle::forPaper());
    setMarksVisible(false);
}

void RockPlot::present(const RockCurve& curve) {
    const bool unitsChanged = !sameUnitsOfPenetration(m_curve.units, curve.units);
    const bool hasOtherRuns = m_curve.runs != curve.runs;
    if (unitsChanged) setGhost(nullptr);
    m_curve = curve;
    m_path->setData(curve.outline);
    if (hasOtherRuns) showRuns();
    name();
    setMarksVisible(curve.peakForce > 0);
    m_lines->present(curve.peakForce > 0 ? curve.lines : QVector<RockLine>(), m_plot->locale());
    nameNumbers(curve);
    finish(unitsChanged);
}

void RockPlot::name() {
    m_path->setName(tr("impact force F"));
    x()->setLabel(m_curve.units.penetration.axisLabel(tr("penetration U")));
    y()->setLabel(m_curve.units.force.axisLabel(tr("impact force F")));
}

void RockPlot::clear() {
    m_path->setData(QSharedPointer<QCPCurveDataContainer>::create());
    setMarksVisible(false);
    m_lines->present({}, m_plot->locale());
    m_point->setVisible(false);
    m_curve = {};
    showRuns();
}

void RockPlot::nameNumbers(const RockCurve& curve) {
    const QLocale locale = m_plot->locale();
    const ShownUnits& units = curve.units;
    const QString force = shown(curve.peakForce, units.force, locale);
    const QString largest = shown(curve.maxPenetration, units.penetration, locale);
    const QString residual = shown(curve.residualPenetration, units.penetration, locale);
    const QString loading = shown(curve.loading, units.stiffness, locale);
    const QString unloading = shown(curve.unloading, units.stiffness, locale);
    const QString energy = energyText(curve, locale);
    m_caption->setText(tr("enclosed area: %1").arg(energy));
    m_peakNumbers = {tr("Fₘ = %1").arg(force), tr("Uₘ = %1").arg(largest)};
    m_peakName->setText(m_peakNumbers.join(QLatin1Char('\n')));
    m_residualName->setText(tr("Uᵣ = %1").arg(residual));
    m_loadingName->setText(tr("k = %1").arg(loading));
    m_unloadingName->setText(tr("k/γ = %1").arg(unloading));
    const QStringList behind = m_lines->texts();
    m_summary =
        tr("Impact force against penetration. Loading along the slope k = %1 up to the peak, Fₘ = %2 at "
           "the penetration Uₘ = %3; unloading along k/γ = %4; the penetration Uᵣ = %5 stays. The "
           "enclosed area: %6.")
            .arg(loading, force, largest, unloading, residual, energy);
    if (!behind.isEmpty())
        m_summary += tr(" Above its corners it loads along %1.").arg(behind.join(QStringLiteral(", ")));
}

// Places labels next to their lines, at any zoom: above the loading line, below the unloading line, the
// residual penetration on the side with room, and the peak in one line if two would be cut off.
void RockPlot::placeLabels() {
    if (!m_peak->visible()) return;
    const auto pixel = [&](double u, double f) { return pixelOf({u, f}); };
    const double um = m_curve.maxPenetration;
    const double ur = m_curve.residualPenetration;
    const double fm = m_curve.peakForce;
    // The first line up to its corner.
    const QPointF end = m_curve.lines.isEmpty() ? QPointF(um, fm) : m_curve.lines.first().to;
    m_loadingName->position->setCoords(0.45 * end);
    m_loadingName->setRotation(rotationAlong(pixel(0, 0), pixelOf(end)));
    m_lines->place();
    m_unloadingName->position->setCoords(ur + 0.5 * (um - ur), 0.5 * fm);
    m_unloadingName->setRotation(rotationAlong(pixel(ur, 0), pixel(um, fm)));
    m_residualName->position->setCoords(ur, 0);
    const double textWidth = QFontMetricsF(m_residualName->font()).horizontalAdvance(m_residualName->text());
    const bool fitsLeft = pixel(ur, 0).x() - pixel(0, 0).x() > 1.6 * textWidth;
    m_residualName->setPositionAlignment((fitsLeft ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
    const double twoLines =
        2 * QFontMetricsF(m_peakName->font()).lineSpacing() + 2 * m_peakName->padding().top();
    const bool fitsAbove = pixel(um, fm).y() - m_rect->top() >= twoLines;
    m_peakName->setText(m_peakNumbers.join(fitsAbove ? QStringLiteral("\n") : QStringLiteral(",  ")));
}

void RockPlot::setMarksVisible(bool visible) {
    const bool stays = visible && m_curve.residualPenetration > 0;
    for (QCPAbstractItem* item : std::initializer_list<QCPAbstractItem*>{m_peakName, m_loadingName, m_peak,
                                                                         m_toForceAxis, m_toPenetrationAxis})
        item->setVisible(visible);
    for (QCPAbstractItem* item :
         std::initializer_list<QCPAbstractItem*>{m_residualName, m_unloadingName, m_residual})
        item->setVisible(stays);
    const double um = m_curve.maxPenetration;
    const double fm = m_curve.peakForce;
    m_peakName->position->setCoords(um, fm);
    m_peak->position->setCoords(um, fm);
    m_residual->position->setCoords(m_curve.residualPenetration, 0);
    m_toForceAxis->start->setCoords(um, fm);
    m_toForceAxis->end->setCoords(0, fm);
    m_toPenetrationAxis->start->setCoords(um, fm);
    m_toPenetrationAxis->end->setCoords(um, 0);
}

void RockPlot::setGhost(const RockCurve* before) {
    if (m_ghost) m_plot->removePlottable(m_ghost);
    m_ghost = nullptr;
    m_ghostSize = {};
    if (before && sameUnitsOfPenetration(before->units, m_curve.units)) {
        m_ghost = new CurvePath(x(), y());
        m_ghost->removeFromLegend();
        m_ghost->setSelectable(QCP::stNone);
        m_ghost->setLayer(ghostLayer(*m_plot));
        m_ghost->setPen(m_style.ghostPen(0));
        m_ghost->setData(before->outline);
        m_ghostSize = {before->maxPenetration, before->peakForce};
    }
    fitUnlessZoomed();
}

void RockPlot::showRuns() {
    QVector<RunPath> paths;
    for (const RunOverlay<RockCurve>& run : m_curve.runs)
        paths.append({run.number, run.title, run.curves->outline});
    m_runs->present(paths);
    // Puts side by side what fits on the narrowest page: names of a few, letters of more.
    m_legend->setWrap(m_curve.runs.size() > 3 ? 5 : 2);
    m_legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void RockPlot::setPoint(const std::optional<QPointF>& point) {
    m_point->setVisible(point.has_value());
    if (point) m_point->position->setCoords(*point);
}

void RockPlot::restyle() {
    const PlotStyle& style = m_style;
    m_runs->setStyle(style);
    m_lines->setStyle(style);
    m_path->setPen(style.linePen(0));
    m_path->setBrush(style.areaBrush(0));
    if (m_ghost) m_ghost->setPen(style.ghostPen(0));
    QColor behind = style.background;
    behind.setAlpha(170);
    m_residualName->setBrush(behind);  // lines of earlier contacts may pass there
    for (QCPItemLine* line : {m_toForceAxis, m_toPenetrationAxis})
        line->setPen(QPen(style.zeroLine, 1, Qt::DashLine));
    for (QCPItemTracer* mark : {m_peak, m_residual}) {
        mark->setSize(6);
        mark->setPen(QPen(style.lines[0], 1.5));
        mark->setBrush(style.background);
    }
    m_point->setSize(10);
    m_point->setPen(QPen(style.text, 1.5));
    m_point->setBrush(style.lines[1]);
    if (m_curve.path) nameNumbers(m_curve);  // files have another locale
}

void RockPlot::setRanges() {
    double penetration = m_ghostSize.width(), force = m_ghostSize.height();  // of others than the present
    for (const RunOverlay<RockCurve>& run : m_curve.runs) {
        penetration = std::max(penetration, run.curves->maxPenetration);
        force = std::max(force, run.curves->peakForce);
    }
    const auto range = [](double present, double other) {
        const double size = std::max(present, other);
        return size > 0 ? QCPRange(-0.03 * size, 1.14 * size) : QCPRange(0, 1);
    };
    x()->setRange(range(m_curve.maxPenetration, penetration));
    y()->setRange(range(m_curve.peakForce, force));
}

}  // namespace drillwave

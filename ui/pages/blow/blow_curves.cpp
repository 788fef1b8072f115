// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_curves.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/blow/blow_waves.h"
#include "core/model/pulse_force.h"
#include "core/model/section_words.h"
#include "core/wave/field/rod_state.h"
#include "core/wave/field/wave_curves.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

// A wave rises from nothing at its arrival.
GraphData waveData(const SampledCurve& wave, const ShownUnits& units) {
    QVector<QCPGraphData> points = shownPoints(wave.time, wave.value, units.time, units.force);
    if (!points.isEmpty()) points.prepend(QCPGraphData(points.first().key, 0));
    return graphData(points);
}

QVector<QCPGraphData> momentumPoints(const Impact& impact, const PulseForce& pulse,
                                     const std::vector<double>& history, const ShownUnits& units) {
    std::vector<double> times = impulseTimes(pulse);
    times.insert(times.end(), history.begin(), history.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(times.size()) + 1);
    for (double t : times)
        appendFinite(points, t * units.time.factor, rodMomentum(impact, pulse, t) * units.impulse.factor);
    return points;
}

double interestingEnd(const Impact& impact, const PulseForce& pulse, const std::vector<SectionWave>& waves) {
    double end = std::max(1.1 * impact.separationTime, visibleImpulseEnd(pulse));
    for (const SectionWave& wave : waves)
        if (!wave.curve.time.empty()) end = std::max(end, wave.curve.time.back());
    return end;
}

/// Until all has happened that is seen: the last contact of the rock, and the first one of the hammer.
double interestingEnd(const Blow& blow, double last) {
    double end = 0;
    for (const double time : {blow.summary.separationTime, blow.summary.faceSeparationTime})
        if (std::isfinite(time)) end = std::max(end, 1.1 * time);
    return end > 0 ? std::min(end, last) : last;
}

/// Names the section of a string in which the waves are observed.
void namePlace(BlowCurves& curves, const DrillString& drill) {
    const std::vector<const Section*> sections = allSections(drill);
    if (sections.empty()) return;
    curves.place = stringPlace(drill, curves.section);
    const Section& at = *sections[curves.place->section];
    curves.sectionWords = translated(sectionWords(drill)[curves.place->section]);
    curves.fromRear = curves.place->share * at.length;
}

void addString(BlowCurves& curves, const Blow& blow, const ShownUnits& units, Tail tail) {
    const BlowWaves waves(blow);
    const double end = interestingEnd(blow, waves.end());
    curves.timeEnd = end * units.time.factor;
    std::vector<RodState> rows = waves.sampled(*curves.place);
    if (tail == Tail::cut) std::erase_if(rows, [end](const RodState& now) { return now.time > end; });
    const auto curve = [&](double RodState::*value, const ShownUnit& unit) {
        QVector<QCPGraphData> points;
        points.reserve(static_cast<qsizetype>(rows.size()));
        for (const RodState& now : rows)
            appendFinite(points, now.time * units.time.factor, now.*value * unit.factor);
        return graphData(points);
    };
    curves.sectionForce = curve(&RodState::normalForce, units.force);
    curves.waves[0] = curve(&RodState::positiveWave, units.force);
    curves.waves[1] = curve(&RodState::negativeWave, units.force);
    curves.force = curve(&RodState::impactForce, units.force);
    curves.faceForce = curve(&RodState::faceForce, units.force);
    curves.impulse = curve(&RodState::impulse, units.impulse);
    curves.momentum = curve(&RodState::momentum, units.impulse);
}

void addRod(BlowCurves& curves, const Impact& impact, const PulseForce& pulse, const ShownUnits& units,
            Tail tail) {
    curves.section = std::max(0.0, curves.section);
    const std::vector<SectionWave> waves = sectionWaves(impact, curves.section, BlowCurves::waveCount);
    for (const SectionWave& wave : waves)
        curves.waves[static_cast<std::size_t>(wave.number)] = waveData(wave.curve, units);
    const double end = interestingEnd(impact, pulse, waves);
    const SectionForce all = sectionForce(impact, curves.section, waves, end);
    curves.laterWaves = {waveData(all.toBit, units), waveData(all.fromBit, units)};
    curves.sectionForce = graphData(shownPoints(all.force.time, all.force.value, units.time, units.force));
    curves.timeEnd = end * units.time.factor;
    const SampledHistory history = sampleHistory(impact);
    curves.force =
        historyData(shownPoints(history.time, history.force, units.time, units.force), curves.timeEnd, tail);
    curves.impulse = historyData(shownPoints(history.time, history.impulse, units.time, units.impulse),
                                 curves.timeEnd, tail);
    curves.momentum = historyData(momentumPoints(impact, pulse, history.time, units), curves.timeEnd, tail);
}

}  // namespace

BlowCurves blowCurves(const Blow& blow, const ShownUnits& units, double section, Tail tail) {
    BlowCurves curves;
    curves.units = units;
    curves.section = section;
    for (GraphData* each : {&curves.sectionForce, &curves.force, &curves.faceForce, &curves.impulse,
                            &curves.momentum, &curves.laterWaves.front(), &curves.laterWaves.back()})
        *each = GraphData::create();
    curves.waves.fill(GraphData::create());
    namePlace(curves, blow.scenario.drillString);
    if (blow.impact.waves)
        addString(curves, blow, units, tail);
    else if (blow.impact.hasHistories())
        addRod(curves, blow.impact, blow.problem.force(), units, tail);
    return curves;
}

}  // namespace drillwave

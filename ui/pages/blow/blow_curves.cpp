// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_curves.h"

#include <qcustomplot.h>

#include <algorithm>
#include <vector>

#include "core/model/visible_pulse.h"
#include "core/wave/field/rod_state.h"
#include "core/wave/field/section_force.h"
#include "core/wave/field/wave_curves.h"

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

}  // namespace

BlowCurves blowCurves(const Impact& impact, const PulseForce& pulse, const ShownUnits& units, double section,
                      Tail tail) {
    BlowCurves curves;
    curves.units = units;
    curves.section = section;
    curves.waves.fill(GraphData::create());
    const std::vector<SectionWave> waves = sectionWaves(impact, section, BlowCurves::waveCount);
    for (const SectionWave& wave : waves)
        curves.waves[static_cast<std::size_t>(wave.number)] = waveData(wave.curve, units);
    const double end = interestingEnd(impact, pulse, waves);
    const SectionForce all = sectionForce(impact, section, waves, end);
    curves.laterWaves = {waveData(all.toBit, units), waveData(all.fromBit, units)};
    curves.sectionForce = graphData(shownPoints(all.force.time, all.force.value, units.time, units.force));
    curves.timeEnd = end * units.time.factor;
    const SampledHistory history = sampleHistory(impact);
    curves.force =
        historyData(shownPoints(history.time, history.force, units.time, units.force), curves.timeEnd, tail);
    curves.impulse = historyData(shownPoints(history.time, history.impulse, units.time, units.impulse),
                                 curves.timeEnd, tail);
    curves.momentum = historyData(momentumPoints(impact, pulse, history.time, units), curves.timeEnd, tail);
    return curves;
}

}  // namespace drillwave

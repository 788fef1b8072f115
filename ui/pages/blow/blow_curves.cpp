// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_curves.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/wave/field/wave_field.h"

namespace drillwave {
namespace {

// A wave rises from nothing at its arrival.
GraphData waveData(const SampledCurve& wave, const ShownUnits& units) {
    QVector<QCPGraphData> points = shownPoints(wave.time, wave.value, units.time, units.force);
    if (!points.isEmpty()) points.prepend(QCPGraphData(points.first().key, 0));
    return graphData(points);
}

// How far into a segment a share of its samples lies, as a fraction of its length or, where the force decays,
// of its impulse.
double localTime(const PulseSegment& segment, double share) {
    if (segment.kind != PulseSegment::Kind::exponential) return segment.length * share;
    return share < 1 ? std::min(-std::log1p(-share), segment.length) : segment.length;
}

// Times at which the impulse of the hammer is sampled: its curve is smooth inside a segment.
std::vector<double> pulseTimes(const PulseForce& pulse) {
    constexpr int samplesPerSegment = 48;
    std::vector<double> times{0};
    for (const PulseSegment& segment : pulse.segments) {
        const bool straight = segment.kind == PulseSegment::Kind::linear && segment.slope == 0;
        const int samples = straight ? 1 : samplesPerSegment;
        for (int i = 1; i <= samples; ++i)
            times.push_back(segment.start + localTime(segment, static_cast<double>(i) / samples));
    }
    return times;
}

QVector<QCPGraphData> momentumPoints(const Impact& impact, const PulseForce& pulse,
                                     const std::vector<double>& history, const ShownUnits& units) {
    std::vector<double> times = pulseTimes(pulse);
    times.insert(times.end(), history.begin(), history.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(times.size()) + 1);
    for (double t : times) {
        const double given = pulse.isRigidBody() ? 1 : pulse.impulseUntil(t);
        const double taken = impactImpulse(impact, t - impact.frontArrival);
        appendFinite(points, t * units.time.factor, (given - taken) * units.impulse.factor);
    }
    return points;
}

// The tail of an exponential blow or of a staircase is long, and nothing can be seen in it.
double visibleEnd(const PulseForce& pulse) {
    constexpr double visible = 0.97;
    for (const double time : pulseTimes(pulse))
        if (pulse.impulseUntil(time) >= visible) return time;
    return pulse.end;
}

double interestingEnd(const Impact& impact, const PulseForce& pulse, const std::vector<SectionWave>& waves) {
    double end = std::max(1.1 * impact.separationTime, visibleEnd(pulse));
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
    curves.timeEnd = interestingEnd(impact, pulse, waves) * units.time.factor;
    const SampledHistory history = sampleHistory(impact);
    curves.force =
        historyData(shownPoints(history.time, history.force, units.time, units.force), curves.timeEnd, tail);
    curves.impulse = historyData(shownPoints(history.time, history.impulse, units.time, units.impulse),
                                 curves.timeEnd, tail);
    curves.momentum = historyData(momentumPoints(impact, pulse, history.time, units), curves.timeEnd, tail);
    return curves;
}

}  // namespace drillwave

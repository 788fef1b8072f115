// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/section_force.h"

#include <algorithm>
#include <cassert>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/recorded_time.h"
#include "core/wave/field/rod_delays.h"

namespace drillwave {
namespace {

/// More than any plot can show, and little to keep: slow drifts have millions of round trips.
constexpr std::size_t mostPoints = 100'000;

void append(SampledCurve& curve, double time, double value) {
    // Rounding apart one wave begins where the one before ends.
    curve.time.push_back(curve.time.empty() ? time : std::max(time, curve.time.back()));
    curve.value.push_back(value);
}

void append(SampledCurve& curve, const SampledCurve& wave) {
    for (std::size_t i = 0; i < wave.time.size(); ++i) append(curve, wave.time[i], wave.value[i]);
}

/// Where a curve goes from point `next` − 1 to point `next`.
double chordBefore(const SampledCurve& curve, std::size_t next, double time) {
    if (next == 0) return curve.value.front();
    const double from = curve.time[next - 1], to = curve.time[next];
    if (!(to > from)) return curve.value[next];
    return curve.value[next - 1] +
           (curve.value[next] - curve.value[next - 1]) * ((time - from) / (to - from));
}

/// The sum of two curves as far as there are both; jumps of both at one time are one.
SampledCurve sumOf(const SampledCurve& a, const SampledCurve& b) {
    SampledCurve sum;
    const auto jumpsNext = [](const SampledCurve& curve, std::size_t i) {
        return i + 1 < curve.time.size() && curve.time[i + 1] == curve.time[i];
    };
    std::size_t i = 0, j = 0;
    while (i < a.time.size() && j < b.time.size()) {
        if (a.time[i] < b.time[j]) {
            append(sum, a.time[i], a.value[i] + chordBefore(b, j, a.time[i]));
            ++i;
        } else if (b.time[j] < a.time[i]) {
            append(sum, b.time[j], chordBefore(a, i, b.time[j]) + b.value[j]);
            ++j;
        } else {
            append(sum, a.time[i], a.value[i] + b.value[j]);
            const bool aJumps = jumpsNext(a, i), bJumps = jumpsNext(b, j);
            if (aJumps || !bJumps) ++i;
            if (bJumps || !aJumps) ++j;
        }
    }
    return sum;
}

/// The waves of one heading from `number` on, every second one.
SampledCurve wavesFrom(const Impact& impact, double xi, int number, double end) {
    SampledCurve waves;
    while (waves.time.size() < mostPoints) {
        const SectionWave wave = sampledWave(impact, xi, number, end);
        if (wave.curve.time.empty()) break;
        append(waves, wave.curve);
        number += 2;
    }
    return waves;
}

}  // namespace

SectionForce sectionForce(const Impact& impact, double xi, std::span<const SectionWave> first, double end) {
    assert(first.size() % 2 == 0);
    const RodDelays delays(impact);
    const int count = static_cast<int>(first.size());
    SectionForce found{{}, wavesFrom(impact, xi, count, end), wavesFrom(impact, xi, count + 1, end)};
    // Before its first wave either way the rod is free of force: nothing, or a uniform motion.
    const double before = waveBeforeArrival(impact);
    const double begin = std::min(0.0, delays.shift(Heading::toBit, xi));
    const auto beginning = [&](Heading heading, double value) {
        SampledCurve curve;
        append(curve, begin, value);
        append(curve, delays.shift(heading, xi), value);
        return curve;
    };
    SampledCurve toBit = beginning(Heading::toBit, -before);
    SampledCurve fromBit = beginning(Heading::fromBit, before);
    for (const SectionWave& wave : first) append(wave.number % 2 == 0 ? toBit : fromBit, wave.curve);
    append(toBit, found.toBit);
    append(fromBit, found.fromBit);
    found.force = sumOf(toBit, fromBit);
    return found;
}

double sectionImpulse(const Impact& impact, double xi, double t) {
    const RodDelays delays(impact);
    const double arriving = delays.atBit(Heading::toBit, xi, t);
    const double leaving = delays.atBit(Heading::fromBit, xi, t);
    return incidentImpulse(impact, leaving) - impactImpulse(impact, leaving) -
           incidentImpulse(impact, arriving);
}

}  // namespace drillwave

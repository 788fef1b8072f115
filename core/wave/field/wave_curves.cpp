// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/history_reader.h"
#include "core/wave/field/wave_field.h"

namespace drillwave {

namespace {

using Piece = PiecewisePolynomial::Piece;

/// A million reflections make a million pieces, each far below a pixel: all of them together get about so
/// many chords, or one each.
constexpr std::size_t chordsOfAll = 1'000'000;

/// Into how many chords a piece is cut: curvature bound Σk(k−1)|c_k| over 8 chords² within 1e-4 of its size.
int chords(const PiecewisePolynomial& f, const Piece& piece) {
    const double u = piece.length / piece.scale;
    double curvature = 0, size = 0, power = 1;
    int k = 0;
    for (const double c : f.coefficients(piece)) {
        curvature += k * (k - 1) * std::abs(c) * power;
        size += std::abs(c) * power;
        power *= u;
        ++k;
    }
    if (size == 0) return 1;
    const std::size_t most = std::clamp<std::size_t>(chordsOfAll / f.pieces().size(), 1, 100);
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(curvature / (8e-4 * size)))), 1,
                      static_cast<int>(most));
}

/// Rounding of times, in round trips: anything shorter is no part of a curve.
constexpr double negligibleTime = 1e-12;

/// Appends value(piece, x) over recorded time [from, to), shifted by `shift`, as chords of `wave`: without
/// the jumps at `from` and `to`, whichever side of them rounding has put the pieces that begin there.
template <class Value>
void sampleRecorded(const Impact& impact, double from, double to, double shift, Value value,
                    SampledCurve& curve) {
    const auto pieces = impact.incident.pieces();
    const auto forces = impact.force.pieces();
    const double rounding = negligibleTime * impact.roundTrip;
    const auto first = std::partition_point(pieces.begin(), pieces.end(), [&](const Piece& piece) {
        return piece.start + piece.length <= from + rounding;
    });
    for (auto piece = first; piece != pieces.end() && piece->start < to - rounding; ++piece) {
        const auto index = static_cast<std::size_t>(piece - pieces.begin());
        const double begin = std::max(0.0, from - piece->start);
        const double end = std::min(piece->length, to - piece->start);
        if (!(end >= begin)) continue;
        const int n = std::max(chords(impact.incident, *piece), chords(impact.force, forces[index]));
        for (int i = 0; i <= n; ++i) {
            const double x = begin + (end - begin) * i / n;
            curve.time.push_back(piece->start + x + shift);
            curve.value.push_back(value(*piece, forces[index], x));
        }
    }
}

Heading headingOf(int number) {
    return number % 2 == 0 ? Heading::toBit : Heading::fromBit;
}

/// When the wave of that number reaches the bit or leaves it, since the first arrival there.
double startOf(const RodDelays& delays, int number) {
    const int trip = number / 2;
    return trip * delays.roundTrip();
}

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

SectionWave sampledWave(const Impact& impact, double xi, int number, double end) {
    const RodDelays delays(impact);
    SectionWave wave{number, {}};
    const bool forward = headingOf(number) == Heading::toBit;
    const double shift = delays.shift(headingOf(number), xi);
    double from = startOf(delays, number);
    const double to = std::min(from + delays.roundTrip(), end - shift);
    const auto value = [&](const Piece& g, const Piece& f, double x) {
        const double incident = impact.incident.value(g, x);
        return forward ? -incident : incident - impact.force.value(f, x);
    };
    while (from < to) {  // past the recording the last period repeats itself
        const double recorded = recordedTime(impact, from);
        const double stretch = std::min(to - from, uninterrupted(impact, from));
        // After very many round trips the rounding of the time itself is the larger one.
        const double least =
            std::max(negligibleTime * delays.roundTrip(), 8 * std::numeric_limits<double>::epsilon() * from);
        if (!(stretch > least)) {
            from += least;
            continue;
        }
        sampleRecorded(impact, recorded, recorded + stretch, from - recorded + shift, value, wave.curve);
        from += stretch;
    }
    return wave;
}

std::vector<SectionWave> sectionWaves(const Impact& impact, double xi, int count) {
    std::vector<SectionWave> waves;
    for (int number = 0; number < count; ++number) waves.push_back(sampledWave(impact, xi, number));
    return waves;
}

double sectionWave(const Impact& impact, double xi, int number, double t) {
    const RodDelays delays(impact);
    const double s = delays.atBit(headingOf(number), xi, t), begin = startOf(delays, number);
    if (s < begin || s > begin + delays.roundTrip()) return std::numeric_limits<double>::quiet_NaN();
    const WaveField field(impact);
    return headingOf(number) == Heading::toBit ? field.positiveWave(xi, t) : field.negativeWave(xi, t);
}

double sectionWaveImpulse(const Impact& impact, double xi, int number, double t) {
    const RodDelays delays(impact);
    const double begin = startOf(delays, number);
    const double s = std::clamp(delays.atBit(headingOf(number), xi, t), begin, begin + delays.roundTrip());
    const double incident = incidentImpulse(impact, s);
    return headingOf(number) == Heading::toBit ? -incident : incident - impactImpulse(impact, s);
}

SampledHistory sampleHistory(const Impact& impact) {
    SampledHistory history;
    const RodDelays delays(impact);
    const auto pieces = impact.incident.pieces();
    const auto forces = impact.force.pieces();
    double impulse = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const int n = std::max(chords(impact.incident, pieces[i]), chords(impact.force, forces[i]));
        const double shift = delays.arrival() + unrecordedBefore(impact, pieces[i].start);
        const double end = i + 1 < pieces.size() ? pieces[i + 1].start : impact.incident.end();
        for (int j = 0; j <= n; ++j) {
            const double x = pieces[i].length * j / n;
            history.time.push_back(std::min(pieces[i].start + x, end) + shift);  // rounding apart
            history.force.push_back(std::max(impact.force.value(forces[i], x), 0.0));
            history.impulse.push_back(impulse + impact.force.integral(forces[i], x));
            history.incident.push_back(impact.incident.value(pieces[i], x));
        }
        impulse += impact.force.integral(forces[i], pieces[i].length);
    }
    return history;
}

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

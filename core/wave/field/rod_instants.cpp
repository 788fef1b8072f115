// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_instants.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/recorded_time.h"

namespace drillwave {
namespace {

/// How far a wave may bend off the chord between two instants, as a share of the peak force.
constexpr double tolerance = 1e-4;

/// k(k − 1), what the second derivative makes of the coefficient of u^k.
constexpr auto bendFactors = [] {
    std::array<double, 256> f{};
    for (std::size_t i = 2; i < f.size(); ++i) f[i] = double(i * (i - 1));
    return f;
}();

/// What the second derivative over u of a piece is at most, and what its values are at most.
struct Sizes {
    double bend = 0, value = 0;

    void add(double coefficient, double bent) {
        value += std::abs(coefficient);
        bend += std::abs(bent);
    }
};

/// The second derivative over u, 0 ≤ u ≤ 1, lies between the least and the largest partial sum of its
/// coefficients: as 1 ≥ u ≥ u² ≥ … it is a mean of them.
struct PartialSums {
    double sum = 0, least = 0, most = 0;

    void add(double coefficient) {
        sum += coefficient;
        least = std::min(least, sum);
        most = std::max(most, sum);
    }
    /// A wave that bends downwards by c at most is above its chord by c/8 in the middle.
    WaveBends bends() const { return {-least / 8, most / 8}; }
};

/// Into how many parts a piece is cut so that no extremum between them is missed by more than `tolerance`.
int partsOf(double bend, double peak) {
    constexpr double most = 64;
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance * peak))), 1.0, most));
}

}  // namespace

PieceBends bendsOfPiece(const Impact& impact, std::size_t index) {
    const double peak = std::max(impact.peakForce, std::numeric_limits<double>::min());
    const std::span<const double> g = impact.incident.coefficients(impact.incident.pieces()[index]);
    const std::span<const double> F = impact.force.coefficients(impact.force.pieces()[index]);
    // what is constant neither bends nor has any rounding
    if (g.size() <= 1 && F.size() <= 1) return {};
    const std::size_t common = std::min(g.size(), F.size());
    assert(std::max(g.size(), F.size()) <= bendFactors.size());
    Sizes incident, force;
    PartialSums ofIncident, ofReflected;
    std::size_t k = 0;
    for (; k < common; ++k) {
        const double bentG = bendFactors[k] * g[k], bentF = bendFactors[k] * F[k];
        incident.add(g[k], bentG);
        force.add(F[k], bentF);
        ofIncident.add(bentG);
        ofReflected.add(bentF - bentG);
    }
    for (; k < g.size(); ++k) {
        const double bent = bendFactors[k] * g[k];
        incident.add(g[k], bent);
        ofIncident.add(bent);
        ofReflected.add(-bent);
    }
    for (; k < F.size(); ++k) {
        const double bent = bendFactors[k] * F[k];
        force.add(F[k], bent);
        ofReflected.add(bent);
    }
    constexpr double ofSum = 64 * std::numeric_limits<double>::epsilon();  // of 30 terms
    return {ofIncident.bends(), ofReflected.bends(),
            ofSum * (incident.value + force.value + (incident.bend + force.bend) / 8),
            std::max(partsOf(incident.bend, peak), partsOf(force.bend, peak))};
}

Instant instantIn(const Impact& impact, std::size_t index, double x, Side side) {
    const PiecewisePolynomial::Piece& piece = impact.incident.pieces()[index];
    const PiecewisePolynomial::Piece& force = impact.force.pieces()[index];
    const double g = impact.incident.value(piece, x);
    const double F = force.count > 0 ? impact.force.value(force, x) : 0;
    return {piece.start + x, side, g, F - g};
}

std::size_t firstPieceUntil(const Impact& impact, double from) {
    const auto pieces = impact.incident.pieces();
    const auto found = std::ranges::partition_point(
        pieces, [from](const auto& piece) { return piece.start + piece.length < from; });
    return static_cast<std::size_t>(found - pieces.begin());
}

double recordedEndOfBlow(const Impact& impact) {
    const double blowEnd = impact.separationTime + impact.roundTrip / 2;
    return blowEnd - impact.frontArrival - unrecordedBefore(impact, impact.incident.end());
}

std::vector<double> counterparts(const Impact& impact, double end, double first, double last) {
    const double half = impact.roundTrip / 2;
    // a little more than is asked for: what lies at a limit but for rounding is among it
    const double rounding = roundingOfTrip(end, impact.roundTrip);
    const double from = std::max(end - half, 2 * end - last - rounding);
    const double until = std::min(end + half, 2 * end - first + rounding);
    std::vector<double> times;
    forEachPoint(impact, from, until, {}, [&](std::size_t piece, double x, Side) {
        const double time = impact.incident.pieces()[piece].start + x;
        if (time >= from && time <= until) times.push_back(2 * end - time);
    });
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
    return times;
}

std::vector<double> counterparts(const Impact& impact, double end) {
    const double half = impact.roundTrip / 2;
    return counterparts(impact, end, end - half, end + half);
}

Instant instantBeforeFront(const Impact& impact, double time) {
    const double before = incidentWave(impact, -impact.roundTrip / 2);
    return {time, Side::end, before, -before};
}

std::vector<Instant> lastPeriod(const Impact& impact) {
    const double from = impact.incident.end() - impact.roundTrip;
    std::vector<Instant> instants;
    forEachInstant(impact, from, {from}, [&](const Instant& now) {
        if (now.time >= from) instants.push_back(now);
    });
    return instants;
}

double roundingOfTrip(double time, double roundTrip) {
    return 8 * std::numeric_limits<double>::epsilon() * (time + roundTrip);
}

}  // namespace drillwave

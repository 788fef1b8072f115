// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_instants.h"

#include <cmath>
#include <limits>
#include <span>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/recorded_time.h"

namespace drillwave {
namespace {

/// How far a wave may bend off the chord between two instants, as a share of the peak force.
constexpr double tolerance = 1e-4;

/// Into how many parts a piece is cut so that no extremum between them is missed by more than `tolerance`.
int partsOf(std::span<const double> c, double peak) {
    constexpr double most = 64;
    double bend = 0;
    for (std::size_t k = 2; k < c.size(); ++k) bend += double(k * (k - 1)) * std::abs(c[k]);
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance * peak))), 1.0, most));
}

}  // namespace

int partsOfPiece(const Impact& impact, std::size_t index) {
    const double peak = std::max(impact.peakForce, std::numeric_limits<double>::min());
    return std::max(partsOf(impact.incident.coefficients(impact.incident.pieces()[index]), peak),
                    partsOf(impact.force.coefficients(impact.force.pieces()[index]), peak));
}

double recordedEndOfBlow(const Impact& impact) {
    const double blowEnd = impact.separationTime + impact.roundTrip / 2;
    return blowEnd - impact.frontArrival - unrecordedBefore(impact, impact.incident.end());
}

std::vector<double> counterparts(const Impact& impact, double end) {
    const double half = impact.roundTrip / 2;
    std::vector<double> times;
    forEachInstant(impact, end - half, {}, [&](const Instant& now) {
        if (now.time >= end - half && now.time <= end + half) times.push_back(2 * end - now.time);
    });
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
    return times;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/event_order.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/wave/field/wave_field.h"

namespace drillwave {

namespace {

constexpr std::size_t mostEvents = 32;
constexpr std::size_t mostHammerPieces = 64;

/// Times this close, in round trips, are one: an event that is caused by an arrival coincides with it but for
/// rounding.
constexpr double coincident = 1e-13;

/// FNV-1a over 64-bit words.
class Fingerprint {
  public:
    void add(std::uint64_t word) {
        for (int byte = 0; byte < 8; ++byte)
            m_hash = (m_hash ^ (word >> (8 * byte) & 0xff)) * 0x100000001b3ULL;
    }
    std::uint64_t value() const { return m_hash; }

  private:
    std::uint64_t m_hash = 0xcbf29ce484222325ULL;
};

/// Even for a whole number of round trips, odd for anything between two.
std::uint64_t roundTripsBetween(double from, double to, double roundTrip) {
    const double trips = (to - from) / roundTrip;
    const double whole = std::round(trips);
    const double rounding = coincident * (1 + to / roundTrip);
    const double place = std::abs(trips - whole) <= rounding ? 2 * whole : 2 * std::floor(trips) + 1;
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::clamp(place, -1e18, 1e18)));
}

}  // namespace

std::uint64_t eventOrder(const Impact& impact, const PulseForce& pulse) {
    assert(impact.hasEvents());
    const WaveField field(impact);
    std::vector<double> sources;  // of fronts
    for (const PulseSegment& segment : pulse.segments) {
        if (sources.size() == mostHammerPieces) break;
        sources.push_back(field.arrival() + segment.start);
    }
    sources.push_back(field.arrival() + pulse.end);
    Fingerprint fingerprint;
    std::size_t counted = 0;
    for (const ImpactEvent& event : impact.events) {
        // Each corner is passed at most once in a blow.
        if (event.kind != ContactEvent::corner && ++counted > mostEvents) break;
        fingerprint.add(static_cast<std::uint64_t>(event.kind));
        for (const double source : sources)
            fingerprint.add(roundTripsBetween(source, event.time, field.roundTrip()));
        sources.push_back(event.time);
    }
    return fingerprint.value();
}

}  // namespace drillwave

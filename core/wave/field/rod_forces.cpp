// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_forces.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/recorded_time.h"

namespace drillwave {

namespace {

using Piece = PiecewisePolynomial::Piece;

/// On which side of a breakpoint a value is taken.
enum class Side { start, inside, end };

/// Both waves at one time of the front end.
struct Instant {
    double time;
    Side side;
    double incident;   ///< g
    double reflected;  ///< r = F − g
};

/// What is reflected at the rear end by now is in g already. A jump that comes back there must not be added
/// to what it was before: within rounding of one round trip only the later side of the earlier time and the
/// earlier side of the later one are in the rod together.
bool areInRod(const Instant& incoming, const Instant& reflected, double roundTrip) {
    const double oldest = incoming.time - roundTrip;
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * (incoming.time + roundTrip);
    if (std::abs(reflected.time - oldest) > rounding) return reflected.time > oldest;
    return incoming.side == Side::end && reflected.side == Side::start;
}

/// The largest of one sign of the force in the rod, as recorded times of the two waves that make it.
struct Meeting {
    double size = 0;
    double incident = 0, reflected = 0;

    void offer(double sum, const Instant& incoming, const Instant& back) {
        if (sum > size) *this = {sum, incoming.time, back.time};
    }

    /// As a place and a global time.
    RodForce found(const Impact& impact) const {
        const double late = std::clamp((incident - reflected) / impact.roundTrip, 0.0, 1.0);  // 1 − ξ
        const double time =
            timeOfRecorded(impact, incident) + impact.frontArrival - late * impact.roundTrip / 2;
        return {size, 1 - late, time};
    }
};

/// Follows one sign of the force: the sum of what comes in and the largest of what went back up to one round
/// trip before.
class SlidingMaximum {
  public:
    SlidingMaximum(double sign, double roundTrip, Meeting& most)
        : m_sign(sign), m_roundTrip(roundTrip), m_most(most) {}

    void pass(const Instant& now) {
        while (!m_back.empty() && m_sign * m_back.back().reflected <= m_sign * now.reflected)
            m_back.pop_back();
        m_back.push_back(now);
        while (m_back.size() > 1 && !areInRod(now, m_back.front(), m_roundTrip)) m_back.pop_front();
        m_most.offer(m_sign * (now.incident + m_back.front().reflected), now, m_back.front());
    }

  private:
    double m_sign;
    double m_roundTrip;
    Meeting& m_most;
    std::deque<Instant> m_back;  ///< falling values of the reflected wave
};

/// How far a wave may bend off the chord between two points that are looked at, as a share of the peak force.
constexpr double tolerance = 1e-4;

/// Into how many parts a piece is cut so that no extremum between them is missed by more than `tolerance`.
int partsOf(std::span<const double> c, double peak) {
    constexpr double most = 64;
    double bend = 0;
    for (std::size_t k = 2; k < c.size(); ++k) bend += double(k * (k - 1)) * std::abs(c[k]);
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance * peak))), 1.0, most));
}

/// Calls pass(instant) for both ends of every piece that ends behind `from`, and for points between where a
/// wave is curved.
template <class Pass>
void forEachInstant(const Impact& impact, double from, Pass pass) {
    const auto incident = impact.incident.pieces();
    const auto force = impact.force.pieces();
    const double peak = std::max(impact.peakForce, std::numeric_limits<double>::min());
    for (std::size_t i = 0; i < incident.size(); ++i) {
        const Piece& piece = incident[i];
        if (piece.start + piece.length < from) continue;
        const auto at = [&](double x, Side side) {
            const double g = impact.incident.value(piece, x);
            const double F = force[i].count > 0 ? impact.force.value(force[i], x) : 0;
            pass(Instant{piece.start + x, side, g, F - g});
        };
        const int parts = std::max(partsOf(impact.incident.coefficients(piece), peak),
                                   partsOf(impact.force.coefficients(force[i]), peak));
        at(0, Side::start);
        for (int part = 1; part < parts; ++part) at(piece.length * part / parts, Side::inside);
        at(piece.length, Side::end);
    }
}

/// The instants of which the last meet before `end` (a recorded time): the breakpoints of one round trip
/// before and half of one after it, and the times that meet these just then.
std::vector<Instant> lastInstants(const Impact& impact, double end) {
    const double half = impact.roundTrip / 2;
    const double skipped = unrecordedBefore(impact, impact.incident.end());
    std::vector<Instant> instants;
    forEachInstant(impact, end - impact.roundTrip, [&](const Instant& now) {
        if (now.time > end + half) return;
        instants.push_back(now);
        if (now.time < end - half) return;
        const double mirrored = 2 * end - now.time;
        const double g = incidentWave(impact, mirrored + skipped);
        instants.push_back({mirrored, Side::inside, g, impactForce(impact, mirrored + skipped) - g});
    });
    std::ranges::stable_sort(instants, {}, &Instant::time);
    return instants;
}

/// Waves that come in later than `end` meet those that left before 2·end − a only: a window that grows at
/// both of its ends as a goes back from end + τ to `end`.
void addLastMeetings(const std::vector<Instant>& instants, double end, double roundTrip, double sign,
                     Meeting& most) {
    const auto first = std::ranges::lower_bound(instants, end - roundTrip / 2, {}, &Instant::time);
    auto low = first, high = first;  // [low, high) is in the window
    const Instant* largest = nullptr;
    const auto take = [&](const Instant& back) {
        if (!largest || sign * back.reflected > sign * largest->reflected) largest = &back;
    };
    for (auto now = instants.rbegin(); now != instants.rend() && now->time > end; ++now) {
        while (high != instants.end() && high->time <= 2 * end - now->time &&
               areInRod(*now, *high, roundTrip))
            take(*high++);
        while (low != instants.begin() && areInRod(*now, *(low - 1), roundTrip)) take(*--low);
        if (largest) most.offer(sign * (now->incident + largest->reflected), *now, *largest);
    }
}

/// After the blow the waves run to and fro: each point of them meets every other, the first time after
/// `begin`.
void addWavesThatRemain(const Impact& impact, double begin, RodForces& forces) {
    const double from = impact.incident.end() - impact.roundTrip;
    Instant least{}, most{};
    bool first = true;
    forEachInstant(impact, from, [&](const Instant& now) {
        if (now.time < from) return;
        if (first || now.incident > most.incident) most = now;
        if (first || now.incident < least.incident) least = now;
        first = false;
    });
    const double size = most.incident - least.incident;
    if (first || !(size > 0)) return;
    const auto meeting = [&](const Instant& incoming, const Instant& reflected) {
        const double behind =
            std::fmod(incoming.time - reflected.time + impact.roundTrip, impact.roundTrip);  // a − b
        const double late = behind / impact.roundTrip;
        const double time = timeOfRecorded(impact, reflected.time) + behind + impact.frontArrival -
                            late * impact.roundTrip / 2;
        const double periods = std::ceil((begin - time) / impact.roundTrip);
        return RodForce{size, 1 - late, time + periods * impact.roundTrip};
    };
    forces.compressionAfter = meeting(most, least);
    forces.tensionAfter = meeting(least, most);
}

/// The peak of the hammer force, which at the rear end is the force in the rod.
void addHammer(const PulseForce& pulse, RodForce& compression) {
    if (!(pulse.peak > compression.size)) return;
    double time = 0;
    for (const PulseSegment& segment : pulse.segments) {
        // Its ends, and the middle of a half sine.
        for (const double part : {0.0, 0.5, 1.0}) {
            const double t = segment.start + part * segment.length;
            if (pulse(t) > pulse(time)) time = t;
        }
    }
    compression = {pulse.peak, 0, time};
}

}  // namespace

RodForces largestRodForces(const Impact& impact, const PulseForce& pulse) {
    Meeting pushed, pulled;
    SlidingMaximum compression(1, impact.roundTrip, pushed), tension(-1, impact.roundTrip, pulled);
    // Before the first front the rod is free of force: nothing, or a uniform motion.
    const double before = incidentWave(impact, -impact.roundTrip / 2);
    const Instant quiet{0, Side::end, before, -before};
    compression.pass(quiet);
    tension.pass(quiet);
    const double transit = impact.roundTrip / 2;
    const double blowEnd = impact.separationTime + transit;
    const double end = blowEnd - impact.frontArrival - unrecordedBefore(impact, impact.incident.end());
    forEachInstant(impact, 0, [&](const Instant& now) {
        if (now.time > end) return;
        compression.pass(now);
        tension.pass(now);
    });
    const std::vector<Instant> last = lastInstants(impact, end);
    addLastMeetings(last, end, impact.roundTrip, 1, pushed);
    addLastMeetings(last, end, impact.roundTrip, -1, pulled);
    RodForces forces{pushed.found(impact), pulled.found(impact), {}, {}};
    // A hammer that still pushes then adds to the waves.
    addWavesThatRemain(impact, std::max(blowEnd, impact.frontArrival + pulse.end + transit), forces);
    addHammer(pulse, forces.compression);
    return forces;
}

}  // namespace drillwave

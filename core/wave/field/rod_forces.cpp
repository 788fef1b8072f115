// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_forces.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "core/wave/field/rod_instants.h"
#include "core/wave/field/rod_meeting.h"

namespace drillwave {

namespace {

/// What is reflected at the rear end by now is in g already. A jump that comes back there must not be added
/// to what it was before: within rounding of one round trip only the later side of the earlier time and the
/// earlier side of the later one are in the rod together.
bool areInRod(const Instant& incoming, const Instant& reflected, double roundTrip) {
    const double oldest = incoming.time - roundTrip;
    if (std::abs(reflected.time - oldest) > roundingOfTrip(incoming.time, roundTrip))
        return reflected.time > oldest;
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
        return meetingInRod(impact, size, incident, incident - reflected);
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
    const std::vector<Instant> period = lastPeriod(impact);
    if (period.empty()) return;
    // The first of the least and of the largest.
    const Instant least = *std::ranges::min_element(period, {}, &Instant::incident);
    const Instant most = *std::ranges::max_element(period, {}, &Instant::incident);
    const double size = most.incident - least.incident;
    if (!(size > 0)) return;
    const auto meeting = [&](const Instant& incoming, const Instant& reflected) {
        const double delay = std::fmod(incoming.time - reflected.time + impact.roundTrip, impact.roundTrip);
        return laterMeetingInRod(impact, size, incoming.time, delay, begin);
    };
    forces.compressionAfter = meeting(most, least);
    forces.tensionAfter = meeting(least, most);
}

}  // namespace

RodForces largestRodForces(const Impact& impact, const PulseForce& pulse) {
    Meeting pushed, pulled;
    SlidingMaximum compression(1, impact.roundTrip, pushed), tension(-1, impact.roundTrip, pulled);
    const Instant quiet = instantBeforeFront(impact, 0);
    compression.pass(quiet);
    tension.pass(quiet);
    const double end = recordedEndOfBlow(impact);
    std::vector<Instant> last;  // of one round trip before the end, and of half of one after it
    forEachInstant(impact, 0, counterparts(impact, end), [&](const Instant& now) {
        if (now.time <= end) {
            compression.pass(now);
            tension.pass(now);
        }
        if (now.time >= end - impact.roundTrip && now.time <= end + impact.roundTrip / 2) last.push_back(now);
    });
    addLastMeetings(last, end, impact.roundTrip, 1, pushed);
    addLastMeetings(last, end, impact.roundTrip, -1, pulled);
    RodForces forces{pushed.found(impact), pulled.found(impact), {}, {}};
    addWavesThatRemain(impact, startOfWavesLeft(impact, pulse), forces);
    if (pulse.peak > forces.compression.size) forces.compression = hammerPeak(pulse);
    return forces;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_envelope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/wave/field/meeting_lines.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/field/rod_instants.h"

namespace drillwave {
namespace {

/// A wave in straight lines from instant to instant, moved in time.
std::vector<WaveStretch> stretchesOf(const std::vector<Instant>& instants, double Instant::*wave, double sign,
                                     double shift = 0) {
    std::vector<WaveStretch> stretches;
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
        const Instant& from = instants[i];
        const Instant& to = instants[i + 1];
        if (from.side == Side::end || to.side == Side::start) continue;  // a jump, or where it could be
        // One piece ends where the next begins: what rounding lets overlap would be in the rod together.
        const double end = i + 2 < instants.size() ? std::min(to.time, instants[i + 2].time) : to.time;
        stretches.push_back({from.time + shift, end + shift, sign * from.*wave, sign * to.*wave});
    }
    return stretches;
}

/// While the blow lasts: from one round trip before the first front, when the rod is at rest, to the end.
std::vector<Instant> instantsOfBlow(const Impact& impact, double end) {
    std::vector<Instant> instants{instantBeforeFront(impact, -impact.roundTrip),
                                  instantBeforeFront(impact, 0)};
    instants.front().side = Side::start;
    forEachInstant(impact, 0, counterparts(impact, end), [&](const Instant& now) {
        if (now.time <= end + impact.roundTrip / 2) instants.push_back(now);
    });
    return instants;
}

bool isBefore(const RodForce& a, const RodForce& b) {
    return a.section < b.section;
}

/// Lines over the delay as points over the section, from the struck end on: `meeting` says where and when
/// both ends of a line are.
template <class Meeting>
EnvelopeLine pointsOf(const std::vector<MeetingLine>& lines, const Meeting& meeting) {
    EnvelopeLine points;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        for (const RodForce& point : meeting(*line))
            if (points.empty() || points.back() != point) points.push_back(point);
    }
    return points;
}

/// The largest force is known to its last digit: chords may miss it by rounding, or where it lasts for one
/// instant only.
void takeOver(const RodForce& largest, EnvelopeLine& line) {
    for (RodForce& point : line) point.size = std::min(point.size, largest.size);
    if (std::ranges::find(line, largest.size, &RodForce::size) != line.end()) return;
    line.insert(std::ranges::upper_bound(line, largest, isBefore), largest);
}

class Builder {
  public:
    Builder(const Impact& impact, const PulseForce& pulse, const std::stop_token& stop, long mostSteps)
        : m_impact(impact), m_stop(stop), m_mostSteps(mostSteps) {
        m_envelope.largest = largestRodForces(impact, pulse);
        addBlow(pulse);
        addWavesLeft(startOfWavesLeft(impact, pulse));
        for (const Load load : loads) takeOver(m_envelope.largest[load], m_envelope[load]);
    }

    RodEnvelope take() { return std::move(m_envelope); }

  private:
    std::vector<MeetingLine> largest(const std::vector<WaveStretch>& incoming,
                                     const std::vector<WaveStretch>& reflected, double end) {
        LargestMeetings found =
            largestMeetings(incoming, reflected, {m_impact.roundTrip, end}, m_mostSteps, m_stop);
        m_envelope.missed = std::max(m_envelope.missed, found.missed);
        m_envelope.steps += found.steps;
        return std::move(found.lines);
    }

    void addBlow(const PulseForce& pulse) {
        const double end = recordedEndOfBlow(m_impact);
        const std::vector<Instant> instants = instantsOfBlow(m_impact, end);
        const auto lineOf = [&](double sign) {
            return pointsOf(largest(stretchesOf(instants, &Instant::incident, sign),
                                    stretchesOf(instants, &Instant::reflected, sign), end),
                            [&](const MeetingLine& line) {
                                return std::array{
                                    meetingInRod(m_impact, line.last, line.incidentLast, line.end),
                                    meetingInRod(m_impact, line.first, line.incidentFirst, line.begin)};
                            });
        };
        m_envelope.compression = lineOf(1);
        m_envelope.tension = lineOf(-1);
        // At the rear end itself the force is that of the hammer.
        RodForce& rear = m_envelope.compression.front();
        if (pulse.peak > rear.size) rear = hammerPeak(pulse);
    }

    void addWavesLeft(double begin) {
        const std::vector<Instant> period = lastPeriod(m_impact);
        const auto lineOf = [&](double sign) {
            // The outgoing wave is the one that had arrived, reversed; maybe from the period before.
            std::vector<WaveStretch> left =
                stretchesOf(period, &Instant::incident, -sign, -m_impact.roundTrip);
            const std::vector<WaveStretch> now = stretchesOf(period, &Instant::incident, -sign);
            left.insert(left.end(), now.begin(), now.end());
            return pointsOf(largest(stretchesOf(period, &Instant::incident, sign), left,
                                    std::numeric_limits<double>::infinity()),
                            [&](const MeetingLine& line) {
                                std::array ends{
                                    meetingInRod(m_impact, line.last, line.incidentLast, line.end),
                                    meetingInRod(m_impact, line.first, line.incidentFirst, line.begin)};
                                // Both in the same period.
                                const double first = std::min(ends[0].time, ends[1].time);
                                const double periods = std::ceil((begin - first) / m_impact.roundTrip);
                                for (RodForce& end : ends) end.time += periods * m_impact.roundTrip;
                                return ends;
                            });
        };
        m_envelope.compressionAfter = lineOf(1);
        m_envelope.tensionAfter = lineOf(-1);
    }

    const Impact& m_impact;
    const std::stop_token& m_stop;
    long m_mostSteps;
    RodEnvelope m_envelope;
};

}  // namespace

RodEnvelope rodEnvelope(const Impact& impact, const PulseForce& pulse, const std::stop_token& stop,
                        long mostSteps) {
    return Builder(impact, pulse, stop, mostSteps).take();
}

RodForce forceAt(const EnvelopeLine& line, double section) {
    if (line.empty()) return {};
    const auto behind = std::ranges::lower_bound(line, section, {}, &RodForce::section);
    if (behind == line.end()) return line.back();
    if (behind == line.begin() || behind->section == section) {
        // Returns the largest of the points at one section.
        const auto end = std::ranges::upper_bound(line, behind->section, {}, &RodForce::section);
        return *std::max_element(behind, end, [](const auto& a, const auto& b) { return a.size < b.size; });
    }
    const RodForce& before = *(behind - 1);
    const double share = (section - before.section) / (behind->section - before.section);
    return {std::lerp(before.size, behind->size, share), section,
            std::lerp(before.time, behind->time, share)};
}

}  // namespace drillwave

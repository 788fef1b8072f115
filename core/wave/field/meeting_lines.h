// SPDX-License-Identifier: GPL-3.0-or-later
// The largest sum of two waves over the delay at which they meet.
#pragma once

#include <limits>
#include <map>
#include <span>
#include <stop_token>
#include <vector>

namespace drillwave {

// For the files of this folder only. Times are recorded times at the front end in t0, sizes in F0.

/// A straight stretch of a wave.
struct WaveStretch {
    double begin = 0, end = 0;
    double first = 0, last = 0;  ///< values at both ends

    double at(double time) const;
    double slope() const { return (last - first) / (end - begin); }
};

/// A straight stretch of the largest sum over the delay between the times of the two waves.
struct MeetingLine {
    double begin = 0, end = 0;                   ///< delays
    double first = 0, last = 0;                  ///< sums at both ends
    double incidentFirst = 0, incidentLast = 0;  ///< times of the incoming wave at both ends

    double at(double delay) const;
    /// The part of it over [from, to].
    MeetingLine part(double from, double to) const;
};

/// The upper edge of many lines over 0 ≤ delay ≤ span; 0 at first.
class UpperEdge {
  public:
    /// Lines no more than `rounding` above the edge do not raise it.
    UpperEdge(double span, double rounding);

    void raise(const MeetingLine& line);
    /// The least of the edge over a stretch of delays, or anything below `enough` where it is less than that.
    double leastOver(double begin, double end,
                     double enough = -std::numeric_limits<double>::infinity()) const;
    /// Returns the lines by delay; each begins where the one before ends.
    std::vector<MeetingLine> lines() const;

  private:
    using Lines = std::map<double, MeetingLine>;
    Lines::const_iterator lineAt(double delay) const;
    bool isRaisedBy(const MeetingLine& line) const;

    double m_rounding;
    Lines m_lines;  ///< by their begin
};

/// Which stretches of the two waves are in the rod together.
struct MeetingLimits {
    double roundTrip = 0;  ///< 0 ≤ delay ≤ 2τ
    /// Meetings at the recorded time `end` at the latest: the times of both waves have the mean `end` or
    /// less.
    double end = std::numeric_limits<double>::infinity();
};

struct LargestMeetings {
    std::vector<MeetingLine> lines;
    double missed = 0;  ///< by how much a line may be too low; 0 where all pairs were looked at
    long steps = 0;     ///< pairs that were looked at
};

/// Returns the largest incoming(a) + reflected(a − delay) for every delay. Pairs of stretches are tried in
/// the order of their upper bounds, first in whole groups; those that cannot raise the edge by more than 2e-5
/// of the largest sum are left out, and after `mostSteps`, or a stop, all others.
LargestMeetings largestMeetings(std::span<const WaveStretch> incoming, std::span<const WaveStretch> reflected,
                                const MeetingLimits& limits, long mostSteps, const std::stop_token& stop);

}  // namespace drillwave

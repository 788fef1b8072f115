// SPDX-License-Identifier: GPL-3.0-or-later
// Largest sum of two opposite waves in a rod, as a function of the delay between them.
#pragma once

#include <limits>
#include <map>
#include <span>
#include <stop_token>
#include <vector>

namespace drillwave {

// For the files of this folder only. Times are recorded times at the front end in t0, sizes in F0.

/// Straight line that approximates a wave over an interval of recorded time.
struct WaveStretch {
    /// Start and end of the interval of recorded time, in units of t0.
    double begin = 0, end = 0;
    /// Values of the wave at the times `begin` and `end`, in units of F0.
    double first = 0, last = 0;

    /// Returns the value of the line at a time, in units of F0. For times outside the interval it returns the
    /// value at the nearer end.
    double at(double time) const;
    /// Returns the slope of the line in F0/t0.
    double slope() const { return (last - first) / (end - begin); }
};

/// Straight part of a curve that gives the largest sum of two opposite waves over the delay between them. The
/// delay is the time from the departure of one wave from the bit to the arrival of the other wave there.
struct MeetingLine {
    /// Range of delays between the two waves, in units of t0.
    double begin = 0, end = 0;
    /// Largest sums of the two waves, in units of F0: `first` at the delay `begin`, `last` at the delay
    /// `end`.
    double first = 0, last = 0;
    /// Times, in units of t0, at which the incident wave of the pair with the largest sum reaches the bit.
    /// `incidentFirst` belongs to the delay `begin`, `incidentLast` to the delay `end`.
    double incidentFirst = 0, incidentLast = 0;

    /// Returns the largest sum of the two waves at a delay (in units of t0) by linear interpolation, in units
    /// of F0.
    double at(double delay) const;
    /// Returns the part of this line over the delays [from, to].
    MeetingLine part(double from, double to) const;
};

/// Upper envelope of many straight lines: the largest value of all lines at every delay between two waves, 0
/// ≤ delay ≤ span. It is zero before the first line is added.
class UpperEdge {
  public:
    /// Creates an envelope over the delays 0 … span. Lines that exceed the envelope by no more than
    /// `rounding` (in units of F0) do not raise it.
    UpperEdge(double span, double rounding);

    /// Raises the envelope to this line wherever the line is higher.
    void raise(const MeetingLine& line);
    /// Returns the smallest value of the envelope over the delays [begin, end], plus the `rounding` of the
    /// constructor, in units of F0. A line below it cannot raise the envelope and need not be added. As soon
    /// as a value below `enough` is found, the search ends and returns a value below `enough`.
    double leastOver(double begin, double end,
                     double enough = -std::numeric_limits<double>::infinity()) const;
    /// Returns the lines of the envelope in order of delay; each begins where the previous one ends.
    std::vector<MeetingLine> lines() const;

  private:
    using Lines = std::map<double, MeetingLine>;
    Lines::const_iterator lineAt(double delay) const;
    bool isRaisedBy(const MeetingLine& line) const;

    double m_rounding;
    Lines m_lines;  ///< keys are the delays at which the lines begin
};

/// Limits of delay and time for the pairs of waves that largestMeetings() adds. Only two waves that are in
/// the rod at the same time can meet.
struct MeetingLimits {
    double roundTrip = 0;  ///< round trip 2τ of a wave, the largest delay of a pair
    /// Recorded time up to which meetings of two waves count, in units of t0; later ones are left out. The
    /// recorded time of a meeting is the mean of the times at which both waves are at the bit.
    double end = std::numeric_limits<double>::infinity();
};

/// Largest sums of two opposite waves for all delays between them, the result of largestMeetings().
struct LargestMeetings {
    /// Largest sums of the two waves as a curve over the delay between them. Its straight lines are in order
    /// of delay.
    std::vector<MeetingLine> lines;
    /// Amount, in units of F0, by which `lines` may be too low because pairs of wave stretches were left out
    /// (too many pairs, or a stop request); 0 if none was left out.
    double missed = 0;
    /// Number of pairs of wave stretches examined, a measure of the work.
    long steps = 0;
};

/// Returns the largest sum incoming(a) + reflected(a − delay) over all times a, for every delay from 0 to a
/// round trip. Two waves with a given delay meet at one section of the rod, so the sum is the largest force
/// there. The waves are approximated by straight stretches. Pairs of stretches that cannot raise the result
/// by more than 2e-5 of the largest sum are skipped. After `mostSteps` pairs or a stop request, all remaining
/// pairs are left out.
LargestMeetings largestMeetings(std::span<const WaveStretch> incoming, std::span<const WaveStretch> reflected,
                                const MeetingLimits& limits, long mostSteps, const std::stop_token& stop);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the histories of an impact at many times, each near the one before.
#pragma once

#include <cstddef>

#include "core/wave/impact.h"

namespace drillwave {

// Conversion between the time at the bit and the time in the recorded histories of an impact.

// Requires an impact solved with Detail::histories. Times s are counted at the front end from
// impact.frontArrival, in t0. Recorded times are those of impact.incident and impact.force. They leave out
// the periods of impact.skips, and end where everything repeats with the round trip 2τ.

/// Returns the time in the recording that belongs to the time s since the first arrival at the bit, both in
/// units of t0. Incident wave and impact force at s are found there. The recording leaves out repeating
/// periods of free flight; after its end, its last round trip repeats. For s < 0 it returns s.
double recordedTime(const Impact& impact, double s);

/// Returns for how long after the time s the recording can be read on without a gap, in units of t0. There is
/// a gap where periods were left out, and where the recording ends and its last round trip repeats.
double uninterrupted(const Impact& impact, double s);

/// Returns the total duration of the periods of free flight that were left out of the recording before a
/// recorded time, in units of t0.
double unrecordedBefore(const Impact& impact, double recorded);

/// Returns the incident wave g/F0 before the first wave arrives at the bit. It is 1/(2τ) in the reference
/// case (a rod that arrives as a rigid body), and 0 for all other blows.
double waveBeforeArrival(const Impact& impact);

/// Reader of incident wave and reflected wave at the bit, for many times in succession. Its values agree with
/// incidentWave() and impactForce(). It is faster than these, because each search starts from the polynomial
/// piece found last. Requires an impact solved with Detail::histories, which must outlive the reader.
class HistoryReader {
  public:
    explicit HistoryReader(const Impact& impact);

    /// Returns the incident wave g/F0 at any time s/t0 since the first arrival at the bit.
    double incident(double s);
    /// Returns the reflected wave r = F − g, in units of F0, at any time s/t0 since the first arrival at the
    /// bit.
    double reflected(double s);
    /// Returns the number of pieces of the histories that were examined so far, a measure of the work.
    long steps() const { return m_steps; }

  private:
    bool seek(double s);
    bool holds(std::size_t index, double recorded) const;
    std::size_t find(double recorded);

    const Impact& m_impact;
    const double m_before;  // incident wave g/F0 at s < 0
    std::size_t m_index = 0;
    double m_local = 0;  // time since the start of the current piece, in units of t0
    long m_steps = 0;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the histories of an impact at many times, each near the one before.
#pragma once

#include <cstddef>

#include "core/wave/impact.h"

namespace drillwave {

// Where in the recorded histories of an impact the state of any time is found.

// Requires an impact solved with Detail::histories. Times s are counted at the front end from
// impact.frontArrival, in t0; recorded times are those of impact.incident and impact.force, which leave out
// impact.skips and end where nothing but a repetition with the round trip 2τ follows.

/// Returns the recorded time at which g and F are those of time s; s itself before the recording begins.
double recordedTime(const Impact& impact, double s);

/// Returns the time from s to the next place where a reader has to jump to another part of the recording.
double uninterrupted(const Impact& impact, double s);

/// Duration of the periods left out before a recorded time.
double unrecordedBefore(const Impact& impact, double recorded);

/// g at times s < 0: the uniform wave 1/(2τ) of the reference case before first contact; 0 where a hammer
/// blow arrives later.
double waveBeforeArrival(const Impact& impact);

/// Returns exactly what incidentWave() and impactForce() do, but walks from piece to piece instead of
/// searching for each time. Requires an impact solved with Detail::histories, which must outlive the reader.
class HistoryReader {
  public:
    explicit HistoryReader(const Impact& impact);

    /// g(s), any s [t0 → F0].
    double incident(double s);
    /// r(s) = F(s) − g(s), any s [t0 → F0].
    double reflected(double s);
    /// Pieces looked at on the way so far.
    long steps() const { return m_steps; }

  private:
    bool seek(double s);
    bool holds(std::size_t index, double recorded) const;
    std::size_t find(double recorded);

    const Impact& m_impact;
    const double m_before;  // g at s < 0
    std::size_t m_index = 0;
    double m_local = 0;  // time since the piece began
    long m_steps = 0;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Recorder of forces in sections, reflections at joints, and waves, for a blow on a drill string.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/wave/impact.h"
#include "core/wave/network/cell_lattice.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/network/section_watch.h"
#include "core/wave/network/string_waves.h"

namespace drillwave {

/// Recorder of the largest forces, joint reflections and waves of a blow, as far as they are requested. It
/// reads each block of time steps that CellLattice has computed. One blow after another can be recorded.
class WaveRecorder {
  public:
    /// Starts the recording of a blow. `plan` and `lattice` must exist until finish().
    void begin(const MarchPlan& plan, const CellLattice& lattice);

    /// Records the block of time steps that the lattice has computed last. If the waves become too many to be
    /// kept, they are discarded.
    void add(const std::stop_token& stop);
    /// Discards the recorded waves, because the blow could not be solved.
    void abandon() { m_waves.reset(); }
    /// Writes the recorded forces, reflections and waves into `impact`. Requires that the blow has been
    /// computed up to `time`, in units of t0.
    void finish(double time, Impact& impact);

    /// Returns the additional work for the largest forces, in units of the work of a cell (time step).
    /// `cells` is the work done so far without it, in cells times nodes (ends of sections).
    long workForForces(long cells) const;
    /// Discards the largest forces found so far and stops their search, because it takes too much work.
    void leaveOutForces();
    /// Returns whether the largest forces are being recorded: they were requested, and leaveOutForces() was
    /// not called.
    bool hasForces() const { return m_hasForces; }
    /// Returns the time t/t0 to which the largest forces are searched: one round trip of the string after the
    /// end of the blow. Returns 0 if they are not requested, or if the blow has not ended yet.
    double wantedTime() const;

  private:
    void restartWatches();
    void addForces(const std::stop_token& stop);
    void addReflection(std::size_t section);
    void addWaves();
    SectionForces forcesOf(std::size_t first, std::size_t count) const;

    const MarchPlan* m_plan = nullptr;
    const CellLattice* m_lattice = nullptr;
    bool m_hasForces = false, m_leftOutForces = false;
    /// Number of parts of a cell (time step) when the last block was recorded; it increases when cells are
    /// cut.
    std::size_t m_parts = 0;
    double m_stringTransit = 0, m_endOfBlow = 0;
    std::vector<SectionWatch> m_watches;
    /// Copies of the joints that receive only waves from the hammer side, to measure what each joint
    /// reflects.
    std::vector<Joint> m_alone;
    /// Energy integral ∫b1² dt of the waves b1 that each joint in m_alone reflects, in units of F0² t0.
    std::vector<double> m_reflected;
    std::shared_ptr<StringWaves> m_waves;
};

}  // namespace drillwave

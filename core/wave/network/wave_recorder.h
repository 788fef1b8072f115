// SPDX-License-Identifier: GPL-3.0-or-later
// Records a blow besides its sums: the forces in its sections, reflections at joints, its waves.
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

/// Records the requested results of one blow after another, block by block; for a blow of which only sums are
/// requested it does nothing.
class WaveRecorder {
  public:
    /// Plan and lattice must outlive the blow.
    void begin(const MarchPlan& plan, const CellLattice& lattice);

    /// Adds the block that the lattice has taken last. Stops recording waves when they are too many.
    void add(const std::stop_token& stop);
    /// Drops the waves of a blow that is not solved.
    void abandon() { m_waves.reset(); }
    /// Writes the results into `impact`, when everything up to `time` [t0] has happened.
    void finish(double time, Impact& impact);

    /// Returns the extra work of the largest forces after `cells` cells × nodes, in cells.
    long workForForces(long cells) const;
    /// Drops the forces, which take too much work.
    void leaveOutForces();
    bool hasForces() const { return m_hasForces; }  ///< requested and not dropped
    /// Returns the time to which the waves should be followed, as far as known: a round trip in the string
    /// after the blow, if the forces are requested.
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
    std::size_t m_parts = 0;  ///< of a cell: more after it was cut
    double m_stringTransit = 0, m_endOfBlow = 0;
    std::vector<SectionWatch> m_watches;
    std::vector<Joint> m_alone;       ///< the joints, met by waves down only
    std::vector<double> m_reflected;  ///< ∫b1² of those
    std::shared_ptr<StringWaves> m_waves;
};

}  // namespace drillwave

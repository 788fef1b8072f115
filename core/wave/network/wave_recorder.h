// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded of a blow beside its sums: the forces in its sections, what joints reflect, its waves.
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

/// Records what is wanted of one blow after another, block by block; of a blow of which nothing is wanted
/// but sums it takes nothing.
class WaveRecorder {
  public:
    /// Plan and lattice must outlive the blow.
    void begin(const MarchPlan& plan, const CellLattice& lattice);

    /// The block that the lattice has taken last. Waves are no longer recorded where they are too many.
    void add(const std::stop_token& stop);
    /// The blow is not solved: its waves are of no use.
    void abandon() { m_waves.reset(); }
    /// What there is when all that counts has happened until `time` [t0].
    void finish(double time, Impact& impact);

    /// What the largest forces have taken beside the `cells` times nodes that have gone by, in cells.
    long workForForces(long cells) const;
    /// They take too much.
    void leaveOutForces();
    bool hasForces() const { return m_hasForces; }  ///< that are wanted, and not left out
    /// To when the waves shall be followed, as far as is known: once to and fro in the string after the blow,
    /// where the forces are wanted.
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

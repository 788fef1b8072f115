// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in a section while its waves go by (strings §7).
#pragma once

#include <cstddef>
#include <deque>
#include <span>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/network_impact.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/network/window_maxima.h"

namespace drillwave {

/// A section for its watch; times are those of its ends.
struct WatchedSection {
    double transitTime = 0;
    double decay = 0;
    double startTime = 0;  ///< of the clock's zero at the rear end [t0]
};

/// Two waves meet in a section exactly when they left its ends at times less than a transit apart, on the
/// clocks of the ends: when the one that runs back left no later, and at most a round trip before. So the
/// largest force is a largest sum over a window that moves.
class SectionWatch {
  public:
    explicit SectionWatch(const WatchedSection& section) : m_section(section) {}

    /// Waves of step number `step` on both clocks: `down` enters at the rear, `up` at the front end;
    /// `window` entered there before, over a round trip, the oldest first, which now leaves. What would meet
    /// after `lastTime` does not count.
    void add(const WaveCell& down, const WaveCell& up, std::span<const WaveCell> window, long step,
             const CellCuts& cuts, double lastTime);
    /// After cells were cut: `window` is on its way before `step`.
    void restart(std::span<const WaveCell> window, long step, const CellCuts& cuts);

    SectionForces forces() const { return {m_compression.peak, m_tension.peak}; }
    /// Blocks and pairs of cells that were looked at where waves lose on their way.
    long looked() const { return m_looked; }

  private:
    /// The largest value of a cell that is on its way.
    struct Entry {
        long step;
        double clock;  ///< of the value
        double value;
    };
    struct Side {
        explicit Side(double ofSign) : sign(ofSign) {}
        double sign;
        SectionPeak peak;
        std::deque<Entry> largest;
        WindowMaxima maxima;  ///< where waves lose: of the cells on their way
    };
    /// One cell and what it meets.
    struct Meeting;

    void watch(Side& side, const Meeting& meeting) const;
    void watchDecaying(Side& side, const Meeting& meeting);
    void meet(Side& side, const Meeting& meeting, const WaveCell& f, std::size_t number) const;
    double mostOf(double down, double up, double earliestShare, double latestShare) const;
    void note(SectionPeak& peak, double force, double downClock, double upClock, double lastTime) const;
    void push(Side& side, const WaveCell& cell, long step, const CellCuts& cuts) const;

    WatchedSection m_section;
    Side m_compression{1};
    Side m_tension{-1};
    long m_looked = 0;
};

}  // namespace drillwave

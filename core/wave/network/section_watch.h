// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in a section while its waves go by (strings §7).
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/section_forces.h"

namespace drillwave {

// Largest values of the steps in a moving window, over blocks of them and blocks of blocks.

/// Steps are consecutive whole numbers; upper bounds of their values are pushed, and the oldest are dropped.
/// Blocks inside a larger one are searched only if that can hold the value.
class WindowMaxima {
  public:
    /// Steps in the smallest block, and blocks in one of the next size.
    static constexpr long smallest = 32, growth = 8;

    /// Returns the first step of the smallest block that holds `step`.
    static long blockStart(long step) { return smallest * blockOf(step, smallest); }

    /// Clears it, for windows of that many steps.
    void begin(long window);
    /// `value` counts for all steps of the smallest block that holds `step`: one call for each of them will
    /// do.
    void push(long step, double value);
    /// Forgets blocks that end before `oldest`.
    void dropBefore(long oldest);

    /// Calls `tell(step)` for the steps in [first, behind), the newest first, of which every block `mayHold`
    /// what is looked for: called with the largest value of a block and its steps from one to behind the
    /// last. Gives how many blocks were looked at.
    template <class MayHold, class Tell>
    long search(long first, long behind, MayHold mayHold, Tell tell) const {
        if (m_levels.empty() || first >= behind) return 0;
        const Level& top = m_levels.back();
        long looked = 0;
        for (long block = top.first + static_cast<long>(top.largest.size()) - 1; block >= top.first; --block)
            looked += searchBlock(m_levels.size() - 1, block, first, behind, mayHold, tell);
        return looked;
    }

  private:
    static long blockOf(long step, long size) {
        return step >= 0 ? step / size : -((size - 1 - step) / size);
    }

    /// Blocks of one size; number n has the steps from n · size on.
    struct Level {
        long size = smallest;
        long first = 0;  ///< number of the oldest block
        std::deque<double> largest;
    };

    template <class MayHold, class Tell>
    long searchBlock(std::size_t level, long block, long first, long behind, MayHold& mayHold,
                     Tell& tell) const {
        const Level& own = m_levels[level];
        const long from = std::max(first, block * own.size);
        const long to = std::min(behind, (block + 1) * own.size);
        if (from >= to || block < own.first) return 0;
        long looked = 1;
        if (!mayHold(own.largest[static_cast<std::size_t>(block - own.first)], from, to)) return looked;
        if (level == 0) {
            for (long step = to - 1; step >= from; --step) tell(step);
        } else {
            for (long part = (block + 1) * growth - 1; part >= block * growth; --part)
                looked += searchBlock(level - 1, part, first, behind, mayHold, tell);
        }
        return looked;
    }

    std::vector<Level> m_levels;  ///< the smallest blocks first
};

/// Section for its watch; times are those of its ends.
struct WatchedSection {
    double transitTime = 0;
    double decay = 0;
    double startTime = 0;  ///< of the clock's zero at the rear end [t0]
};

/// Watch for the largest force. Two waves meet in a section exactly when they left its
/// ends at times less than a transit apart, on the clocks of the ends: when the one that
/// runs back left no later, and at most a round trip before. So the largest force is a
/// largest sum over a moving window. Hardly any cell has it: coefficients limit the sum of
/// a block of cells, and only blocks that may exceed the largest force so far are
/// searched.
class SectionWatch {
  public:
    explicit SectionWatch(const WatchedSection& section) : m_section(section) {}

    /// Adds waves of the steps from `step` on, on both clocks: `downs` enter at the rear end. `ups` are those
    /// that have entered at the front end during the round trip before, the oldest first, followed by those
    /// that enter there now, as many as `downs`. Meetings after `lastTime` do not count.
    void add(std::span<const WaveCell> downs, std::span<const WaveCell> ups, long step, const CellCuts& cuts,
             double lastTime);
    /// Restarts at the beginning, or after cells were cut: `window` is on its way before `step`.
    void restart(std::span<const WaveCell> window, long step);
    /// Sets the end of the blow, as far as known, and of the residual waves; forces after the blow are kept
    /// apart. A later end of the blow includes all meetings so far in the blow.
    void setEndOfBlow(double time, double lastAfter);

    SectionForces forces() const {
        return {m_compression.during, m_tension.during, m_compression.after, m_tension.after};
    }
    /// Blocks and pairs of cells that were looked at closely where it matters where they meet.
    long looked() const { return m_looked; }
    /// Cells down that were looked at closely, for either sign.
    long cellsLookedInto() const { return m_cells; }

  private:
    /// Compression or tension.
    struct Side {
        explicit Side(double ofSign) : sign(ofSign) {}
        double sign;
        SectionPeak during, after;
        SectionPeak later;    ///< later than counted, unless bit and rock touch again
        WindowMaxima maxima;  ///< upper bounds of the cells on their way
    };
    /// A cell and those that it meets.
    struct Meeting;

    /// Largest force of the meetings in a span of time.
    struct Span {
        SectionPeak& peak;
        double after, until;
        bool hasEdge = false;  ///< some of the meetings are before or after it
    };

    enum class Part { during, after, later };
    Span spanOf(Side& side, Part part, double lastTime, double first, double last) const;
    void watch(const Span& span, const Side& side, const Meeting& meeting);
    void watchAnywhere(const Span& span, const Side& side, const Meeting& meeting, const WaveCell& f,
                       const WaveCell::Peak& top);
    void watchClosely(const Span& span, const Side& side, const Meeting& meeting, const WaveCell& f,
                      const WaveCell::Peak& top);
    void meet(const Span& span, double sign, const Meeting& meeting, const WaveCell& f,
              const WaveCell::Peak& top, std::size_t number) const;
    double mostOf(double down, double up, double earliestShare, double latestShare) const;
    void note(const Span& span, double force, double downClock, double upClock) const;
    static double mostOnTheWay(const Side& side, double down, double known, long first, long behind);
    void push(std::span<const WaveCell> cells, long step);

    WatchedSection m_section;
    Side m_compression{1};
    Side m_tension{-1};
    double m_endOfBlow = std::numeric_limits<double>::infinity();
    double m_lastAfter = std::numeric_limits<double>::infinity();
    long m_looked = 0;
    long m_cells = 0;
};

}  // namespace drillwave

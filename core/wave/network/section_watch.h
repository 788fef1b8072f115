// SPDX-License-Identifier: GPL-3.0-or-later
// Search for the largest forces in a section of hammer or string while its waves are computed (strings §7).
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

// Largest values of steps in a moving window

/// Upper bounds of a wave in consecutive time steps, stored as maxima over small blocks and over larger
/// blocks of steps. New steps are added and old ones dropped. A search skips each block whose maximum is too
/// small.
class WindowMaxima {
  public:
    /// Number of time steps in a smallest block, and number of blocks that form a block of the next size.
    static constexpr long smallest = 32, growth = 8;

    /// Returns the number of the first time step of the smallest block that contains `step`.
    static long blockStart(long step) { return smallest * blockOf(step, smallest); }

    /// Clears all bounds, and prepares for searches over up to `window` time steps.
    void begin(long window);
    /// Adds the upper bound `value` for all time steps of the smallest block that contains `step`. One call
    /// for each block is enough.
    void push(long step, double value);
    /// Removes the bounds of blocks that end before the time step `oldest`.
    void dropBefore(long oldest);

    /// Calls `tell(step)` for the time steps first ≤ step < behind in blocks that pass the test `mayHold`,
    /// the newest first. mayHold(largest, from, to) receives the maximum of a block and its steps from ≤ step
    /// < to. It returns whether the block may contain the value that is searched for. Returns the number of
    /// blocks tested.
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

    /// Maxima over blocks of time steps of one size; block number n begins with the time step n · size.
    struct Level {
        long size = smallest;
        long first = 0;  ///< number of the oldest stored block
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

    std::vector<Level> m_levels;  ///< levels of blocks, the smallest blocks first
};

/// Properties of a section that the search for its largest forces needs.
struct WatchedSection {
    /// One-way transit time τ of a wave through the section, in units of t0.
    double transitTime = 0;
    /// Attenuation αL of a wave over one transit of the section; ≥ 0.
    double decay = 0;
    /// Time t/t0 at which the clock of the section's rear end reads zero. Each end of a section has its own
    /// clock.
    double startTime = 0;
};

/// Search for the largest compression and tension in one section while a blow is computed. The force is the
/// sum of two opposite waves. They meet in the section if they enter its two ends less than one transit time
/// apart. So each time step of one wave must be combined with those of the other within one round trip. Upper
/// bounds exclude almost all pairs; only those that may exceed the largest force so far are examined.
class SectionWatch {
  public:
    /// Creates a search for the largest compression and tension in one section of hammer or string.
    explicit SectionWatch(const WatchedSection& section) : m_section(section) {}

    /// Adds the waves of consecutive time steps, of which the first has the number `step`, and searches the
    /// largest forces among them. `downs` enter the section at its rear end. `ups` enter at its front end:
    /// those of the previous round trip, oldest first, then one for each of `downs`. Forces after `lastTime`
    /// [t0] are ignored.
    void add(std::span<const WaveCell> downs, std::span<const WaveCell> ups, long step, const CellCuts& cuts,
             double lastTime);
    /// Sets the waves that are in the section at the start of a blow, or after cells (time steps) were
    /// divided. `window` holds those that entered at the front end during the round trip before `step`.
    void restart(std::span<const WaveCell> window, long step);
    /// Sets the end of the blow as known so far, and the time up to which residual waves (waves left after
    /// the blow) are searched, in units of t0. Forces after the blow are recorded separately from those
    /// during the blow. If the end of the blow moves to a later time, forces recorded before it count as
    /// during the blow.
    void setEndOfBlow(double time, double lastAfter);

    /// Returns the largest compression and tension in the section, during and after the blow.
    SectionForces forces() const {
        return {m_compression.during, m_tension.during, m_compression.after, m_tension.after};
    }
    /// Returns the work of close examination so far, in blocks of time steps; a pair of time steps counts as
    /// six blocks. It is needed in sections with attenuation, and at the borders of the searched time.
    long looked() const { return m_looked; }
    /// Returns the number of cells (time steps) of the wave towards the rock that were examined closely, for
    /// compression and tension together.
    long cellsLookedInto() const { return m_cells; }

  private:
    /// Search for forces of one sign: compression (sign 1) or tension (sign −1).
    struct Side {
        explicit Side(double ofSign) : sign(ofSign) {}
        double sign;
        SectionPeak during, after;
        /// Largest force after the time `lastAfter` of setEndOfBlow(). It counts only if bit and rock touch
        /// again, which moves the end of the blow to a later time.
        SectionPeak later;
        /// Upper bounds of sign × wave away from the rock, for the time steps (cells) that are now inside the
        /// section.
        WindowMaxima maxima;
    };
    /// One cell (time step) of the wave towards the rock, with the cells of the opposite wave that it meets
    /// within the section.
    struct Meeting;

    /// Interval of time, for example during the blow, with the largest force found in it so far.
    struct Span {
        SectionPeak& peak;
        double after, until;
        /// Whether some of the waves considered meet before or after the interval, so that the time of each
        /// meeting must be checked.
        bool hasEdge = false;
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

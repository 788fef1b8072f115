// SPDX-License-Identifier: GPL-3.0-or-later
// The largest values of the steps in a window that moves, over blocks of them and blocks of blocks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace drillwave {

/// Steps are whole numbers that follow each other; what their values are at most is pushed, and the oldest
/// are dropped. What no larger block can hold is not looked for in the smaller ones.
class WindowMaxima {
  public:
    /// So many steps make the smallest block, and so many blocks one of the next size.
    static constexpr long smallest = 32, growth = 8;

    /// The first step of the smallest block that holds `step`.
    static long blockStart(long step) { return smallest * blockOf(step, smallest); }

    /// Empty, for windows of so many steps.
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

}  // namespace drillwave

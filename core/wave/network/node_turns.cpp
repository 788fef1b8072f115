// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/node_turns.h"

#include <algorithm>

namespace drillwave {

namespace {

/// The turns of nodes number `first` … `last` over some steps.
void addTurns(std::vector<NodeTurn>& turns, std::span<const std::size_t> delays, std::size_t first,
              std::size_t last, std::size_t from, std::size_t count) {
    for (std::size_t begin = first, end = first; begin <= last; begin = end = end + 1) {
        std::size_t shortest = count;  // of sections between nodes that have to wait for each other
        for (; end < last && delays[end] < count; ++end) shortest = std::min(shortest, delays[end]);
        if (begin == end) {
            turns.push_back({begin, from, count});
            continue;
        }
        // a few turns each; where sections are shorter still, those divide them further
        const std::size_t most = std::max(shortest, (count + 3) / 4);
        for (std::size_t done = 0; done < count; done += most)
            addTurns(turns, delays, begin, end, from + done, std::min(most, count - done));
    }
}

}  // namespace

void planTurns(std::span<const std::size_t> delays, std::size_t block, std::vector<NodeTurn>& turns) {
    turns.clear();
    addTurns(turns, delays, 0, delays.size(), 0, block);
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// In which order the nodes of a string take the steps of a block.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace drillwave {

/// Steps of a block that a node takes without waiting for others.
struct NodeTurn {
    std::size_t node;  ///< in front of section `node`; behind the last one the bit
    std::size_t from, count;
    std::size_t behind() const { return from + count; }
    bool operator==(const NodeTurn&) const = default;
};

/// A node waits for the waves that the next one made a round trip before, `delays` steps for each section,
/// all > 0. Where that is less than a block, the nodes at both ends take turns. Written into `turns`.
void planTurns(std::span<const std::size_t> delays, std::size_t block, std::vector<NodeTurn>& turns);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Pairing of the items of a list before and after an edit.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace drillwave {

/// Similarity of two list items, one before an edit and one after it.
struct Likeness {
    int shared = 0;  ///< number of values that both items have
    bool isEqual = false;
};

/// Pairs the items of a list before and after an edit, so that unchanged items keep their comments in the
/// file. Returns the index of the new item for each old item, ascending; nullopt for a removed item. Equal
/// items at the start and at the end of the lists are paired first. The other pairs are chosen to have as
/// many values in common as possible. If there are too many items to compare, they are paired in order.
std::vector<std::optional<std::size_t>> listPairs(
    std::size_t before, std::size_t after,
    const std::function<Likeness(std::size_t before, std::size_t after)>& likeness);

}  // namespace drillwave

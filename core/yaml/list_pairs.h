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

/// Pairs the items of a list before and after an edit, so that items that remain keep their comments.
/// Returns, for each of the `before` old items, the index of its new item, ascending; nullopt for a removed
/// item. Equal items at both ends are paired first. Between them the pairs share as many values as possible;
/// if there are too many items to compare, they are paired in order.
std::vector<std::optional<std::size_t>> listPairs(
    std::size_t before, std::size_t after,
    const std::function<Likeness(std::size_t before, std::size_t after)>& likeness);

}  // namespace drillwave

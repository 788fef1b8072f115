// SPDX-License-Identifier: GPL-3.0-or-later
// Which items of a list that was edited are the items of the list before.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace drillwave {

/// How much of an item before is in an item after.
struct Likeness {
    int shared = 0;  ///< values that both have
    bool isEqual = false;
};

/// Returns for each of `before` items the item after that it became, in rising order; nothing for an item
/// that was removed. Items at both ends that are equal are paired first. Between them, the pairs share the
/// most values; lists with too many changes for that are paired in order.
std::vector<std::optional<std::size_t>> listPairs(
    std::size_t before, std::size_t after,
    const std::function<Likeness(std::size_t before, std::size_t after)>& likeness);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Search for an index in an ordered sequence, starting from one that is likely to be near.
#pragma once

#include <algorithm>
#include <cstddef>

namespace drillwave {

/// Returns the last index below `count` for which `begins(index)` is true, or 0 if there is none. Requires
/// that `begins` is true up to this index and false after it, and near < count. The search tries strides of
/// 1, 2, 4, … from the index `near` and then bisects. It is fast if the result is close to `near`, and
/// otherwise takes logarithmic time.
template <class Begins>
std::size_t strideSearch(std::size_t near, std::size_t count, const Begins& begins) {
    std::size_t first = near, stride = 1;  // the index sought is in [first, end)
    std::size_t end = count;
    if (begins(near)) {
        while (first + stride < count && begins(first + stride)) {
            first += stride;
            stride *= 2;
        }
        end = std::min(end, first + stride);
    } else {
        end = first;
        while (true) {
            first = end > stride ? end - stride : 0;
            if (first == 0 || begins(first)) break;
            end = first;
            stride *= 2;
        }
    }
    while (end - first > 1) {
        const std::size_t middle = first + (end - first) / 2;
        (begins(middle) ? first : end) = middle;
    }
    return first;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a piece among many, starting from one that is likely to be near.
#pragma once

#include <algorithm>
#include <cstddef>

namespace drillwave {

/// The last index below `count` of which `begins(index)` is true, 0 where there is none; true ones come
/// before the others. Strides of 1, 2, 4 … from `near`, then bisection of the last one: next to nothing for a
/// neighbour, and no more than a search however many lie between. Requires near < count.
template <class Begins>
std::size_t strideSearch(std::size_t near, std::size_t count, const Begins& begins) {
    std::size_t first = near, stride = 1;  // what is sought is in [first, end)
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

// SPDX-License-Identifier: GPL-3.0-or-later
// One of N contiguous parts of a long table, for job arrays.
#pragma once

#include <cstdint>

namespace drillwave {

/// The `index`-th (1 … count) of `count` contiguous parts; only the first has the header, so that the parts
/// put together are the whole.
struct Shard {
    std::uint64_t index = 1;
    std::uint64_t count = 1;
    bool hasHeader() const { return index == 1; }
    bool operator==(const Shard&) const = default;
};

/// Rows begin … end − 1.
struct RowRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::uint64_t size() const { return end - begin; }
    bool operator==(const RowRange&) const = default;
};

/// Largest number of parts, so that the arithmetic below cannot overflow.
inline constexpr std::uint64_t maximumShards = 1'000'000;

/// The rows of that part; parts differ by at most one row.
constexpr RowRange rowsOf(const Shard& shard, std::uint64_t rows) {
    const auto start = [&](std::uint64_t part) {
        return rows / shard.count * part + rows % shard.count * part / shard.count;
    };
    return {start(shard.index - 1), start(shard.index)};
}

}  // namespace drillwave

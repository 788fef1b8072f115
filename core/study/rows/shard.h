// SPDX-License-Identifier: GPL-3.0-or-later
// One of N contiguous parts of a long table, for job arrays.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/text/decimal_text.h"

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

/// "2/7"; nullopt where it is no part.
inline std::optional<Shard> parseShard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto index = wholeNumberIn<std::uint64_t>(text.substr(0, slash));
    const auto count = wholeNumberIn<std::uint64_t>(text.substr(slash + 1));
    if (!index || !count || *count < 1 || *count > maximumShards || *index < 1 || *index > *count)
        return std::nullopt;
    return Shard{*index, *count};
}

/// The rows of that part; parts differ by at most one row.
constexpr RowRange rowsOf(const Shard& shard, std::uint64_t rows) {
    const auto start = [&](std::uint64_t part) {
        return rows / shard.count * part + rows % shard.count * part / shard.count;
    };
    return {start(shard.index - 1), start(shard.index)};
}

}  // namespace drillwave

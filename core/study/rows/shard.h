// SPDX-License-Identifier: GPL-3.0-or-later
// One of N contiguous parts of a long table, for job arrays on a cluster.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/text/decimal_text.h"

namespace drillwave {

/// Part number `index` (1 … count) of `count` contiguous parts of a table. Only the first part has the
/// header, so that all parts joined give the whole table.
struct Shard {
    std::uint64_t index = 1;
    std::uint64_t count = 1;
    bool hasHeader() const { return index == 1; }
    bool operator==(const Shard&) const = default;
};

/// Range of row indices from `begin` to `end` − 1.
struct RowRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::uint64_t size() const { return end - begin; }
    bool operator==(const RowRange&) const = default;
};

/// Maximum number of parts of a table (see Shard), so that the arithmetic in rowsOf() cannot overflow.
inline constexpr std::uint64_t maximumShards = 1'000'000;

/// Returns the part of a table that a text such as "2/7" names, here the second of seven; empty if the text
/// is not a valid part.
inline std::optional<Shard> parseShard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto index = wholeNumberIn<std::uint64_t>(text.substr(0, slash));
    const auto count = wholeNumberIn<std::uint64_t>(text.substr(slash + 1));
    if (!index || !count || *count < 1 || *count > maximumShards || *index < 1 || *index > *count)
        return std::nullopt;
    return Shard{*index, *count};
}

/// Returns the rows of one part of a table with `rows` rows. The sizes of parts differ by at most one row.
constexpr RowRange rowsOf(const Shard& shard, std::uint64_t rows) {
    const auto start = [&](std::uint64_t part) {
        return rows / shard.count * part + rows % shard.count * part / shard.count;
    };
    return {start(shard.index - 1), start(shard.index)};
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// One of the parts that rows were written in, as its record tells.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/rows/shard.h"
#include "core/text/message.h"

namespace drillwave {

/// What the record beside a part says.
struct RowPart {
    std::string file;     ///< of the rows
    std::string command;  ///< with its --shard
    std::uint64_t rows = 0;
    Shard shard;         ///< 1/1 for rows in one piece
    std::string record;  ///< as it stands there
};

/// Reads the text of the record beside `file`. Throws ScenarioError (unreadable) where it is none.
RowPart parseRowPart(std::string_view record, const std::string& file);

/// The first key of the record in which two parts differ although they must agree ("axes"): any but rows,
/// part and command; empty where they agree.
std::string differingKey(const RowPart& one, const RowPart& other);

/// What keeps parts that agree with each other from being a whole, each a line that names the part: missing
/// ones, doubled ones, ones with other rows than are theirs. Empty for a whole.
std::vector<Message> wholeProblems(std::span<const RowPart> parts);

/// The record of the rows in one piece, of any of the parts: with that command and so many rows.
std::string wholeRecord(const RowPart& part, std::string_view command, std::uint64_t rows);

}  // namespace drillwave

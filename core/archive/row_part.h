// SPDX-License-Identifier: GPL-3.0-or-later
// One of the parts that rows were written in, as its record tells.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/disk/file_bytes.h"
#include "core/study/rows/shard.h"
#include "core/text/message.h"

namespace drillwave {

/// What the record beside a part says.
struct RowPart {
    std::string file;     ///< of the rows
    std::string command;  ///< with its --shard
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;  ///< of these, without outputs
    FileSum sum;                 ///< of the file of the rows
    Shard shard;                 ///< 1/1 for rows in one piece
    std::string record;          ///< its entries, without the checksum
};

/// Reads the text of the record beside `file`. Throws ScenarioError (unreadable) where it is none, or was
/// changed since it was written.
RowPart parseRowPart(std::string_view record, const std::string& file);

/// The first key of the record in which two parts differ although they must agree ("axes"): any but rows,
/// unsolved, bytes, crc32, part and command; empty where they agree.
std::string differingKey(const RowPart& one, const RowPart& other);

/// What keeps parts that agree with each other from being a whole, each a line that names the part: missing
/// ones, doubled ones, ones with other rows than are theirs. Empty for a whole.
std::vector<Message> wholeProblems(std::span<const RowPart> parts);

/// The rows of all parts together.
struct WholeRows {
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;
    FileSum sum;
};

/// The record of the rows in one piece, of any of the parts: with that command and those rows.
std::string wholeRecord(const RowPart& part, std::string_view command, const WholeRows& whole);

}  // namespace drillwave

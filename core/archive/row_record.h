// SPDX-License-Identifier: GPL-3.0-or-later
// The record beside a CSV file of rows, map.csv.yaml beside map.csv: what the rows are and how to get them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/method.h"
#include "core/disk/file_bytes.h"
#include "core/study/rows/shard.h"
#include "core/text/message.h"

namespace drillwave {

/// The first key of a record, with the number of its format.
inline constexpr std::string_view rowRecordKey = "drillwave_result:";
inline constexpr std::string_view rowRecordFormatKey = rowRecordKey.substr(0, rowRecordKey.size() - 1);
inline constexpr int rowRecordFormat = 1;

/// An axis of a sweep: its column, and its values as they were asked for.
struct RecordedAxis {
    std::string column;       ///< "rod.length [m]"
    std::string values;       ///< "3 m:6 m:4"
    std::uint64_t count = 0;  ///< 0 where every line has its own
};

/// Contents of a record besides the version of the program.
struct RowRecord {
    std::string command;                 ///< command that gives the same rows
    std::optional<MethodChoice> method;  ///< empty for studies with only one
    std::uint64_t rows = 0;
    std::optional<std::uint64_t> unsolved = {};  ///< of these, without outputs; nothing if not counted
    std::optional<FileSum> file = {};            ///< of the file of the rows; nothing before it is written
    Shard shard;
    std::vector<RecordedAxis> axes;  ///< of a sweep
    std::string cases;               ///< file of the rows of a table, as given; empty for a sweep
    std::optional<FileSum> casesFile = {};
    std::vector<std::string> outputs;  ///< their columns
    std::string scenario;              ///< complete in itself, as YAML
};

/// The file: recordEntries() and its checksum, sealed().
std::string recordText(const RowRecord& record);

/// The lines of the file. The scenario is in it as text, and parseInput() finds it there.
std::string recordEntries(const RowRecord& record);

/// "bytes: 123" and "crc32: 0a1b2c3d", each on its line, behind such a beginning of their keys.
std::string sumLines(std::string_view prefix, const FileSum& sum);

/// The key of the last line of a record, the checksum of all lines before it.
inline constexpr std::string_view recordChecksumKey = "record_crc32";

/// Entries with that line behind them.
std::string sealed(std::string entries);

/// Entries without that line; nothing where it is missing or another text was sealed.
std::optional<std::string_view> unsealed(std::string_view record);

// A part of the rows that were written in several, as in its record.

/// Contents of the record beside a part.
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

/// Returns why parts that agree with each other are not a whole, each a line that names the part: missing
/// parts, doubled parts, parts with other rows than their own. Empty for a whole.
std::vector<Message> wholeProblems(std::span<const RowPart> parts);

/// Rows of all parts together.
struct WholeRows {
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;
    FileSum sum;
};

/// The record of the rows in one piece, of any of the parts: with that command and those rows.
std::string wholeRecord(const RowPart& part, std::string_view command, const WholeRows& whole);

}  // namespace drillwave

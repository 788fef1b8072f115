// SPDX-License-Identifier: GPL-3.0-or-later
// Record next to a CSV file of rows, map.csv.yaml for map.csv: what the rows are and how to get them again.
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

/// First key of a record (the YAML file that describes a CSV file of rows), and the number of its format.
inline constexpr std::string_view rowRecordKey = "drillwave_result:";
inline constexpr std::string_view rowRecordFormatKey = rowRecordKey.substr(0, rowRecordKey.size() - 1);
inline constexpr int rowRecordFormat = 1;

/// Axis of a sweep: its column, and its values as typed by the user.
struct RecordedAxis {
    std::string column;       ///< heading of the column, "rod.length [m]"
    std::string values;       ///< values as given by the user, "3 m:6 m:4"
    std::uint64_t count = 0;  ///< number of values; 0 if the axis has one value for each row
};

/// Contents of the record (YAML file) that describes a CSV file of rows, except the version of the program.
struct RowRecord {
    std::string command;                 ///< command line that computes the same rows
    std::optional<MethodChoice> method;  ///< method of solution; empty for studies with only one method
    std::uint64_t rows = 0;
    /// Number of rows for which no result was found; nullopt if not counted.
    std::optional<std::uint64_t> unsolved = {};
    /// Size and checksum of the file of rows; nullopt until it is written.
    std::optional<FileSum> file = {};
    Shard shard;
    std::vector<RecordedAxis> axes;  ///< axes of a sweep; empty for a table
    std::string cases;               ///< path of the table of cases, as given by the user; empty for a sweep
    std::optional<FileSum> casesFile = {};
    std::vector<std::string> outputs;  ///< headings of the columns of results
    std::string scenario;              ///< complete scenario as YAML
};

/// Returns the complete record, the YAML file that describes a CSV file of rows: recordEntries(), then a line
/// with their checksum.
std::string recordText(const RowRecord& record);

/// Returns the lines of the record, the YAML file that describes a CSV file of rows, without the checksum
/// line. They contain the scenario as text, from which parseInput() can read it.
std::string recordEntries(const RowRecord& record);

/// Returns the lines "bytes: 123" and "crc32: 0a1b2c3d" for a size and checksum, with `prefix` before both
/// keys.
std::string sumLines(std::string_view prefix, const FileSum& sum);

/// Key of the last line of a record, which is the checksum of all lines before it.
inline constexpr std::string_view recordChecksumKey = "record_crc32";

/// Returns `entries`, the lines of a record, followed by a last line with their checksum. unsealed() checks
/// it.
std::string sealed(std::string entries);

/// Returns the lines of a record without the last line, the checksum. Returns nullopt if this line is missing
/// or does not match the other lines.
std::optional<std::string_view> unsealed(std::string_view record);

// Part of the rows of a run that was divided, as its record describes it.

/// Contents of the record of one part of a sweep or table. The option --shard divides a sweep or table into
/// parts.
struct RowPart {
    std::string file;     ///< path of the file of rows
    std::string command;  ///< command line that computes this part of the rows, including its option --shard
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;  ///< number of rows without a result
    FileSum sum;                 ///< size and checksum of the file of rows
    Shard shard;                 ///< number of the part and of all parts; 1/1 for undivided rows
    std::string record;          ///< entries of the record, without the checksum
};

/// Returns the contents of a record, the YAML text that describes the CSV file `file` with rows. Throws
/// ScenarioError (unreadable) if the text is not a record, or was changed after it was written.
RowPart parseRowPart(std::string_view record, const std::string& file);

/// Returns the first key in which the records of two parts of a divided sweep or table differ, for example
/// "axes". Such parts do not belong together. Empty if they agree. The keys rows, unsolved, bytes, crc32,
/// part and command may differ.
std::string differingKey(const RowPart& one, const RowPart& other);

/// Returns why the parts of a divided sweep or table cannot be joined: missing or repeated parts, or parts
/// with a wrong number of rows. Each message names the part. Empty if they can be joined. Requires parts
/// whose records agree.
std::vector<Message> wholeProblems(std::span<const RowPart> parts);

/// Number of rows in the CSV file that joins all parts of a divided sweep or table, and size and checksum of
/// this file.
struct WholeRows {
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;
    FileSum sum;
};

/// Returns the record (YAML file) of the CSV file in which all parts of a divided sweep or table are joined.
/// It repeats the record of any `part`, but with the command, row numbers and checksum of the joined file.
std::string wholeRecord(const RowPart& part, std::string_view command, const WholeRows& whole);

}  // namespace drillwave

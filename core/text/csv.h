// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing of CSV (RFC 4180) with comma, decimal point and a header row, in any locale. Numbers
// are the shortest text that reads back as the same double.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

/// Returns the text as one cell of CSV: in double quotes if it has a comma, a quote or a line end, else
/// unchanged.
std::string csvCell(std::string_view text);

/// Separator and decimal sign of a table: comma and point, or semicolon and comma as in spreadsheets of many
/// countries.
enum class CsvSigns { pointAndComma, commaAndSemicolon };

/// Converter of CSV text to another separator and decimal sign, block by block. Only separators and numbers
/// change. If the new separator is a semicolon, cells that contain one are put in quotes. Lines that begin
/// with '#' before the header are copied.
class CsvInSigns {
  public:
    explicit CsvInSigns(CsvSigns signs) : m_signs(signs) {}

    /// Converts complete lines of CSV with commas and decimal points to the separator and decimal sign of
    /// this object.
    std::string text(std::string_view lines);

  private:
    CsvSigns m_signs;
    bool m_isBehindHeader = false;
};

/// Row of a table, split into cells without their quotes and without the line end. If it is malformed,
/// `problem` says why; else `problem` is empty.
struct CsvRecord {
    std::vector<std::string> cells;
    Message problem;
};

/// Reader of CSV records, one at a time in bounded memory. Cells in quotes may contain line ends; lines may
/// end in CRLF; a UTF-8 byte order mark is skipped.
class CsvReader {
  public:
    explicit CsvReader(std::istream& in, std::size_t maximumRecordBytes = 1 << 20, char separator = ',');
    /// Reads the next record into `record` and returns true, or returns false at the end of the file. Skips
    /// empty lines, and lines that begin with '#' before the header.
    bool next(CsvRecord& record);
    /// Kind of the record that skipNext() passed: `none` at the end of the file, `emptyCells` for several
    /// cells with only blanks in them, else `record`.
    enum class Skipped { none, record, emptyCells };
    /// Skips the next record without reading its cells, and returns whether there was one and whether its
    /// cells are empty.
    Skipped skipNext();
    /// Skips at most `most` records without reading their cells, and returns the number of records skipped.
    std::uint64_t skip(std::uint64_t most);
    /// Returns the line of the file on which the last record began, counted from 1.
    int line() const { return m_line; }

  private:
    /// Moves to the start of the next line; before the header, lines that begin with '#' are skipped. The
    /// line may be blank. Returns false at the end of the file.
    bool findRecord();

    std::istream& m_in;
    std::size_t m_maximumRecordBytes;
    char m_separator;
    int m_line = 0;
    int m_nextLine = 1;
    bool m_first = true;
};

}  // namespace drillwave

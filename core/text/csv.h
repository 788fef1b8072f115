// SPDX-License-Identifier: GPL-3.0-or-later
// CSV, RFC 4180: "," and ".", header row, shortest round-trip numbers, whatever the locale.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

/// A cell quoted where RFC 4180 needs it.
std::string csvCell(std::string_view text);

/// Separator and decimal sign: "," and ".", or ";" and "," as spreadsheets of many countries read them.
enum class CsvSigns { pointAndComma, commaAndSemicolon };

/// Rewrites CSV in other signs, piece by piece. Words stay as they are; lines that begin with '#' do so
/// before the header.
class CsvInSigns {
  public:
    explicit CsvInSigns(CsvSigns signs) : m_signs(signs) {}

    /// Returns whole lines, with ',' and '.', in the signs.
    std::string text(std::string_view lines);

  private:
    CsvSigns m_signs;
    bool m_isBehindHeader = false;
};

/// Record without the line end, split into unquoted cells; empty `problem` if well formed.
struct CsvRecord {
    std::vector<std::string> cells;
    Message problem;
};

/// Reads records one at a time in bounded memory (quotes, CRLF, embedded line ends, UTF-8 BOM skipped).
class CsvReader {
  public:
    explicit CsvReader(std::istream& in, std::size_t maximumRecordBytes = 1 << 20, char separator = ',');
    /// Reads the next record that is not empty and, before the header, does not begin with '#'. False at the
    /// end.
    bool next(CsvRecord& record);
    /// Steps over the next record without reading its cells; says whether there was one, and one of several
    /// cells with nothing but blanks in them.
    enum class Skipped { none, record, emptyCells };
    Skipped skipNext();
    /// Skips the next `most` records without reading their cells, and returns how many there were.
    std::uint64_t skip(std::uint64_t most);
    int line() const { return m_line; }  ///< line on which the last record began, 1-based

  private:
    /// Finds the next record, which may be blank; false at the end.
    bool findRecord();

    std::istream& m_in;
    std::size_t m_maximumRecordBytes;
    char m_separator;
    int m_line = 0;
    int m_nextLine = 1;
    bool m_first = true;
};

}  // namespace drillwave

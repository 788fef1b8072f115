// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of cases and samples whose header names parameters. They are read as records of text in bounded
// memory, with any encoding, line ends, separator and decimal sign.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <streambuf>
#include <string>

#include "core/signal/table_row.h"
#include "core/signal/text_lines.h"
#include "core/text/csv.h"

namespace drillwave {

/// Returns separator and decimal sign of a table of cases, detected from its beginning. The separator is that
/// with which most rows have as many cells as the header. The default is comma and point.
RowFormat caseFormat(std::string_view beginning);

/// Stream of the lines of a text, converted to UTF-8 with LF as line end.
class DecodedText : public std::streambuf {
  public:
    explicit DecodedText(std::istream& in) : m_lines(in) {}
    std::string_view beginning() { return m_lines.beginning(); }
    /// Returns why reading stopped before the end of the text, see TextLines::problem(); empty if it did not.
    const std::string& problem() const { return m_lines.problem(); }

  protected:
    int_type underflow() override;

  private:
    TextLines m_lines;
    std::string m_block;
};

/// Reader of the records of a table, one at a time. It converts numbers with a decimal comma, U+2212 as
/// minus, or groups of thousands to C notation: "3,66 m" becomes "3.66 m". Empty rows are allowed only at the
/// end. If other rows follow an empty one, next() returns one record with an error message.
class CaseRecords {
  public:
    explicit CaseRecords(std::istream& in) : m_text(in), m_in(&m_text) {}

    /// Reads the next record into `record` and returns true, or returns false at the end. Skips empty lines,
    /// and lines that begin with '#' before the header.
    bool next(CsvRecord& record);
    /// Skips at most `most` records, and returns the number of records skipped.
    std::uint64_t skip(std::uint64_t most);
    /// Returns the line of the file on which the last record began, counted from 1.
    int line() const { return m_line; }

  private:
    void begin();
    bool read(CsvRecord& record);
    void makePlain(CsvRecord& record) const;
    bool nextRecord(CsvRecord& record);
    bool findBehindEmptyRows();

    DecodedText m_text;
    std::istream m_in;
    std::unique_ptr<CsvReader> m_reader;
    RowFormat m_format;
    /// Whether the decimal sign of the table is the point. If true, only cells with non-ASCII characters are
    /// converted to C notation; otherwise all cells are.
    bool m_isPlain = true;
    std::optional<CsvRecord> m_ahead;  ///< first record after empty rows, read in advance; empty without one
    int m_aheadLine = 0;
    int m_line = 0;
    bool m_isFirst = true;
    bool m_hasEnded = false;
};

}  // namespace drillwave

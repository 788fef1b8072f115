// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of cases and draws, whose header names parameters: records of text cells in bounded memory, whatever
// encoding, line ends, separator and decimal sign the file has.
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

/// Separator and decimal sign of a table of cases, from its beginning: those under which most rows have as
/// many cells as the header. Comma and point where nothing speaks against them.
RowFormat caseFormat(std::string_view beginning);

/// The lines of a text as UTF-8 with LF between them, as a stream.
class DecodedText : public std::streambuf {
  public:
    explicit DecodedText(std::istream& in) : m_lines(in) {}
    std::string_view beginning() { return m_lines.beginning(); }
    /// TextLines::problem().
    const std::string& problem() const { return m_lines.problem(); }

  protected:
    int_type underflow() override;

  private:
    TextLines m_lines;
    std::string m_block;
};

/// Reads records one at a time. Numbers with a decimal comma, with U+2212 or with groups of thousands come as
/// numbers in C notation, so that "3,66 m" is "3.66 m". Rows of empty cells end the table; between cases a
/// run of them is one record with a problem.
class CaseRecords {
  public:
    explicit CaseRecords(std::istream& in) : m_text(in), m_in(&m_text) {}

    /// Reads the next record, as CsvReader::next() does.
    bool next(CsvRecord& record);
    /// Skips the next `most` records, and returns how many there were.
    std::uint64_t skip(std::uint64_t most);
    int line() const { return m_line; }  ///< line on which the last record began, from 1

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
    bool m_isPlain = true;             ///< commas and points: only characters beyond ASCII are put right
    std::optional<CsvRecord> m_ahead;  ///< the record behind empty rows
    int m_aheadLine = 0;
    int m_line = 0;
    bool m_isFirst = true;
    bool m_hasEnded = false;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/csv.h"

#include <algorithm>
#include <charconv>

namespace drillwave {
namespace {

constexpr int endOfInput = std::char_traits<char>::eof();

/// Takes one cell off the stream; `budget` is what is left of the record's limit.
class CellScanner {
  public:
    CellScanner(std::streambuf& in, std::size_t budget, char separator, int& line)
        : m_in(in), m_budget(budget), m_separator(separator), m_line(line) {}

    /// Reads a cell up to, and not including, the comma or line end behind it.
    std::string cell() {
        std::string text;
        if (m_in.sgetc() == '"') {
            m_in.sbumpc();
            quotedPart(text);
        }
        while (!atCellEnd()) {
            if (m_wasQuoted && m_problem.isEmpty()) m_problem = translatable("text follows a closing quote");
            take(text);
        }
        m_wasQuoted = false;
        return text;
    }

    /// Steps over the separator: true for a comma, false at the end of the record.
    bool anotherCell() {
        const int c = m_in.sgetc();
        if (c == endOfInput) return false;
        m_in.sbumpc();
        if (c == m_separator) return true;
        if (c == '\r' && m_in.sgetc() == '\n') m_in.sbumpc();
        ++m_line;
        return false;
    }

    const Message& problem() const { return m_problem; }

  private:
    bool atCellEnd() const {
        const int c = m_in.sgetc();
        return c == endOfInput || c == m_separator || c == '\n' || c == '\r';
    }

    /// Everything up to the closing quote; a doubled quote is one of the text.
    void quotedPart(std::string& text) {
        m_wasQuoted = true;
        while (true) {
            const int c = m_in.sgetc();
            if (c == endOfInput) {
                m_problem = translatable("a quote is not closed");
                return;
            }
            if (c == '"') {
                m_in.sbumpc();
                if (m_in.sgetc() != '"') return;
            }
            if (c == '\n') ++m_line;
            take(text);
        }
    }

    void take(std::string& text) {
        const int c = m_in.sbumpc();
        if (m_budget == 0) {
            if (m_problem.isEmpty()) m_problem = translatable("the record is too long");
            return;
        }
        --m_budget;
        text += std::char_traits<char>::to_char_type(c);
    }

    std::streambuf& m_in;
    std::size_t m_budget;
    int m_separator;
    int& m_line;
    bool m_wasQuoted = false;
    Message m_problem;
};

using Skipped = CsvReader::Skipped;

/// Steps over a record and its line end, counting lines; `none` where it is blank.
Skipped skipRecord(std::streambuf& in, char separator, int& line) {
    bool isBlank = true, isEmpty = true, beginsCell = true, hasSeparator = false, hasQuotes = false;
    for (int c = in.sgetc(); c != endOfInput; c = in.snextc()) {
        if (beginsCell && c == '"') {
            isBlank = false;
            if (hasQuotes) isEmpty = false;  // a doubled quote
            hasQuotes = true;
            for (c = in.snextc(); c != endOfInput && c != '"'; c = in.snextc()) {
                line += c == '\n';
                if (c != ' ' && c != '\t') isEmpty = false;
            }
            if (c == endOfInput) break;
            continue;  // a doubled quote ends one quotation and begins the next
        }
        if (c == '\n' || c == '\r') {
            if (in.snextc() == '\n' && c == '\r') in.sbumpc();
            ++line;
            break;
        }
        isBlank = false;
        beginsCell = c == separator;
        if (!beginsCell && c != ' ' && c != '\t') isEmpty = false;
        hasSeparator |= beginsCell;
        hasQuotes = hasQuotes && !beginsCell;
    }
    if (isBlank) return Skipped::none;
    return isEmpty && hasSeparator ? Skipped::emptyCells : Skipped::record;
}

void skipByteOrderMark(std::streambuf& in) {
    for (const int byte : {0xEF, 0xBB, 0xBF}) {
        if (in.sgetc() != byte) return;
        in.sbumpc();
    }
}

void skipLine(std::streambuf& in) {
    for (int c = in.sbumpc(); c != endOfInput && c != '\n'; c = in.sbumpc()) {
    }
}

}  // namespace

std::string csvCell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

namespace {

/// Takes the first cell off the text, with its quotes.
std::string_view takeCell(std::string_view& text) {
    bool isQuoted = false;  // a doubled quote ends the quotation and begins it again
    std::size_t end = 0;
    for (; end < text.size() && (isQuoted || (text[end] != ',' && text[end] != '\n')); ++end)
        if (text[end] == '"') isQuoted = !isQuoted;
    const std::string_view cell = text.substr(0, end);
    text.remove_prefix(end);
    return cell;
}

bool isNumber(std::string_view cell) {
    double number = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    return error == std::errc() && end == cell.data() + cell.size();
}

}  // namespace

std::string CsvInSigns::text(std::string_view lines) {
    if (m_signs == CsvSigns::pointAndComma) return std::string(lines);
    std::string rewritten;
    while (!lines.empty()) {
        if (!m_isBehindHeader && lines.starts_with('#')) {
            const std::size_t end = std::min(lines.find('\n'), lines.size() - 1) + 1;
            rewritten += lines.substr(0, end);
            lines.remove_prefix(end);
            continue;
        }
        const std::string_view cell = takeCell(lines);
        const std::size_t begin = rewritten.size();
        const bool isToBeQuoted = cell.find(';') != cell.npos && !cell.starts_with('"');
        rewritten += isToBeQuoted ? '"' + std::string(cell) + '"' : std::string(cell);
        if (isNumber(cell))
            std::replace(rewritten.begin() + std::ptrdiff_t(begin), rewritten.end(), '.', ',');
        if (lines.empty()) break;
        m_isBehindHeader |= lines.front() == '\n';
        rewritten += lines.front() == ',' ? ';' : lines.front();
        lines.remove_prefix(1);
    }
    return rewritten;
}

CsvReader::CsvReader(std::istream& in, std::size_t maximumRecordBytes, char separator)
    : m_in(in), m_maximumRecordBytes(maximumRecordBytes), m_separator(separator) {}

bool CsvReader::findRecord() {
    std::streambuf& in = *m_in.rdbuf();
    if (m_nextLine == 1) skipByteOrderMark(in);
    for (; m_first && in.sgetc() == '#'; ++m_nextLine) skipLine(in);
    m_line = m_nextLine;
    return in.sgetc() != endOfInput;
}

CsvReader::Skipped CsvReader::skipNext() {
    while (findRecord()) {
        const Skipped skipped = skipRecord(*m_in.rdbuf(), m_separator, m_nextLine);
        if (skipped == Skipped::none) continue;
        m_first = false;
        return skipped;
    }
    return Skipped::none;
}

std::uint64_t CsvReader::skip(std::uint64_t most) {
    std::uint64_t count = 0;
    while (count < most && skipNext() != Skipped::none) ++count;
    return count;
}

bool CsvReader::next(CsvRecord& record) {
    std::streambuf& in = *m_in.rdbuf();
    while (findRecord()) {
        record = {};
        const bool quoted = in.sgetc() == '"';
        CellScanner scanner(in, m_maximumRecordBytes, m_separator, m_nextLine);
        do {
            record.cells.push_back(scanner.cell());
            // A cell costs more than its bytes: a line of a million commas is refused as well.
            if (record.cells.size() > m_maximumRecordBytes / 16) {
                record.problem = translatable("the record has too many cells");
                record.cells.clear();
                skipLine(in);
                ++m_nextLine;
                m_first = false;
                return true;
            }
        } while (scanner.anotherCell());
        record.problem = scanner.problem();
        const bool blank = record.cells.size() == 1 && record.cells.front().empty() && !quoted;
        if (blank) continue;
        m_first = false;
        return true;
    }
    return false;
}

}  // namespace drillwave

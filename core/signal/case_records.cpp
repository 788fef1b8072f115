// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/case_records.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/text/decimal_text.h"

namespace drillwave {
namespace {

constexpr std::size_t rowsLookedAt = 200;
constexpr std::size_t decodedBytes = std::size_t{1} << 16;

/// A line of only separators and blanks has no case.
bool isEmptyRow(const CsvRecord& record) {
    return record.cells.size() > 1 && record.problem.isEmpty() &&
           std::ranges::all_of(record.cells, [](const std::string& cell) { return trimmed(cell).empty(); });
}

std::vector<std::string_view> headOf(std::string_view text) {
    std::vector<std::string_view> lines;
    bool isHeader = true;
    while (!text.empty() && lines.size() < rowsLookedAt) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (trimmed(line).empty() || (isHeader && line.starts_with('#'))) continue;
        if (isHeader && line.starts_with("sep=") && line.size() == 5) continue;
        isHeader = false;
        lines.push_back(line);
    }
    return lines;
}

/// Whether every row is one number with a decimal comma: "3,66".
bool isOneCommaNumber(const std::vector<std::string_view>& lines) {
    const RowFormat commas{';', DecimalSign::comma};
    return lines.size() > 1 && std::all_of(lines.begin() + 1, lines.end(), [&](std::string_view line) {
               return signEvidence(line).comma && cellNumber(trimmed(line), commas);
           });
}

}  // namespace

RowFormat caseFormat(std::string_view beginning) {
    const std::vector<std::string_view> lines = headOf(beginning);
    RowFormat format;
    if (lines.empty()) return format;
    std::size_t best = 0;
    TableRow row;
    for (const char separator : {',', ';', '\t'}) {
        const std::size_t header = row.split(lines.front(), separator).size();
        if (header < 2) continue;
        std::size_t same = 0;
        for (const std::string_view line : lines) same += row.split(line, separator).size() == header;
        if (same <= best) continue;
        best = same;
        format.separator = separator;
    }
    // A header of one cell.
    if (best == 0) {
        if (isOneCommaNumber(lines)) format = {';', DecimalSign::comma};
        return format;
    }
    SignEvidence all;
    for (std::size_t i = 1; i < lines.size(); ++i)
        for (const std::string_view cell : row.split(lines[i], format.separator)) {
            // The number at the beginning: units may stand behind it.
            const std::size_t end = std::min(cell.find_first_not_of("+-0123456789.,"), cell.size());
            const SignEvidence evidence = signEvidence(cell.substr(0, end));
            all.point |= evidence.point;
            all.comma |= evidence.comma;
            all.ambiguous |= evidence.ambiguous && cell.substr(0, end).find(',') != std::string_view::npos;
        }
    // Between commas a comma is no decimal sign unless it is quoted; elsewhere it is one where no point is.
    const bool hasCommas = all.comma || (all.ambiguous && format.separator != ',');
    if (hasCommas && !all.point) format.decimal = DecimalSign::comma;
    return format;
}

DecodedText::int_type DecodedText::underflow() {
    m_block.clear();
    if (!m_lines.takePlainBlock(m_block)) {
        std::string_view line;
        while (m_block.size() < decodedBytes && m_lines.next(line)) {
            m_block += line;
            m_block += '\n';
        }
    }
    setg(m_block.data(), m_block.data(), m_block.data() + m_block.size());
    return m_block.empty() ? traits_type::eof() : traits_type::to_int_type(m_block.front());
}

void CaseRecords::begin() {
    const std::string_view beginning = m_text.beginning();
    m_format = caseFormat(beginning);
    m_isPlain = m_format.decimal == DecimalSign::point;
    m_reader = std::make_unique<CsvReader>(m_in, std::size_t{1} << 20, m_format.separator);
    if (std::string_view head = beginning; head.starts_with("sep=")) {
        CsvRecord ignored;
        m_reader->next(ignored);
    }
}

bool CaseRecords::read(CsvRecord& record) {
    if (!m_reader) begin();
    if (m_reader->next(record)) return true;
    if (m_hasEnded || m_text.problem().empty()) return false;
    // Once: why the text ends here.
    m_hasEnded = true;
    record = {};
    record.cells.emplace_back();
    record.problem = Message(m_text.problem());
    return true;
}

void CaseRecords::makePlain(CsvRecord& record) const {
    for (std::string& cell : record.cells)
        if (!m_isPlain || hasWideCharacters(cell)) cell = plainCell(cell, m_format);
}

bool CaseRecords::nextRecord(CsvRecord& record) {
    if (m_ahead) {
        record = std::move(*m_ahead);
        m_ahead.reset();
        m_line = m_aheadLine;
        return true;
    }
    if (!read(record)) return false;
    m_line = m_reader->line();
    if (m_isFirst || !isEmptyRow(record)) {
        m_isFirst = false;
        return true;
    }
    if (!findBehindEmptyRows()) return false;
    record.problem = translatable("there is a row without values between the cases; delete it");
    return true;
}

/// Whether a record follows an empty row, which becomes the next one.
bool CaseRecords::findBehindEmptyRows() {
    CsvRecord behind;
    while (read(behind)) {
        if (isEmptyRow(behind)) continue;
        m_aheadLine = m_reader->line();
        m_ahead = std::move(behind);
        return true;
    }
    return false;
}

bool CaseRecords::next(CsvRecord& record) {
    if (!nextRecord(record)) return false;
    makePlain(record);
    return true;
}

std::uint64_t CaseRecords::skip(std::uint64_t most) {
    if (!m_reader) begin();
    std::uint64_t count = 0;
    while (count < most) {
        if (m_ahead) {
            m_ahead.reset();
            ++count;
            continue;
        }
        const CsvReader::Skipped skipped = m_reader->skipNext();
        if (skipped == CsvReader::Skipped::none) {
            // The record with the problem of the text, as next() gives it.
            if (!m_hasEnded && !m_text.problem().empty()) ++count;
            m_hasEnded = true;
            break;
        }
        const bool isFirst = std::exchange(m_isFirst, false);
        if (skipped == CsvReader::Skipped::record || isFirst || findBehindEmptyRows()) ++count;
    }
    return count;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/detected_table.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/signal/signal_unit.h"
#include "core/text/decimal_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

using Pattern = std::vector<bool>;  // which cells are numbers

bool isComment(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

/// The cells of a line that are numbers, and how much speaks for the format.
struct RowLook {
    Pattern numbers;
    int count = 0;
    int words = 0;
};

RowLook look(std::string_view line, const RowFormat& format, TableRow& row) {
    RowLook seen;
    if (isComment(line) || trimmed(line).empty()) return seen;
    for (const std::string_view cell : row.split(line, format.separator)) {
        const bool isNumber = cellNumber(cell, format.decimal).has_value();
        seen.numbers.push_back(isNumber || isMissing(cell));
        seen.count += isNumber;
        seen.words += !isNumber && !isMissing(cell);
    }
    // A separator at the end of each line makes no column.
    if (seen.numbers.size() > 1 && row.split(line, format.separator).back().empty()) seen.numbers.pop_back();
    return seen;
}

std::vector<RowLook> lookAtAll(std::span<const std::string> lines, const RowFormat& format) {
    TableRow row;
    std::vector<RowLook> all;
    all.reserve(lines.size());
    for (const std::string& line : lines) all.push_back(look(line, format, row));
    return all;
}

/// The commonest pattern of the lines with numbers.
std::optional<Pattern> commonPattern(const std::vector<RowLook>& rows) {
    std::map<Pattern, std::size_t> counts;
    for (const RowLook& row : rows)
        if (row.count > 0) ++counts[row.numbers];
    if (counts.empty()) return std::nullopt;
    return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })->first;
}

/// How far a format explains the lines, where each word speaks against it with that weight.
long score(const std::vector<RowLook>& rows, int wordWeight) {
    const std::optional<Pattern> pattern = commonPattern(rows);
    if (!pattern) return 0;
    long sum = 0;
    for (const RowLook& row : rows)
        if (row.numbers == *pattern) sum += std::max(0, 2 * row.count - wordWeight * row.words);
    return sum;
}

/// Cells of the last line of words before the samples.
std::size_t headerCells(std::span<const std::string> lines, std::size_t before, char separator) {
    TableRow row;
    for (std::size_t i = before; i-- > 0;)
        if (!isComment(lines[i]) && !trimmed(lines[i]).empty()) return row.split(lines[i], separator).size();
    return 0;
}

/// Where the samples begin: the first line like most, followed by another one.
std::size_t firstSample(const std::vector<RowLook>& rows, const Pattern& pattern) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].numbers != pattern || rows[i].count == 0) continue;
        if (i + 1 == rows.size() || rows[i + 1].numbers.size() == pattern.size()) return i;
    }
    return rows.size();
}

/// "[s];[kN]", or "s;kN" with at least one unit that is known.
bool isUnitsOnly(const std::vector<TableColumn>& columns) {
    const auto isBracket = [](const TableColumn& column) { return column.name.empty(); };
    const auto isUnit = [](const TableColumn& column) {
        return column.unit.empty() && (findUnit(Quantity::time, column.name) || findSignalUnit(column.name));
    };
    return std::ranges::all_of(columns, isBracket) || std::ranges::any_of(columns, isUnit);
}

/// The headings of a line; empty where it is none for these columns. Comments may carry one too.
std::vector<TableColumn> headings(std::string_view line, char separator, std::size_t count) {
    line = trimmed(line);
    while (line.starts_with('#') || line.starts_with('%') || line.starts_with('/')) line.remove_prefix(1);
    TableRow row;
    std::vector<std::string_view> cells = row.split(line, separator);
    if (cells.size() == count + 1 && cells.back().empty()) cells.pop_back();
    if (cells.size() != count) return {};
    std::vector<TableColumn> columns;
    for (const std::string_view cell : cells) columns.push_back(columnOf(cell));
    return columns;
}

/// The line from which on there are nothing but samples, blank lines and comments down to the first one that
/// is taken; lines from 0.
std::size_t topSample(std::span<const std::string> lines, const DetectedTable& table,
                      const Pattern& pattern) {
    TableRow row;
    std::size_t top = table.firstLine - 1;
    for (std::size_t i = top; i-- > 0;) {
        const RowLook seen = look(lines[i], table.format, row);
        if (seen.count > 0 && seen.numbers == pattern)
            top = i;
        else if (!seen.numbers.empty())
            break;
    }
    return top;
}

/// The nearest headings above a line, which becomes theirs; empty where something else is nearer.
std::vector<TableColumn> headingsAbove(std::span<const std::string> lines, const DetectedTable& table,
                                       std::size_t& line) {
    const auto hasUnit = [](const TableColumn& column) { return !column.unit.empty(); };
    while (line-- > 0) {
        if (trimmed(lines[line]).empty()) continue;
        std::vector<TableColumn> found = headings(lines[line], table.format.separator, table.columns.size());
        if (!isComment(lines[line])) return found;
        // Any comment is one cell: of a single column only one with a unit speaks.
        if (found.size() > 1 || std::ranges::any_of(found, hasUnit)) return found;
    }
    return {};
}

/// Names, and a line of units below them where there is one, above all samples.
void readHeader(std::span<const std::string> lines, const Pattern& pattern, DetectedTable& table) {
    const auto take = [&](const std::vector<TableColumn>& header) {
        for (std::size_t i = 0; i < header.size(); ++i) {
            if (!header[i].name.empty()) table.columns[i].name = header[i].name;
            if (!header[i].unit.empty()) table.columns[i].unit = header[i].unit;
        }
    };
    std::size_t line = topSample(lines, table, pattern);
    std::vector<TableColumn> last = headingsAbove(lines, table, line);
    if (last.empty()) return;
    const std::vector<TableColumn> names = headingsAbove(lines, table, line);
    if (!names.empty() && isUnitsOnly(last)) {
        take(names);
        for (TableColumn& column : last)
            if (column.unit.empty()) column.unit = std::exchange(column.name, {});
    }
    take(last);
}

bool increases(std::span<const std::string> lines, const RowFormat& format, std::size_t firstLine) {
    TableRow row;
    std::optional<double> before;
    for (std::size_t i = firstLine - 1; i < lines.size(); ++i) {
        const std::optional<double> now =
            cellNumber(row.split(lines[i], format.separator, 1).front(), format.decimal);
        if (now && before && *now <= *before) return false;
        if (now) before = now;
    }
    return true;
}

/// Under the format that explains most.
DetectedTable bestTable(std::span<const std::string> lines, int wordWeight) {
    DetectedTable best;
    long bestScore = 0;
    for (const char separator : {'\t', ';', ',', ' '})
        for (const DecimalSign decimal : {DecimalSign::point, DecimalSign::comma}) {
            const RowFormat format{separator, decimal};
            const long now = score(lookAtAll(lines, format), wordWeight);
            if (now <= bestScore) continue;
            const DetectedTable table = detectTable(lines, format);
            // Numbers of one column with a decimal comma look like two columns: then the header has one cell,
            // or there is none and the first column does not grow.
            const bool splitsNumbers = separator == ',' && bestScore > 0 && table.columns.size() == 2 &&
                                       best.format.decimal == DecimalSign::comma;
            const std::size_t header = headerCells(lines, table.firstLine - 1, separator);
            const bool grows = increases(lines, format, table.firstLine);
            if (splitsNumbers && (header == 1 || (header != 2 && !grows))) continue;
            bestScore = now;
            best = table;
        }
    return best;
}

}  // namespace

DetectedTable detectTable(std::span<const std::string> lines, RowFormat format) {
    DetectedTable table;
    table.format = format;
    const std::vector<RowLook> rows = lookAtAll(lines, format);
    const std::optional<Pattern> pattern = commonPattern(rows);
    table.firstLine = (pattern ? firstSample(rows, *pattern) : lines.size()) + 1;
    return tableFrom(lines, format, table.firstLine);
}

DetectedTable tableFrom(std::span<const std::string> lines, RowFormat format, std::size_t firstLine) {
    DetectedTable table;
    table.format = format;
    table.firstLine = firstLine;
    if (firstLine == 0 || firstLine > lines.size()) return table;
    TableRow row;
    const RowLook first = look(lines[firstLine - 1], format, row);
    for (const bool isNumber : first.numbers) table.columns.push_back({{}, {}, isNumber});
    readHeader(lines, first.numbers, table);
    return table;
}

DetectedTable detectTable(std::span<const std::string> lines) {
    constexpr int usualWeight = 3;
    const DetectedTable table = bestTable(lines, usualWeight);
    // Mostly words, such as a date and a time of day before each sample.
    return table.hasSamples() ? table : bestTable(lines, 0);
}

}  // namespace drillwave

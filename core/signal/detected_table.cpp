// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/detected_table.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/signal/stated_time.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {
namespace {

using Pattern = std::vector<bool>;  // which cells are numbers

constexpr std::size_t mostHeaderLines = 12;  // above the samples that are looked at for names and units

bool isComment(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.starts_with('#') || text.starts_with('%') || text.starts_with("//") ||
           text.starts_with('!') || text.starts_with('"' + std::string("#"));
}

/// The cells of a line that are numbers, and how much speaks for the format.
struct RowLook {
    Pattern numbers;   // or missing values
    Pattern isNumber;  // numbers only
    int count = 0;
    int words = 0;
};

bool isComment(std::string_view line, char separator) {
    return isComment(line) && (!trimmed(line).starts_with('#') || isPassedOver(line, separator));
}

RowLook look(std::string_view line, const RowFormat& format, TableRow& row) {
    RowLook seen;
    if (isComment(line, format.separator) || trimmed(line).empty()) return seen;
    for (const std::string_view cell : row.split(line, format.separator)) {
        const bool isNumber = cellNumber(cell, format).has_value();
        const bool missing = !isNumber && isMissing(cell);
        seen.numbers.push_back(isNumber || missing);
        seen.isNumber.push_back(isNumber);
        seen.count += isNumber;
        seen.words += !isNumber && !missing;
    }
    // A separator at the end of each line makes no column.
    if (seen.numbers.size() > 1 && row.split(line, format.separator).back().empty()) {
        seen.numbers.pop_back();
        seen.isNumber.pop_back();
    }
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

/// The columns that hold a number in most of the lines of the commonest pattern: metadata that stand beside
/// the first samples are none.
Pattern sampleColumns(const std::vector<RowLook>& rows, const Pattern& pattern) {
    std::vector<std::size_t> counts(pattern.size());
    std::size_t all = 0;
    for (const RowLook& row : rows) {
        if (row.count == 0 || row.numbers != pattern) continue;
        ++all;
        for (std::size_t i = 0; i < pattern.size(); ++i) counts[i] += row.isNumber[i];
    }
    Pattern columns(pattern.size());
    for (std::size_t i = 0; i < pattern.size(); ++i) columns[i] = 2 * counts[i] > all;
    return columns;
}

/// Whether a line is a sample: numbers, or missing values, in all of these columns, and one number at least.
bool isSample(const RowLook& row, const Pattern& columns) {
    bool any = false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i]) continue;
        if (i >= row.numbers.size() || !row.numbers[i]) return false;
        any |= row.isNumber[i];
    }
    return any;
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

/// Where the samples begin: the first line like most that is followed by another one, or by a line that at
/// least has a number: a line of numbers above a heading is none.
std::size_t firstSample(const std::vector<RowLook>& rows, const Pattern& columns) {
    std::optional<std::size_t> lone;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!isSample(rows[i], columns)) continue;
        std::size_t next = i + 1;
        while (next < rows.size() && rows[next].numbers.empty()) ++next;
        const bool goesOn = next == rows.size() || isSample(rows[next], columns) ||
                            (rows[next].count > 0 && rows[next].numbers.size() >= columns.size());
        if (goesOn) return i;
        if (!lone) lone = i;
    }
    return lone.value_or(rows.size());
}

/// "[s];[kN]", or "s;kN": units, and no names.
bool isUnitsOnly(const std::vector<TableColumn>& columns, bool isBelowNames) {
    const auto isBracket = [](const TableColumn& column) { return column.name.empty(); };
    const auto isUnit = [](const TableColumn& column) {
        return column.unit.empty() && isKnownUnit(column.name);
    };
    const auto isEither = [&](const TableColumn& column) { return isBracket(column) || isUnit(column); };
    const bool any = std::ranges::any_of(columns, isUnit);
    if (std::ranges::all_of(columns, isBracket))
        return std::ranges::any_of(columns, [](const TableColumn& column) { return !column.unit.empty(); });
    return any && (isBelowNames || std::ranges::all_of(columns, isEither));
}

/// Cells of a heading: between blanks, a unit in brackets belongs to the name before it.
std::vector<std::string> headingCells(std::string_view line, char separator) {
    TableRow row;
    std::vector<std::string> cells;
    for (const std::string_view cell : row.split(line, separator)) {
        const bool opens = cell.starts_with('[') || cell.starts_with('(');
        const bool isOpen = !cells.empty() && cells.back().find_last_of("[(") != std::string::npos &&
                            cells.back().find_last_of("])") == std::string::npos;
        if (separator == ' ' && !cells.empty() && (opens || isOpen) &&
            !(opens && (cells.back().ends_with(']') || cells.back().ends_with(')'))))
            cells.back() += " " + std::string(cell);
        else
            cells.emplace_back(cell);
    }
    return cells;
}

/// Whether most of the cells that say something are numbers.
bool isMostlyNumbers(const std::vector<std::string>& cells, const RowFormat& format) {
    std::size_t numbers = 0, filled = 0;
    for (const std::string& cell : cells) {
        if (cell.empty()) continue;
        ++filled;
        numbers += cellNumber(cell, format).has_value();
    }
    return 2 * numbers > filled || filled == 0;
}

/// The headings of a line; empty where it is none for these columns. Comments may carry one too.
std::vector<TableColumn> headings(std::string_view line, const RowFormat& format, std::size_t count) {
    line = trimmed(line);
    while (line.starts_with('#') || line.starts_with('%') || line.starts_with('/') || line.starts_with('!'))
        line.remove_prefix(1);
    // A separator may stand first, above a column without a name.
    std::vector<std::string> cells = headingCells(line, format.separator);
    if (cells.size() != count && format.separator == ' ') {
        TableRow row;
        cells.clear();
        for (const std::string_view cell : row.split(line, ' ')) cells.emplace_back(cell);
    }
    while (cells.size() > count && cells.back().empty()) cells.pop_back();
    if (cells.size() != count || isMostlyNumbers(cells, format)) return {};
    std::vector<TableColumn> columns;
    for (const std::string& cell : cells) columns.push_back(columnOf(cell));
    return columns;
}

/// The line from which on there are nothing but samples, blank lines and comments down to the first one that
/// is taken; lines from 0.
std::size_t topSample(std::span<const std::string> lines, const DetectedTable& table,
                      const Pattern& columns) {
    TableRow row;
    std::size_t top = table.firstLine - 1;
    for (std::size_t i = top; i-- > 0;) {
        const RowLook seen = look(lines[i], table.format, row);
        if (isSample(seen, columns))
            top = i;
        else if (!seen.numbers.empty())
            break;
    }
    return top;
}

/// Names and units from the lines above the samples: the nearest names, the nearest line of units, which may
/// stand below or above the names.
void readHeader(std::span<const std::string> lines, const Pattern& columns, DetectedTable& table) {
    const auto hasUnit = [](const TableColumn& column) { return !column.unit.empty(); };
    std::size_t line = topSample(lines, table, columns);
    std::vector<TableColumn> names, units;
    std::size_t looked = 0;
    while (line-- > 0 && looked < mostHeaderLines) {
        if (trimmed(lines[line]).empty()) continue;
        ++looked;
        std::vector<TableColumn> found = headings(lines[line], table.format, table.columns.size());
        const bool comment = isComment(lines[line], table.format.separator);
        // Any comment is one cell: of a single column only one with a unit speaks.
        if (comment && (found.size() < 2 && std::ranges::none_of(found, hasUnit))) continue;
        if (found.empty()) {
            // Ranges and offsets between headings are no headings.
            TableRow row;
            const bool hasCells =
                row.split(lines[line], table.format.separator).size() == table.columns.size();
            if (hasCells && names.empty()) continue;
            break;
        }
        if (names.empty() && units.empty() && isUnitsOnly(found, false)) {
            units = std::move(found);
        } else if (names.empty()) {
            // Below names a line with some units is one of units: "x-axis,3" over "second,Volt".
            const std::vector<TableColumn> above =
                line > 0 && units.empty() ? headings(lines[line - 1], table.format, table.columns.size())
                                          : std::vector<TableColumn>{};
            if (!above.empty() && isUnitsOnly(found, true) && !isUnitsOnly(above, false))
                units = std::move(found);
            else
                names = std::move(found);
            if (std::ranges::any_of(names, hasUnit)) break;
        } else {
            if (units.empty() && isUnitsOnly(found, false)) units = std::move(found);
            break;
        }
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.columns[i].name = names[i].name;
        table.columns[i].unit = names[i].unit;
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
        const std::string& unit = units[i].unit.empty() ? units[i].name : units[i].unit;
        if (!unit.empty()) table.columns[i].unit = unit;
    }
}

/// Sorts columns into numbers, stamps and counts of the rows.
void judgeColumns(std::span<const std::string> lines, DetectedTable& table) {
    const std::size_t count = table.columns.size();
    std::vector<std::size_t> numbers(count), stamps(count), filled(count);
    std::vector<std::optional<double>> before(count);
    std::vector<bool> counts(count, true);
    TableRow row;
    std::size_t rows = 0;
    SignEvidence all;
    bool isQuoted = false;
    for (std::size_t i = table.firstLine - 1; i < lines.size(); ++i) {
        if (isPassedOver(lines[i], table.format.separator)) continue;
        isQuoted |= lines[i].find('"') != std::string::npos;
        const std::vector<std::string_view>& cells = row.split(lines[i], table.format.separator);
        if (cells.size() < count / 2 + 1) continue;
        ++rows;
        for (std::size_t c = 0; c < std::min(count, cells.size()); ++c) {
            const std::optional<double> value = cellNumber(cells[c], table.format);
            numbers[c] += value.has_value();
            filled[c] += !cells[c].empty();
            stamps[c] += !value && timeStamp(cells[c]).has_value();
            if (!value || (before[c] && *value != *before[c] + 1) ||
                (!before[c] && *value != 0 && *value != 1))
                counts[c] = false;
            before[c] = value;
            const SignEvidence evidence = signEvidence(cells[c]);
            all.point |= evidence.point;
            all.comma |= evidence.comma;
            all.ambiguous |= evidence.ambiguous;
            if (evidence.groups) all.groups = evidence.groups;
        }
    }
    for (std::size_t c = 0; c < count; ++c) {
        TableColumn& column = table.columns[c];
        column.isNumeric = 2 * numbers[c] > rows;
        column.isStamp = 2 * stamps[c] > rows;
        column.isIndex = column.isNumeric && rows > 2 && counts[c] && column.unit.empty();
    }
    table.groups = all.groups;
    const bool isPoint = table.format.decimal == DecimalSign::point;
    const bool isKnown = isPoint ? all.point : all.comma;
    table.format.otherSignGroups = isKnown;
    // Between commas without quotes a comma is no sign of a number.
    table.isDecimalOpen = all.ambiguous && !isKnown && !(table.format.separator == ',' && !isQuoted);
}

bool increases(std::span<const std::string> lines, const RowFormat& format, std::size_t firstLine) {
    TableRow row;
    std::optional<double> before;
    for (std::size_t i = firstLine - 1; i < lines.size(); ++i) {
        const std::optional<double> now =
            cellNumber(row.split(lines[i], format.separator, 1).front(), format);
        if (now && before && *now <= *before) return false;
        if (now) before = now;
    }
    return true;
}

/// Whether channels stand in rows: a name and its samples, fewer rows than samples in each.
bool hasChannelsInRows(std::span<const std::string> lines, const RowFormat& format) {
    constexpr std::size_t fewest = 8, mostWords = 3;
    TableRow row;
    std::size_t rows = 0, cells = 0;
    for (const std::string& line : lines) {
        const RowLook seen = look(line, format, row);
        if (seen.numbers.empty()) continue;
        const bool isChannel = static_cast<std::size_t>(seen.count) >= fewest && !seen.isNumber.front() &&
                               static_cast<std::size_t>(seen.words) <= mostWords;
        if (!isChannel) return false;
        cells = seen.numbers.size();
        ++rows;
    }
    return rows > 0 && cells > 2 * rows;
}

/// Under the format that explains most.
DetectedTable bestTable(std::span<const std::string> lines, int wordWeight) {
    DetectedTable best;
    long bestScore = 0;
    for (const char separator : {'\t', ';', ',', '|', ' '})
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

/// The line "sep=;" by which Excel names the separator.
std::optional<char> namedSeparator(std::span<const std::string> lines) {
    if (lines.empty()) return std::nullopt;
    const std::string_view line = trimmed(lines.front());
    if (!line.starts_with("sep=") || line.size() != 5) return std::nullopt;
    return line.back();
}

}  // namespace

DetectedTable detectTable(std::span<const std::string> lines, RowFormat format) {
    DetectedTable table;
    table.format = format;
    const std::vector<RowLook> rows = lookAtAll(lines, format);
    const std::optional<Pattern> pattern = commonPattern(rows);
    table.firstLine = (pattern ? firstSample(rows, sampleColumns(rows, *pattern)) : lines.size()) + 1;
    return tableFrom(lines, format, table.firstLine);
}

DetectedTable tableFrom(std::span<const std::string> lines, RowFormat format, std::size_t firstLine) {
    DetectedTable table;
    table.format = format;
    table.firstLine = firstLine;
    table.hasRows = hasChannelsInRows(lines, format);
    if (firstLine == 0 || firstLine > lines.size()) return table;
    const std::vector<RowLook> below = lookAtAll(lines.subspan(firstLine - 1), format);
    TableRow row;
    const RowLook first = look(lines[firstLine - 1], format, row);
    const std::optional<Pattern> pattern = commonPattern(below);
    // Samples may have more columns than the first one shows, and metadata beside it are no columns less.
    const std::size_t count = std::max(first.numbers.size(), pattern ? pattern->size() : 0);
    if (count == 0) return table;
    table.columns.resize(count);
    const Pattern columns = pattern ? sampleColumns(below, *pattern) : first.numbers;
    readHeader(lines, columns, table);
    judgeColumns(lines, table);
    readStatedRate(lines, table);
    return table;
}

DetectedTable detectTable(std::span<const std::string> lines) {
    constexpr int usualWeight = 3;
    if (const std::optional<char> separator = namedSeparator(lines)) {
        const DetectedTable points = detectTable(lines, RowFormat{*separator, DecimalSign::point});
        const DetectedTable commas = detectTable(lines, RowFormat{*separator, DecimalSign::comma});
        const auto numeric = [](const DetectedTable& table) {
            return std::ranges::count_if(table.columns, &TableColumn::isNumeric);
        };
        return numeric(commas) > numeric(points) ? commas : points;
    }
    const DetectedTable table = bestTable(lines, usualWeight);
    // Mostly words, such as a date and a time of day before each sample.
    return table.hasSamples() ? table : bestTable(lines, 0);
}

std::optional<std::size_t> columnNamed(std::span<const TableColumn> columns, const std::string& wanted) {
    if (const auto number = wholeNumberIn<std::size_t>(wanted); number && *number >= 1)
        if (*number <= columns.size()) return *number - 1;
    const std::string lower = lowerCase(wanted);
    std::vector<std::size_t> beginning;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string whole =
            columns[i].unit.empty() ? columns[i].name : columns[i].name + " [" + columns[i].unit + "]";
        if (lowerCase(columns[i].name) == lower || lowerCase(whole) == lower) return i;
        if (!wanted.empty() && lowerCase(columns[i].name).starts_with(lower)) beginning.push_back(i);
    }
    return beginning.size() == 1 ? std::optional(beginning.front()) : std::nullopt;
}

}  // namespace drillwave

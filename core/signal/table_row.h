// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a table of samples: its cells, and the numbers in them.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

enum class DecimalSign { point, comma };

/// Format of the rows of a table.
struct RowFormat {
    char separator = ',';  ///< ',', ';', '|' or a tab; a blank stands for any number of blanks and tabs
    DecimalSign decimal = DecimalSign::point;
    /// Whether the other sign may part groups of three digits: only where the decimal sign is known. Blanks
    /// and apostrophes between groups of three are always read.
    bool otherSignGroups = false;
    bool operator==(const RowFormat&) const = default;
};

/// Splits one row after the other. Cells are trimmed; quotes around one are taken off, a separator inside of
/// them belongs to the cell.
class TableRow {
  public:
    /// The cells of a line, at most so many; they point into the line and into this until the next call.
    const std::vector<std::string_view>& split(std::string_view line, char separator,
                                               std::size_t most = mostCells);
    static constexpr std::size_t mostCells = 1000;

  private:
    std::string_view quotedCell(std::string_view line, std::size_t& at);

    std::vector<std::string_view> m_cells;
    std::deque<std::string> m_unquoted;
};

/// Returns the number in a cell, or nothing. The sign that is not the decimal sign, point or comma, is only
/// allowed between groups of three digits, if the format says so or if a decimal sign follows: "3,676.8".
/// Reads U+2212 as minus, no-break spaces as blanks, and exponents with D as Fortran writes them.
std::optional<double> cellNumber(std::string_view cell, const RowFormat& format);

/// A cell that begins with a number, with that number in C notation, "3,66 m" as "3.66 m"; every other cell
/// as it is.
std::string plainCell(std::string_view cell, const RowFormat& format);

/// Evidence in one cell of the decimal sign and of groups of thousands.
struct SignEvidence {
    bool point = false;      ///< the point must be a decimal sign
    bool comma = false;      ///< the comma must be
    bool ambiguous = false;  ///< one sign before three digits: "1,234"
    char groups = 0;         ///< ',', '.', an apostrophe or ' ' between groups of three
};
SignEvidence signEvidence(std::string_view cell);

/// Values from here on mean "overload" in files of recorders.
inline constexpr double overloadValue = 9.9e37;

/// Whether a cell says that there is no value: empty, "NaN", "#N/A", "-", "OVL", 9.9e37 and the like, as
/// instruments and spreadsheets write them.
bool isMissing(std::string_view cell);
/// Returns whether a cell means that the value was too large for the instrument.
bool isOverload(std::string_view cell);

/// Whether a line is blank or a comment: '#' at its beginning, unless the first cell is a spreadsheet's word
/// for a missing value such as #N/A.
bool isPassedOver(std::string_view line, char separator);

}  // namespace drillwave

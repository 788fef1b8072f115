// SPDX-License-Identifier: GPL-3.0-or-later
// Row of a table of samples: its cells, and the numbers in them.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

enum class DecimalSign { point, comma };

/// Separator and decimal sign of the rows of a table.
struct RowFormat {
    char separator = ',';  ///< ',', ';', '|' or a tab; a blank stands for any number of blanks and tabs
    DecimalSign decimal = DecimalSign::point;
    /// Whether thousands may be separated by the other sign: commas if the decimal sign is the point, points
    /// if it is the comma. Set only if the decimal sign is certain. Blanks and apostrophes may always
    /// separate thousands.
    bool otherSignGroups = false;
    bool operator==(const RowFormat&) const = default;
};

/// Splitter of table rows into cells, one row at a time. Cells lose the blanks and the quotes around them. A
/// separator inside quotes belongs to the cell.
class TableRow {
  public:
    /// Returns the cells of a line, at most `most`. They point into the line, and are valid only until the
    /// next call.
    const std::vector<std::string_view>& split(std::string_view line, char separator,
                                               std::size_t most = mostCells);
    static constexpr std::size_t mostCells = 1000;

  private:
    std::string_view quotedCell(std::string_view line, std::size_t& at);

    std::vector<std::string_view> m_cells;
    std::deque<std::string> m_unquoted;
};

/// Returns the number in a cell, or nullopt. If the comma is the decimal sign, points may only separate
/// groups of three digits, and vice versa. Such groups require `format.otherSignGroups`, or a decimal sign
/// after them ("3,676.8"). U+2212 is a minus, no-break spaces are blanks, and D may begin an exponent, as in
/// Fortran.
std::optional<double> cellNumber(std::string_view cell, const RowFormat& format);

/// Converts the number at the beginning of a cell to C notation: "3,66 m" becomes "3.66 m". Returns any other
/// cell unchanged.
std::string plainCell(std::string_view cell, const RowFormat& format);

/// Evidence in one cell for the decimal sign and for groups of thousands.
struct SignEvidence {
    bool point = false;  ///< whether the point must be a decimal sign
    bool comma = false;  ///< whether the comma must be a decimal sign
    /// Whether the point or comma in a number such as "1,234" may be a decimal sign or may separate
    /// thousands.
    bool ambiguous = false;
    /// Character that separates groups of three digits: ',', '.', an apostrophe or ' '; 0 if the cell has no
    /// such groups.
    char groups = 0;
};
/// Returns what a cell shows about the decimal sign and groups of thousands.
SignEvidence signEvidence(std::string_view cell);

/// Smallest value that means "overload" in files of recorders.
inline constexpr double overloadValue = 9.9e37;

/// Returns whether a cell stands for a missing value, as instruments and spreadsheets write it: an empty
/// cell, a word such as "NaN", "#N/A" or "-", or a word for overload such as "OVL".
bool isMissing(std::string_view cell);
/// Returns whether a cell means that the value exceeded the range of the instrument, "OVL" or 9.9e37.
bool isOverload(std::string_view cell);

/// Returns whether a line has no samples because it is blank or a comment, which begins with '#'. A first
/// cell such as #N/A is a missing value, not a comment.
bool isPassedOver(std::string_view line, char separator);

}  // namespace drillwave

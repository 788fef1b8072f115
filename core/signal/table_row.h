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
    /// Whether thousands may be separated by the point or comma that is not the decimal sign. It is set only
    /// if the decimal sign is certain. Blanks and apostrophes between groups are always allowed.
    bool otherSignGroups = false;
    bool operator==(const RowFormat&) const = default;
};

/// Reader of one row after the other. Cells lose the blanks and the quotes around them. A separator inside
/// quotes belongs to the cell.
class TableRow {
  public:
    /// Returns the cells of a line, at most `most`. They refer to the line and are valid only until the next
    /// call.
    const std::vector<std::string_view>& split(std::string_view line, char separator,
                                               std::size_t most = mostCells);
    static constexpr std::size_t mostCells = 1000;

  private:
    std::string_view quotedCell(std::string_view line, std::size_t& at);

    std::vector<std::string_view> m_cells;
    std::deque<std::string> m_unquoted;
};

/// Returns the number in a cell, or nullopt. The point or comma that is not the decimal sign is allowed only
/// between groups of three digits. It requires that the format says so, or that a decimal sign follows
/// ("3,676.8"). U+2212 is a minus, no-break spaces are blanks, and D may begin an exponent, as in Fortran.
std::optional<double> cellNumber(std::string_view cell, const RowFormat& format);

/// Returns a cell that begins with a number with that number in C notation: "3,66 m" becomes "3.66 m". Any
/// other cell does not change.
std::string plainCell(std::string_view cell, const RowFormat& format);

/// Evidence in one cell for the decimal sign and for groups of thousands.
struct SignEvidence {
    bool point = false;  ///< whether the point must be a decimal sign
    bool comma = false;  ///< whether the comma must be a decimal sign
    /// Whether a single point or comma precedes three digits, "1,234", and may be either.
    bool ambiguous = false;
    /// Sign between groups of three digits: ',', '.', an apostrophe or ' '; 0 for none.
    char groups = 0;
};
/// Returns what a cell shows about the decimal sign and groups of thousands.
SignEvidence signEvidence(std::string_view cell);

/// Smallest value that means "overload" in files of recorders.
inline constexpr double overloadValue = 9.9e37;

/// Returns whether a cell stands for a missing value, as instruments and spreadsheets write it: empty, "NaN",
/// "#N/A", "-", "OVL", 9.9e37.
bool isMissing(std::string_view cell);
/// Returns whether a cell means that the value exceeded the range of the instrument, "OVL" or 9.9e37.
bool isOverload(std::string_view cell);

/// Returns whether a line has no samples because it is blank or a comment, which begins with '#'. A first
/// cell such as #N/A is a missing value, not a comment.
bool isPassedOver(std::string_view line, char separator);

}  // namespace drillwave

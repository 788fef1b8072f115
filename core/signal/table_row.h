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

/// How the rows of a table are written.
struct RowFormat {
    char separator = ',';  ///< ',', ';' or a tab; a blank stands for any number of blanks and tabs
    DecimalSign decimal = DecimalSign::point;
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

/// The number that a cell holds, or nothing. A sign of the other kind is no part of a number.
std::optional<double> cellNumber(std::string_view cell, DecimalSign decimal);

/// Whether a cell says that there is no value: empty, "NaN", "n/a", "-" and the like.
bool isMissing(std::string_view cell);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Meaning and format of one number column of a sweep or a table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/units.h"

namespace drillwave {

/// Meaning of the numbers in one column of a sweep or a table.
struct RowColumn {
    enum class Kind {
        number,    ///< number without a unit, or in the unit of the heading
        quantity,  ///< value in SI units, shown in `unit`
        word,      ///< index of one of `words`
    };

    /// Heading of the column, such as "beta", "peak_force [N]" or "rod.length [mm]". For Kind::quantity,
    /// rows contain SI values; appendText() converts them to the unit of the heading.
    std::string header;
    Kind kind = Kind::number;
    Quantity quantity = Quantity::ratio;
    const Unit* unit = nullptr;  ///< unit of a Kind::quantity; may be nullptr for other kinds
    std::span<const std::string_view> words = {};  ///< words for Kind::word

    /// Appends a number to `cell` as in files: in the unit of the heading, without the unit's name. Reading
    /// it back gives the same number. Appends nothing for NaN.
    void appendText(std::string& cell, double number) const;
    /// Returns a number as text for a file; see appendText().
    std::string cell(double number) const {
        std::string text;
        appendText(text, number);
        return text;
    }
};

/// Headings and meanings of the columns in the rows of a run. A sink receives them before the first row.
struct RowHeader {
    std::vector<std::string> copied;  ///< headings of the text cells that precede the numbers
    std::vector<RowColumn> columns;   ///< meaning of each number in a row
    /// Whether these rows are the first part of a table. Only the first part of a file begins with a line of
    /// headings; later parts are appended to it.
    bool isFirstPart = true;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Contents of one column of numbers of a sweep or a table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/units.h"

namespace drillwave {

/// The meaning of the numbers of a column.
struct RowColumn {
    enum class Kind {
        number,    ///< without a unit, or in the one of the header
        quantity,  ///< SI, shown in `unit`
        word,      ///< the number of one of `words`
    };

    std::string header;  ///< "beta", "peak_force [N]", "rod.length [mm]" (also where the numbers are SI)
    Kind kind = Kind::number;
    Quantity quantity = Quantity::ratio;
    const Unit* unit = nullptr;                    ///< of Kind::quantity; may be nullptr for the others
    std::span<const std::string_view> words = {};  ///< of Kind::word

    /// Appends a number as in files, in the unit of the header but without its name; it reads back as the
    /// same number. Nothing for NaN.
    void appendText(std::string& cell, double number) const;
    /// Returns that text.
    std::string cell(double number) const {
        std::string text;
        appendText(text, number);
        return text;
    }
};

/// All columns of a run of rows.
struct RowHeader {
    std::vector<std::string> copied;  ///< headings of the text cells before the numbers
    std::vector<RowColumn> columns;   ///< of the numbers
    bool isFirstPart = true;          ///< of all rows; later parts are written after it, without a header
};

}  // namespace drillwave

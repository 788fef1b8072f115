// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities as users type them: numbers, simple arithmetic, and units in the spellings of everyday.
#pragma once

#include <QLocale>
#include <QString>

#include "core/text/units.h"

namespace drillwave {

/// The longest text that counts as arithmetic; no field needs more, and no input takes long.
inline constexpr qsizetype longestArithmetic = 100;

/// Reads "38", "38 mm", "3,2 m" as plainText() and parseQuantity() do, and also
/// sums, products and quotients, with brackets: "2*3.05 m", "(3 + 0.66) m", "12 ft + 3 in", "1/2 in";
/// feet and inches: "12'", "144\"", "5' 6 1/2\"", and mixed fractions: "1 1/2 in";
/// units in words and capitals that mean no other unit: "3.66 metres", "12 FT".
/// A number without a unit is in that of the last summand, else in `defaultUnit`. For people only: files and
/// the command line take none of this.
TypedQuantity typedQuantity(const QString& typed, Quantity quantity, const Unit& defaultUnit,
                            const QLocale& locale);

/// Returns the unit with that spelling, or nullptr. "mn/m" is none: it could be milli or mega.
const Unit* typedUnit(const QString& spelling, Quantity quantity);

}  // namespace drillwave

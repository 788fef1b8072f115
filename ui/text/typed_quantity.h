// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities as users type them: numbers, simple arithmetic, and units in everyday spellings.
#pragma once

#include <QLocale>
#include <QString>

#include "core/text/units.h"

namespace drillwave {

/// Largest length of a text that is read as arithmetic [characters].
inline constexpr qsizetype longestArithmetic = 100;

/// Returns the quantity that a user has typed, in SI, or why it cannot be read. Accepts all that plainText()
/// and parseQuantity() accept, such as "38", "38 mm" and "3,2 m". Also accepts:
/// - sums, products and quotients, with brackets: "2*3.05 m", "(3 + 0.66) m", "12 ft + 3 in", "1/2 in"
/// - feet and inches: "12'", "144\"", "5' 6 1/2\"", and mixed fractions: "1 1/2 in"
/// - units as words or in capitals if they are unambiguous: "3.66 metres", "12 FT"
/// A number without a unit has that of the last summand, else `defaultUnit`. Files and the command line do
/// not use this function.
TypedQuantity typedQuantity(const QString& typed, Quantity quantity, const Unit& defaultUnit,
                            const QLocale& locale);

/// Returns the unit that a user means by `spelling`. It is nullptr if there is none, or if the spelling is
/// ambiguous: "mn/m" could mean milli or mega.
const Unit* typedUnit(const QString& spelling, Quantity quantity);

}  // namespace drillwave

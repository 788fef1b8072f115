// SPDX-License-Identifier: GPL-3.0-or-later
// Physical quantities, their units, and the conversion between SI values and text with a unit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Physical quantity that a number measures; `ratio` has no dimension.
enum class Quantity {
    ratio,
    length,
    area,
    stress,
    density,
    time,
    impulse,
    force,
    stiffness,
    velocity,
    frequency,
    energy,
    power,
    mass,
    angle,        ///< angle in degrees, unlike other quantities not in SI: a right angle is exactly 90
    share,        ///< part of a whole: a bare number (0.02) or per cent (2 %)
    attenuation,  ///< decay of the amplitude of a wave per length, 1/m
    damping,      ///< force per velocity, N s/m
};

/// Unit of one physical quantity. SI value = factor × value in this unit, with
/// factor = numerator/denominator.
struct Unit {
    std::string_view name;
    /// Numerator of the factor to SI. Numerator and denominator are exact for most units, so that 1.5 in is
    /// the double nearest to 0.0381.
    double numerator = 1;
    double denominator = 1;                   ///< denominator of the factor to SI, > 0
    std::optional<int> decimalExponent = {};  ///< n if the factor is exactly 10^n ("mm": −3), else empty

    double factor() const { return numerator / denominator; }
    double toSi(double value) const { return value * numerator / denominator; }
    double fromSi(double si) const { return si * denominator / numerator; }
};

/// Returns the units of a quantity, the SI unit first. `ratio` has one unit, with an empty name; it is also
/// the first unit of `share`.
std::span<const Unit> unitsOf(Quantity quantity);

/// Returns the unit with this name, or nullptr if the quantity has none. Names are case-sensitive: "mm",
/// "MN/m", "N s", "us" and "µs".
const Unit* findUnit(Quantity quantity, std::string_view name);

/// Returns the names of all units of a quantity for messages: "m, mm, cm, km, in, ft".
std::string unitList(Quantity quantity);

/// Returns the finite number, in the C locale, that fills the entire text; blanks around it are allowed.
/// Returns nullopt for anything else.
std::optional<double> parseNumber(std::string_view text);

/// Returns the shortest text in the C locale that reads back as the same double: "0.1", "1e-07".
std::string formatNumber(double value);

/// Value and unit read from a text such as "38 mm", or the reason why it was refused.
struct TypedQuantity {
    double si = 0;               ///< value in SI, 38 mm as 0.038
    const Unit* unit = nullptr;  ///< unit in the text, never nullptr if the text was valid
    Message problem;             ///< reason why the text was refused; empty if it was valid
    bool valid() const { return problem.isEmpty(); }
};

/// Treatment of a number without a unit: refused, as in files, or in a given default unit, as in form fields.
enum class BareNumber { refused, inDefaultUnit };

/// Returns the value and unit of a text such as "38 mm", "1.5in", "255 kN", "200 us" or "51 N s". A `ratio`
/// is a bare number, a `share` "0.02" or "2 %". Decimal commas are refused: input fields replace them by
/// points first.
TypedQuantity parseQuantity(std::string_view text, Quantity quantity, BareNumber bare = BareNumber::refused,
                            const Unit* defaultUnit = nullptr);

/// Returns a value given in SI as the shortest text in `unit` that reads back as exactly the same double:
/// "38 mm". If no decimal number in that unit does so, the text is in the SI unit.
std::string formatQuantity(double si, Quantity quantity, const Unit& unit);

// Headings of columns with their unit in brackets: "rod.length [mm]".

/// Returns the heading of a column, "rod.length [mm]"; only the name if `unit` is nullptr or has no name.
std::string withUnit(std::string_view name, const Unit* unit);

/// Heading of a column split into name and unit, without blanks around them. `unit` is empty if the heading
/// does not end in brackets.
struct UnitHeading {
    std::string_view name;
    std::string_view unit;
};
/// Splits the heading of a column, "rod.length [mm]", into the name "rod.length" and the unit "mm".
UnitHeading splitHeading(std::string_view heading);

}  // namespace drillwave

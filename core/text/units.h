// SPDX-License-Identifier: GPL-3.0-or-later
// Physical quantities, their units, and text with a unit read into SI and written back.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Physical quantity of a number; `ratio` is dimensionless.
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
    angle,        ///< in degrees, which go with the SI: a right angle is 90, exactly
    share,        ///< part of a whole: a bare number, or per cent
    attenuation,  ///< decay per length
    damping,      ///< force per velocity
};

/// A unit of one quantity: value in SI = factor × value in this unit.
struct Unit {
    std::string_view name;
    double numerator = 1;                     ///< factor = numerator/denominator, both exact for most units,
    double denominator = 1;                   ///< so that 1.5 in is the double nearest to 0.0381
    std::optional<int> decimalExponent = {};  ///< the factor is exactly 10 to this power ("mm": −3)

    double factor() const { return numerator / denominator; }
    double toSi(double value) const { return value * numerator / denominator; }
    double fromSi(double si) const { return si * denominator / numerator; }
};

/// The units of a quantity, the SI unit first; for `ratio` one unit with an empty name, which is also the
/// first one of `share`.
std::span<const Unit> unitsOf(Quantity quantity);

/// The unit of that name, or nullptr. Names are case sensitive ("mm", "MN/m", "N s", "us" and "µs").
const Unit* findUnit(Quantity quantity, std::string_view name);

/// "m, mm, cm, km, in, ft": the units that would do, for messages.
std::string unitList(Quantity quantity);

/// A finite C-locale number filling the whole text (surrounding blanks allowed), whatever the user's locale.
std::optional<double> parseNumber(std::string_view text);

/// Returns the shortest text that reads back as the same double ("0.1", "1e-07"), C locale.
std::string formatNumber(double value);

/// A number with its unit as typed.
struct TypedQuantity {
    double si = 0;               ///< the value in SI
    const Unit* unit = nullptr;  ///< the unit that was typed, never nullptr when valid
    Message problem;             ///< why the text was refused; empty when it was read
    bool valid() const { return problem.isEmpty(); }
};

/// Whether a number without a unit is refused (files) or taken in the given default unit (form fields).
enum class BareNumber { refused, inDefaultUnit };

/// Reads "38 mm", "1.5in", "255 kN", "200 us", "51 N s". For `ratio` a bare number, for `share` "0.02" or "2
/// %". A decimal comma is not accepted here: the form turns the user's locale into C text first.
TypedQuantity parseQuantity(std::string_view text, Quantity quantity, BareNumber bare = BareNumber::refused,
                            const Unit* defaultUnit = nullptr);

/// The value in that unit as the shortest text that reads back as exactly the same SI double ("38 mm");
/// falls back to the SI unit where no decimal text in `unit` would.
std::string formatQuantity(double si, Quantity quantity, const Unit& unit);

// Headings of columns with their unit in brackets: "rod.length [mm]".

/// Returns "rod.length [mm]"; only the name without a unit, or with one that has no name.
std::string withUnit(std::string_view name, const Unit* unit);

/// A heading in its parts, without blanks around them; `unit` is empty without brackets at the end.
struct UnitHeading {
    std::string_view name;
    std::string_view unit;
};
UnitHeading splitHeading(std::string_view heading);

}  // namespace drillwave

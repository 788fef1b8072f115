// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// 10 to a small power, exact in a double for |exponent| ≤ 22.
constexpr double powerOfTen(int exponent) {
    double power = 1;
    for (int i = 0; i < exponent; ++i) power *= 10;
    return power;
}

constexpr Unit decimal(std::string_view name, int exponent) {
    if (exponent < 0) return {name, 1, powerOfTen(-exponent), exponent};
    return {name, powerOfTen(exponent), 1, exponent};
}
constexpr Unit multiple(std::string_view name, double numerator, double denominator = 1) {
    return {name, numerator, denominator, std::nullopt};
}

// Exact by definition.
constexpr double poundForce = 4.4482216152605;
constexpr double poundForceAnInch = 175.12683524647636;  // N/m

constexpr std::array ratioUnits{decimal("", 0)};
constexpr std::array lengthUnits{decimal("m", 0),          decimal("mm", -3), decimal("cm", -2),
                                 decimal("km", 3),         decimal("um", -6), multiple("in", 254, 1e4),
                                 multiple("ft", 3048, 1e4)};
constexpr std::array areaUnits{decimal("m^2", 0), decimal("mm^2", -6), decimal("cm^2", -4),
                               multiple("in^2", 64516, 1e8)};
constexpr std::array stressUnits{decimal("Pa", 0),
                                 decimal("kPa", 3),
                                 decimal("MPa", 6),
                                 decimal("GPa", 9),
                                 decimal("bar", 5),
                                 multiple("psi", 6894.757293168361),
                                 multiple("ksi", 6894757.293168361),
                                 multiple("Mpsi", 6894757293.168361)};
constexpr std::array densityUnits{decimal("kg/m^3", 0), decimal("g/cm^3", 3), decimal("t/m^3", 3),
                                  multiple("lb/ft^3", 16.018463373960142)};
constexpr std::array timeUnits{decimal("s", 0), decimal("ms", -3), decimal("us", -6), decimal("ns", -9),
                               multiple("min", 60)};
constexpr std::array impulseUnits{decimal("N s", 0), decimal("kN s", 3), decimal("MN s", 6),
                                  multiple("lbf s", poundForce)};
constexpr std::array forceUnits{decimal("N", 0),
                                decimal("kN", 3),
                                decimal("MN", 6),
                                decimal("GN", 9),
                                decimal("daN", 1),
                                multiple("lbf", poundForce),
                                multiple("kip", 1000 * poundForce),
                                multiple("kgf", 980665, 1e5)};
constexpr std::array stiffnessUnits{decimal("N/m", 0),
                                    decimal("kN/m", 3),
                                    decimal("MN/m", 6),
                                    decimal("GN/m", 9),
                                    decimal("N/mm", 3),
                                    decimal("kN/mm", 6),
                                    multiple("lbf/in", poundForceAnInch),
                                    multiple("kip/in", 1000 * poundForceAnInch)};
constexpr std::array velocityUnits{decimal("m/s", 0),           decimal("mm/s", -3),
                                   multiple("km/h", 5, 18),     multiple("ft/s", 3048, 1e4),
                                   multiple("m/min", 1, 60),    multiple("ft/min", 3048, 6e5),
                                   multiple("in/min", 254, 6e5)};
constexpr std::array frequencyUnits{decimal("Hz", 0), decimal("kHz", 3), multiple("1/min", 1, 60),
                                    multiple("bpm", 1, 60), multiple("rpm", 1, 60)};
constexpr std::array energyUnits{decimal("J", 0), decimal("mJ", -3), decimal("kJ", 3), decimal("MJ", 6),
                                 multiple("ft lbf", 1.3558179483314004)};
constexpr std::array powerUnits{decimal("W", 0), decimal("kW", 3), decimal("MW", 6),
                                multiple("hp", 745.69987158227022)};  // 550 ft lbf/s
constexpr std::array massUnits{decimal("kg", 0), decimal("t", 3), decimal("g", -3),
                               multiple("lb", 45359237, 1e8)};
constexpr std::array angleUnits{decimal("deg", 0), multiple("rad", 180, std::numbers::pi)};
constexpr std::array shareUnits{decimal("", 0), decimal("%", -2)};
constexpr std::array attenuationUnits{decimal("1/m", 0), decimal("1/mm", 3), decimal("1/km", -3),
                                      multiple("1/ft", 1e4, 3048)};
constexpr std::array dampingUnits{decimal("N s/m", 0), decimal("kN s/m", 3), decimal("MN s/m", 6),
                                  multiple("lbf s/in", poundForceAnInch)};

struct Spelling {
    std::string_view written;
    std::string_view name;
};

// Other spellings, after the normalisation of findUnit().
constexpr std::array spellings{
    Spelling{"Ns", "N s"},           Spelling{"kNs", "kN s"},       Spelling{"lbfs", "lbf s"},
    Spelling{"inch", "in"},          Spelling{"feet", "ft"},        Spelling{"sec", "s"},
    Spelling{"m2", "m^2"},           Spelling{"mm2", "mm^2"},       Spelling{"cm2", "cm^2"},
    Spelling{"in2", "in^2"},         Spelling{"kg/m3", "kg/m^3"},   Spelling{"g/cm3", "g/cm^3"},
    Spelling{"t/m3", "t/m^3"},       Spelling{"lb/ft3", "lb/ft^3"}, Spelling{"blows/min", "bpm"},
    Spelling{"1/s", "Hz"},           Spelling{"°", "deg"},          Spelling{"lbs", "lb"},
    Spelling{"Ns/m", "N s/m"},       Spelling{"kNs/m", "kN s/m"},   Spelling{"MNs/m", "MN s/m"},
    Spelling{"lbfs/in", "lbf s/in"}, Spelling{"msec", "ms"},        Spelling{"usec", "us"},
};

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// One spelling for the micro signs, superscripts and product signs; single blanks.
std::string normalised(std::string_view name) {
    std::string text(trimmed(name));
    replaceAll(text, "\u00b5", "u");
    replaceAll(text, "\u03bc", "u");
    replaceAll(text, "\u00b2", "^2");
    replaceAll(text, "\u00b3", "^3");
    replaceAll(text, "\u00b7", " ");
    replaceAll(text, "\u22c5", " ");
    replaceAll(text, "*", " ");
    replaceAll(text, "\u00a0", " ");
    replaceAll(text, "\u202f", " ");
    replaceAll(text, "\u2009", " ");
    replaceAll(text, "\t", " ");
    const auto twoBlanks = [](char a, char b) { return a == ' ' && b == ' '; };
    text.erase(std::unique(text.begin(), text.end(), twoBlanks), text.end());
    return text;
}

/// Longer than any unit; anything beyond is no unit and not worth normalising.
constexpr std::size_t maximumUnitBytes = 32;

/// A typed text cut to what fits a message.
std::string quoted(std::string_view text) {
    return "`" + shortened(text) + "`";
}

TypedQuantity refused(Message problem) {
    return {0, nullptr, std::move(problem)};
}

/// "nan", ".inf", "-Infinity" and the like.
bool isNotFinite(std::string_view text) {
    const std::size_t word = text.find_first_not_of("+-.");
    if (word == std::string_view::npos) return false;
    std::string start(text.substr(word, 3));
    for (char& c : start) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return start == "nan" || start == "inf";
}

Message missingUnit(std::string_view number, Quantity quantity, const Unit* example) {
    const std::string_view unit = (example ? *example : unitsOf(quantity).front()).name;
    return {translatable("has no unit: write for example `%1 %2`; allowed units: %3"),
            {shortened(number), std::string(unit), unitList(quantity)}};
}

Message unknownUnit(std::string_view unit, Quantity quantity) {
    if (unit.front() == ',') return translatable("a decimal comma is not read here: write a decimal point");
    if (quantity == Quantity::ratio)
        return {translatable("must be a plain number: remove %1"), {quoted(unit)}};
    return {translatable("unit %1 is not known here; allowed units: %2"), {quoted(unit), unitList(quantity)}};
}

/// The shortest decimal text near si/factor that parseQuantity() turns into exactly `si`.
std::optional<std::string> textInInexactUnit(double si, const Unit& unit) {
    const double estimate = unit.fromSi(si);
    if (!std::isfinite(estimate)) return std::nullopt;
    std::array<char, 40> buffer{};
    for (int digits = 1; digits <= 17; ++digits) {
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), estimate,
                                       std::chars_format::general, digits);
        const std::string_view text(buffer.data(), end.ptr);
        const std::optional<double> value = parseNumber(text);
        if (value && unit.toSi(*value) == si) return formatNumber(*value);
    }
    // The rounded product skips some doubles; a neighbour of the quotient may still lead back.
    for (const double direction : {-HUGE_VAL, HUGE_VAL}) {
        double neighbour = estimate;
        for (int step = 0; step < 3; ++step) {
            neighbour = std::nextafter(neighbour, direction);
            if (unit.toSi(neighbour) == si) return formatNumber(neighbour);
        }
    }
    return std::nullopt;
}

std::string withUnit(const std::string& number, const Unit& unit) {
    return unit.name.empty() ? number : number + " " + std::string(unit.name);
}

}  // namespace

std::span<const Unit> unitsOf(Quantity quantity) {
    switch (quantity) {
        case Quantity::ratio:
            return ratioUnits;
        case Quantity::length:
            return lengthUnits;
        case Quantity::area:
            return areaUnits;
        case Quantity::stress:
            return stressUnits;
        case Quantity::density:
            return densityUnits;
        case Quantity::time:
            return timeUnits;
        case Quantity::impulse:
            return impulseUnits;
        case Quantity::force:
            return forceUnits;
        case Quantity::stiffness:
            return stiffnessUnits;
        case Quantity::velocity:
            return velocityUnits;
        case Quantity::frequency:
            return frequencyUnits;
        case Quantity::energy:
            return energyUnits;
        case Quantity::power:
            return powerUnits;
        case Quantity::mass:
            return massUnits;
        case Quantity::angle:
            return angleUnits;
        case Quantity::share:
            return shareUnits;
        case Quantity::attenuation:
            return attenuationUnits;
        case Quantity::damping:
            return dampingUnits;
    }
    return ratioUnits;
}

const Unit* findUnit(Quantity quantity, std::string_view name) {
    if (name.size() > maximumUnitBytes) return nullptr;
    std::string wanted = normalised(name);
    const auto spelling = std::ranges::find(spellings, std::string_view(wanted), &Spelling::written);
    if (spelling != spellings.end()) wanted = spelling->name;
    const std::span<const Unit> units = unitsOf(quantity);
    const auto found = std::ranges::find(units, std::string_view(wanted), &Unit::name);
    return found == units.end() ? nullptr : &*found;
}

std::string unitList(Quantity quantity) {
    std::string list;
    for (const Unit& unit : unitsOf(quantity)) {
        if (unit.name.empty() && unitsOf(quantity).size() > 1) continue;  // goes without saying
        if (!list.empty()) list += ", ";
        list += unit.name;
    }
    return list;
}

std::optional<double> parseNumber(std::string_view text) {
    if (hasWideCharacters(text)) {
        const std::string plain = withPlainSigns(text);
        return hasWideCharacters(plain) ? std::nullopt : parseNumber(plain);
    }
    text = trimmed(text);
    const std::size_t length = numberLength(text);
    if (length == 0 || length != text.size()) return std::nullopt;
    return scaledNumber(text, 0);
}

std::string formatNumber(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), end.ptr);
}

TypedQuantity parseQuantity(std::string_view text, Quantity quantity, BareNumber bare,
                            const Unit* defaultUnit) {
    std::string plain;
    if (hasWideCharacters(text)) text = plain = withPlainSigns(text);
    text = trimmed(text);
    if (text.empty()) return refused(translatable("is empty"));
    const std::size_t length = numberLength(text);
    if (length == 0)
        return refused(isNotFinite(text) ? translatable("must be a finite number")
                                         : translatable("is not a number"));
    const std::string_view number = text.substr(0, length);
    const std::string_view unitName = trimmed(text.substr(length));

    const bool inDefault = unitName.empty() && defaultUnit && bare == BareNumber::inDefaultUnit;
    const Unit* unit = inDefault ? defaultUnit : findUnit(quantity, unitName);
    const bool needsUnit = !unitsOf(quantity).front().name.empty();
    if (unitName.empty() && needsUnit && (bare == BareNumber::refused || !defaultUnit))
        return refused(missingUnit(number, quantity, defaultUnit));
    if (!unit) return refused(unknownUnit(unitName, quantity));

    const std::optional<double> value = scaledNumber(number, unit->decimalExponent.value_or(0));
    const double si = !value ? HUGE_VAL : unit->decimalExponent ? *value : unit->toSi(*value);
    if (!std::isfinite(si))
        return refused(translatable("is too large or too small for a number of double precision"));
    return {si, unit, {}};
}

std::string formatQuantity(double si, Quantity quantity, const Unit& unit) {
    if (unit.decimalExponent) return withUnit(shiftedNumber(si, -*unit.decimalExponent), unit);
    if (const std::optional<std::string> text = textInInexactUnit(si, unit)) return withUnit(*text, unit);
    return withUnit(formatNumber(si), unitsOf(quantity).front());
}

std::string withUnit(std::string_view name, const Unit* unit) {
    if (!unit || unit->name.empty()) return std::string(name);
    return std::string(name) + " [" + std::string(unit->name) + "]";
}

UnitHeading splitHeading(std::string_view heading) {
    heading = trimmed(heading);
    const std::size_t bracket = heading.find('[');
    if (bracket == std::string_view::npos || !heading.ends_with(']')) return {heading, {}};
    return {trimmed(heading.substr(0, bracket)),
            trimmed(heading.substr(bracket + 1, heading.size() - bracket - 2))};
}

}  // namespace drillwave

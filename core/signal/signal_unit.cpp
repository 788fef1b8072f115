// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/signal_unit.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/text/decimal_text.h"
#include "core/text/handy_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::array strainUnits{SignalUnit{"microstrain", 1e-6}, SignalUnit{"m/m", 1},
                                 SignalUnit{"mm/m", 1e-3}, SignalUnit{"%", 1e-2}};
constexpr std::array bridgeUnits{SignalUnit{"mV/V", 1e-3}, SignalUnit{"V/V", 1}, SignalUnit{"uV/V", 1e-6}};

constexpr std::array voltageUnits{SignalUnit{"V", 1}, SignalUnit{"mV", 1e-3}, SignalUnit{"uV", 1e-6}};
constexpr SignalUnit tonneForce{"tf", 9806.65};

using SignalSpelling = std::pair<std::string_view, std::string_view>;

/// Other spellings of units, after "µ" has become "u".
constexpr SignalSpelling unitSpellings[] = {{"ustrain", "microstrain"},
                                            {"um/m", "microstrain"},
                                            {"uε", "microstrain"},
                                            {"ue", "microstrain"},
                                            {"uS", "microstrain"},
                                            {"1e-6", "microstrain"},
                                            {"ppm", "microstrain"},
                                            {"ustr", "microstrain"},
                                            {"uD", "microstrain"},
                                            {"ε", "m/m"},
                                            {"mstrain", "mm/m"},
                                            {"mε", "mm/m"},
                                            {"KN", "kN"},
                                            {"MPA", "MPa"},
                                            {"N/mm2", "MPa"},
                                            {"N/mm^2", "MPa"},
                                            {"N/mm²", "MPa"},
                                            {"ton-force", "tf"},
                                            {"Mp", "tf"},
                                            {"t-f", "tf"},
                                            {"kp", "kgf"},
                                            {"lbs", "lbf"},
                                            {"klbf", "kip"},
                                            {"kips", "kip"},
                                            {"lb", "lbf"},
                                            {"fps", "ft/s"},
                                            {"m/sec", "m/s"},
                                            {"mm/sec", "mm/s"},
                                            {"in/in", "m/m"},
                                            {"mm/mm", "m/m"},
                                            {"ms^-1", "m/s"},
                                            {"m s^-1", "m/s"}};

/// Words for units, in small letters.
constexpr SignalSpelling unitWords[] = {{"microstrain", "microstrain"},
                                        {"microstrains", "microstrain"},
                                        {"mikrostrain", "microstrain"},
                                        {"micro strain", "microstrain"},
                                        {"mikrodehnung", "microstrain"},
                                        {"mikrotöjning", "microstrain"},
                                        {"strain", "m/m"},
                                        {"millistrain", "mm/m"},
                                        {"percent", "%"},
                                        {"volt", "V"},
                                        {"volts", "V"},
                                        {"voltage", "V"},
                                        {"spannung", "V"},
                                        {"spänning", "V"},
                                        {"millivolt", "mV"},
                                        {"millivolts", "mV"},
                                        {"microvolt", "uV"},
                                        {"microvolts", "uV"},
                                        {"mikrovolt", "uV"},
                                        {"newton", "N"},
                                        {"newtons", "N"},
                                        {"kilonewton", "kN"},
                                        {"kilonewtons", "kN"},
                                        {"meganewton", "MN"},
                                        {"pascal", "Pa"},
                                        {"megapascal", "MPa"},
                                        {"kilopond", "kgf"},
                                        {"tonf", "tf"},
                                        {"tonnef", "tf"},
                                        {"pound-force", "lbf"},
                                        {"mv/v", "mV/V"},
                                        {"kn", "kN"},
                                        {"mpa", "MPa"}};

/// Words for units of time, in small letters.
constexpr SignalSpelling timeWords[] = {{"second", "s"},
                                        {"seconds", "s"},
                                        {"sekunde", "s"},
                                        {"sekunden", "s"},
                                        {"sekund", "s"},
                                        {"sekunder", "s"},
                                        {"sec", "s"},
                                        {"secs", "s"},
                                        {"sek", "s"},
                                        {"sek.", "s"},
                                        {"sec.", "s"},
                                        {"millisecond", "ms"},
                                        {"milliseconds", "ms"},
                                        {"millisekunde", "ms"},
                                        {"millisekunden", "ms"},
                                        {"millisekund", "ms"},
                                        {"millisekunder", "ms"},
                                        {"msek", "ms"},
                                        {"msec", "ms"},
                                        {"microsecond", "us"},
                                        {"microseconds", "us"},
                                        {"mikrosekunde", "us"},
                                        {"mikrosekunden", "us"},
                                        {"mikrosekund", "us"},
                                        {"mikrosekunder", "us"},
                                        {"usec", "us"},
                                        {"microsec", "us"},
                                        {"usek", "us"},
                                        {"nanosecond", "ns"},
                                        {"nanoseconds", "ns"},
                                        {"nanosekunden", "ns"},
                                        {"nanosekunder", "ns"},
                                        {"nsec", "ns"},
                                        {"minute", "min"},
                                        {"minutes", "min"},
                                        {"minuten", "min"},
                                        {"minuter", "min"}};

/// Units of rates in Hz, in small letters but for their prefix.
constexpr std::pair<std::string_view, double> rateUnits[] = {{"Hz", 1},
                                                             {"kHz", 1e3},
                                                             {"KHz", 1e3},
                                                             {"MHz", 1e6},
                                                             {"GHz", 1e9},
                                                             {"hz", 1},
                                                             {"khz", 1e3},
                                                             {"1/s", 1},
                                                             {"1/ms", 1e3},
                                                             {"1/us", 1e6},
                                                             {"S/s", 1},
                                                             {"kS/s", 1e3},
                                                             {"KS/s", 1e3},
                                                             {"MS/s", 1e6},
                                                             {"GS/s", 1e9},
                                                             {"Sa/s", 1},
                                                             {"kSa/s", 1e3},
                                                             {"KSa/s", 1e3},
                                                             {"MSa/s", 1e6},
                                                             {"GSa/s", 1e9},
                                                             {"sps", 1},
                                                             {"SPS", 1},
                                                             {"kSPS", 1e3},
                                                             {"MSPS", 1e6},
                                                             {"ksps", 1e3},
                                                             {"Msps", 1e6},
                                                             {"s/s", 1},
                                                             {"s^-1", 1},
                                                             {"samples/s", 1},
                                                             {"Samples/s", 1},
                                                             {"samples/sec", 1},
                                                             {"Samples/sec", 1},
                                                             {"samples/second", 1},
                                                             {"Samples/second", 1},
                                                             {"Hertz", 1},
                                                             {"hertz", 1},
                                                             {"kilohertz", 1e3},
                                                             {"Kilohertz", 1e3},
                                                             {"megahertz", 1e6},
                                                             {"Megahertz", 1e6},
                                                             {"S/sec", 1}};

/// Without blanks around it, and "µ" of either kind as "u".
std::string plainUnit(std::string_view name) {
    std::string text(trimmed(withPlainSigns(name)));
    for (const std::string_view micro : {"\u00b5", "\u03bc"})
        for (std::size_t at = text.find(micro); at != std::string::npos; at = text.find(micro))
            text.replace(at, micro.size(), "u");
    return text;
}

constexpr std::size_t longestUnit = 32;

std::optional<std::string_view> spelled(std::span<const SignalSpelling> table, std::string_view name) {
    const auto found = std::ranges::find(table, name, &SignalSpelling::first);
    return found == table.end() ? std::nullopt : std::optional(found->second);
}

/// The name as the tables have it.
std::string tableName(std::string_view name) {
    const std::string plain = plainUnit(name);
    if (const auto known = spelled(unitSpellings, plain)) return std::string(*known);
    if (const auto known = spelled(unitWords, lowerCase(plain)); known && plain.size() > 1)
        return std::string(*known);
    return plain;
}

const SignalUnit* named(std::span<const SignalUnit> units, std::string_view name) {
    const auto found = std::ranges::find(units, name, &SignalUnit::name);
    return found == units.end() ? nullptr : &*found;
}

std::vector<SignalUnit> unitsFrom(Quantity quantity) {
    std::vector<SignalUnit> units;
    for (const Unit& unit : unitsOf(quantity)) units.push_back({unit.name, unit.factor()});
    return units;
}

bool isTimeUnit(std::string_view word) {
    return findTimeUnit(word) && word != "min";  // a minimum
}

/// Whether a last word without brackets is a unit, and no word of the name: "strain", "ε".
bool isUnitWord(std::string_view word) {
    if (isTimeUnit(word)) return true;
    const std::optional<NamedSignalUnit> found = findSignalUnit(word);
    if (word == "bar") return false;  // "incident bar"
    return found && (found->kind != SignalKind::strain || found->unit.name == word ||
                     word.find_first_of("/%") != std::string_view::npos || word.starts_with("\u00b5") ||
                     word.starts_with("\u03bc"));
}

/// Whether "name/unit" and "name_unit" are that, and not a rate such as "m/s".
bool isUnitBehind(std::string_view name, std::string_view unit) {
    if (name.empty() || !isUnitWord(unit)) return false;
    return !isTimeUnit(unit) || isTimeName(name);
}

TableColumn parts(std::string_view name, std::string_view unit) {
    return {std::string(trimmed(name)), std::string(trimmed(unit)), false};
}

}  // namespace

std::vector<SignalUnit> signalUnits(SignalKind kind) {
    switch (kind) {
        case SignalKind::strain:
            return {strainUnits.begin(), strainUnits.end()};
        case SignalKind::bridge:
            return {bridgeUnits.begin(), bridgeUnits.end()};
        case SignalKind::voltage:
            return {voltageUnits.begin(), voltageUnits.end()};
        case SignalKind::stress:
            return unitsFrom(Quantity::stress);
        case SignalKind::velocity:
            return unitsFrom(Quantity::velocity);
        case SignalKind::force:
            break;
    }
    std::vector<SignalUnit> units = unitsFrom(Quantity::force);
    units.push_back(tonneForce);
    return units;
}

std::optional<NamedSignalUnit> findSignalUnit(std::string_view written) {
    if (written.empty() || written.size() > longestUnit) return std::nullopt;
    const std::string name = tableName(written);
    if (const Unit* unit = findUnit(Quantity::force, name))
        return NamedSignalUnit{SignalKind::force, {unit->name, unit->factor()}};
    if (name == tonneForce.name) return NamedSignalUnit{SignalKind::force, tonneForce};
    if (const SignalUnit* unit = named(strainUnits, name)) return NamedSignalUnit{SignalKind::strain, *unit};
    if (const SignalUnit* unit = named(bridgeUnits, name)) return NamedSignalUnit{SignalKind::bridge, *unit};
    if (const SignalUnit* unit = named(voltageUnits, name))
        return NamedSignalUnit{SignalKind::voltage, *unit};
    if (const Unit* unit = findUnit(Quantity::stress, name))
        return NamedSignalUnit{SignalKind::stress, {unit->name, unit->factor()}};
    if (const Unit* unit = findUnit(Quantity::velocity, name))
        return NamedSignalUnit{SignalKind::velocity, {unit->name, unit->factor()}};
    return std::nullopt;
}

std::optional<double> findTimeUnit(std::string_view written) {
    if (written.empty() || written.size() > longestUnit) return std::nullopt;
    std::string name = plainUnit(written);
    if (const auto word = spelled(timeWords, lowerCase(name))) name = *word;
    const Unit* unit = findUnit(Quantity::time, name);
    return unit ? std::optional(unit->factor()) : std::nullopt;
}

std::optional<double> findRateUnit(std::string_view written) {
    if (written.empty() || written.size() > longestUnit) return std::nullopt;
    const std::string name = plainUnit(written);
    const auto found =
        std::ranges::find(rateUnits, std::string_view(name), &std::pair<std::string_view, double>::first);
    return found == std::end(rateUnits) ? std::nullopt : std::optional(found->second);
}

std::string rateText(double rate) {
    constexpr int digits = 6;
    for (const auto& [name, factor] : {std::pair{" GHz", 1e9}, {" MHz", 1e6}, {" kHz", 1e3}})
        if (rate >= factor) return rounded(rate / factor, digits) + name;
    return rounded(rate, digits) + " Hz";
}

double forcePerNumber(SignalKind kind, double unitFactor, const GaugedBar& bar) {
    const double perStrain = 4 / (bar.gaugeFactor * bar.activeGauges);
    switch (kind) {
        case SignalKind::force:
            return unitFactor;
        case SignalKind::strain:
            return bar.axialStiffness * unitFactor;
        case SignalKind::bridge:
            return bar.axialStiffness * unitFactor * perStrain;
        case SignalKind::voltage:
            if (bar.forcePerVolt != 0) return bar.forcePerVolt * unitFactor;
            return bar.axialStiffness * unitFactor / (bar.gain * bar.excitation) * perStrain;
        case SignalKind::stress:
            return bar.area * unitFactor;
        case SignalKind::velocity:
            return bar.impedance * unitFactor;
    }
    return unitFactor;
}

bool isKnownUnit(std::string_view word) {
    return findTimeUnit(word) || findSignalUnit(word);
}

namespace {

/// Brackets in a heading: what is in them, and what is around.
struct Bracketed {
    std::string name;
    std::string_view unit;
    bool isLast = false;
};

/// All of them, from the last to the first.
std::vector<Bracketed> bracketsOf(std::string_view cell) {
    std::vector<Bracketed> found;
    constexpr auto npos = std::string_view::npos;
    for (std::size_t end = cell.find_last_of("])"); end != npos && end > 0;
         end = cell.find_last_of("])", end - 1)) {
        const std::size_t begin = cell.rfind(cell[end] == ']' ? '[' : '(', end);
        if (begin == npos) continue;
        const std::string_view before = trimmed(cell.substr(0, begin)),
                               behind = trimmed(cell.substr(end + 1));
        std::string name(before);
        if (!before.empty() && !behind.empty()) name += ' ';
        name += behind;
        found.push_back({name, trimmed(cell.substr(begin + 1, end - begin - 1)), behind.empty()});
    }
    return found;
}

}  // namespace

TableColumn columnOf(std::string_view heading) {
    constexpr auto npos = std::string_view::npos;
    const std::string plain = hasWideCharacters(heading) ? withPlainSigns(heading) : std::string(heading);
    const std::string_view cell = trimmed(plain);
    const std::vector<Bracketed> brackets = bracketsOf(cell);
    for (const Bracketed& bracket : brackets)
        if (isKnownUnit(bracket.unit)) return parts(bracket.name, bracket.unit);
    for (const Bracketed& bracket : brackets)
        if (bracket.isLast) return parts(bracket.name, bracket.unit);
    for (const std::string_view word : {" / ", " in ", " i "})
        if (const std::size_t at = cell.rfind(word);
            at != npos && (word != " i " || isUnitWord(trimmed(cell.substr(at + word.size())))))
            return parts(cell.substr(0, at), cell.substr(at + word.size()));
    for (const char sign : {',', ':', ';'})
        if (const std::size_t at = cell.rfind(sign); at != npos && isUnitWord(trimmed(cell.substr(at + 1))))
            return parts(cell.substr(0, at), cell.substr(at + 1));
    if (const std::size_t blank = cell.rfind(' '); blank != npos && isUnitWord(cell.substr(blank + 1)))
        return parts(cell.substr(0, blank), cell.substr(blank + 1));
    // A unit has slashes itself, a name has underscores: "strain/µm/m", "gauge_1_kN".
    for (const std::size_t at : {cell.find('/'), cell.rfind('/'), cell.rfind('_')})
        if (at != npos && isUnitBehind(cell.substr(0, at), cell.substr(at + 1)))
            return parts(cell.substr(0, at), cell.substr(at + 1));
    return parts(cell, {});
}

bool isTimeName(std::string_view name) {
    const std::string lower = lowerCase(std::string(name));
    const std::string_view beginnings[] = {"time",   "zeit",      "tid",         "x_value", "x-axis",
                                           "x axis", "timestamp", "zeitstempel", "t(",      "t [",
                                           "t_",     "elapsed",   "date",        "datum"};
    return lower == "t" || lower == "x" || std::ranges::any_of(beginnings, [&](std::string_view beginning) {
               return lower.starts_with(beginning);
           });
}

}  // namespace drillwave

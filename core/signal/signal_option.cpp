// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/signal_option.h"

#include <algorithm>

#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr std::pair<std::string_view, char> separatorWords[] = {
    {"tab", '\t'}, {"\\t", '\t'}, {"\t", '\t'},   {"comma", ','}, {",", ','}, {"semicolon", ';'}, {";", ';'},
    {"bar", '|'},  {"|", '|'},    {"blank", ' '}, {"space", ' '}, {" ", ' '}, {"blanks", ' '}};

Message setSeparator(SignalOptions& options, std::string_view text) {
    for (const auto& [word, separator] : separatorWords)
        if (word == text) {
            options.separator = separator;
            return {};
        }
    return translatable("must be one of tab, semicolon, comma, bar, blank");
}

Message setDecimal(SignalOptions& options, std::string_view text) {
    if (text != "point" && text != "comma" && text != "." && text != ",")
        return translatable("must be point or comma");
    options.decimal = text == "point" || text == "." ? DecimalSign::point : DecimalSign::comma;
    return {};
}

Message setFirstLine(SignalOptions& options, std::string_view text) {
    options.firstLine = wholeNumberIn<std::size_t>(text);
    constexpr std::size_t most = 1'000'000'000;
    if (!options.firstLine || *options.firstLine == 0 || *options.firstLine > most)
        return wholeNumberProblem<std::size_t>(1, most);
    return {};
}

Message setEncoding(SignalOptions& options, std::string_view text) {
    const std::optional<TextEncoding> found = findEncoding(text);
    if (!found) return translatable("must be one of utf-8, windows-1252, latin-1, utf-16le, utf-16be");
    options.encoding = *found;
    return {};
}

Message setColumn(std::string& column, std::string_view text) {
    if (trimmed(text).empty()) return translatable("must be the name of a column, or its number from 1");
    column = trimmed(text);
    return {};
}

Message setTimeUnit(SignalOptions& options, std::string_view text) {
    options.timeUnit = findTimeUnit(text);
    if (options.timeUnit) return {};
    return {translatable("must be a unit of time, one of %1"), {unitList(Quantity::time)}};
}

Message setUnit(SignalOptions& options, std::string_view text) {
    options.unit = findSignalUnit(text);
    if (options.unit) return {};
    std::string list;
    for (const SignalKind kind : {SignalKind::force, SignalKind::strain, SignalKind::bridge,
                                  SignalKind::voltage, SignalKind::stress, SignalKind::velocity})
        for (const SignalUnit& unit : signalUnits(kind))
            list += (list.empty() ? "" : ", ") + std::string(unit.name);
    return {translatable("must be a unit of a signal, one of %1"), {list}};
}

/// A quantity above 0, a bare number where there is a unit for it.
Message setPositive(std::optional<double>& value, std::string_view text, Quantity quantity, const char* unit,
                    BareNumber bare = BareNumber::refused) {
    const TypedQuantity typed = parseQuantity(text, quantity, bare, findUnit(quantity, unit));
    if (!typed.valid()) return typed.problem;
    if (!(typed.si > 0)) return translatable("must be above 0");
    value = typed.si;
    return {};
}

Message setNumber(std::optional<double>& value, std::string_view text) {
    return setPositive(value, text, Quantity::ratio, "");
}

Message setExcitation(SignalOptions& options, std::string_view text) {
    std::string_view number = trimmed(text);
    double factor = 1;
    if (number.ends_with("mV"))
        factor = 1e-3, number.remove_suffix(2);
    else if (number.ends_with('V'))
        number.remove_suffix(1);
    const Message problem = setNumber(options.excitation, number);
    if (problem.isEmpty()) *options.excitation *= factor;
    return problem;
}

Message setRate(SignalOptions& options, std::string_view text) {
    const std::string plain = withPlainSigns(text);
    const std::string_view typed = trimmed(plain);
    const std::size_t length = numberLength(typed);
    if (const auto unit = findRateUnit(typed.substr(length)); unit && length > 0) {
        const std::optional<double> value = parseNumber(typed.substr(0, length));
        if (value && *value > 0) {
            options.rate = *value * *unit;
            return {};
        }
    }
    return setPositive(options.rate, text, Quantity::frequency, "kHz");
}

Message setTime(std::optional<double>& time, std::string_view text) {
    const TypedQuantity typed =
        parseQuantity(text, Quantity::time, BareNumber::refused, findUnit(Quantity::time, "us"));
    if (typed.valid()) time = typed.si;
    return typed.problem;
}

Message setZero(SignalOptions& options, std::string_view text) {
    const std::size_t colon = text.find(':');
    std::optional<double> from, to;
    if (colon == std::string_view::npos) return translatable("must be two times A:B, as in -50us:-10us");
    if (const Message problem = setTime(from, text.substr(0, colon)); !problem.isEmpty()) return problem;
    if (const Message problem = setTime(to, text.substr(colon + 1)); !problem.isEmpty()) return problem;
    if (!(*from < *to)) return translatable("the first time must be before the second one");
    options.zero = {*from, *to};
    return {};
}

Message setScale(SignalOptions& options, std::string_view text) {
    options.scale = parseScale(text);
    if (options.scale) return {};
    return translatable("must be a factor that is not 0, or a force per unit: 2.5, 50kN/V, 18kN s/m");
}

Message setRows(SignalOptions& options, std::string_view text) {
    if (text != "refuse" && text != "skip") return translatable("must be refuse or skip");
    options.wrongRows = text == "skip" ? WrongRows::skipped : WrongRows::refused;
    return {};
}

constexpr SignalOption readingOptions[] = {
    {"separator", "SIGN",
     "sign between the columns of the table: tab, semicolon, comma, bar (|) or blank (default: detected)",
     setSeparator},
    {"decimal", "SIGN", "decimal sign of the table: point or comma (default: detected)", setDecimal},
    {"first-line", "N", "number of the first line with a sample (default: detected)", setFirstLine},
    {"encoding", "NAME",
     "character encoding of the table: utf-8, windows-1252, latin-1, utf-16le or utf-16be (default: "
     "detected)",
     setEncoding},
    {"time", "COLUMN", "column of the times, by name or by number from 1",
     [](SignalOptions& options, std::string_view text) { return setColumn(options.timeColumn, text); }},
    {"signal-column", "COLUMN",
     "column of the signal, by name or by number from 1; A+B takes the mean of two gauges on opposite sides",
     [](SignalOptions& options, std::string_view text) { return setColumn(options.signalColumn, text); }},
    {"time-unit", "UNIT", "unit of the times, if the table does not state it: s, ms, us", setTimeUnit},
    {"unit", "UNIT", "unit of the signal, if the table does not state it: kN, microstrain, V, MPa, m/s",
     setUnit},
    {"rate", "RATE", "sampling rate, such as 5MHz, used instead of a time column", setRate},
    {"scale", "S", "multiply the signal by this factor, or by a force per unit: 50kN/V, 18kN s/m", setScale},
    {"gain", "G", "gain of the amplifier, for a signal in volts (default: 1)",
     [](SignalOptions& options, std::string_view text) { return setNumber(options.gain, text); }},
    {"excitation", "V", "supply voltage of the bridge in volts, for a signal in volts", setExcitation},
    {"bridge", "B",
     "bridge factor of the strain gauges: 1 (quarter bridge), 2 (half bridge), 4 (full bridge) or 2.6 (full "
     "bridge with Poisson gauges)",
     [](SignalOptions& options, std::string_view text) { return setNumber(options.bridge, text); }},
    {"gauge-factor", "K", "gauge factor of the strain gauges, for a signal in volts or mV/V",
     [](SignalOptions& options, std::string_view text) { return setNumber(options.gaugeFactor, text); }},
    {"area", "A", "cross-section of the bar at the gauge, such as 1134mm^2",
     [](SignalOptions& options, std::string_view text) {
         return setPositive(options.area, text, Quantity::area, "mm^2");
     }},
    {"modulus", "E", "Young's modulus of the bar that carries the gauge, such as 210GPa",
     [](SignalOptions& options, std::string_view text) {
         return setPositive(options.modulus, text, Quantity::stress, "GPa");
     }},
    {"zero", "A:B", "time range in which the signal is zero on average, such as -50us:-10us", setZero},
    {"from", "T", "ignore samples earlier than this time in the table, such as 0us",
     [](SignalOptions& options, std::string_view text) { return setTime(options.from, text); }},
    {"to", "T", "ignore samples later than this time in the table, such as 400us",
     [](SignalOptions& options, std::string_view text) { return setTime(options.to, text); }},
    {"invert", "", "reverse the sign of the signal: its largest value is tension (default: compression)",
     [](SignalOptions& options, std::string_view) {
         options.invert = true;
         return Message();
     }},
    {"rows", "WHAT",
     "treatment of rows in which a value is not a number: refuse the table, or skip these rows (default: "
     "refuse)",
     setRows},
};

}  // namespace

std::span<const SignalOption> signalOptions() {
    return readingOptions;
}

const SignalOption* findSignalOption(std::string_view name) {
    const auto found = std::ranges::find(readingOptions, name, &SignalOption::name);
    return found == std::end(readingOptions) ? nullptr : &*found;
}

std::vector<std::pair<std::string, std::string>> recorderSettings(const SignalOptions& options) {
    std::vector<std::pair<std::string, std::string>> settings;
    const auto add = [&](const char* name, std::string value) {
        settings.emplace_back(name, std::move(value));
    };
    const auto addNumber = [&](const char* name, const std::optional<double>& value, const char* unit = "") {
        if (value) add(name, formatNumber(*value) + unit);
    };
    if (options.separator)
        for (const auto& [word, separator] : separatorWords)
            if (separator == *options.separator) {
                add("separator", std::string(word));
                break;
            }
    if (options.decimal) add("decimal", *options.decimal == DecimalSign::comma ? "comma" : "point");
    if (options.firstLine) add("first-line", std::to_string(*options.firstLine));
    if (options.encoding != TextEncoding::found) add("encoding", std::string(name(options.encoding)));
    if (!options.timeColumn.empty()) add("time", options.timeColumn);
    if (!options.signalColumn.empty()) add("signal-column", options.signalColumn);
    if (options.timeUnit)
        for (const Unit& unit : unitsOf(Quantity::time))
            if (unit.factor() == *options.timeUnit) {
                add("time-unit", std::string(unit.name));
                break;
            }
    if (options.unit) add("unit", std::string(options.unit->unit.name));
    addNumber("rate", options.rate, "Hz");
    if (options.scale) {
        const bool isImpedance = options.unit && options.unit->kind == SignalKind::velocity;
        add("scale", formatNumber(options.scale->factor) + (!options.scale->isPerUnit ? ""
                                                            : isImpedance             ? "N s/m"
                                                                                      : "N/V"));
    }
    addNumber("gain", options.gain);
    addNumber("excitation", options.excitation, "V");
    addNumber("bridge", options.bridge);
    addNumber("gauge-factor", options.gaugeFactor);
    addNumber("area", options.area, "m^2");
    addNumber("modulus", options.modulus, "Pa");
    if (options.wrongRows == WrongRows::skipped) add("rows", "skip");
    return settings;
}

std::string_view answerTo(std::string_view question) {
    constexpr std::pair<std::string_view, std::string_view> answers[] = {{"unit", "--unit"},
                                                                         {"rate", "--rate"},
                                                                         {"time_unit", "--time-unit"},
                                                                         {"column", "--signal-column"},
                                                                         {"decimal", "--decimal"},
                                                                         {"area", "--area"},
                                                                         {"modulus", "--modulus"},
                                                                         {"bridge", "--bridge"},
                                                                         {"gauge_factor", "--gauge-factor"},
                                                                         {"impedance", "--scale"}};
    for (const auto& [asked, answer] : answers)
        if (asked == question) return answer;
    return {};
}

}  // namespace drillwave

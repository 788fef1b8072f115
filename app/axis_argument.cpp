// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/axis_argument.h"

#include <utility>

#include "app/command_error.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// Most levels: each is a search of its own.
constexpr std::size_t mostLevels = 100;

SweepAxis checked(ParsedAxis parsed, const std::string& option) {
    if (parsed.problem.isEmpty()) return std::move(parsed.axis);
    // A value that the parameter cannot take is like one in a file; anything else is a mistyped command.
    const bool badValue = parsed.kind == ParsedAxis::Kind::badValue;
    throw CommandError(badValue ? ExitCode::invalidScenario : ExitCode::usage,
                       about("--" + option, parsed.problem));
}

}  // namespace

SweepAxis axisArgument(const std::string& option, const std::string& word) {
    return checked(parseAxis(word), option);
}

SweepAxis axisOrPresetsArgument(const std::string& option, const std::string& word, const Scenario& scenario,
                                const PresetLookup& presets) {
    return checked(parseAxisOrPresets(word, scenario, presets), option);
}

SweepAxis rangeArgument(const std::string& option, const std::string& word) {
    ParsedAxis parsed = parseRange(word);
    if (parsed.axis.count == 2 && parsed.axis.start > parsed.axis.stop) {
        std::swap(parsed.axis.start, parsed.axis.stop);
        parsed.problem = followProblem(parsed.axis);
    }
    return checked(std::move(parsed), option);
}

std::string quotedAxis(const std::string& option, const std::string& word) {
    return "--" + option + " " + shortened(word);
}

double quantityArgument(const std::string& option, const std::string& word, Quantity quantity) {
    const TypedQuantity typed =
        parseQuantity(word, quantity, BareNumber::inDefaultUnit, &unitsOf(quantity).front());
    if (!typed.valid()) throw CommandError(ExitCode::usage, about(quotedAxis(option, word), typed.problem));
    return typed.si;
}

std::vector<double> levelArguments(const Arguments& arguments, Quantity quantity) {
    std::vector<double> levels;
    for (const std::string& word : arguments.values("level"))
        levels.push_back(quantityArgument("level", word, quantity));
    if (levels.size() > mostLevels)
        throw CommandError(ExitCode::usage,
                           Message(translatable("--level: at most %1 levels"), {std::to_string(mostLevels)}));
    return levels;
}

RecordedAxis recordedAxis(const SweepAxis& axis, const std::string& word) {
    return {axis.column().header, word.substr(word.find('=') + 1), axis.count};
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/sweep_axis.h"

#include <algorithm>
#include <cmath>

#include "core/model/law_parameter.h"
#include "core/model/parameter_text.h"
#include "core/text/decimal_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(trimmed(text.substr(0, at)));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

/// Takes the form of the first value: numbers in scales of the blow have no unit in a dimensionless
/// scenario.
void takeForm(SweepAxis& axis, std::string_view text) {
    if (axis.unit) return;
    const KeptParameter other = inScales(*axis.parameter);
    if (other && parseQuantity(text, Quantity::ratio, BareNumber::refused, nullptr).valid())
        axis.parameter = other;
}

/// Reads a value of the axis; a problem for what is no value or out of range.
Message readValue(ParsedAxis& parsed, std::string_view text, double& value) {
    SweepAxis& axis = parsed.axis;
    takeForm(axis, text);
    const Parameter& parameter = *axis.parameter;
    const TypedQuantity typed =
        parseQuantity(text, parameter.quantity, BareNumber::refused, &parameter.displayUnit());
    parsed.kind = ParsedAxis::Kind::badValue;
    if (!typed.valid()) return refusedValue(parameter.key, text, typed.problem);
    const bool sameUnit = !axis.unit || axis.unit == typed.unit;
    axis.unit = sameUnit ? typed.unit : &unitsOf(parameter.quantity).front();
    value = typed.si;
    const Message problem = rangeProblem(parameter, value);
    if (!problem.isEmpty()) return refusedValue(parameter.key, text, problem);
    parsed.kind = ParsedAxis::Kind::badText;
    return {};
}

/// The way from a (position 0) to b (position last). Weights rather than steps, so that 1 to 10 in ten steps
/// gives whole numbers and 0.1 to 0.5 in five gives 0.2.
double between(double a, double b, double position, double last) {
    const double sum = a * (last - position) + b * position;
    return std::isfinite(sum) ? sum / last : a * ((last - position) / last) + b * (position / last);
}

Message readCount(SweepAxis& axis, std::string_view text) {
    axis.count = wholeNumberIn<decltype(axis.count)>(text).value_or(0);
    if (axis.count >= 1 && axis.count <= maximumSweepPoints) return {};
    return {translatable("the count `%1` of %2 must be a whole number from 1 to %3"),
            {shortened(text), std::string(axis.key()), std::to_string(maximumSweepPoints)}};
}

/// START, STOP and, as the last of `parts`, perhaps `log`.
Message readEnds(ParsedAxis& parsed, const std::vector<std::string_view>& parts, std::size_t last) {
    SweepAxis& axis = parsed.axis;
    if (parts.size() == last + 2 && parts.back() != "log")
        return {last == 1 ? translatable("unknown suffix `%1` after the range of %2; only `log` is allowed")
                          : translatable("unknown suffix `%1` after the count of %2; only `log` is allowed"),
                {shortened(parts.back()), std::string(axis.key())}};
    axis.kind = parts.size() == last + 2 ? SweepAxis::Kind::logarithmic : SweepAxis::Kind::linear;
    if (Message problem = readValue(parsed, parts[0], axis.start); !problem.isEmpty()) return problem;
    if (Message problem = readValue(parsed, parts[1], axis.stop); !problem.isEmpty()) return problem;
    return {};
}

Message logarithmProblem(const SweepAxis& axis) {
    if (axis.kind != SweepAxis::Kind::logarithmic || (axis.start > 0 && axis.stop > 0)) return {};
    return {translatable("a logarithmic axis of %1 must begin and end above 0"), {std::string(axis.key())}};
}

/// Each value of the axis of a whole number must be one.
Message wholeNumberProblem(const SweepAxis& axis) {
    if (!axis.parameter->rules.wholeNumber) return {};
    const double most = axis.parameter->hard.high - axis.parameter->hard.low + 1;
    const Message advice{
        translatable("%1 takes only whole numbers; give a COUNT that hits them, or a list A,B,C"),
        {std::string(axis.key())}};
    if (static_cast<double>(axis.count) > most) return advice;
    for (std::uint64_t i = 0; i < axis.count; ++i)
        if (!rangeProblem(*axis.parameter, axis.value(i)).isEmpty()) return advice;
    return {};
}

Message spacingProblem(const SweepAxis& axis) {
    const Message problem = logarithmProblem(axis);
    return problem.isEmpty() ? wholeNumberProblem(axis) : problem;
}

/// The count may lack where one is assumed.
Message readRange(ParsedAxis& parsed, const std::vector<std::string_view>& parts,
                  std::optional<std::uint64_t> assumedCount) {
    SweepAxis& axis = parsed.axis;
    if (assumedCount && (parts.size() == 2 || (parts.size() == 3 && parts[2] == "log"))) {
        if (Message problem = readEnds(parsed, parts, 1); !problem.isEmpty()) return problem;
        axis.count = countWithin(*axis.parameter, axis.start, axis.stop, *assumedCount);
        return spacingProblem(axis);
    }
    if (parts.size() < 3 || parts.size() > 4)
        return {translatable("%1 needs START:STOP:COUNT, START:STOP:COUNT:log or a list A,B,C"),
                {std::string(axis.key())}};
    if (Message problem = readEnds(parsed, parts, 2); !problem.isEmpty()) return problem;
    if (Message problem = readCount(axis, parts[2]); !problem.isEmpty()) return problem;
    return spacingProblem(axis);
}

Message followedForm(std::string_view key) {
    return {translatable("%1 needs START:STOP or START:STOP:log"), {std::string(key)}};
}

Message wordsProblem(const WordParameter& words) {
    return {words.key == pulseShapeKey ? translatable("%1 has no numeric values; use a family of shapes")
                                       : translatable("%1 has no numeric values; use a family of words"),
            {std::string(words.key)}};
}

Message readFollowedRange(ParsedAxis& parsed, const std::vector<std::string_view>& parts) {
    SweepAxis& axis = parsed.axis;
    if (parts.size() < 2 || parts.size() > 3) return followedForm(axis.key());
    if (Message problem = readEnds(parsed, parts, 1); !problem.isEmpty()) return problem;
    axis.count = 2;
    return followProblem(axis);
}

Message readList(ParsedAxis& parsed, const std::vector<std::string_view>& items) {
    SweepAxis& axis = parsed.axis;
    axis.count = items.size();
    for (const std::string_view item : items) {
        double value = 0;
        if (Message problem = readValue(parsed, item, value); !problem.isEmpty()) return problem;
        axis.list.push_back(value);
    }
    return {};
}

Message readWords(ParsedAxis& parsed, const std::vector<std::string_view>& items) {
    SweepAxis& axis = parsed.axis;
    axis.kind = SweepAxis::Kind::words;
    axis.count = items.size();
    const auto words = axis.words->words();
    for (const std::string_view item : items) {
        const auto found = std::ranges::find(words, item);
        if (found == words.end()) {
            parsed.kind = ParsedAxis::Kind::badValue;
            return refusedValue(axis.key(), item, {translatable("must be one of %1"), {axis.words->list()}});
        }
        axis.list.push_back(static_cast<double>(found - words.begin()));
    }
    return {};
}

/// KEY and what stands behind its sign; without one it is `noAxis`, which says the forms that there are.
Message readKey(ParsedAxis& parsed, std::string_view text, std::string_view& values, const char* noAxis) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return {noAxis, {shortened(text)}};
    const std::string_view key = trimmed(text.substr(0, equals));
    values = text.substr(equals + 1);
    parsed.axis.parameter = findParameter(key);
    parsed.axis.words = findWordParameter(key);
    if (parsed.axis.parameter || parsed.axis.words) return {};
    if (key == restrikeKey)
        return {translatable("%1 is true or false, so it cannot be an axis; give it with --set"),
                {std::string(key)}};
    if (findPresetPart(key))
        return {translatable("`%1` names presets, not a parameter; `sweep --vary %1=all` compares them"),
                {std::string(key)}};
    return notAParameter(key);
}

Message readAxis(ParsedAxis& parsed, std::string_view text, std::optional<std::uint64_t> assumedCount) {
    std::string_view values;
    if (Message problem = readKey(
            parsed, text, values,
            translatable(
                "`%1` is not an axis: write KEY=START:STOP:COUNT, KEY=START:STOP:COUNT:log or KEY=A,B,C"));
        !problem.isEmpty())
        return problem;
    if (!parsed.axis.parameter) return readWords(parsed, split(values, ','));
    if (values.find(':') != std::string_view::npos)
        return readRange(parsed, split(values, ':'), assumedCount);
    return readList(parsed, split(values, ','));
}

Message readFollowedAxis(ParsedAxis& parsed, std::string_view text) {
    std::string_view values;
    if (Message problem =
            readKey(parsed, text, values,
                    translatable("`%1` is not an axis: write KEY=START:STOP or KEY=START:STOP:log"));
        !problem.isEmpty())
        return problem;
    if (!parsed.axis.parameter) return wordsProblem(*parsed.axis.words);
    return readFollowedRange(parsed, split(values, ':'));
}

}  // namespace

RowColumn SweepAxis::column() const {
    if (kind == Kind::words)
        return {.header = std::string(key()), .kind = RowColumn::Kind::word, .words = words->words()};
    if (kind == Kind::presets)
        return {.header = std::string(key()), .kind = RowColumn::Kind::word, .words = presets->words()};
    const Quantity quantity = parameter->quantity;
    const bool hasUnit = quantity != Quantity::ratio;
    return {.header = withUnit(key(), unit),
            .kind = hasUnit ? RowColumn::Kind::quantity : RowColumn::Kind::number,
            .quantity = quantity,
            .unit = unit};
}

std::string_view SweepAxis::key() const {
    if (presets) return name(presets->part());
    return parameter ? parameter->key : words->key;
}

double SweepAxis::value(std::uint64_t i) const {
    if (kind == Kind::list || kind == Kind::words || kind == Kind::presets) return list[i];
    if (i == 0) return start;
    if (i + 1 == count) return stop;
    const double position = static_cast<double>(i);
    const double last = static_cast<double>(count - 1);
    const double a = unit->fromSi(start);
    const double b = unit->fromSi(stop);
    if (kind == Kind::linear) return unit->toSi(between(a, b, position, last));
    return unit->toSi(std::pow(10.0, between(std::log10(a), std::log10(b), position, last)));
}

std::pair<double, double> SweepAxis::range(double room) const {
    const auto [low, high] = std::ranges::minmax(list.empty() ? std::vector{start, stop} : list);
    const double alone = low == 0 ? 1 : std::abs(low) / 20, step = room * (high - low);
    if (low == high) return {low - alone, high + alone};
    const double ratio = isLogarithmic() ? std::pow(high / low, room) : 1;
    return isLogarithmic() ? std::pair(low / ratio, high * ratio) : std::pair(low - step, high + step);
}

Message SweepAxis::assign(Scenario& scenario, double value) const {
    if (presets) {
        const Message problem =
            replacePart(scenario, presets->part(), presets->presets()[static_cast<std::size_t>(value)]);
        return problem.isEmpty() ? problem : Message("%1: %2", {std::string(key()), problem});
    }
    if (words) {
        const Message reason = words->assign(scenario, static_cast<std::size_t>(value));
        return reason.isEmpty()
                   ? reason
                   : Message(translatable("%1 does not apply here: %2"), {std::string(key()), reason});
    }
    const Message problem = assignNumber(scenario, *parameter, value);
    return problem.isEmpty() ? problem : Message("%1 %2", {std::string(key()), problem});
}

Message SweepAxis::readBackProblem(const Scenario& scenario, double value) const {
    if (!parameter || !parameter->applies(scenario)) return {};
    return drillwave::readBackProblem(*parameter, scenario, value);
}

std::vector<std::uint64_t> SweepAxis::extremes() const {
    std::vector<std::uint64_t> indices;
    if (kind == Kind::words || kind == Kind::presets) {
        for (std::uint64_t i = 0; i < count; ++i) indices.push_back(i);
    } else if (kind == Kind::list) {
        const auto [low, high] = std::ranges::minmax_element(list);
        indices = {static_cast<std::uint64_t>(low - list.begin()),
                   static_cast<std::uint64_t>(high - list.begin())};
    } else {
        indices = {0, count - 1};
    }
    return indices;
}

ParsedAxis parseRange(std::string_view text) {
    ParsedAxis parsed;
    parsed.problem = readFollowedAxis(parsed, text);
    return parsed;
}

Message mustRise(const SweepAxis& axis) {
    return {translatable("the range of %1 must end above its beginning"), {std::string(axis.key())}};
}

Message followProblem(const SweepAxis& axis) {
    // Narrower ranges, of their larger end, have fewer values than places of their features are to have.
    constexpr double narrowest = 1e-4;
    const std::string key(axis.key());
    if (!axis.parameter) return wordsProblem(*axis.words);
    if (axis.parameter->rules.wholeNumber)
        return {translatable("%1 has only whole numbers; make a family of them, or sweep it"), {key}};
    if (axis.kind != SweepAxis::Kind::linear && axis.kind != SweepAxis::Kind::logarithmic)
        return followedForm(key);
    if (!(axis.start < axis.stop)) return mustRise(axis);
    if (axis.stop - axis.start < narrowest * std::max(std::abs(axis.start), std::abs(axis.stop)))
        return {translatable("the range of %1 is too narrow: it must be at least 1e-4 of its end"), {key}};
    return logarithmProblem(axis);
}

std::uint64_t countWithin(const Parameter& parameter, double start, double stop, std::uint64_t most) {
    const double span = std::abs(stop - start);
    if (!parameter.rules.wholeNumber || !(span >= 1) || span != std::floor(span)) return most;
    const auto steps = static_cast<std::uint64_t>(span);
    for (std::uint64_t points = std::min(most, steps + 1); points > 2; --points)
        if (steps % (points - 1) == 0) return points;
    return 2;
}

ParsedAxis parseAxis(std::string_view text, std::optional<std::uint64_t> assumedCount) {
    ParsedAxis parsed;
    parsed.problem = readAxis(parsed, text, assumedCount);
    return parsed;
}

}  // namespace drillwave

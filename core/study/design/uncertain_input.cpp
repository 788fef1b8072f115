// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/uncertain_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// Whether the whole range is one that the parameter can have and the kind can be made of.
Message rangeRefusal(const UncertainInput& input, std::string_view text) {
    const Parameter& parameter = *input.parameter;
    const auto refuse = [&](const Message& reason) { return refusedValue(parameter.key, text, reason); };
    if (input.low == input.high) return refuse(translatable("has no width; give LOW below HIGH"));
    if (!(input.low < input.high)) return refuse(translatable("has LOW above HIGH; exchange them"));
    for (const double end : {input.low, input.high})
        if (const Message problem = rangeProblem(parameter, end); !problem.isEmpty()) return refuse(problem);
    if (input.low <= 0 && input.kind == DistributionKind::log)
        return refuse(translatable("must begin above 0 where it is `log`"));
    if (input.low <= 0 && input.kind == DistributionKind::lognormal)
        return refuse(translatable("must begin above 0 where it is `lognormal`"));
    if (input.kind != DistributionKind::normal || !parameter.hard.lowOpen) return {};
    const double mean = (input.low + input.high) / 2;
    const double deviation = (input.high - input.low) / (2 * normalHalfWidth);
    return mean - normalCut * deviation <= parameter.hard.low
               ? refuse({translatable(
                             "the distribution extends to %1, outside the allowed range; use lognormal"),
                         {formatNumber(parameter.hard.low)}})
               : Message();
}

Message readEnd(UncertainInput& input, std::string_view text, double& end) {
    const Parameter& parameter = *input.parameter;
    const TypedQuantity typed =
        parseQuantity(text, parameter.quantity, BareNumber::refused, &parameter.displayUnit());
    if (!typed.valid()) return refusedValue(parameter.key, text, typed.problem);
    const bool sameUnit = !input.unit || input.unit == typed.unit;
    input.unit = sameUnit ? typed.unit : &unitsOf(parameter.quantity).front();
    end = typed.si;
    return {};
}

Message readPercent(UncertainInput& input, std::string_view text) {
    const std::string_view number = trimmed(text.substr(2, text.size() - 3));
    const std::optional<double> percent = parseNumber(number);
    input.kind = DistributionKind::percent;
    input.unit = &input.parameter->displayUnit();
    if (percent && *percent > 0) {
        input.percent = *percent;
        return {};
    }
    return refusedValue(input.parameter->key, text,
                        translatable("needs a number above 0 of per cent, as +-5%"));
}

Message readValues(ParsedUncertain& parsed, std::string_view text) {
    UncertainInput& input = parsed.input;
    text = trimmed(text);
    if (text.starts_with("+-") && text.ends_with('%')) return readPercent(input, text);
    std::vector<std::string_view> parts;
    for (std::string_view rest = text;;) {
        const std::size_t colon = rest.find(':');
        parts.push_back(trimmed(rest.substr(0, colon)));
        if (colon == std::string_view::npos) break;
        rest.remove_prefix(colon + 1);
    }
    parsed.isMistyped = true;
    if (parts.size() < 2 || parts.size() > 3)
        return {translatable("%1 needs LOW:HIGH, LOW:HIGH:log, :normal or :lognormal, or +-P%"),
                {std::string(input.parameter->key)}};
    if (parts.size() == 3) {
        using enum DistributionKind;
        constexpr std::array kinds{uniform, log, normal, lognormal};
        const auto found =
            std::ranges::find(kinds, parts[2], [](DistributionKind kind) { return name(kind); });
        if (found == kinds.end())
            return {
                translatable(
                    "unknown suffix `%1` after the range of %2; choose from uniform, log, normal, lognormal"),
                {shortened(parts[2]), std::string(input.parameter->key)}};
        input.kind = *found;
    }
    parsed.isMistyped = false;
    if (Message problem = readEnd(input, parts[0], input.low); !problem.isEmpty()) return problem;
    if (Message problem = readEnd(input, parts[1], input.high); !problem.isEmpty()) return problem;
    return rangeRefusal(input, text);
}

Message read(ParsedUncertain& parsed, std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) {
        parsed.isMistyped = true;
        return {translatable("`%1` is not a range: write KEY=LOW:HIGH, KEY=LOW:HIGH:log or KEY=+-P%"),
                {shortened(text)}};
    }
    const std::string_view key = trimmed(text.substr(0, equals));
    parsed.input.parameter = findParameter(key);
    if (key == pulseShapeKey || key == restrikeKey || key == "bit_rock.law")
        return {translatable("%1 is not a number and cannot be uncertain; list values with --choose"),
                {std::string(key)}};
    if (!parsed.input.parameter) return notAParameter(key);
    if (parsed.input.parameter->rules.wholeNumber)
        return {
            translatable("%1 takes only whole numbers and cannot be uncertain; list values with --choose"),
            {std::string(key)}};
    return readValues(parsed, text.substr(equals + 1));
}

}  // namespace

Distribution UncertainInput::in(const Scenario& design) const {
    if (kind != DistributionKind::percent)
        return {kind, low, high, parameter->hard.low, parameter->hard.high};
    const double value = *parameter->value(design);
    const double width = std::abs(value) * percent / 100;
    return {kind, value - width, value + width};
}

Message UncertainInput::problemIn(const Scenario& design) const {
    const std::string key(parameter->key);
    if (const Message why = whyNotApplicable(*parameter, design); !why.isEmpty())
        return {translatable("%1 does not apply here: %2"), {key, why}};
    if (kind != DistributionKind::percent) return {};
    const std::optional<double> value = parameter->value(design);
    if (!value || *value == 0)
        return {value ? translatable("%1 = +-%2% (the scenario has 0 there; give LOW:HIGH)")
                      : translatable("%1 = +-%2% (the scenario has no value there; give LOW:HIGH)"),
                {key, formatNumber(percent)}};
    for (const double share : {1 - percent / 100, 1 + percent / 100})
        if (const Message problem = rangeProblem(*parameter, *value * share); !problem.isEmpty())
            return {translatable("%1 = +-%2% of %3 (%4)"),
                    {key, formatNumber(percent),
                     formatQuantity(*value, parameter->quantity, parameter->displayUnit()), problem}};
    return {};
}

ParsedUncertain parseUncertain(std::string_view text) {
    ParsedUncertain parsed;
    parsed.problem = read(parsed, text);
    return parsed;
}

}  // namespace drillwave

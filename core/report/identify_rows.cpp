// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "core/report/parameter_words.h"

namespace drillwave {

namespace {

constexpr std::size_t mostLimits = 6;  ///< causes of the error that are shown
constexpr double leastLimit = 5e-4;    ///< relative effect of a cause that is shown
constexpr double widestShown = 4.6;    ///< half-width of a logarithm: a factor of 100

struct ParameterNames {
    const char *what, *term;
    Quantity quantity;
};

ParameterNames namesOf(const std::string& key) {
    if (key == "bit_rock.stiffness")
        return {translatable("rock when it is first loaded"), translatable("stiffness"), Quantity::stiffness};
    if (key == "bit_rock.gamma") return {translatable("elasticity"), "gamma", Quantity::ratio};
    if (key == "bit_rock.gap") return {translatable("bit not seated"), translatable("gap"), Quantity::length};
    if (key == "bit_rock.corner.1.force")
        return {translatable("force at which the rock yields"), translatable("corner"), Quantity::force};
    return {translatable("slope after yielding"), translatable("slope"), Quantity::ratio};
}

/// A gap is a short length.
std::string valueText(double value, Quantity quantity, int digits, const ReadingStyle& style) {
    return quantity == Quantity::length ? shortLength(value, digits, style)
                                        : style.quantity(value, quantity, digits);
}

std::string percentOf(double share, const ReadingStyle& style) {
    return style.number(100 * share, 2) + " %";
}

Message verdictWords(const IdentifiedParameter& parameter, Quantity quantity, const ReadingStyle& style) {
    const auto shown = [&](double value) { return valueText(value, quantity, 3, style); };
    const double width = parameter.halfWidth;
    const bool isShown = parameter.low && parameter.high && (parameter.isGap() || width <= 1);
    const auto withWidth = [&](const char* words, const char* alone) -> Message {
        if (!isShown) return alone;
        return {words, {parameter.isGap() ? valueText(width, quantity, 2, style) : percentOf(width, style)}};
    };
    switch (parameter.verdict) {
        case ParameterVerdict::identified:
            return withWidth(translatable("known to within %1"), translatable("known"));
        case ParameterVerdict::uncertain:
            return withWidth(translatable("uncertain by %1"), translatable("uncertain"));
        case ParameterVerdict::bounded:
            if (parameter.high) return {translatable("less than %1"), {shown(*parameter.high)}};
            if (parameter.low) return {translatable("more than %1"), {shown(*parameter.low)}};
            return translatable("bounded");
        case ParameterVerdict::notSeen:
            if (parameter.reason == "no_contact") return translatable("not seen: no contact");
            if (parameter.reason == "no_corner")
                return translatable("not seen: the force stays below a corner");
            if (parameter.reason == "noise")
                return translatable("not known: uncertain by more than a factor of 10");
            if (parameter.reason == "front") return translatable("not seen: the rock is too stiff");
            return translatable("not seen: the record ends before the rock unloads");
        case ParameterVerdict::rejected:
            break;
    }
    return translatable("not known");
}

/// Whether a key of --known is of a size of a section.
bool isOfSize(const std::string& key) {
    return !key.empty() && key != "gauge" && key != "gain" && key != "material";
}

/// Without the key of a size, which would widen the column of a table.
Message causeWords(const std::string& source, const std::string& key, const Scenario& scenario) {
    if (isOfSize(key)) {
        const KeptParameter parameter = findParameter(key);
        return parameter ? labelMessage(*parameter, scenario) : Message(key);
    }
    if (source == "noise") return translatable("noise");
    if (source == "tail") return translatable("waves that follow the blow");
    if (source == "timing") return translatable("arrival of the reflection");
    if (source == "material") return translatable("modulus and density");
    if (source == "gain_change") return translatable("gain within the record");
    if (source == "gain") return translatable("gain of the amplifier");
    if (source == "place") return translatable("distance between the gauges");
    if (source == "resolution") return translatable("force rise hidden by noise");
    if (source == "law") return translatable("law of the rock");
    if (source == "minimum") return translatable("another solution, as good");
    if (source == "step") return translatable("step of the recorder");
    if (source == "unexplained_wave") return translatable("unexplained waves");
    return source;
}

Message toleranceWords(const BudgetRow& row, const ReadingStyle& style) {
    if (row.tolerance <= 0 || row.source == "tail" || row.source == "unexplained_wave" ||
        row.source == "timing" || row.source == "resolution")
        return {};
    const std::string value = row.unit == "m"     ? shortLength(row.tolerance, 2, style)
                              : row.unit == "m^2" ? style.quantity(row.tolerance, Quantity::area, 2)
                              : row.unit == "N"   ? style.quantity(row.tolerance, Quantity::force, 2)
                                                  : percentOf(row.tolerance, style);
    const Message tolerance =
        row.isAssumed ? Message(translatable("assumed +-%1"), {value}) : Message("+-" + value);
    if (style.isPrinted() || row.key.empty() || row.key == "material") return tolerance;
    return {"%1 (%2)", {tolerance, row.key}};  // the key to state it by
}

}  // namespace

Message sizeWords(const std::string& key, const Scenario& scenario, const ReadingStyle& style) {
    const KeptParameter parameter = findParameter(key);
    if (!parameter) return key;
    const Message words = labelMessage(*parameter, scenario);
    return style.isPrinted() ? words : Message("%1 (%2)", {words, key});
}

std::string shortLength(double si, int digits, const ReadingStyle& style) {
    const ReadUnit read =
        style.unitFor(2e-3, Quantity::length);  // the unit in which lengths of a few millimetres are shown
    const double shown = std::round(read.unit->fromSi(si) * 1e4) / 1e4 + 0.0;  // + 0.0 turns -0 into 0
    const int whole = shown == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(shown)))) + 1;
    return style.number(shown, std::max(digits, whole)) + " " + read.name;
}

std::vector<IdentifyRow> identifyRows(const RecordAnswer& answer,
                                      const std::vector<NextBlowParameter>& nextBlow,
                                      const ReadingStyle& style) {
    std::vector<IdentifyRow> rows;
    const auto interval = [&](double low, double high, Quantity quantity) {
        return valueText(low, quantity, 4, style) + " … " + valueText(high, quantity, 4, style);
    };
    for (const IdentifiedParameter& parameter : answer.parameters) {
        const auto [what, term, quantity] = namesOf(parameter.key);
        IdentifyRow row{parameter.key,
                        what,
                        term,
                        valueText(parameter.value, quantity, 4, style),
                        "",
                        verdictWords(parameter, quantity, style)};
        const bool isWide = !parameter.isGap() && parameter.halfWidth > widestShown;
        if (answer.model != ModelVerdict::rejected && parameter.low && parameter.high && !isWide)
            row.interval = interval(*parameter.low, *parameter.high, quantity);
        rows.push_back(std::move(row));
    }
    for (const NextBlowParameter& next : nextBlow) {
        const auto [what, term, quantity] = namesOf(next.key);
        rows.push_back(
            {next.key, translatable("next blow"), term, valueText(next.value, quantity, 4, style),
             interval(next.low, next.high, quantity),
             next.hasChange ? translatable("changes from blow to blow") : translatable("no change is seen")});
    }
    return rows;
}

std::vector<IdentifyLimit> identifyLimits(const RecordAnswer& answer, const Scenario& scenario,
                                          const ReadingStyle& style) {
    if (answer.refusal || answer.model == ModelVerdict::rejected || answer.parameters.size() < 2) return {};
    const IdentifiedParameter &stiffness = answer.parameters[0], &gamma = answer.parameters[1];
    // A value that is not seen has no interval that a cause could widen.
    const auto on = [](const IdentifiedParameter& parameter, double effect) {
        return parameter.verdict == ParameterVerdict::notSeen ? std::nullopt : std::optional(effect);
    };
    std::vector<IdentifyLimit> limits{
        {causeWords("noise", "", scenario), "", {}, on(stiffness, stiffness.noise), on(gamma, gamma.noise)}};
    for (std::size_t i = 0; i < stiffness.budget.size(); ++i) {
        const BudgetRow& row = stiffness.budget[i];
        limits.push_back({causeWords(row.source, row.key, scenario), row.key, toleranceWords(row, style),
                          on(stiffness, row.effect), on(gamma, gamma.budget[i].effect), row.isAssumed});
    }
    std::stable_sort(limits.begin(), limits.end(), [](const IdentifyLimit& a, const IdentifyLimit& b) {
        const auto together = [](const IdentifyLimit& limit) {
            return std::hypot(limit.onStiffness.value_or(0), limit.onGamma.value_or(0));
        };
        return together(a) > together(b);
    });
    limits.resize(std::min(limits.size(), mostLimits));
    std::erase_if(limits, [](const IdentifyLimit& limit) {
        return std::max(limit.onStiffness.value_or(0), limit.onGamma.value_or(0)) <= leastLimit;
    });
    return limits;
}

Message limitWords(std::optional<double> effect, const ReadingStyle& style) {
    if (!effect) return Message("-");
    return *effect > 1 ? Message(translatable("over 100 %")) : Message(percentOf(*effect, style));
}

Message identifyNext(const RecordAnswer& answer, const Scenario& scenario, const ReadingStyle& style) {
    const std::optional<NextMeasurement> next = nextMeasurement(answer);
    if (!next) return {};
    const double today = answer.find(next->parameter)->halfWidth;
    const std::string after = percentOf(next->halfWidth, style);
    const char* term = namesOf(next->parameter).term;
    const Message gain =
        today > 1 ? Message(translatable("%1 +-%2"), {term, after})
                  : Message(translatable("%1 +-%2 instead of +-%3"), {term, after, percentOf(today, style)});
    for (const IdentifiedParameter& parameter : answer.parameters)
        if (parameter.verdict == ParameterVerdict::notSeen && parameter.reason == "no_unloading")
            return translatable(
                "To know more: record until the rock has unloaded, up to 1 ms after the reflection arrives.");
    if (next->halfWidth > 1)
        return {translatable("No single measurement would bring the uncertainty of %1 below 100 %."),
                {namesOf(next->parameter).term}};
    if (next->source == "noise" || next->source == "law" || next->source == "resolution" ||
        next->source == "minimum")
        return {translatable("To know more: average 4 blows: %1."), {gain}};
    if (next->source == "unexplained_wave" || next->source == "tail")
        return {answer.hasTwoGauges()
                    ? translatable("To know more: use gauges on opposite sides: %1.")
                    : translatable("To know more: use gauges on opposite sides, or a second gauge: %1."),
                {gain}};
    if (next->source == "gain_change")
        return {translatable("To know more: use a larger range of the amplifier, and check glue and cable of "
                             "the gauge: %1."),
                {gain}};
    if (next->source == "step")
        return {translatable("To know more: use a smaller range or more bits: %1."), {gain}};
    if (next->source == "timing")
        return {translatable("To know more: measure the distance of the gauge from the bit: %1."), {gain}};
    const std::string tolerance =
        next->unit == "m" ? shortLength(next->tolerance, 2, style) : percentOf(next->tolerance, style);
    if (next->source == "place")
        return {translatable("To know more: measure the distance between the gauges to %1: %2."),
                {tolerance, gain}};
    return {translatable("To know more: measure %1 to %2: %3."),
            {isOfSize(next->key) ? sizeWords(next->key, scenario, style)
                                 : causeWords(next->source, next->key, scenario),
             tolerance, gain}};
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/law_parameter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <utility>

#include "core/model/parameter.h"
#include "core/model/scales.h"

namespace drillwave {

namespace {

using Value = std::optional<double>;

constexpr std::string_view cornerPrefix = "bit_rock.corner.";
constexpr Range anyPositive{0, std::numeric_limits<double>::infinity(), true};

template <std::size_t place, double RockCorner::*member>
Value cornerValue(const Scenario& scenario) {
    const std::vector<RockCorner>& corners = scenario.bitRock.corners;
    if (place > corners.size() || std::isnan(corners[place - 1].*member)) return std::nullopt;
    return corners[place - 1].*member;
}

template <std::size_t place, double RockCorner::*member>
void assignCorner(Scenario& scenario, double value) {
    std::vector<RockCorner>& corners = scenario.bitRock.corners;
    if (corners.size() < place) corners.resize(place);
    corners[place - 1].*member = value;
}

/// All of them, and the texts that they refer to.
struct LawParameters {
    std::deque<std::string> texts;
    std::vector<Parameter> corners, cornersInScales;
    std::vector<Parameter> numbersInScales;  // others with a unit

    std::string_view keep(std::string text) { return texts.emplace_back(std::move(text)); }

    template <std::size_t place>
    void addCorner() {
        const std::string number = std::to_string(place);
        constexpr auto force = &RockCorner::force, slope = &RockCorner::slope;
        const std::string_view forceKey = keep(cornerKey(place, "force"));
        const std::string_view forceLabel = keep("force of corner " + number);
        constexpr std::string_view forceMeaning = "Force at which the slope of the loading curve changes";
        corners.push_back({forceKey,
                           forceLabel,
                           "",
                           forceMeaning,
                           Quantity::force,
                           "kN",
                           anyPositive,
                           {5e3, 5e5},
                           SliderScale::logarithmic,
                           Scope::withUnits,
                           cornerValue<place, force>,
                           assignCorner<place, force>,
                           {.shortLabel = "force", .law = RockLaw::corners}});
        cornersInScales.push_back({forceKey,
                                   forceLabel,
                                   "",
                                   forceMeaning,
                                   Quantity::ratio,
                                   "",
                                   anyPositive,
                                   {0.05, 2},
                                   SliderScale::logarithmic,
                                   Scope::withoutUnits,
                                   cornerValue<place, force>,
                                   assignCorner<place, force>,
                                   {.shortLabel = "force", .law = RockLaw::corners}});
        corners.push_back({keep(cornerKey(place, "slope")),
                           keep("slope behind corner " + number),
                           "",
                           "Slope of the loading curve above that corner, as a multiple of the stiffness",
                           Quantity::ratio,
                           "",
                           anyPositive,
                           {0.05, 5},
                           SliderScale::logarithmic,
                           Scope::all,
                           cornerValue<place, slope>,
                           assignCorner<place, slope>,
                           {.shortLabel = "slope", .law = RockLaw::corners}});
    }

    /// A number with a unit, of whichever law, as a dimensionless scenario has it.
    void addInScales(const Parameter& row) {
        assert(row.quantity == Quantity::force || row.quantity == Quantity::length);
        Parameter parameter = row;
        parameter.meaning =
            keep(std::string(row.meaning) + (row.quantity == Quantity::force ? ", in F0" : ", in d0"));
        parameter.quantity = Quantity::ratio;
        parameter.unit = "";
        parameter.hard = anyPositive;
        parameter.plausible = {0.05, 5};
        parameter.scope = Scope::withoutUnits;
        numbersInScales.push_back(parameter);
    }

    LawParameters() {
        [this]<std::size_t... i>(std::index_sequence<i...>) {
            (addCorner<i + 1>(), ...);
        }
        (std::make_index_sequence<mostRockCorners>());
        for (const Parameter& row : parameters())
            if (row.rules.law && row.quantity != Quantity::ratio) addInScales(row);
    }
};

const LawParameters& lawParameters() {
    static const LawParameters parameters;
    return parameters;
}

KeptParameter findIn(const std::vector<Parameter>& parameters, std::string_view key) {
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    return found == parameters.end() ? KeptParameter() : KeptParameter(*found);
}

}  // namespace

KeptParameter findLawParameter(std::string_view key) {
    return key.starts_with(cornerPrefix) ? findIn(lawParameters().corners, key) : KeptParameter();
}

KeptParameter inScales(const Parameter& parameter) {
    if (parameter.section() != "bit_rock") return {};
    const LawParameters& all = lawParameters();
    return findIn(cornerOf(parameter) > 0 ? all.cornersInScales : all.numbersInScales, parameter.key);
}

KeptParameter inFormOf(const Scenario& scenario, const Parameter& parameter) {
    KeptParameter other = hasUnits(scenario) ? KeptParameter() : inScales(parameter);
    return other ? other : KeptParameter(parameter);
}

std::vector<KeptParameter> numbersInScales(const Scenario& scenario) {
    std::vector<KeptParameter> numbers;
    for (const Parameter& parameter : lawParameters().numbersInScales)
        if (parameter.applies(scenario)) numbers.emplace_back(parameter);
    return numbers;
}

std::vector<KeptParameter> loadingNumbers(const Scenario& scenario) {
    std::vector<KeptParameter> numbers;
    const std::size_t corners = std::min(scenario.bitRock.corners.size(), mostRockCorners);
    for (std::size_t place = 1; place <= corners; ++place)
        for (const std::string_view field : {"force", "slope"})
            numbers.push_back(inFormOf(scenario, *findParameter(cornerKey(place, field))));
    std::ranges::copy(numbersInScales(scenario), std::back_inserter(numbers));
    return numbers;
}

std::size_t cornerOf(const Parameter& parameter) {
    if (!parameter.key.starts_with(cornerPrefix)) return 0;
    return static_cast<std::size_t>(std::atoi(parameter.key.data() + cornerPrefix.size()));
}

std::string cornerKey(std::size_t place, std::string_view field) {
    return std::string(cornerPrefix) + std::to_string(place) + "." + std::string(field);
}

BitRock withLaw(BitRock rock, RockLaw law) {
    if (law != RockLaw::corners) rock.corners.clear();
    Scenario changed;
    changed.bitRock = std::move(rock);
    for (const Parameter& parameter : parameters()) {
        if (!parameter.rules.law || *parameter.rules.law == law) continue;
        Scenario usual;
        usual.bitRock.law = changed.bitRock.law = *parameter.rules.law;  // so that the number has a meaning
        parameter.assign(changed, *parameter.value(usual));
    }
    changed.bitRock.law = law;
    return changed.bitRock;
}

BitRock proposedRock(const Scenario& scenario, RockLaw law) {
    constexpr double scaleShare = 0.5;
    Scenario proposed = scenario;
    proposed.bitRock = withLaw(scenario.bitRock, law);
    if (law == RockLaw::corners && proposed.bitRock.corners.empty())
        proposed.bitRock.corners.push_back(
            {scaleShare * (hasUnits(scenario) ? scalesOf(scenario).force : 1), 1});
    for (const KeptParameter& number : numbersInScales(proposed)) number->assign(proposed, scaleShare);
    return proposed.bitRock;
}

}  // namespace drillwave

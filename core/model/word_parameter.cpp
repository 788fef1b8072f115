// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/word_parameter.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/model/law_change.h"
#include "core/model/parameter_text.h"

namespace drillwave {
namespace {

Message setShape(Scenario& scenario, std::size_t word) {
    const auto shape = static_cast<PulseShape>(word);
    Message refusal = shapeRefusal(scenario, shape);
    if (refusal.isEmpty()) scenario.pulse.shape = shape;
    return refusal;
}

Message setLaw(Scenario& scenario, std::size_t word) {
    scenario.bitRock = withLaw(std::move(scenario.bitRock), static_cast<RockLaw>(word));
    return {};
}

Message setIndexing(Scenario& scenario, std::size_t word) {
    if (!hasUnits(scenario)) return translatable("a dimensionless scenario has no drill");
    scenario.drill.indexing = static_cast<RockIndexing>(word);
    return {};
}

constexpr std::array wordTable{
    WordParameter{pulseShapeKey, pulseShapeNames,
                  [](const Scenario& scenario) { return name(scenario.pulse.shape); }, setShape},
    WordParameter{rockLawKey, rockLawNames,
                  [](const Scenario& scenario) { return name(scenario.bitRock.law); }, setLaw},
    WordParameter{rockIndexingKey, rockIndexingNames,
                  [](const Scenario& scenario) { return name(scenario.drill.indexing); }, setIndexing},
};

}  // namespace

std::string WordParameter::list() const {
    std::string list;
    for (const std::string_view word : words()) list += (list.empty() ? "" : ", ") + std::string(word);
    return list;
}

std::span<const WordParameter> wordParameters() {
    return wordTable;
}

const WordParameter* findWordParameter(std::string_view key) {
    const auto found = std::ranges::find(wordTable, key, &WordParameter::key);
    return found == wordTable.end() ? nullptr : &*found;
}

}  // namespace drillwave

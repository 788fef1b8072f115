// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_json.h"

#include <algorithm>

#include "core/report/alert_words.h"
#include "core/report/blow_csv.h"
#include "core/report/feed_json.h"
#include "core/report/json_value.h"

namespace drillwave {

namespace {

/// Nothing where there is no result.
std::optional<double> valueOf(const Blow& blow, const Output& output) {
    if (!blow.isSolved()) return std::nullopt;
    return output.value({blow.summary, blow.scenario, blow.thrustMargin()});
}

/// null for nothing.
Json numberJson(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

JsonObject dimensionlessJson(const Blow& blow) {
    JsonObject object;
    for (const Output& output : outputs())
        if (!output.isOnlySi() && output.problem(blow.scenario).isEmpty())
            object[output.name] = numberJson(valueOf(blow, output));
    return object;
}

/// All that the scenario has.
JsonObject siJson(const Blow& blow) {
    JsonObject si;
    for (const Output& output : outputs()) {
        if (!output.problem(blow.scenario).isEmpty()) continue;
        std::optional<double> value = valueOf(blow, output);
        if (value) value = inSi(output, *value, blow);
        si[output.name] = numberJson(value);
    }
    return si;
}

/// The SI unit of each, "1" for what has none; nothing of a scenario in groups.
JsonObject siUnitsJson(const Blow& blow) {
    JsonObject units;
    if (!hasUnits(blow.scenario)) return units;
    for (const Output& output : outputs())
        if (output.problem(blow.scenario).isEmpty()) units[output.name] = unitJson(output.siQuantity());
    return units;
}

JsonArray eventsJson(const Impact& impact) {
    JsonArray array;
    for (const ImpactEvent& event : impact.events)
        array.emplace_back(JsonObject{{"kind", name(event.kind)}, {"time", event.time}});
    return array;
}

std::string_view outcomeName(const Blow& blow) {
    static constexpr EnumNames<Outcome> names{{{Outcome::rebounded, "rebounded"},
                                               {Outcome::endTime, "end_time"},
                                               {Outcome::nextBlow, "next_blow"},
                                               {Outcome::notSolved, "not_solved"}}};
    return names[blow.impact.outcome];
}

JsonObject peakJson(const StressPeak& peak) {
    return {{"stress", peak.stress}, {"x", peak.place}, {"time", peak.time}};
}

/// Name, place, and the largest compression and tension with where and when: of all the time that was
/// followed, and where it goes beyond the blow those of the blow and of the waves left. SI.
JsonArray sectionsJson(const Blow& blow) {
    JsonArray array;
    const DrillString& drill = blow.scenario.drillString;
    const std::vector<const Section*> sections = allSections(drill);
    const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
    const std::size_t ofHammer = drill.hammer.sections.size();
    double from = 0;
    for (std::size_t j = 0; j < sections.size(); ++j) {
        const bool hammer = j < ofHammer;
        const Section& section = *sections[j];
        JsonObject object{{"part", hammer ? "hammer" : "string"},
                          {"place", hammer ? j + 1 : j + 1 - ofHammer},
                          {"name", section.name},
                          {"from", from},
                          {"length", section.length}};
        from += section.length;
        if (!stresses.empty()) {
            const SectionStress& stress = stresses[j];
            const auto larger = [](const StressPeak& during, const StressPeak& after) {
                return after.stress > during.stress ? after : during;
            };
            const StressPeak compression = larger(stress.compression, stress.compressionAfter);
            const StressPeak tension = larger(stress.tension, stress.tensionAfter);
            object["compression"] = peakJson(compression);
            object["tension"] = peakJson(tension);
            if (hasStressesAfter(blow.impact)) {
                object["compression_blow"] = peakJson(stress.compression);
                object["tension_blow"] = peakJson(stress.tension);
                object["compression_after"] = peakJson(stress.compressionAfter);
                object["tension_after"] = peakJson(stress.tensionAfter);
            }
            if (section.yieldStrength)
                object["yield_use"] = std::max(compression.stress, tension.stress) / *section.yieldStrength;
            if (section.fatigueStrength) object["fatigue_use"] = tension.stress / *section.fatigueStrength;
        }
        const std::vector<double>& reflected = blow.impact.jointReflection;
        if (!hammer && j - ofHammer < reflected.size()) object["joint_reflection"] = reflected[j - ofHammer];
        array.emplace_back(object);
    }
    return array;
}

}  // namespace

JsonArray alertsJson(const std::vector<Alert>& alerts) {
    JsonArray array;
    for (const Alert& alert : alerts)
        array.emplace_back(
            JsonObject{{"level", alert.level == AlertLevel::warning ? "warning" : "information"},
                       {"code", name(alert.code)},
                       {"parameter", alert.parameter},
                       {"text", alertText(alert)}});
    return array;
}

double inSi(const Output& output, double value, const Blow& blow) {
    return output.inSi(value, {blow.summary, blow.scenario}, blow.scales);
}

std::string blowJson(const Blow& blow, const std::string& scenarioText) {
    const Impact& impact = blow.impact;
    JsonObject object = headJson({.scenario = blow.scenario,
                                  .scenarioText = scenarioText,
                                  .method = blow.method,
                                  .units = siUnitsJson(blow),
                                  .runTime = blow.runTime});
    object["outcome"] = outcomeName(blow);
    object["dimensionless"] = dimensionlessJson(blow);
    if (hasUnits(blow.scenario)) object["si"] = siJson(blow);
    if (blow.isSolved()) object["feed"] = feedJson(blow.feed);
    object["events"] = eventsJson(impact);
    object["contacts"] = impact.contacts;
    object["pieces"] = impact.pieces;
    object["alerts"] = alertsJson(blow.alerts);
    if (!blow.isSolved()) object["reason"] = impact.reason.text();
    if (!blow.isSolved()) return Json(object).text();
    if (JsonArray sections = sectionsJson(blow); !sections.empty()) object["sections"] = std::move(sections);
    return Json(object).text();
}

}  // namespace drillwave

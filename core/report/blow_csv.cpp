// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_csv.h"

#include <algorithm>
#include <vector>

#include "core/blow/blow_waves.h"
#include "core/blow/outputs.h"
#include "core/report/report_table.h"
#include "core/report/result_remarks.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

std::string heading(std::string_view name, Quantity quantity, OutputUnits units) {
    if (units == OutputUnits::dimensionless) return std::string(name);
    return std::string(name) + " [" + std::string(unitsOf(quantity).front().name) + "]";
}

/// A column of histories.
struct HistoryColumn {
    std::string_view name;
    Quantity quantity;
    double RodState::*value;
    double Scales::*scale;
    OutputOf of = OutputOf::anyBlow;
};

constexpr HistoryColumn historyTable[] = {
    {"time", Quantity::time, &RodState::time, &Scales::time},
    {"impact_force", Quantity::force, &RodState::impactForce, &Scales::force},
    {"impulse", Quantity::impulse, &RodState::impulse, &Scales::impulse},
    {"momentum", Quantity::impulse, &RodState::momentum, &Scales::impulse},
    {"incident_wave", Quantity::force, &RodState::positiveWave, &Scales::force, OutputOf::uniformRod},
    {"penetration", Quantity::length, &RodState::penetration, &Scales::penetration},
    {"front_velocity", Quantity::velocity, &RodState::frontVelocity, &Scales::velocity},
    {"face_force", Quantity::force, &RodState::faceForce, &Scales::force, OutputOf::drillString},
    {"normal_force", Quantity::force, &RodState::normalForce, &Scales::force, OutputOf::drillString},
    {"positive_wave", Quantity::force, &RodState::positiveWave, &Scales::force, OutputOf::drillString},
    {"negative_wave", Quantity::force, &RodState::negativeWave, &Scales::force, OutputOf::drillString},
    {"velocity", Quantity::velocity, &RodState::velocity, &Scales::velocity, OutputOf::drillString}};

/// The first line of a text, which is removed from it.
std::string_view takeLine(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

}  // namespace

std::string scenarioHeader(std::string_view scenarioYaml, std::string_view method, std::string_view columns) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (scenarioYaml.starts_with(byteOrderMark)) scenarioYaml.remove_prefix(byteOrderMark.size());
    const std::string yaml =
        remarksText("; without the leading \"# \" these lines are the scenario.", method, columns) +
        std::string(scenarioYaml);
    std::string header;
    for (std::string_view rest = yaml; !rest.empty();) {
        const std::string_view line = takeLine(rest);
        header += line.empty() ? "#" : "# ";
        header += line;
        header += '\n';
    }
    return header;
}

std::string scenarioFromHeader(std::string_view csv) {
    std::string scenario;
    while (csv.starts_with('#')) {
        std::string_view line = takeLine(csv).substr(1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.starts_with(' ')) line.remove_prefix(1);
        scenario += line;
        scenario += '\n';
    }
    return scenario;
}

std::string historiesCsv(const Blow& blow, const StringPlace& place, OutputUnits units) {
    Scales scale = units == OutputUnits::si ? blow.scales : Scales{};
    // in which those of a rod are
    if (concerns(OutputOf::uniformRod, blow.scenario)) scale.velocity = scale.penetration / scale.time;
    std::vector<HistoryColumn> columns;
    std::vector<std::string> headers;
    for (const HistoryColumn& column : historyTable) {
        if (!concerns(column.of, blow.scenario)) continue;
        columns.push_back(column);
        headers.push_back(heading(column.name, column.quantity, units));
    }
    const std::vector<RodState> states = BlowWaves(blow).sampled(place);
    return csvText({headers, states.size(), [&](std::size_t row) {
                        Cells cells;
                        for (const HistoryColumn& column : columns)
                            cells.push_back(states[row].*column.value * scale.*column.scale);
                        return cells;
                    }});
}

std::string historyColumns(const Scenario& scenario, const StringPlace& place, OutputUnits units) {
    const bool isSi = units == OutputUnits::si;
    if (concerns(OutputOf::uniformRod, scenario))
        return std::string(
                   "incident_wave is a normal force, tension positive; impact_force, impulse, "
                   "momentum, penetration and front_velocity are positive into the rock; penetration "
                   "is that of the bit below the first surface of the rock") +
               (isSi ? ". Units stand in the header."
                     : "; units: time t0, force F0 = I0/t0, impulse and momentum I0, penetration d0 = 2 "
                       "I0/Z, front_velocity d0/t0.");
    const DrillString& drillString = scenario.drillString;
    const bool forced = isForced(scenario);
    const Section& section = *allSections(drillString)[place.section];
    const std::size_t ofHammer = drillString.hammer.sections.size();
    std::string where;
    appendNumber(where, place.share * section.length);
    where += " m from the rear end of section ";
    where += place.section < ofHammer ? std::to_string(place.section + 1) + " of the hammer"
                                      : std::to_string(place.section - ofHammer + 1) + " of the string";
    if (!section.name.empty()) where += " (" + section.name + ")";
    return "normal_force, positive_wave, negative_wave and velocity are those at " + where +
           ", the normal forces tension positive; face_force is that of " +
           (forced ? "the blow on the string" : "hammer and string") +
           "; impact_force, impulse, momentum, penetration and the velocities are positive into the rock; "
           "momentum is what the " +
           (forced ? "blow" : "hammer") +
           " has given to the string less the impulse on the rock; penetration is that of the bit below the "
           "first surface of the rock" +
           (isSi     ? ". Units stand in the header."
            : forced ? "; units: time t0, force F0 = I0/t0, impulse and momentum I0, penetration "
                       "2 I0/Z, velocities v0 = I0/m."
                     : "; units: time t0, force F0 = Z v0/2, impulse and momentum those of "
                       "the hammer, penetration v0 t0, velocities v0.");
}

std::string eventsCsv(const Impact& impact, OutputUnits units, const Scales& scales) {
    const double scale = units == OutputUnits::si ? scales.time : 1;
    return csvText(
        {{"kind", heading("time", Quantity::time, units)}, impact.events.size(), [&](std::size_t row) {
             const ImpactEvent& event = impact.events[row];
             return Cells{name(event.kind), event.time * scale};
         }});
}

std::string_view name(ContactEvent event) {
    using enum ContactEvent;
    static constexpr EnumNames<ContactEvent> names{{{contact, "contact"},
                                                    {unloading, "unloading"},
                                                    {primaryLoading, "primary_loading"},
                                                    {separation, "separation"},
                                                    {corner, "corner"}}};
    return names[event];
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_csv.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/blow/outputs.h"
#include "core/contact/contact_law.h"
#include "core/report/result_remarks.h"
#include "core/text/enum_names.h"
#include "core/text/number_text.h"
#include "core/wave/field/bit_motion.h"
#include "core/wave/field/rod_state.h"
#include "core/wave/field/wave_curves.h"

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
    double StringInstant::*value;
    double Scales::*scale;
    OutputOf of = OutputOf::anyBlow;
};

constexpr HistoryColumn historyTable[] = {
    {"time", Quantity::time, &StringInstant::time, &Scales::time},
    {"impact_force", Quantity::force, &StringInstant::impactForce, &Scales::force},
    {"impulse", Quantity::impulse, &StringInstant::impulse, &Scales::impulse},
    {"momentum", Quantity::impulse, &StringInstant::momentum, &Scales::impulse},
    {"incident_wave", Quantity::force, &StringInstant::positiveWave, &Scales::force, OutputOf::uniformRod},
    {"penetration", Quantity::length, &StringInstant::penetration, &Scales::penetration},
    {"front_velocity", Quantity::velocity, &StringInstant::frontVelocity, &Scales::velocity},
    {"face_force", Quantity::force, &StringInstant::faceForce, &Scales::force, OutputOf::drillString},
    {"normal_force", Quantity::force, &StringInstant::normalForce, &Scales::force, OutputOf::drillString},
    {"positive_wave", Quantity::force, &StringInstant::positiveWave, &Scales::force, OutputOf::drillString},
    {"negative_wave", Quantity::force, &StringInstant::negativeWave, &Scales::force, OutputOf::drillString},
    {"velocity", Quantity::velocity, &StringInstant::velocity, &Scales::velocity, OutputOf::drillString}};

/// The columns of rods or of strings.
std::string historyCsv(OutputOf which, const std::vector<StringInstant>& instants, OutputUnits units,
                       const Scales& scale) {
    const auto row = [&](std::string& csv, const auto& appendCell) {
        for (const HistoryColumn& column : historyTable) {
            if (column.of != OutputOf::anyBlow && column.of != which) continue;
            if (&column != historyTable) csv += ',';
            appendCell(column);
        }
        csv += '\n';
    };
    std::string csv;
    row(csv, [&](const HistoryColumn& c) { csv += heading(c.name, c.quantity, units); });
    for (const StringInstant& now : instants)
        row(csv, [&](const HistoryColumn& c) { appendNumber(csv, now.*c.value * scale.*c.scale); });
    return csv;
}

/// Where the bit is, from the first time to the last.
class FrontEnd {
  public:
    FrontEnd(const Impact& impact, const Problem& problem)
        : m_impact(impact), m_rock(problem.law), m_firstGap(problem.firstGap()) {}

    /// [d0] Of the law of the rock while it pushes, where the displacement of the bit would have its digits
    /// cancelled by those of a much longer way.
    double penetration(double time, double force) {
        m_rock.rememberAcross(force);
        if (force > 0) return m_rock.penetration(force) * lawUnitOfPenetration;
        return bitDisplacement(m_impact, time) - m_firstGap;
    }

  private:
    const Impact& m_impact;
    ContactLaw<> m_rock;
    double m_firstGap;
};

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

std::string historiesCsv(const Impact& impact, const Problem& problem, OutputUnits units,
                         const Scales& scales) {
    assert(impact.hasHistories());
    Scales scale = units == OutputUnits::si ? scales : Scales{};
    scale.velocity = scale.penetration / scale.time;  // in which those of a rod are
    const SampledHistory history = sampleHistory(impact);
    std::vector<StringInstant> instants(history.time.size());
    FrontEnd front(impact, problem);
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        const double time = history.time[i], force = history.force[i], incident = history.incident[i];
        instants[i] = {.time = time,
                       .impactForce = force,
                       .impulse = history.impulse[i],
                       .momentum = rodMomentum(problem.force(), time, history.impulse[i]),
                       .penetration = front.penetration(time, force),
                       .frontVelocity = incident - force / 2,
                       .positiveWave = incident == 0 ? 0 : -incident};
    }
    return historyCsv(OutputOf::uniformRod, instants, units, scale);
}

std::string historyColumns(OutputUnits units) {
    return std::string(
               "incident_wave is a normal force, tension positive; impact_force, impulse, momentum, "
               "penetration and front_velocity are positive into the rock; penetration is that of the "
               "bit below the first surface of the rock") +
           (units == OutputUnits::si ? ". Units stand in the header."
                                     : "; units: time t0, force F0 = I0/t0, impulse and momentum I0, "
                                       "penetration d0 = 2 I0/Z, front_velocity d0/t0.");
}

std::string stringHistoriesCsv(const Blow& blow, const StringPlace& place, OutputUnits units,
                               const Scales& scales) {
    return historyCsv(OutputOf::drillString, StringHistory(blow.impact, blow.problem, place).sampled(), units,
                      units == OutputUnits::si ? scales : Scales{});
}

std::string stringHistoryColumns(const Scenario& scenario, const StringPlace& place, OutputUnits units) {
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
           (units == OutputUnits::si ? ". Units stand in the header."
            : forced ? "; units: time t0, force F0 = I0/t0, impulse and momentum I0, penetration "
                       "2 I0/Z, velocities v0 = I0/m."
                     : "; units: time t0, force F0 = Z v0/2, impulse and momentum those of "
                       "the hammer, penetration v0 t0, velocities v0.");
}

std::string eventsCsv(const Impact& impact, OutputUnits units, const Scales& scales) {
    const double scale = units == OutputUnits::si ? scales.time : 1;
    std::string csv = "kind," + heading("time", Quantity::time, units) + "\n";
    for (const ImpactEvent& event : impact.events) {
        csv += name(event.kind);
        csv += ',';
        appendNumber(csv, event.time * scale);
        csv += '\n';
    }
    return csv;
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

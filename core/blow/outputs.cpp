// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/outputs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/blow/thrust.h"

namespace drillwave {

namespace {

using Number = std::optional<double>;
using From = OutputSource;

/// Per time: a number per blow in its unit times the blow frequency.
Number perTime(const From& from, double perBlow, double unit) {
    if (!frequencyProblem(from.scenario, {}).empty()) return std::nullopt;
    return perBlow * unit * *from.scenario.drill.blowFrequency;
}

Number percussionPower(const From& from) {
    return perTime(from, from.summary.workRatio, scalesOf(from.scenario).energy);
}

Number penetrationRate(const From& from) {
    return perTime(from, from.summary.residualPenetration, scalesOf(from.scenario).penetration);
}

/// A number of the summary.
template <double ImpactSummary::*member>
Number number(const From& from) {
    return from.summary.*member;
}

/// One that a drill string alone has.
template <double ImpactSummary::*member>
Number ofString(const From& from) {
    return isString(from.scenario) ? number<member>(from) : std::nullopt;
}

/// One that only a hammer of sections gives.
template <double ImpactSummary::*member>
Number ofHammer(const From& from) {
    return isForced(from.scenario) ? std::nullopt : number<member>(from);
}

std::string notAString(const Scenario& scenario) {
    return isString(scenario) ? std::string() : "only a drill string has it (`drillwave: 2`)";
}

std::string notOfAHammer(const Scenario& scenario) {
    if (!isString(scenario)) return notAString(scenario);
    return isForced(scenario)
               ? "only a hammer of sections has it (`hammer`), this string is driven by a force"
               : std::string();
}

std::string notOfElasticFaces(const Scenario& scenario) {
    if (isForced(scenario)) return notOfAHammer(scenario);
    return scenario.drillString.hammer.faceStiffness
               ? std::string()
               : "only faces with a stiffness have it (`hammer.face_stiffness`)";
}

std::string notAUniformRod(const Scenario& scenario) {
    return isString(scenario) ? "only a uniform rod has it (`drillwave: 1`)" : std::string();
}

constexpr std::string_view thrustMarginName = "thrust_margin";

constexpr auto outputTable = std::to_array<Output>({
    {"cor", "coefficient of restitution e = -pf/p0", Measure::number, Detail::cor,
     number<&ImpactSummary::cor>},
    {"impulse", "impulse of the impact force, 1 + e", Measure::impulse, Detail::cor,
     number<&ImpactSummary::impulse>, OutputGroup::impact, "impulse on the rock",
     "Impulse of the impact force on the rock, (1 + e) times that of the hammer"},
    {"peak_force", "largest impact force", Measure::force, Detail::summary, number<&ImpactSummary::peakForce>,
     OutputGroup::impact, "peak force", "Largest impact force"},
    {"max_penetration", "largest penetration of the bit", Measure::penetration, Detail::summary,
     number<&ImpactSummary::maxPenetration>, OutputGroup::impact, "largest penetration",
     "Largest penetration of the bit during the blow"},
    {"residual_penetration", "penetration that stays after the blow", Measure::penetration, Detail::summary,
     number<&ImpactSummary::residualPenetration>, OutputGroup::impact, "penetration a blow",
     "Penetration that stays after the blow"},
    {"first_contact_time", "time of the first contact", Measure::time, Detail::summary,
     number<&ImpactSummary::firstContactTime>, OutputGroup::impact, "first contact",
     "Time of the first contact"},
    {"separation_time", "time of the last separation", Measure::time, Detail::summary,
     number<&ImpactSummary::separationTime>, OutputGroup::impact, "last separation",
     "Time of the last separation"},
    {"contact_duration", "time in contact, summed over contacts", Measure::time, Detail::summary,
     number<&ImpactSummary::contactDuration>, OutputGroup::impact, "time in contact",
     "Summed over all contacts"},
    {"work_ratio", "work of the hammer over m v0^2/2", Measure::work, Detail::summary,
     number<&ImpactSummary::workRatio>, OutputGroup::energy, "hammer work W",
     "Work of the hammer on the rod"},
    {"rock_work", "energy left in the rock, fraction of the hammer work", Measure::share, Detail::summary,
     [](const From& f) -> Number { return f.summary.energy.rockWork; }, OutputGroup::energy, "into the rock",
     "Share of the energy that stays in the rock: the efficiency"},
    {"rebound_energy", "energy of the rebound, fraction of the hammer work", Measure::share, Detail::summary,
     [](const From& f) -> Number { return f.summary.energy.reboundEnergy; }, OutputGroup::energy,
     "into the rebound", "Share of the energy that moves the rod or the string back as a whole"},
    {"residual_wave_energy", "energy left in waves, fraction of the hammer work", Measure::share,
     Detail::ledger, [](const From& f) -> Number { return f.summary.energy.residualWaveEnergy; },
     OutputGroup::energy, "left in waves",
     "Share of the energy that runs to and fro in the rod or the string"},
    {"efficiency", "share of the hammer work that stays in the rock", Measure::share, Detail::summary,
     [](const From& f) -> Number { return f.summary.energy.rockWork; }},
    {"momentum_residual", "error of the momentum balance, fraction of I0", Measure::error, Detail::ledger,
     number<&ImpactSummary::momentumResidual>},
    {"energy_residual", "error of the energy balance, fraction of the hammer work", Measure::error,
     Detail::ledger, [](const From& f) -> Number { return f.summary.energy.residual; }, OutputGroup::energy,
     "balance error", "What all the shares together miss"},
    {"cor_error", "bound on the numerical error of cor", Measure::error, Detail::cor,
     number<&ImpactSummary::corError>},
    {"thrust",
     "blow frequency times impulse, N, when the scenario has a frequency",
     Measure::newton,
     Detail::cor,
     [](const From& f) { return thrustNeeded(f.scenario, f.summary.cor, f.summary.transferred); },
     OutputGroup::none,
     {},
     {},
     nullptr,
     thrustProblem},
    {thrustMarginName,
     "effective feed force over the largest of the four needs of the thrust, less 1, when the scenario has "
     "them; takes a study of all gaps",
     Measure::number,
     Detail::cor,
     [](const From& f) { return f.thrustMargin; },
     OutputGroup::none,
     {},
     {},
     nullptr,
     thrustMarginProblem},
    {"percussion_power", "hammer work times blow frequency, W, when the scenario has a frequency",
     Measure::watt, Detail::summary, percussionPower, OutputGroup::energy, "percussion power",
     "Work of the hammer on the rod times the blow frequency", nullptr,
     [](const Scenario& s) { return frequencyProblem(s, "the percussion power"); }},
    {"penetration_rate",
     "penetration that stays times blow frequency, m/s, when the scenario has a frequency: an upper limit",
     Measure::speed, Detail::summary, penetrationRate, OutputGroup::impact, "penetration rate",
     "Penetration that stays times the blow frequency: an upper limit, which indexing, flushing and a bit "
     "off the rock do not reach",
     nullptr, [](const Scenario& s) { return frequencyProblem(s, "the penetration rate"); }},
    {"peak_compression", "largest compression in the rod while the blow lasts", Measure::stress,
     Detail::histories, [](const From& f) -> Number { return f.summary.largestCompression; },
     OutputGroup::stress, "compression, blow",
     "Largest compressive stress of uniform sections while the blow lasts, to the last separation of bit and "
     "rock plus one transit time; threads and shoulders raise it locally",
     &RodForces::compression},
    {"peak_tension", "largest tension in the rod while the blow lasts", Measure::stress, Detail::histories,
     [](const From& f) -> Number { return f.summary.largestTension; }, OutputGroup::stress, "tension, blow",
     "Largest tensile stress of uniform sections while the blow lasts, to the last separation of bit and "
     "rock plus one transit time; threads and shoulders raise it locally",
     &RodForces::tension},
    {"peak_compression_after", "largest compression of the waves left, undamped", Measure::stress,
     Detail::histories, [](const From& f) -> Number { return f.summary.largestCompressionAfter; },
     OutputGroup::stress, "compression, after",
     "Largest compressive stress of the waves that are left after the blow and run on, of a string as long "
     "as it is followed; nothing damps them in the model, a real rod does",
     &RodForces::compressionAfter},
    {"peak_tension_after", "largest tension of the waves left, undamped", Measure::stress, Detail::histories,
     [](const From& f) -> Number { return f.summary.largestTensionAfter; }, OutputGroup::stress,
     "tension, after",
     "Largest tensile stress of the waves that are left after the blow and run on, of a string over a round "
     "trip at least; nothing damps them in the model, a real rod does",
     &RodForces::tensionAfter},
    {"force_peaks", "peaks of the impact force above 1 % of the largest", Measure::number, Detail::histories,
     [](const From& f) -> Number { return f.summary.forcePeaks; }, OutputGroup::impact, "force peaks",
     "Number of peaks of the impact force above 1 % of the largest", nullptr, notAUniformRod},
    {"efficiency_recovered",
     "efficiency, and what the hammer takes back with it, of a drill string",
     Measure::share,
     Detail::summary,
     [](const From& f) -> Number {
         return isString(f.scenario) ? Number(f.summary.efficiencyRecovered()) : std::nullopt;
     },
     OutputGroup::none,
     {},
     {},
     nullptr,
     notAString},
    {"efficiency_error",
     "stated error of the efficiency of a drill string",
     Measure::error,
     Detail::summary,
     ofString<&ImpactSummary::efficiencyError>,
     OutputGroup::none,
     {},
     {},
     nullptr,
     notAString},
    {"hammer_rebound_velocity",
     "velocity of the hammer after the blow, away from the rock, over that of impact", Measure::velocity,
     Detail::summary, ofHammer<&ImpactSummary::hammerReboundVelocity>, OutputGroup::impact, "hammer rebound",
     "Velocity of the hammer after the blow, away from the rock", nullptr, notOfAHammer},
    {"hammer_rebound_energy", "energy of the hammer moving back as a whole, fraction of that of impact",
     Measure::share, Detail::summary, ofHammer<&ImpactSummary::hammerReboundEnergy>, OutputGroup::energy,
     "into the hammer", "Share of its energy with which the hammer moves after the blow", nullptr,
     notOfAHammer},
    {"hammer_wave_energy", "energy left in waves of the hammer, fraction of its own", Measure::share,
     Detail::summary, ofHammer<&ImpactSummary::hammerWaveEnergy>, OutputGroup::energy, "waves in the hammer",
     "Share of its energy that runs to and fro in the hammer", nullptr, notOfAHammer},
    {"string_momentum",
     "momentum of the string after the blow, towards the rock, over that of the hammer",
     Measure::impulse,
     Detail::summary,
     ofString<&ImpactSummary::stringMomentum>,
     OutputGroup::none,
     {},
     {},
     nullptr,
     notAString},
    {"string_energy",
     "energy of the string after the blow, fraction of that of the hammer",
     Measure::share,
     Detail::summary,
     ofString<&ImpactSummary::stringEnergy>,
     OutputGroup::none,
     {},
     {},
     nullptr,
     notAString},
    {"joint_loss", "energy lost in joints, fraction of that of the hammer", Measure::share, Detail::summary,
     ofString<&ImpactSummary::jointLoss>, OutputGroup::energy, "lost in joints",
     "Share of the energy of the hammer that joints take", nullptr, notAString},
    {"rod_loss", "energy lost on the way through sections, fraction of that of the hammer", Measure::share,
     Detail::summary, ofString<&ImpactSummary::rodLoss>, OutputGroup::energy, "lost in sections",
     "Share of the energy of the hammer that waves lose on their way", nullptr, notAString},
    {"face_energy", "energy in the stiffness of the faces, fraction of that of the hammer", Measure::share,
     Detail::summary, ofHammer<&ImpactSummary::faceEnergy>, OutputGroup::energy, "between the faces",
     "Share of the energy of the hammer in the stiffness of the faces, where they still touch", nullptr,
     notOfElasticFaces},
    {"piston_separation_time", "time at which hammer and string first part", Measure::time, Detail::summary,
     ofHammer<&ImpactSummary::faceSeparationTime>, OutputGroup::impact, "hammer leaves",
     "Time at which hammer and string first part", nullptr, notOfAHammer},
    {"end_time",
     "time to which the blow was followed",
     Measure::time,
     Detail::summary,
     ofString<&ImpactSummary::endTime>,
     OutputGroup::none,
     {},
     {},
     nullptr,
     notAString},
});

}  // namespace

std::string Output::problem(const Scenario& scenario) const {
    return lack ? lack(scenario) : std::string();
}

bool Output::concerns(const Scenario& scenario) const {
    if (lack == notAString || lack == notOfAHammer || lack == notOfElasticFaces)
        return lack(scenario).empty();
    if (lack == notAUniformRod) return !isString(scenario);
    return true;
}

bool Output::isOnlySi() const {
    return measure == Measure::newton || measure == Measure::watt || measure == Measure::speed;
}

bool Output::needsThrustStudy() const {
    return name == thrustMarginName;
}

Quantity Output::quantity() const {
    switch (measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
            return Quantity::ratio;
        case Measure::time:
            return Quantity::time;
        case Measure::impulse:
            return Quantity::impulse;
        case Measure::force:
        case Measure::newton:
            return Quantity::force;
        case Measure::watt:
            return Quantity::power;
        case Measure::speed:
        case Measure::velocity:
            return Quantity::velocity;
        case Measure::penetration:
            return Quantity::length;
        case Measure::stress:
            return Quantity::stress;
    }
    return Quantity::ratio;
}

double Output::scale(const Scales& scales) const {
    switch (measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
        case Measure::newton:
        case Measure::watt:
        case Measure::speed:
            return 1;
        case Measure::time:
            return scales.time;
        case Measure::impulse:
            return scales.impulse;
        case Measure::force:
            return scales.force;
        case Measure::penetration:
            return scales.penetration;
        case Measure::stress:
            return scales.stress;
        case Measure::velocity:
            return scales.velocity;
    }
    return 1;
}

std::span<const Output> outputs() {
    return outputTable;
}

std::string overflowProblem(const Output& output, double value) {
    const bool isNever = output.measure == Measure::time && std::isnan(value);
    if (std::isfinite(value) || isNever) return {};
    return std::string(output.name) +
           " is beyond the range of double precision: the values are too large or too small";
}

std::string overflowProblem(const OutputSource& source, const Scales& scales, Detail detail) {
    for (const Output& output : outputTable) {
        const Number value = output.detail <= detail ? output.value(source) : std::nullopt;
        if (!value) continue;
        for (const double number : {*value, *value * output.scale(scales)})
            if (std::string problem = overflowProblem(output, number); !problem.empty()) return problem;
    }
    return {};
}

const Output* findOutput(std::string_view name) {
    const auto found = std::ranges::find(outputTable, name, &Output::name);
    return found == outputTable.end() ? nullptr : &*found;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/outputs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/blow/drill_problems.h"
#include "core/blow/feed_estimate.h"

namespace drillwave {

namespace {

using Number = std::optional<double>;
using From = OutputSource;

/// Per time: a number per blow in its unit times the blow frequency.
Number perTime(const From& from, double perBlow, double unit) {
    if (!frequencyProblem(from.scenario, "").isEmpty()) return std::nullopt;
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

/// Returns why an output is not defined for a scenario that is none of `which`.
Message whyNone(OutputOf which, const Scenario& scenario) {
    if (which == OutputOf::uniformRod) return translatable("only for uniform rods (`drillwave: 1`)");
    if (!concerns(OutputOf::drillString, scenario))
        return translatable("only for drill strings (`drillwave: 2`)");
    return isForced(scenario)
               ? translatable("only for a hammer of sections (`hammer`); this string is driven by a force")
               : translatable("only for faces with a stiffness (`hammer.face_stiffness`)");
}

Message whyNoPower(const Scenario& scenario) {
    return frequencyProblem(scenario, translatable("the percussion power"));
}

Message whyNoRate(const Scenario& scenario) {
    return frequencyProblem(scenario, translatable("the penetration rate"));
}

constexpr std::string_view thrustMarginName = "thrust_margin";

/// Prefix of all names of drillOutputs().
constexpr std::string_view drillPrefix = "drill_";

constexpr auto outputTable = std::to_array<Output>({
    {"cor", "coefficient of restitution e = -pf/p0", Measure::number, Detail::cor,
     number<&ImpactSummary::cor>, "restitution e"},
    {"impulse", "impulse of the impact force, 1 + e", Measure::impulse, Detail::cor,
     number<&ImpactSummary::impulse>, "impulse on the rock", OutputOf::anyBlow, OutputGroup::rebound,
     "Impulse of the impact force on the rock, (1 + e) times that of the hammer"},
    {"peak_force", "largest impact force", Measure::force, Detail::summary, number<&ImpactSummary::peakForce>,
     "peak force", OutputOf::anyBlow, OutputGroup::contact, "Largest impact force"},
    {"max_penetration", "largest penetration of the bit", Measure::penetration, Detail::summary,
     number<&ImpactSummary::maxPenetration>, "largest penetration", OutputOf::anyBlow,
     OutputGroup::penetration, "Largest penetration of the bit during the blow", std::nullopt, std::nullopt,
     nullptr, "", 1},
    {"residual_penetration", "residual penetration after the blow", Measure::penetration, Detail::summary,
     number<&ImpactSummary::residualPenetration>, "penetration per blow", OutputOf::anyBlow,
     OutputGroup::penetration, "Residual penetration after the blow"},
    {"first_contact_time", "time of the first contact", Measure::time, Detail::summary,
     number<&ImpactSummary::firstContactTime>, "first contact", OutputOf::anyBlow, OutputGroup::contact,
     "Time of the first contact"},
    {"separation_time", "time of the last separation", Measure::time, Detail::summary,
     number<&ImpactSummary::separationTime>, "last separation", OutputOf::anyBlow, OutputGroup::contact,
     "Time of the last separation"},
    {"contact_duration", "time in contact, summed over contacts", Measure::time, Detail::summary,
     number<&ImpactSummary::contactDuration>, "time in contact", OutputOf::anyBlow, OutputGroup::contact,
     "Summed over all contacts"},
    {"work_ratio", "work of the hammer over m v0^2/2", Measure::work, Detail::summary,
     number<&ImpactSummary::workRatio>, "hammer work W", OutputOf::anyBlow, OutputGroup::work,
     "Work of the hammer on the rod"},
    {"rock_work", "energy remaining in the rock, fraction of the hammer work", Measure::energy,
     Detail::summary, [](const From& f) -> Number { return f.summary.energy.rockWork; }, "into the rock",
     OutputOf::anyBlow, OutputGroup::share, "Share of the energy that remains in the rock: the efficiency",
     EnergyPart::rock},
    {"rebound_energy", "energy of the rebound, fraction of the hammer work", Measure::energy, Detail::summary,
     [](const From& f) -> Number { return f.summary.energy.reboundEnergy; }, "into the rebound",
     OutputOf::anyBlow, OutputGroup::share,
     "Share of the energy that moves the rod or the string back as a whole", EnergyPart::rebound},
    {"residual_wave_energy", "energy remaining in waves, fraction of the hammer work", Measure::energy,
     Detail::ledger, [](const From& f) -> Number { return f.summary.energy.residualWaveEnergy; },
     "remaining in waves", OutputOf::anyBlow, OutputGroup::share,
     "Share of the energy that remains in the rod or string as waves", EnergyPart::waves},
    {"efficiency", "share of the hammer work that remains in the rock", Measure::share, Detail::summary,
     [](const From& f) -> Number { return f.summary.energy.rockWork; }, "efficiency"},
    {"loading_work", "work on the rock up to the largest force, fraction of the hammer work", Measure::share,
     Detail::summary, number<&ImpactSummary::loadingWork>, "loading work"},
    {"momentum_residual", "error of the momentum balance, fraction of I0", Measure::error, Detail::ledger,
     number<&ImpactSummary::momentumResidual>, "error of the momentum balance"},
    {"energy_residual", "error of the energy balance, fraction of the hammer work", Measure::error,
     Detail::ledger, [](const From& f) -> Number { return f.summary.energy.residual; },
     "error of the energy balance", OutputOf::anyBlow, OutputGroup::share,
     "Difference of all shares together from 1", std::nullopt, std::nullopt, nullptr, "balance error"},
    {"cor_error", "bound on the numerical error of cor", Measure::error, Detail::cor,
     number<&ImpactSummary::corError>, "bound on the error of e"},
    {"thrust", "blow frequency times impulse, N, if the scenario gives a frequency", Measure::newton,
     Detail::cor,
     [](const From& f) { return thrustNeeded(f.scenario, f.summary.cor, f.summary.transferred); },
     "feed force required by this blow", OutputOf::anyBlow, OutputGroup::none, "", std::nullopt, std::nullopt,
     thrustProblem},
    {thrustMarginName,
     "effective feed force over the largest of the four required ones, less 1, if the scenario gives them; "
     "takes a study of all gaps",
     Measure::number, Detail::cor, [](const From& f) { return f.thrustMargin; },
     "feed force margin at every gap", OutputOf::anyBlow, OutputGroup::none, "", std::nullopt, std::nullopt,
     thrustMarginProblem},
    {"percussion_power", "hammer work times blow frequency, W, if the scenario gives a frequency",
     Measure::watt, Detail::summary, percussionPower, "percussion power", OutputOf::anyBlow,
     OutputGroup::work, "Work of the hammer on the rod times the blow frequency", std::nullopt, std::nullopt,
     whyNoPower},
    {"penetration_rate",
     "residual penetration times blow frequency, m/s, if the scenario gives a frequency: an upper limit",
     Measure::speed, Detail::summary, penetrationRate, "penetration rate", OutputOf::anyBlow,
     OutputGroup::penetration,
     "Residual penetration times blow frequency. It is an upper limit for blows from rest: indexing, "
     "flushing and lost contact reduce it. Residual waves may add to it (page Drilling).",
     std::nullopt, std::nullopt, whyNoRate},
    {"peak_compression", "largest compression in the rod during the blow", Measure::stress, Detail::histories,
     [](const From& f) -> Number { return f.summary.largest.compression; }, "compression, blow",
     OutputOf::anyBlow, OutputGroup::stress,
     "Largest compressive stress of uniform sections during the blow, until one transit time after the last "
     "separation of bit and rock; threads and shoulders raise it locally",
     std::nullopt, Load::compression},
    {"peak_tension", "largest tension in the rod during the blow", Measure::stress, Detail::histories,
     [](const From& f) -> Number { return f.summary.largest.tension; }, "tension, blow", OutputOf::anyBlow,
     OutputGroup::stress,
     "Largest tensile stress of uniform sections during the blow, until one transit time after the last "
     "separation of bit and rock; threads and shoulders raise it locally",
     std::nullopt, Load::tension},
    {"peak_compression_after", "largest compression of the residual waves, undamped", Measure::stress,
     Detail::histories, [](const From& f) -> Number { return f.summary.largest.compressionAfter; },
     "compression, after", OutputOf::anyBlow, OutputGroup::stress,
     "Largest compressive stress of the residual waves after the blow; for drill strings, over one round "
     "trip. The model does not damp them, a real rod does.",
     std::nullopt, Load::compressionAfter},
    {"peak_tension_after", "largest tension of the residual waves, undamped", Measure::stress,
     Detail::histories, [](const From& f) -> Number { return f.summary.largest.tensionAfter; },
     "tension, after", OutputOf::anyBlow, OutputGroup::stress,
     "Largest tensile stress of the residual waves after the blow; for drill strings, over one round trip. "
     "The model does not damp them, a real rod does.",
     std::nullopt, Load::tensionAfter},
    {"force_peaks", "peaks of the impact force above 1 % of the largest", Measure::number, Detail::histories,
     [](const From& f) -> Number { return f.summary.forcePeaks; }, "force peaks", OutputOf::uniformRod,
     OutputGroup::contact, "Number of peaks of the impact force above 1 % of the largest"},
    {"efficiency_recovered", "efficiency plus the energy that returns with the hammer, for drill strings",
     Measure::share, Detail::summary, [](const From& f) -> Number { return f.summary.efficiencyRecovered(); },
     "rock, and energy returned with the hammer", OutputOf::drillString},
    {"efficiency_error", "error bound of the efficiency, for drill strings", Measure::error, Detail::summary,
     number<&ImpactSummary::efficiencyError>, "bound on the error of the efficiency", OutputOf::drillString},
    {"stress_error", "error bound of the largest stresses of a drill string, fraction of each",
     Measure::error, Detail::histories, number<&ImpactSummary::stressError>,
     "bound on the error of the stresses", OutputOf::drillString},
    {"hammer_rebound_velocity",
     "velocity of the hammer after the blow, away from the rock, over that of impact", Measure::velocity,
     Detail::summary, number<&ImpactSummary::hammerReboundVelocity>, "hammer rebound", OutputOf::hammer,
     OutputGroup::contact, "Velocity of the hammer after the blow, away from the rock"},
    {"hammer_rebound_energy", "energy of the hammer's motion after the blow, fraction of that before it",
     Measure::energy, Detail::summary, number<&ImpactSummary::hammerReboundEnergy>, "into the hammer",
     OutputOf::hammer, OutputGroup::share,
     "Share of the hammer energy that remains as motion of the hammer after the blow", EnergyPart::hammer},
    {"hammer_wave_energy", "energy remaining in waves of the hammer, fraction of the hammer energy",
     Measure::energy, Detail::summary, number<&ImpactSummary::hammerWaveEnergy>, "waves in the hammer",
     OutputOf::hammer, OutputGroup::share, "Share of the hammer energy that remains in the hammer as waves",
     EnergyPart::hammer},
    {"string_momentum", "momentum of the string after the blow, towards the rock, over that of the hammer",
     Measure::impulse, Detail::summary, number<&ImpactSummary::stringMomentum>,
     "momentum of the string to the rock", OutputOf::drillString},
    {"string_energy", "energy of the string after the blow, fraction of the hammer energy", Measure::energy,
     Detail::summary, number<&ImpactSummary::stringEnergy>, "remaining in the string", OutputOf::drillString},
    {"joint_loss", "energy lost in joints, fraction of the hammer energy", Measure::energy, Detail::summary,
     number<&ImpactSummary::jointLoss>, "lost in joints", OutputOf::drillString, OutputGroup::share,
     "Share of the hammer energy lost in joints", EnergyPart::losses},
    {"rod_loss", "energy lost along the sections, fraction of the hammer energy", Measure::energy,
     Detail::summary, number<&ImpactSummary::rodLoss>, "lost in sections", OutputOf::drillString,
     OutputGroup::share, "Share of the hammer energy that waves lose along the sections", EnergyPart::losses},
    {"face_energy", "energy stored in the stiffness of the faces, fraction of the hammer energy",
     Measure::energy, Detail::summary, number<&ImpactSummary::faceEnergy>, "between the faces",
     OutputOf::elasticFaces, OutputGroup::share,
     "Share of the hammer energy stored in the stiffness of the faces while they touch", EnergyPart::losses},
    {"piston_separation_time", "time of the first separation of hammer and string", Measure::time,
     Detail::summary, number<&ImpactSummary::faceSeparationTime>, "hammer separates", OutputOf::hammer,
     OutputGroup::contact, "Time of the first separation of hammer and string"},
    {"end_time", "end of the computed time of the blow", Measure::time, Detail::summary,
     number<&ImpactSummary::endTime>, "computed until", OutputOf::drillString},
});

template <DrillNumbers::Number DrillNumbers::*member>
std::optional<double> drilled(const OutputSource& from) {
    return from.drill ? from.drill->*member : std::nullopt;
}

template <DrillNumbers::Number DrillNumbers::*member>
constexpr Output row(std::string_view name, std::string_view meaning, Measure measure,
                     std::string_view title) {
    return {.name = name,
            .meaning = meaning,
            .measure = measure,
            .detail = Detail::cor,
            .number = drilled<member>,
            .title = title,
            .lack = drillProblem};
}

using D = DrillNumbers;

constexpr std::string_view lyapunovName = "drill_lyapunov", errorName = "drill_penetration_error";

constexpr auto drillTable = std::to_array<Output>({
    row<&D::gapMean>("drill_gap_mean",
                     "mean gap between bit and rock at the start of the blows, from `drill`",
                     Measure::penetration, "mean gap at the blow"),
    row<&D::gapDeviation>("drill_gap_deviation",
                          "standard deviation of the gap between bit and rock at the start of the blows",
                          Measure::penetration, "deviation of the gap"),
    row<&D::gap05>("drill_gap_05", "gap between bit and rock that 95 % of the blows exceed",
                   Measure::penetration, "5 % of the gaps"),
    row<&D::gap50>("drill_gap_50", "median of the gap between bit and rock at the start of the blows",
                   Measure::penetration, "median of the gaps"),
    row<&D::gap95>("drill_gap_95", "gap between bit and rock that 5 % of the blows exceed",
                   Measure::penetration, "95 % of the gaps"),
    row<&D::penetration>(
        "drill_penetration",
        "mean penetration per blow; an upper limit, as all rock under the bit is assumed to break",
        Measure::penetration, "mean penetration of a blow"),
    row<&D::penetrationError>(errorName,
                              "95 % error of drill_penetration, the mean penetration per blow. Needs a "
                              "second simulation of all blows, with other time steps",
                              Measure::penetration, "error of the mean penetration"),
    row<&D::penetrationRate>("drill_penetration_rate",
                             "penetration rate, m/s: mean penetration per blow times blow frequency; an "
                             "upper limit, as all rock under the bit is assumed to break",
                             Measure::speed, "penetration rate of many blows"),
    row<&D::rockImpulse>("drill_rock_impulse",
                         "mean impulse on the rock per blow: feed force over blow frequency",
                         Measure::impulse, "mean impulse on the rock"),
    row<&D::peakForce>("drill_peak_force", "mean over all blows of the largest force on the rock",
                       Measure::force, "mean peak force"),
    row<&D::damperForce>("drill_damper_force", "largest force in the damper between machine and rod",
                         Measure::force, "largest force in the damper between machine and rod"),
    row<&D::contactShare>(
        "drill_contact_share",
        "contact share: share of blows that start with the bit on the rock, or less than 0.05 d0 away from "
        "it. d0 = 2 I0/Z, with the impulse I0 of a blow and the impedance Z of the rod",
        Measure::number, "contact share: blows that start with the bit on the rock"),
    row<&D::contacts>("drill_contacts", "mean number of contacts between bit and rock in a blow",
                      Measure::number, "contacts of a blow"),
    row<&D::period>("drill_period",
                    "number of blows after which the motion repeats, 1 to 16; 0 if it does not repeat",
                    Measure::number, "period of the motion"),
    row<&D::lyapunov>(lyapunovName,
                      "Lyapunov exponent: growth of a small disturbance per blow; above 0, single blows are "
                      "not reproducible and only mean values count. Needs a second simulation of all blows",
                      Measure::number, "Lyapunov exponent"),
    row<&D::thrustNumber>("drill_thrust_number",
                          "effective feed force divided by the mean force of the blows (phi); below 1 the "
                          "blows push the machine back",
                          Measure::number, "thrust number"),
    row<&D::roundTrips>(
        "drill_round_trips",
        "number of round trips that a wave makes through rod or string between two blows (n_b)",
        Measure::number, "round trips from blow to blow"),
    row<&D::momentumResidual>(
        "drill_momentum_residual",
        "error of the momentum balance of all blows, relative to the impulse of the feed force",
        Measure::error, "error of the momentum of many blows"),
    row<&D::energyResidual>("drill_energy_residual",
                            "error of the energy balance of all blows, as a share of the hammer work",
                            Measure::error, "error of the energy of many blows"),
});

}  // namespace

bool concerns(OutputOf which, const Scenario& scenario) {
    switch (which) {
        case OutputOf::anyBlow:
            return true;
        case OutputOf::uniformRod:
        case OutputOf::drillString:
            return isString(scenario) == (which == OutputOf::drillString);
        case OutputOf::hammer:
            return !isForced(scenario);
        case OutputOf::elasticFaces:
            return !isForced(scenario) && scenario.drillString.hammer.faceStiffness;
    }
    return false;
}

Message Output::problem(const Scenario& scenario) const {
    if (!concerns(scenario)) return whyNone(of, scenario);
    return lack ? lack(scenario) : Message();
}

bool Output::concerns(const Scenario& scenario) const {
    return drillwave::concerns(of, scenario);
}

std::string_view Output::label() const {
    if (group == OutputGroup::none) return {};
    return shortTitle.empty() ? title : shortTitle;
}

bool Output::isOnlySi() const {
    return measure == Measure::newton || measure == Measure::watt || measure == Measure::speed;
}

bool Output::needsThrustStudy() const {
    return name == thrustMarginName;
}

bool Output::needsDrilling() const {
    return name.starts_with(drillPrefix);
}

Quantity Output::quantity() const {
    switch (measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
        case Measure::energy:
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

Quantity Output::siQuantity() const {
    return measure == Measure::energy ? Quantity::energy : quantity();
}

double Output::inSi(double value, const OutputSource& source, const Scales& scales) const {
    if (measure != Measure::energy) return value * scale(scales);
    return value * (drivenEnergy(source.summary, source.scenario) * scales.energy);
}

double Output::scale(const Scales& scales) const {
    switch (measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
        case Measure::energy:
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

std::span<const Output> drillOutputs() {
    return drillTable;
}

RequiredMarches drillWishesOf(const Output& output) {
    return {.any = output.needsDrilling(),
            .lyapunov = output.name == lyapunovName,
            .penetrationError = output.name == errorName};
}

Message overflowProblem(const Output& output, double value) {
    const bool isNever = output.measure == Measure::time && std::isnan(value);
    if (std::isfinite(value) || isNever) return {};
    return {translatable("%1 is beyond the range of double precision: the values are too large or too small"),
            {std::string(output.name)}};
}

Message overflowProblem(const OutputSource& source, const Scales& scales, Detail detail) {
    for (const Output& output : outputTable) {
        const Number value = output.detail <= detail ? output.value(source) : std::nullopt;
        if (!value) continue;
        for (const double number : {*value, *value * output.scale(scales)})
            if (Message problem = overflowProblem(output, number); !problem.isEmpty()) return problem;
    }
    return {};
}

MainOutput mainOutput(const Scenario& scenario) {
    const MainOutput ofCells{findOutput("efficiency"), findOutput("efficiency_error")};
    return ofCells.error->concerns(scenario) ? ofCells
                                             : MainOutput{findOutput("cor"), findOutput("cor_error")};
}

const Output* findOutput(std::string_view name) {
    for (const std::span<const Output> table : {outputs(), drillOutputs()})
        if (const auto found = std::ranges::find(table, name, &Output::name); found != table.end())
            return &*found;
    return nullptr;
}

}  // namespace drillwave

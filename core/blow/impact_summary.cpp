// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/impact_summary.h"

#include <algorithm>
#include <array>

#include "core/contact/bilinear_law.h"

namespace drillwave {

namespace {

double one(const Scales&) {
    return 1;
}
double timeScale(const Scales& scales) {
    return scales.time;
}
double impulseScale(const Scales& scales) {
    return scales.impulse;
}
double forceScale(const Scales& scales) {
    return scales.force;
}
double penetrationScale(const Scales& scales) {
    return scales.penetration;
}

constexpr auto outputTable = std::to_array<Output>({
    {"cor", "coefficient of restitution e = -pf/p0", Quantity::ratio, Detail::cor,
     [](const ImpactSummary& s) { return s.cor; }, one},
    {"impulse", "impulse of the impact force, 1 + e", Quantity::impulse, Detail::cor,
     [](const ImpactSummary& s) { return s.impulse; }, impulseScale},
    {"peak_force", "largest impact force", Quantity::force, Detail::summary,
     [](const ImpactSummary& s) { return s.peakForce; }, forceScale},
    {"max_penetration", "largest penetration of the bit", Quantity::length, Detail::summary,
     [](const ImpactSummary& s) { return s.maxPenetration; }, penetrationScale},
    {"residual_penetration", "penetration that stays after the blow", Quantity::length, Detail::summary,
     [](const ImpactSummary& s) { return s.residualPenetration; }, penetrationScale},
    {"first_contact_time", "time of the first contact", Quantity::time, Detail::summary,
     [](const ImpactSummary& s) { return s.firstContactTime; }, timeScale},
    {"separation_time", "time of the last separation", Quantity::time, Detail::summary,
     [](const ImpactSummary& s) { return s.separationTime; }, timeScale},
    {"contact_duration", "time in contact, summed over contacts", Quantity::time, Detail::summary,
     [](const ImpactSummary& s) { return s.contactDuration; }, timeScale},
    {"work_ratio", "work of the hammer over m v0^2/2", Quantity::ratio, Detail::summary,
     [](const ImpactSummary& s) { return s.workRatio; }, one},
    {"rock_work", "energy left in the rock, fraction of the hammer work", Quantity::ratio, Detail::summary,
     [](const ImpactSummary& s) { return s.energy.rockWork; }, one},
    {"rebound_energy", "energy of the rebound, fraction of the hammer work", Quantity::ratio, Detail::summary,
     [](const ImpactSummary& s) { return s.energy.reboundEnergy; }, one},
    {"residual_wave_energy", "energy left in waves, fraction of the hammer work", Quantity::ratio,
     Detail::summary, [](const ImpactSummary& s) { return s.energy.residualWaveEnergy; }, one},
    {"efficiency", "share of the hammer work that stays in the rock", Quantity::ratio, Detail::summary,
     [](const ImpactSummary& s) { return s.energy.rockWork; }, one},
    {"momentum_residual", "error of the momentum balance, fraction of I0", Quantity::ratio, Detail::summary,
     [](const ImpactSummary& s) { return s.momentumResidual; }, one},
    {"energy_residual", "error of the energy balance, fraction of the hammer work", Quantity::ratio,
     Detail::summary, [](const ImpactSummary& s) { return s.energy.residual; }, one},
    {"cor_error", "bound on the numerical error of cor", Quantity::ratio, Detail::cor,
     [](const ImpactSummary& s) { return s.corError; }, one},
});

}  // namespace

ImpactSummary summarize(const Impact& impact, const Problem& problem) {
    BilinearLaw<> rock(problem.law);
    rock.remember(impact.peakForce);
    return {.cor = impact.cor,
            .impulse = impact.impulse,
            .peakForce = impact.peakForce,
            .maxPenetration = rock.largestPenetration() * lawUnitOfPenetration,  // (T4)
            .residualPenetration = rock.residualPenetration() * lawUnitOfPenetration,
            .firstContactTime = impact.firstContactTime,
            .separationTime = impact.separationTime,
            .contactDuration = impact.contactDuration,
            .workRatio = impact.hammerWork * 2 * problem.transitTime,  // [paper (2)]
            .energy = ledgerOf(impact, problem),
            .momentumResidual = 1 - impact.impulse - impact.finalMomentum,  // [paper (10)]
            .corError = impact.corError,
            .growth = impact.growth,
            .contacts = impact.contacts,
            .rodForces = {}};
}

std::span<const Output> outputs() {
    return outputTable;
}

const Output* findOutput(std::string_view name) {
    const auto found = std::ranges::find(outputTable, name, &Output::name);
    return found == outputTable.end() ? nullptr : &*found;
}

}  // namespace drillwave

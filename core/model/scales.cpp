// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scales.h"

#include <cmath>
#include <numbers>

#include "core/model/blow_traits.h"
#include "core/model/section_pieces.h"

namespace drillwave {

namespace {

/// Section that the force pushes: the rod, or the first section of a string, at its rear end.
struct RearEnd {
    Material material;
    double impedance = 0;
};
RearEnd rearEndOf(const Scenario& scenario) {
    const Rod& rod = scenario.rod;
    const Section* first = sectionAt(scenario.drillString, 1);
    if (!first) return {{rod.youngsModulus, rod.density}, propertiesOf(rod).impedance};
    const Material& material = scenario.drillString.material;
    Section rear = *first;
    rear.area = areaAt(rear, 0);
    rear.endArea.reset();
    return {{rear.youngsModulus.value_or(material.youngsModulus), rear.density.value_or(material.density)},
            propertiesOf(rear, material).impedance};
}

/// Impedance and mass of the hammer, its material being the rod's where none is given.
RodProperties hammerOf(const Scenario& scenario) {
    const Piston& piston = scenario.pulse.piston;
    const Material rear = rearEndOf(scenario).material;
    Rod hammer;
    hammer.length = piston.length;
    hammer.diameter = piston.diameter;
    hammer.youngsModulus = piston.youngsModulus.value_or(rear.youngsModulus);
    hammer.density = piston.density.value_or(rear.density);
    return propertiesOf(hammer);
}

/// The whole staircase: F_0 t0/(1 − R) = m v for q ≥ 1; the single step F_0 t0 = 2 m v/(1 + q) below.
double pistonImpulse(const Scenario& scenario) {
    const double ratio = pistonImpedanceRatio(scenario);
    const double momentum = hammerOf(scenario).mass * scenario.pulse.piston.velocity;
    return ratio >= 1 ? momentum : momentum * 2 / (1 + ratio);
}

double tableImpulse(const TablePoints& points) {
    double impulse = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        impulse += (points[i].time - points[i - 1].time) * (points[i].force / 2 + points[i - 1].force / 2);
    return impulse;
}

void add(ChainProperties& sum, const Section& section, const Material& material, double times) {
    const RodProperties properties = propertiesOf(section, material);
    sum.length += times * section.length;
    sum.transitTime += times * properties.transitTime;
    sum.mass += times * (properties.mass + section.massAfter);
}

/// Returns the properties that the scales refer to: of the rod, or of the ruleSection() of a string.
RodProperties ruleProperties(const Scenario& scenario) {
    const Section* rule = ruleSection(scenario.drillString);
    return rule ? propertiesOf(*rule, scenario.drillString.material) : propertiesOf(scenario.rod);
}

}  // namespace

RodProperties propertiesOf(const Rod& rod) {
    RodProperties result;
    result.area =
        rod.area.value_or(std::numbers::pi / 4 * (rod.diameter - rod.bore) * (rod.diameter + rod.bore));
    result.waveSpeed = std::sqrt(rod.youngsModulus / rod.density);
    result.impedance = result.area * rod.youngsModulus / result.waveSpeed;
    result.transitTime = rod.length / result.waveSpeed;
    result.mass = rod.density * result.area * rod.length;
    return result;
}

RodProperties propertiesOf(const Section& section, const Material& material) {
    Rod rod;
    rod.length = section.length;
    rod.diameter = section.diameter;
    rod.bore = section.bore;
    rod.area = isUniform(section) ? section.area : meanArea(section);
    rod.youngsModulus = section.youngsModulus.value_or(material.youngsModulus);
    rod.density = section.density.value_or(material.density);
    return propertiesOf(rod);
}

ChainProperties hammerProperties(const DrillString& drillString) {
    ChainProperties sum;
    for (const Section& section : drillString.hammer.sections) add(sum, section, drillString.material, 1);
    return sum;
}

ChainProperties stringProperties(const DrillString& drillString) {
    ChainProperties sum;
    for (const StringPart& part : drillString.parts)
        for (const Section& section : part.sections) add(sum, section, drillString.material, part.repeat);
    return sum;
}

double pistonImpedanceRatio(const Scenario& scenario) {
    if (scenario.form == ScenarioForm::dimensionless) return scenario.pulse.piston.impedanceRatio;
    return hammerOf(scenario).impedance / rearEndOf(scenario).impedance;
}

double pulseDuration(const Scenario& scenario) {
    if (!hasUnits(scenario)) return 1;
    if (!isForced(scenario)) return 2 * hammerProperties(scenario.drillString).transitTime;
    const Pulse& pulse = scenario.pulse;
    if (pulse.shape == PulseShape::piston) return 2 * hammerOf(scenario).transitTime;
    if (pulse.shape == PulseShape::table)
        return pulse.tablePoints.empty() ? 0 : pulse.tablePoints.back().time - pulse.tablePoints.front().time;
    return pulse.duration;
}

double pulseImpulse(const Scenario& scenario) {
    if (!hasUnits(scenario)) return 1;
    if (!isForced(scenario))
        return hammerProperties(scenario.drillString).mass * scenario.drillString.hammer.velocity;
    if (scenario.pulse.shape == PulseShape::piston) return pistonImpulse(scenario);
    if (scenario.pulse.shape == PulseShape::table) return tableImpulse(scenario.pulse.tablePoints);
    return scenario.pulse.impulse;
}

double meanForce(const Pulse& pulse) {
    const double quotient = pulse.impulse / pulse.duration;
    for (const double candidate : {quotient, std::nextafter(quotient, 0), std::nextafter(quotient, HUGE_VAL)})
        if (candidate * pulse.duration == pulse.impulse) return candidate;
    return quotient;
}

ChainProperties chainProperties(const Scenario& scenario) {
    const ChainProperties string = stringProperties(scenario.drillString);
    if (string.length != 0) return string;
    const RodProperties rod = propertiesOf(scenario.rod);
    return {scenario.rod.length, rod.transitTime, rod.mass};
}

Groups groupsOf(const Scenario& scenario) {
    if (!hasUnits(scenario)) return scenario.groups;
    const Scales scales = scalesOf(scenario);
    return {.beta = scenario.bitRock.stiffness / scales.stiffness,
            .gamma = scenario.bitRock.gamma,
            .tau = chainProperties(scenario).transitTime / scales.time,
            .delta = scenario.bitRock.gap / scales.penetration};
}

Scales scalesOf(const Scenario& scenario) {
    if (!hasUnits(scenario)) return {};
    const RodProperties rule = ruleProperties(scenario);
    const ChainProperties chain = chainProperties(scenario);
    Scales scales;
    scales.time = pulseDuration(scenario);
    scales.impulse = pulseImpulse(scenario);
    if (isForced(scenario)) {
        scales.force = scales.impulse / scales.time;
        scales.velocity = scales.impulse / chain.mass;
        scales.particleVelocity = scales.force / rule.impedance;
        scales.penetration = 2 * scales.impulse / rule.impedance;  // [paper (3)]
    } else {
        scales.velocity = scenario.drillString.hammer.velocity;
        scales.force = rule.impedance * scales.velocity / 2;
        scales.particleVelocity = scales.velocity / 2;
        scales.penetration = scales.velocity * scales.time;
    }
    scales.stress = scales.force / rule.area;
    scales.stiffness = rule.impedance / scales.time;
    scales.energy = scales.impulse * scales.velocity / 2;
    scales.length = chain.length;
    return scales;
}

std::optional<double> gapPeriod(const Scenario& scenario) {
    return isFollowedByEvents(scenario) ? std::optional(scalesOf(scenario).penetration) : std::nullopt;
}

std::optional<double> roundTripsBetweenBlows(const Scenario& scenario) {
    if (!hasUnits(scenario) || !scenario.drill.blowFrequency) return std::nullopt;
    return 1 / (2 * chainProperties(scenario).transitTime * *scenario.drill.blowFrequency);
}

std::optional<int> stepOfWaves(double roundTrips) {
    constexpr double inStep = 0.1;
    const double whole = std::round(roundTrips);
    if (whole < 1 || whole >= enoughRoundTrips || std::abs(roundTrips - whole) > inStep) return std::nullopt;
    return static_cast<int>(whole);
}

}  // namespace drillwave

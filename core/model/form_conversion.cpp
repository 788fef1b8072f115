// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/form_conversion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/blow_traits.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"
#include "core/model/string_edit.h"

namespace drillwave {

namespace {

/// Additions to the title of a scenario that state its form.
constexpr std::string_view asString = ", as a drill string", asRod = ", as a uniform rod";

std::string titleAs(std::string title, std::string_view form) {
    for (const std::string_view other : {asString, asRod})
        if (title.ends_with(other)) title.resize(title.size() - other.size());
    return title.empty() ? title : title.append(form);
}

Section sectionOf(const Piston& piston) {
    Section section;
    section.length = piston.length;
    section.diameter = piston.diameter;
    section.youngsModulus = piston.youngsModulus;
    section.density = piston.density;
    return section;
}

std::string wholeMillimetres(double length) {
    return std::to_string(std::lround(1000 * length)) + " mm";
}

/// Rounds the lengths of hammer and rod, so that they share few cells of the solver. The momentum stays.
void roundLengths(DrillString& drillString, std::vector<Message>& lost) {
    Section& hammer = drillString.hammer.sections.front();
    Section& rod = drillString.parts.front().sections.front();
    const double ofHammer = roundedLength(hammer.length), ofRod = roundedLength(rod.length);
    if (ofHammer != hammer.length)
        lost.push_back({translatable("The hammer is rounded to %1, so that waves can be kept. Its impulse is "
                                     "the same; its blow is longer or shorter in proportion."),
                        {wholeMillimetres(ofHammer)}});
    if (ofRod != rod.length)
        lost.push_back({translatable("The rod is rounded to %1, so that waves can be kept."),
                        {wholeMillimetres(ofRod)}});
    drillString.hammer.velocity *= hammer.length / ofHammer;
    hammer.length = ofHammer;
    rod.length = ofRod;
}

/// The hammer of a rectangular blow or a piston.
Hammer hammerOf(const Scenario& scenario, std::vector<Message>& lost) {
    const Pulse& pulse = scenario.pulse;
    Hammer hammer;
    hammer.restrike = false;
    if (pulse.shape == PulseShape::piston) {
        hammer.velocity = pulse.piston.velocity;
        hammer.sections = {sectionOf(pulse.piston)};
        if (pistonImpedanceRatio(scenario) > 1)
            lost.emplace_back(translatable(
                "The force is no longer prescribed: reflected waves can separate the hammer from the rod."));
        return hammer;
    }
    Section section;
    section.diameter = scenario.rod.diameter;
    section.bore = scenario.rod.bore;
    section.area = scenario.rod.area;
    section.length = propertiesOf(scenario.rod).waveSpeed * pulseDuration(scenario) / 2;
    hammer.sections = {section};
    const Material material{scenario.rod.youngsModulus, scenario.rod.density};
    hammer.velocity = pulseImpulse(scenario) / propertiesOf(section, material).mass;
    return hammer;
}

/// Returns whether a uniform hammer makes that force; any other shape stays a force.
bool isOfHammer(PulseShape shape) {
    return shape == PulseShape::rectangular || shape == PulseShape::piston;
}

/// Adds a sentence on each difference from the section that is kept.
void nameLostSections(const DrillString& drill, std::vector<Message>& lost) {
    const double kept = propertiesOf(*ruleSection(drill), drill.material).impedance;
    int others = 0, losses = 0;
    double mass = 0;
    const std::vector<const Section*> sections = expandedSections(drill);
    for (const Section* section : sections) {
        const double impedance = propertiesOf(*section, drill.material).impedance;
        others += std::abs(impedance - kept) > 1e-9 * kept || !isUniform(*section);
        losses += section->loss > 0 || section->attenuation > 0;
        mass += section->massAfter;
    }
    if (others > 0)
        lost.push_back({translatable("%1 of %2 sections have another impedance (couplings, adapter, bit): "
                                     "they became rod, which reflects nothing."),
                        {std::to_string(others), std::to_string(sections.size())}});
    if (mass > 0) lost.emplace_back(translatable("The lumped masses, that of the bit among them."));
    if (losses > 0) lost.emplace_back(translatable("The losses in joints and along the rods."));
}

void nameLostHammer(const Hammer& hammer, std::vector<Message>& lost) {
    if (hammer.sections.size() > 1)
        lost.emplace_back(
            translatable("The steps of the hammer: it became uniform, with the same mass, velocity and "
                         "travel time of waves."));
    if (hammer.faceStiffness) lost.emplace_back(translatable("The elastic face of the hammer: it is rigid."));
    if (hammer.restrike)
        lost.emplace_back(
            translatable("After separation the hammer is withdrawn: it does not strike again."));
}

/// The uniform hammer of the mass, velocity and transit time of this one.
Pulse pistonOf(const DrillString& drill, std::vector<Message>& lost) {
    const ChainProperties hammer = hammerProperties(drill);
    const Section& front = drill.hammer.sections.back();
    Pulse pulse;
    pulse.shape = PulseShape::piston;
    Piston& piston = pulse.piston;
    piston.velocity = drill.hammer.velocity;
    piston.youngsModulus = front.youngsModulus.value_or(drill.material.youngsModulus);
    piston.density = front.density.value_or(drill.material.density);
    piston.length = propertiesOf(front, drill.material).waveSpeed * hammer.transitTime;
    piston.diameter = std::sqrt(4 * hammer.mass / (std::numbers::pi * *piston.density * piston.length));
    nameLostHammer(drill.hammer, lost);
    return pulse;
}

/// Returns a piston of the rod's material that has the duration and the impulse.
Piston pistonOf(const Piston& groups, const RodProperties& rod, double density, double duration,
                double impulse) {
    const double ratio = groups.impedanceRatio;
    Piston piston;
    piston.length = rod.waveSpeed * duration / 2;
    const double area = ratio * rod.area;
    piston.diameter = std::sqrt(4 * area / std::numbers::pi);
    const double momentum = ratio >= 1 ? impulse : impulse * (1 + ratio) / 2;
    piston.velocity = momentum / (density * area * piston.length);
    return piston;
}

/// Returns the points stretched to the duration and the impulse.
TablePoints stretched(const TablePoints& points, double duration, double impulse) {
    double area = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        area += (points[i].time - points[i - 1].time) * (points[i].force / 2 + points[i - 1].force / 2);
    const double first = points.front().time;
    const double toTime = duration / (points.back().time - first), toForce = impulse / (area * toTime);
    std::vector<TablePoint> list;
    for (const TablePoint& point : points)
        list.push_back({(point.time - first) * toTime, point.force * toForce});
    return list;
}

}  // namespace

Section sectionOf(const Rod& rod, const Material& material) {
    Section section;
    section.name = "rod";
    section.length = rod.length;
    section.diameter = rod.diameter;
    section.bore = rod.bore;
    section.area = rod.area;
    if (rod.youngsModulus != material.youngsModulus) section.youngsModulus = rod.youngsModulus;
    if (rod.density != material.density) section.density = rod.density;
    section.yieldStrength = rod.yieldStrength;
    section.fatigueStrength = rod.fatigueStrength;
    return section;
}

Message whyNoString(const Scenario& scenario) {
    if (hasSections(scenario)) return translatable("it is a drill string already");
    if (!hasUnits(scenario))
        return translatable("a drill string has physical units, and this scenario has none");
    if (scenario.pulse.shape == PulseShape::rigidBody)
        return translatable("the reference case of a rod that arrives without waves has no hammer");
    return {};
}

Scenario oneSectionOf(const Scenario& scenario) {
    Scenario string;
    string.title = scenario.title;
    string.form = ScenarioForm::string;
    string.pulse = scenario.pulse;
    string.bitRock = scenario.bitRock;
    string.drill = scenario.drill;
    string.drillString.material = {scenario.rod.youngsModulus, scenario.rod.density};
    string.drillString.parts.resize(1);
    string.drillString.parts.front().sections = {sectionOf(scenario.rod, string.drillString.material)};
    return string;
}

Conversion stringOf(const Scenario& scenario) {
    assert(whyNoString(scenario).isEmpty());
    Conversion converted{oneSectionOf(scenario), {}};
    Scenario& string = converted.scenario;
    string.title = titleAs(scenario.title, asString);
    if (!isOfHammer(scenario.pulse.shape)) return converted;
    string.pulse = Pulse();
    string.drillString.hammer = hammerOf(scenario, converted.lost);
    roundLengths(string.drillString, converted.lost);
    return converted;
}

Conversion forcedStringOf(const Scenario& scenario) {
    assert(!isForced(scenario));
    Conversion converted{scenario, {}};
    converted.scenario.pulse = pistonOf(scenario.drillString, converted.lost);
    converted.scenario.drillString.hammer = Hammer();
    converted.lost.emplace_back(translatable(
        "Waves reflected to the hammer are left out: the force is that of the hammer on an endless rod."));
    return converted;
}

Scenario withForce(const Scenario& scenario) {
    return !isForced(scenario) ? forcedStringOf(scenario).scenario : scenario;
}

Conversion uniformRodOf(const Scenario& scenario) {
    const DrillString& drill = scenario.drillString;
    const Section& kept = *ruleSection(drill);
    const RodProperties properties = propertiesOf(kept, drill.material);
    Conversion converted;
    Scenario& uniform = converted.scenario;
    uniform.title = titleAs(scenario.title, asRod);
    uniform.bitRock = scenario.bitRock;
    uniform.drill = scenario.drill;
    uniform.rod = {.length = properties.waveSpeed * stringProperties(drill).transitTime,
                   .diameter = kept.diameter,
                   .bore = kept.bore,
                   .area = kept.area,
                   .youngsModulus = kept.youngsModulus.value_or(drill.material.youngsModulus),
                   .density = kept.density.value_or(drill.material.density),
                   .yieldStrength = kept.yieldStrength,
                   .fatigueStrength = kept.fatigueStrength};
    nameLostSections(drill, converted.lost);
    uniform.pulse = isForced(scenario) ? scenario.pulse : pistonOf(drill, converted.lost);
    if (drill.endTime)
        converted.lost.emplace_back(translatable("The time until which the blow is followed."));
    return converted;
}

Scenario rigOf(const Scenario& groups, const RigChoice& choice) {
    assert(groups.form == ScenarioForm::dimensionless);
    Scenario rig;
    rig.title = groups.title;
    rig.form = ScenarioForm::dimensional;
    rig.rod = choice.rod;
    const RodProperties rod = propertiesOf(choice.rod);
    const double duration = choice.duration, impulse = choice.meanForce * duration;
    rig.rod.length = groups.groups.tau * duration * rod.waveSpeed;
    rig.pulse = groups.pulse;
    rig.pulse.duration = duration;
    rig.pulse.impulse = impulse;
    rig.pulse.impulseFromForce = true;
    if (groups.pulse.shape == PulseShape::piston)
        rig.pulse.piston = pistonOf(groups.pulse.piston, rod, choice.rod.density, duration, impulse);
    if (groups.pulse.shape == PulseShape::table) {
        rig.pulse.tableFile.clear();
        rig.pulse.tablePoints = stretched(groups.pulse.tablePoints, duration, impulse);
    }
    const double penetration = 2 * impulse / rod.impedance;
    rig.bitRock = groups.bitRock;
    rig.bitRock.stiffness = groups.groups.beta * rod.impedance / duration;
    rig.bitRock.gamma = groups.groups.gamma;
    rig.bitRock.gap = groups.groups.delta * penetration;
    for (RockCorner& corner : rig.bitRock.corners) corner.force *= choice.meanForce;
    if (groups.bitRock.law == RockLaw::power) rig.bitRock.referencePenetration *= penetration;
    return rig;
}

}  // namespace drillwave

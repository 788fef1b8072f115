// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/validation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/model/section_field.h"
#include "core/model/section_pieces.h"
#include "core/model/string_ranges.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

std::string valueText(const Parameter& parameter, double value) {
    return formatQuantity(value, parameter.quantity, parameter.displayUnit());
}

void report(std::vector<InputProblem>& problems, std::string_view key, std::string_view value,
            const Message& reason) {
    problems.push_back(valueProblem(key, value, reason));
}

void checkRanges(const Scenario& scenario, std::vector<InputProblem>& problems) {
    for (const Parameter& parameter : parameters()) {
        if (!isGiven(parameter, scenario)) continue;
        const std::optional<double> value = parameter.value(scenario);
        const Message reason = value ? rangeProblem(parameter, *value) : Message();
        if (!reason.isEmpty()) report(problems, parameter.key, valueText(parameter, *value), reason);
    }
}

/// Beneath a string the rock has a range too: a uniform rod judges it by its groups.
void checkRockOfString(const BitRock& rock, std::vector<InputProblem>& problems) {
    const Parameter& stiffness = *findParameter("bit_rock.stiffness");
    const Message reason =
        string_ranges::stiffness.problem(rock.stiffness, unitsOf(stiffness.quantity).front());
    if (!reason.isEmpty()) report(problems, stiffness.key, valueText(stiffness, rock.stiffness), reason);
}

/// The corners of the loading curve, each behind the one before and none steeper than the way down.
class CornerCheck {
  public:
    CornerCheck(const Scenario& scenario, std::vector<InputProblem>& problems)
        : m_rock(scenario.bitRock),
          m_gamma(groupOrValue(scenario)),
          m_scenario(scenario),
          m_problems(problems) {}

    void check() {
        if (m_rock.corners.empty()) {
            add("bit_rock.corners", "",
                translatable("is missing: a law with corners needs at least one, as "
                             "`bit_rock.corner.1.force` and `bit_rock.corner.1.slope`"));
            return;
        }
        if (m_rock.corners.size() > mostRockCorners) {
            add("bit_rock.corners", "",
                {translatable("has %1 corners, at most %2 are possible"),
                 {std::to_string(m_rock.corners.size()), std::to_string(mostRockCorners)}});
            return;
        }
        for (std::size_t i = 0; i < m_rock.corners.size(); ++i) checkCorner(i);
    }

  private:
    static double groupOrValue(const Scenario& scenario) {
        return hasUnits(scenario) ? scenario.bitRock.gamma : scenario.groups.gamma;
    }

    void checkCorner(std::size_t i) {
        constexpr double rounding = 1e-12;  // of 1/gamma, as it is written
        const RockCorner& corner = m_rock.corners[i];
        if (isRight(i, "force", corner.force) && i > 0 && !(corner.force > m_rock.corners[i - 1].force) &&
            !std::isnan(m_rock.corners[i - 1].force))
            add(pathOf(i, "force"), textOf(i, "force", corner.force),
                {translatable("must be greater than the force of the corner before it, %1"),
                 {textOf(i - 1, "force", m_rock.corners[i - 1].force)}});
        if (isRight(i, "slope", corner.slope) && corner.slope * m_gamma > 1 + rounding)
            add(pathOf(i, "slope"), formatNumber(corner.slope),
                {translatable("must be at most 1/gamma = %1, because loading steeper than unloading would "
                              "create energy"),
                 {formatNumber(1 / m_gamma)}});
    }

    bool isRight(std::size_t i, std::string_view field, double value) {
        if (std::isnan(value)) {
            add(pathOf(i, field), "", translatable("is missing: a corner has a force and a slope"));
            return false;
        }
        const Message reason = rangeProblem(*parameterOf(i, field), value);
        if (!reason.isEmpty()) add(pathOf(i, field), textOf(i, field, value), reason);
        return reason.isEmpty();
    }

    KeptParameter parameterOf(std::size_t i, std::string_view field) const {
        return inFormOf(m_scenario, *findParameter(cornerKey(i + 1, field)));
    }
    std::string textOf(std::size_t i, std::string_view field, double value) const {
        return valueText(*parameterOf(i, field), value);
    }
    /// As in a file.
    static std::string pathOf(std::size_t i, std::string_view field) {
        return "bit_rock.corners." + std::to_string(i + 1) + "." + std::string(field);
    }
    void add(std::string_view key, std::string_view value, const Message& reason) {
        report(m_problems, key, value, reason);
    }

    const BitRock& m_rock;
    double m_gamma;
    const Scenario& m_scenario;
    std::vector<InputProblem>& m_problems;
};

void checkLaw(const Scenario& scenario, std::vector<InputProblem>& problems) {
    if (scenario.bitRock.law == RockLaw::corners) CornerCheck(scenario, problems).check();
    for (const KeptParameter& parameter : numbersInScales(scenario)) {
        const double value = *parameter->value(scenario);
        const Message reason = rangeProblem(*parameter, value);
        if (!reason.isEmpty()) report(problems, parameter->key, formatNumber(value), reason);
    }
}

/// A uniform rod keeps the sections of another form empty: what is about sections asks for no form.
void checkSectionsOfRod(const DrillString& unused, std::vector<InputProblem>& problems) {
    if (!unused.parts.empty() || !unused.hammer.sections.empty())
        report(problems, "string", "",
               translatable("a uniform rod has no sections; they belong to `drillwave: 2`"));
}

void checkBore(const Scenario& scenario, std::vector<InputProblem>& problems) {
    const Rod& rod = scenario.rod;
    if (scenario.form != ScenarioForm::dimensional || rod.area || !(rod.bore >= rod.diameter)) return;
    const Parameter& bore = *findParameter("rod.bore");
    report(problems, bore.key, valueText(bore, rod.bore),
           {translatable("must be less than the diameter of %1"), {valueText(bore, rod.diameter)}});
}

void checkTrapezoid(const Pulse& pulse, std::vector<InputProblem>& problems) {
    if (pulse.shape != PulseShape::trapezoid || !(pulse.rise + pulse.fall > 1)) return;
    // 0.7 + 0.3 may be a rounding error above 1: accept it, the plateau is then empty.
    if (pulse.rise + pulse.fall <= 1 + 1e-12) return;
    report(problems, "pulse.fall", formatNumber(pulse.fall),
           {translatable("rise and fall together must not exceed 1, they are %1"),
            {formatNumber(pulse.rise + pulse.fall)}});
}

void checkTable(const Scenario& scenario, std::vector<InputProblem>& problems) {
    if (scenario.pulse.shape != PulseShape::table) return;
    const Message reason = pointProblem(scenario.pulse.tablePoints).reason;
    if (!reason.isEmpty()) report(problems, "pulse.points", "", reason);
}

/// Numbers of a sequence that contradict each other, whatever else is missing.
void checkDrill(const Drill& drill, std::vector<InputProblem>& problems) {
    const auto add = [&](const char* key, double value, const Message& reason) {
        const Parameter& parameter = *findParameter(key);
        report(problems, parameter.key, valueText(parameter, value), reason);
    };
    if (drill.blows && drill.settle && *drill.settle >= *drill.blows)
        add("drill.settle", *drill.settle,
            {translatable("must be less than the blows, which are %1"), {formatNumber(*drill.blows)}});
    const bool hasDamper = drill.damperDamping.value_or(0) > 0 || drill.damperStiffness.value_or(0) > 0;
    if (hasDamper && drill.machineMass == 0.0)
        add("drill.machine_mass", 0, translatable("must be more than 0: the damper carries it"));
}

/// A string that arrives as a whole is no blow of a force.
void checkShapeOfString(PulseShape shape, std::vector<InputProblem>& problems) {
    if (shape == PulseShape::rigidBody)
        report(
            problems, pulseShapeKey, std::string(name(shape)),
            translatable("is the reference case of a uniform rod (`drillwave: 1`); a drill string takes any "
                         "other shape"));
}

void checkPiston(const Scenario& scenario, std::vector<InputProblem>& problems) {
    if (scenario.pulse.shape != PulseShape::piston) return;
    const double ratio = pistonImpedanceRatio(scenario);
    if (pistonStepCount(ratio) <= maximumPulseSegments) return;
    const bool given = scenario.form == ScenarioForm::dimensionless;
    report(problems, given ? "pulse.impedance_ratio" : "pulse.diameter",
           given ? formatNumber(ratio) : std::string(),
           {translatable("the hammer's impedance is %1 times the rod's, too many steps to follow; use the "
                         "shape exponential, a rigid hammer"),
            {formatNumber(ratio)}});
}

bool isPositiveAndFinite(double value) {
    return std::isfinite(value) && value > 0;
}

/// The bit closes the gap by one d0 in each round trip.
void checkFirstContact(const Groups& groups, const Message& follows, std::vector<InputProblem>& problems) {
    constexpr double latest = 1e12;  // neighbouring doubles are 1e-4 t0 apart there
    const double firstContact = groups.tau * (1 + 2 * groups.delta);
    if (firstContact <= latest) return;
    report(problems, "delta", formatNumber(groups.delta),
           {translatable("with tau = %1 the bit meets the rock after %2 t0, too late for double precision to "
                         "resolve one t0 (at most %3)%4"),
            {formatNumber(groups.tau), formatNumber(firstContact), formatNumber(latest), follows}});
}

/// Each value may be fine and the conversion still overflow or vanish.
void checkGroups(const Scenario& scenario, std::vector<InputProblem>& problems) {
    const Scales scales = scalesOf(scenario);
    for (const double scale : {scales.time, scales.impulse, scales.force, scales.velocity, scales.penetration,
                               scales.stiffness, scales.energy}) {
        if (isPositiveAndFinite(scale)) continue;
        const Message reason =
            translatable("the values are too large or too small: the force or energy of the blow overflows");
        problems.push_back({.key = "", .text = reason, .reason = reason});
        return;
    }
    const Message follows = hasUnits(scenario) ? translatable("; it follows from the other values") : "";
    for (const Parameter& parameter : parameters()) {
        if (parameter.section() != "groups") continue;
        const double value = *parameter.value(scenario);
        const Message reason = rangeProblem(parameter, value);
        if (!reason.isEmpty())
            report(problems, parameter.key, formatNumber(value), {"%1%2", {reason, follows}});
    }
    if (problems.empty()) checkFirstContact(groupsOf(scenario), follows, problems);
}

using Chain = SectionAddress::Chain;

/// Enough to see what is the matter with a thousand sections.
constexpr std::size_t enoughProblems = 100;

class SectionCheck {
  public:
    explicit SectionCheck(const DrillString& drillString) : m_string(drillString) {}

    std::vector<InputProblem> problems() {
        checkHammer();
        checkParts();
        each([this](const std::string& key, const Section& section) { checkSection(key, section); });
        if (m_problems.empty()) checkHammerLosses();
        if (m_problems.empty()) checkFace();
        if (m_problems.empty())
            each([this](const std::string& key, const Section& section) { checkDerived(key, section); });
        return std::move(m_problems);
    }

  private:
    void report(const std::string& key, const std::string& value, const Message& reason) {
        m_problems.push_back(valueProblem(key, value, reason));
    }

    template <class Check>
    void each(const Check& check) {
        for (std::size_t i = 0; i < m_string.hammer.sections.size() && goesOn(); ++i)
            check(sectionKey(Chain::hammer, i + 1), m_string.hammer.sections[i]);
        for (const PlacedSection& placed : placedSections(m_string))
            if (goesOn()) check(sectionKey(Chain::string, placed.place), *placed.section);
    }
    bool goesOn() const { return m_problems.size() < enoughProblems; }

    void checkHammer() {
        const std::size_t count = m_string.hammer.sections.size();
        if (count > maximumSections) report("hammer.sections", "", tooManySections(count));
    }

    void checkParts() {
        if (m_string.parts.empty()) report("string", "", translatable("must have at least one section"));
        for (const StringPart& part : m_string.parts) {
            if (part.sections.empty() || (!part.group && part.sections.size() != 1))
                report("string", "",
                       translatable("each part must be one section, or a repeat of at least one"));
            const Message reason =
                rangeProblem(*findParameter("string.repeat"), static_cast<double>(part.repeat));
            if (!reason.isEmpty()) report("string.repeat", std::to_string(part.repeat), reason);
            if (!part.group && part.repeat > 1)
                report("string.repeat", std::to_string(part.repeat), translatable("only for a repeat"));
        }
        if (const std::uint64_t count = sectionCount(m_string); count > maximumSections)
            report("string", "", tooManySections(count));
    }

    void checkSection(const std::string& key, const Section& section) {
        const auto text = [](const SectionField& field, double value) {
            return formatQuantity(value, field.quantity, field.displayUnit());
        };
        for (const SectionField& field : sectionFields()) {
            const std::optional<double> value = field.value(section);
            const Message reason = value ? rangeProblem(field, *value) : Message();
            if (!reason.isEmpty()) report(key + "." + std::string(field.key), text(field, *value), reason);
        }
        for (const ShapeProblem& problem : shapeProblems(section)) {
            const SectionField& field = *findSectionField(problem.field);
            report(key + "." + std::string(field.key), text(field, *field.value(section)), problem.reason);
        }
        const Message reason = sectionNameProblem(section.name);
        if (!reason.isEmpty()) report(key + ".name", section.name, reason);
    }

    /// A hammer that flies loses nothing: waves that decay while it does would slow it down.
    void checkHammerLosses() {
        const std::vector<Section>& sections = m_string.hammer.sections;
        const auto refuse = [this](std::size_t i, const char* field, double value) {
            const SectionField& losing = *findSectionField(field);
            report(sectionKey(Chain::hammer, i + 1) + "." + field,
                   formatQuantity(value, losing.quantity, losing.displayUnit()),
                   translatable(
                       "losses inside the hammer are not modelled: give them to sections of the string"));
        };
        for (std::size_t i = 0; i < sections.size() && goesOn(); ++i) {
            if (sections[i].attenuation > 0) refuse(i, "attenuation", sections[i].attenuation);
            // behind the last section there is no joint
            if (sections[i].loss > 0 && i + 1 < sections.size()) refuse(i, "loss", sections[i].loss);
        }
    }

    /// A cone of a hammer may end in a face that fits into the bore of what it strikes.
    void checkFace() {
        if (m_string.hammer.sections.empty()) return;
        const Section& last = m_string.hammer.sections.back();
        const Section& struck = *expandedSections(m_string).front();
        const double hole = struck.area ? 0 : struck.bore;
        if (isUniform(last) || outerDiameterAt(last, 1) > hole) return;
        const SectionField& end = *findSectionField(endKey(last));
        const SectionField& bore = *findSectionField("bore");
        report(
            sectionKey(Chain::hammer, m_string.hammer.sections.size()) + "." + std::string(end.key),
            formatQuantity(*end.value(last), end.quantity, end.displayUnit()),
            {translatable("is so narrow that its face only covers the bore of %1 of the section it strikes"),
             {formatQuantity(hole, bore.quantity, bore.displayUnit())}});
    }

    void checkDerived(const std::string& key, const Section& section) {
        const RodProperties properties = propertiesOf(section, m_string.material);
        for (const double value :
             {properties.area, properties.impedance, properties.transitTime, properties.mass})
            if (!std::isfinite(value) || value <= 0)
                return report(
                    key, "",
                    translatable(
                        "the values are too large or too small: impedance, transit time or mass overflows"));
    }

    const DrillString& m_string;
    std::vector<InputProblem> m_problems;
};

}  // namespace

InputProblem valueProblem(std::string_view key, std::string_view value, const Message& reason) {
    const std::string name(key), given = value.empty() ? name : name + " = " + std::string(value);
    return {.key = name, .text = {"%1 (%2)", {given, reason}}, .reason = {"%1 %2", {name, reason}}};
}

PointProblem pointProblem(const TablePoints& points) {
    const std::size_t last = points.empty() ? 0 : points.size() - 1;
    if (points.size() < 2) return {last, translatable("needs at least two points of time and force")};
    if (points.size() > static_cast<std::size_t>(maximumPulseSegments))
        return {last, {translatable("has more than %1 points"), {std::to_string(maximumPulseSegments)}}};
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto that = [i](const char* text) -> PointProblem {
            return {i, {text, {std::to_string(i + 1)}}};
        };
        if (!std::isfinite(points[i].time) || !std::isfinite(points[i].force))
            return that(translatable("point %1 must be finite numbers"));
        if (points[i].force < 0)
            return that(translatable("point %1 has a negative force, a hammer only pushes"));
        if (i > 0 && points[i].time <= points[i - 1].time)
            return that(translatable("point %1 must be later than the one before it"));
        largest = std::max(largest, points[i].force);
    }
    if (largest == 0) return {last, translatable("must have a force greater than 0 somewhere")};
    if (!isPositiveAndFinite(points.back().time - points.front().time))
        return {last, translatable("lasts too long")};
    return {};
}

std::vector<InputProblem> validate(const Scenario& scenario) {
    std::vector<InputProblem> problems;
    checkRanges(scenario, problems);
    checkLaw(scenario, problems);
    if (hasUnits(scenario)) checkDrill(scenario.drill, problems);
    const bool ofString = isString(scenario);
    if (ofString) {
        if (problems.empty()) checkRockOfString(scenario.bitRock, problems);
        std::ranges::move(sectionProblems(scenario.drillString), std::back_inserter(problems));
    } else {
        checkSectionsOfRod(scenario.drillString, problems);
        checkBore(scenario, problems);
    }
    if (isForced(scenario)) {
        if (ofString) checkShapeOfString(scenario.pulse.shape, problems);
        checkTrapezoid(scenario.pulse, problems);
        checkTable(scenario, problems);
        if (problems.empty()) checkPiston(scenario, problems);
    }
    if (problems.empty()) checkGroups(scenario, problems);
    return problems;
}

Message invalidity(const Scenario& scenario) {
    std::vector<Message> reasons;
    for (InputProblem& problem : validate(scenario)) reasons.push_back(std::move(problem.text));
    return inOneLine(std::move(reasons));
}

std::vector<InputProblem> sectionProblems(const DrillString& drillString) {
    return SectionCheck(drillString).problems();
}

Message tooManySections(std::uint64_t count) {
    return {translatable("has %1 sections, its repeats written out; at most %2 are followed"),
            {std::to_string(count), std::to_string(maximumSections)}};
}

}  // namespace drillwave

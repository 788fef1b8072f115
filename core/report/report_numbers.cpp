// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_numbers.h"

#include <cmath>

#include "core/blow/outputs.h"
#include "core/model/blow_traits.h"
#include "core/report/blow_json.h"
#include "core/report/section_grid.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

constexpr int reportDigits = 5;

bool isDimensional(const Blow& blow) {
    return hasUnits(blow.scenario);
}

/// " I₀".
std::string multipleUnit(Measure measure, const Scenario& scenario) {
    std::string unit(multipleName(measure, scenario));
    if (const std::size_t zero = unit.find('0'); zero != unit.npos) unit.replace(zero, 1, "₀");
    return unit.empty() ? unit : " " + unit;
}

/// " % of W".
std::string shareUnit(const Scenario& scenario) {
    return " % of" + multipleUnit(Measure::energy, scenario);
}

std::string multipleText(const Output& output, double value, const Blow& blow, const ReadingStyle& style) {
    if (output.name == "cor") return style.number(value, 6) + " ± " + style.bound(blow.summary.corError);
    if (output.name == "efficiency" && mainOutput(blow.scenario).value == &output)
        return style.number(100 * value, 6) + " ± " + style.bound(100 * blow.summary.efficiencyError) +
               shareUnit(blow.scenario);
    if (output.measure == Measure::error) return style.bound(std::abs(value));
    if (output.measure == Measure::share || output.measure == Measure::energy)
        return style.number(100 * shareOrZero(output, value), reportDigits) + shareUnit(blow.scenario);
    return style.number(value, reportDigits) + multipleUnit(output.measure, blow.scenario);
}

ReportCell siCell(const Output& output, double value, const Blow& blow, const ReadingStyle& style) {
    if (output.measure == Measure::number || output.measure == Measure::error) return {};
    std::string text = siText(output, shareOrZero(output, value), blow, style);
    // of the work people read joules, and programs the number of JSON
    return output.measure == Measure::work ? ReportCell{text, {}}
                                           : ReportCell{text, inSi(output, value, blow)};
}

/// "in 7 rod, 1.2 m from its rear end, at 3.4 ms".
std::string stringPlaceText(const StringPeak& largest, const Blow& blow, const ReadingStyle& style) {
    const StressPeak& peak = largest.peak;
    if (!(peak.stress > 0)) return {};
    const std::string place =
        peak.place == 0 ? "at" : style.quantity(peak.place, Quantity::length, 4) + " from";
    return "in " + sectionLabel(blow.scenario.drillString, largest.section) + ", " + place +
           " its rear end, at " + style.quantity(peak.time, Quantity::time, 4);
}

ReportCell placeCell(const Output& output, const Blow& blow, const ReadingStyle& style) {
    if (!output.load) return {};
    if (const std::optional<RodForces>& forces = blow.summary.rodForces)
        return {placeText((*forces)[*output.load], blow, style), {}};
    const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
    if (stresses.empty()) return {};
    return {stringPlaceText(largestStress(stresses, *output.load), blow, style), {}};
}

/// Of the outputs that are wanted and that the scenario has.
template <class IsWanted>
std::vector<ReportRow> rowsOf(const Blow& blow, const ReadingStyle& style, const IsWanted& isWanted) {
    std::vector<ReportRow> rows;
    for (const Output& output : outputs()) {
        if (!isWanted(output) || !output.problem(blow.scenario).empty()) continue;
        const std::optional<double> value = output.value({blow.summary, blow.scenario, blow.thrustMargin()});
        if (!value) continue;
        ReportRow row{std::string(output.name), std::string(output.title), {}};
        row.cells.push_back(output.isOnlySi() ? ReportCell()
                                              : ReportCell{multipleText(output, *value, blow, style), value});
        if (isDimensional(blow)) row.cells.push_back(siCell(output, *value, blow, style));
        row.cells.push_back(placeCell(output, blow, style));
        rows.push_back(std::move(row));
    }
    return rows;
}

template <class Add>
void addStringScales(const Blow& blow, const Add& add) {
    const DrillString& drill = blow.scenario.drillString;
    const Scales& scales = blow.scales;
    const ChainProperties string = stringProperties(drill);
    add("β", "stiffness k t₀/Z", blow.groups.beta, Quantity::ratio);
    add("γ", "elasticity of the rock", blow.groups.gamma, Quantity::ratio);
    add("τ", "transit time of the string over t₀", blow.groups.tau, Quantity::ratio);
    add("δ", "gap d/d₀", blow.groups.delta, Quantity::ratio);
    if (isForced(blow.scenario)) {
        add("t₀", "duration of the blow", scales.time, Quantity::time);
        add("I₀", "impulse of the blow", scales.impulse, Quantity::impulse);
        add("W₀", "energy I₀²/(2 m), m of the string", scales.energy, Quantity::energy);
        add("F₀", "mean force I₀/t₀", scales.force, Quantity::force);
        add("F₀/A", "its stress in the rod", scales.stress, Quantity::stress);
        add("d₀", "displacement 2 I₀/Z, Z of the rod", scales.penetration, Quantity::length);
    } else {
        const ChainProperties hammer = hammerProperties(drill);
        add("t₀", "twice the transit time of the hammer", scales.time, Quantity::time);
        add("p₀", "momentum of the hammer", scales.impulse, Quantity::impulse);
        add("E₀", "energy of the hammer", scales.energy, Quantity::energy);
        add("F₀", "force Z v₀/2, Z of the rod", scales.force, Quantity::force);
        add("F₀/A", "its stress in the rod", scales.stress, Quantity::stress);
        add("d₀", "displacement v₀ t₀", scales.penetration, Quantity::length);
        add("m", "mass of the hammer", hammer.mass, Quantity::mass);
        add("", "length of the hammer", hammer.length, Quantity::length);
    }
    add("", "mass of the string", string.mass, Quantity::mass);
    add("", "length of the string", string.length, Quantity::length);
}

}  // namespace

std::string_view multipleName(Measure measure, const Scenario& scenario) {
    const bool ofForce = isForced(scenario);
    switch (measure) {
        case Measure::work:
            return ofForce ? "W0" : "E0";
        case Measure::energy:
            return ofForce ? "W" : "E0";
        case Measure::time:
            return "t0";
        case Measure::impulse:
            return ofForce ? "I0" : "p0";
        case Measure::force:
            return "F0";
        case Measure::penetration:
            return "d0";
        case Measure::stress:
            return "F0/A";
        case Measure::velocity:
            return "v0";
        default:
            return "";
    }
}

double shareOrZero(const Output& output, double value) {
    const bool isShare = output.measure == Measure::share || output.measure == Measure::energy;
    return isShare && std::abs(value) < 1e-12 ? 0 : value;
}

std::string siText(const Output& output, double value, const Blow& blow, const ReadingStyle& style,
                   int digits) {
    switch (output.measure) {
        case Measure::work:
            return style.quantity(value * blow.scales.energy, Quantity::energy, digits);
        case Measure::share:
        case Measure::energy:
            return style.quantity(value * (blow.drivenEnergy() * blow.scales.energy), Quantity::energy,
                                  digits);
        default:
            return style.quantity(inSi(output, value, blow), output.quantity(), digits);
    }
}

std::string placeText(const RodForce& found, const Blow& blow, const ReadingStyle& style) {
    if (!(found.size > 0)) return {};
    if (!isDimensional(blow))
        return "at x/L = " + style.number(found.section, 4) +
               ", t = " + style.number(found.time, reportDigits) + " t₀";
    return style.quantity(found.section * blow.scales.length, Quantity::length, 4) + " from the hammer, at " +
           style.quantity(found.time * blow.scales.time, Quantity::time, 4);
}

std::vector<ReportRow> resultRows(const Blow& blow, const ReadingStyle& style) {
    return rowsOf(blow, style, [](const Output& output) { return output.measure != Measure::error; });
}

std::vector<ReportRow> solverRows(const Blow& blow, const ReadingStyle& style) {
    return rowsOf(blow, style, [](const Output& output) { return output.measure == Measure::error; });
}

std::vector<ReportRow> scaleRows(const Blow& blow, const ReadingStyle& style) {
    std::vector<ReportRow> rows;
    const auto add = [&](const char* symbol, const char* label, double value, Quantity quantity) {
        rows.push_back({symbol, label, {{style.quantity(value, quantity, reportDigits), value}}});
    };
    const Groups& groups = blow.groups;
    if (hasSections(blow.scenario)) {
        addStringScales(blow, add);
        return rows;
    }
    add("β", "stiffness k/k₀, k₀ = Z/t₀", groups.beta, Quantity::ratio);
    add("γ", "elasticity of the rock", groups.gamma, Quantity::ratio);
    add("τ", "transit time T/t₀", groups.tau, Quantity::ratio);
    add("δ", "gap d/d₀, d₀ = 2 I₀/Z", groups.delta, Quantity::ratio);
    if (!isDimensional(blow)) return rows;
    const Scales& scales = blow.scales;
    const RodProperties rod = propertiesOf(blow.scenario.rod);
    add("t₀", "duration of the blow", scales.time, Quantity::time);
    add("I₀", "impulse of the blow", scales.impulse, Quantity::impulse);
    add("F₀", "mean force I₀/t₀", scales.force, Quantity::force);
    add("F₀/A", "its stress", scales.stress, Quantity::stress);
    add("d₀", "displacement 2 I₀/Z", scales.penetration, Quantity::length);
    add("W₀", "energy I₀²/(2 m)", scales.energy, Quantity::energy);
    add("T", "transit time L/c", rod.transitTime, Quantity::time);
    add("c", "wave speed √(E/ρ)", rod.waveSpeed, Quantity::velocity);
    add("m", "mass of the rod", rod.mass, Quantity::mass);
    return rows;
}

}  // namespace drillwave

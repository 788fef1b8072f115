// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_numbers.h"

#include <cmath>

#include "core/blow/outputs.h"
#include "core/model/section_words.h"
#include "core/report/blow_json.h"
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

/// "42.3 % of W".
std::string shareText(const std::string& percent, const Scenario& scenario, const ReadingStyle& style) {
    return style.said({translatable("%1 % of%2"), {percent, multipleUnit(Measure::energy, scenario)}});
}

std::string multipleText(const Output& output, double value, const Blow& blow, const ReadingStyle& style) {
    if (output.name == "cor") return style.number(value, 6) + " ± " + style.bound(blow.summary.corError);
    if (output.name == "efficiency" && mainOutput(blow.scenario).value == &output)
        return shareText(
            style.number(100 * value, 6) + " ± " + style.bound(100 * blow.summary.efficiencyError),
            blow.scenario, style);
    if (output.measure == Measure::error) return style.bound(std::abs(value));
    if (output.needsThrustStudy() && style.isPrinted()) return style.signedPercent(value);
    if (output.measure == Measure::share || output.measure == Measure::energy)
        return shareText(style.number(100 * shareOrZero(output, value), reportDigits), blow.scenario, style);
    return style.number(value, reportDigits) + multipleUnit(output.measure, blow.scenario);
}

ReportCell siCell(const Output& output, double value, const Blow& blow, const ReadingStyle& style) {
    if (output.measure == Measure::number || output.measure == Measure::error) return {};
    std::string text = siText(output, shareOrZero(output, value), blow, style);
    // of the work people read joules, and programs the number of JSON
    return output.measure == Measure::work ? ReportCell{text, {}}
                                           : ReportCell{text, inSi(output, value, blow)};
}

/// "in 3rd rod, 1.2 m from its rear end, at 3.4 ms".
std::string stringPlaceText(const StringPeak& largest, const Blow& blow, const ReadingStyle& style) {
    const StressPeak& peak = largest.peak;
    if (!(peak.stress > 0)) return {};
    const Message section = sectionWords(blow.scenario.drillString)[largest.section];
    const std::string time = style.quantity(peak.time, Quantity::time, 4);
    if (peak.place == 0) return style.said({translatable("in %1, at its rear end, at %2"), {section, time}});
    return style.said({translatable("in %1, %2 from its rear end, at %3"),
                       {section, style.quantity(peak.place, Quantity::length, 4), time}});
}

ReportCell placeCell(const Output& output, const Blow& blow, const ReadingStyle& style) {
    if (!output.load) return {};
    if (const std::optional<RodForces>& forces = blow.summary.rodForces)
        return {placeText((*forces)[*output.load], blow, style), {}};
    const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
    if (stresses.empty()) return {};
    return {stringPlaceText(largestStress(stresses, *output.load), blow, style), {}};
}

/// Returns the requested outputs that the scenario has.
template <class IsWanted>
std::vector<ReportRow> rowsOf(const Blow& blow, const ReadingStyle& style, const IsWanted& isWanted) {
    std::vector<ReportRow> rows;
    for (const Output& output : outputs()) {
        if (!isWanted(output) || !output.problem(blow.scenario).isEmpty()) continue;
        const std::optional<double> value = output.value({blow.summary, blow.scenario, blow.thrustMargin()});
        if (!value) continue;
        ReportRow row{std::string(output.name), style.said(Message::ofTable(output.title)), {}};
        row.cells.push_back(output.isOnlySi() ? ReportCell()
                                              : ReportCell{multipleText(output, *value, blow, style), value});
        if (isDimensional(blow)) row.cells.push_back(siCell(output, *value, blow, style));
        row.cells.push_back(placeCell(output, blow, style));
        rows.push_back(std::move(row));
    }
    return rows;
}

void addRodScales(const Blow& blow, const auto& add) {
    const Groups& groups = blow.groups;
    add("β", translatable("stiffness k/k₀, k₀ = Z/t₀"), groups.beta, Quantity::ratio);
    add("γ", translatable("elasticity of the rock"), groups.gamma, Quantity::ratio);
    add("τ", translatable("transit time T/t₀"), groups.tau, Quantity::ratio);
    add("δ", translatable("gap d/d₀, d₀ = 2 I₀/Z"), groups.delta, Quantity::ratio);
    if (!isDimensional(blow)) return;
    const Scales& scales = blow.scales;
    const RodProperties rod = propertiesOf(blow.scenario.rod);
    add("t₀", translatable("duration of the blow"), scales.time, Quantity::time);
    add("I₀", translatable("impulse of the blow"), scales.impulse, Quantity::impulse);
    add("F₀", translatable("mean force I₀/t₀"), scales.force, Quantity::force);
    add("F₀/A", translatable("its stress"), scales.stress, Quantity::stress);
    add("d₀", translatable("displacement 2 I₀/Z"), scales.penetration, Quantity::length);
    add("W₀", translatable("energy I₀²/(2 m)"), scales.energy, Quantity::energy);
    add("T", translatable("transit time L/c"), rod.transitTime, Quantity::time);
    add("c", translatable("wave speed √(E/ρ)"), rod.waveSpeed, Quantity::velocity);
    add("m", translatable("mass of the rod"), rod.mass, Quantity::mass);
}

void addStringScales(const Blow& blow, const auto& add) {
    const DrillString& drill = blow.scenario.drillString;
    const Scales& scales = blow.scales;
    const ChainProperties string = stringProperties(drill);
    add("β", translatable("stiffness k t₀/Z"), blow.groups.beta, Quantity::ratio);
    add("γ", translatable("elasticity of the rock"), blow.groups.gamma, Quantity::ratio);
    add("τ", translatable("transit time of the string over t₀"), blow.groups.tau, Quantity::ratio);
    add("δ", translatable("gap d/d₀"), blow.groups.delta, Quantity::ratio);
    if (isForced(blow.scenario)) {
        add("t₀", translatable("duration of the blow"), scales.time, Quantity::time);
        add("I₀", translatable("impulse of the blow"), scales.impulse, Quantity::impulse);
        add("W₀", translatable("energy I₀²/(2 m), m of the string"), scales.energy, Quantity::energy);
        add("F₀", translatable("mean force I₀/t₀"), scales.force, Quantity::force);
        add("F₀/A", translatable("its stress in the rod"), scales.stress, Quantity::stress);
        add("d₀", translatable("displacement 2 I₀/Z, Z of the rod"), scales.penetration, Quantity::length);
    } else {
        const ChainProperties hammer = hammerProperties(drill);
        add("t₀", translatable("twice the transit time of the hammer"), scales.time, Quantity::time);
        add("p₀", translatable("momentum of the hammer"), scales.impulse, Quantity::impulse);
        add("E₀", translatable("energy of the hammer"), scales.energy, Quantity::energy);
        add("F₀", translatable("force Z v₀/2, Z of the rod"), scales.force, Quantity::force);
        add("F₀/A", translatable("its stress in the rod"), scales.stress, Quantity::stress);
        add("d₀", translatable("displacement v₀ t₀"), scales.penetration, Quantity::length);
        add("m", translatable("mass of the hammer"), hammer.mass, Quantity::mass);
        add("", translatable("length of the hammer"), hammer.length, Quantity::length);
    }
    add("", translatable("mass of the string"), string.mass, Quantity::mass);
    add("", translatable("length of the string"), string.length, Quantity::length);
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
        case Measure::speed:
            return style.rate(inSi(output, value, blow), digits);
        default:
            return style.quantity(inSi(output, value, blow), output.quantity(), digits);
    }
}

std::string placeText(const RodForce& found, const Blow& blow, const ReadingStyle& style) {
    if (!(found.size > 0)) return {};
    if (!isDimensional(blow))
        return style.said({translatable("at x/L = %1, t = %2 t₀"),
                           {style.number(found.section, 4), style.number(found.time, reportDigits)}});
    return style.said({translatable("%1 from the hammer, at %2"),
                       {style.quantity(found.section * blow.scales.length, Quantity::length, 4),
                        style.quantity(found.time * blow.scales.time, Quantity::time, 4)}});
}

std::vector<ReportRow> resultRows(const Blow& blow, const ReadingStyle& style) {
    return rowsOf(blow, style, [](const Output& output) { return output.measure != Measure::error; });
}

std::vector<ReportRow> solverRows(const Blow& blow, const ReadingStyle& style) {
    return rowsOf(blow, style, [](const Output& output) { return output.measure == Measure::error; });
}

std::vector<ReportRow> scaleRows(const Blow& blow, const ReadingStyle& style) {
    std::vector<ReportRow> rows;
    const auto rowsFor = [&](OutputOf of) {
        return [&, of](const char* symbol, const char* label, double value, Quantity quantity) {
            if (concerns(of, blow.scenario))
                rows.push_back(
                    {symbol, style.said(label), {{style.quantity(value, quantity, reportDigits), value}}});
        };
    };
    addRodScales(blow, rowsFor(OutputOf::uniformRod));
    addStringScales(blow, rowsFor(OutputOf::drillString));
    return rows;
}

}  // namespace drillwave

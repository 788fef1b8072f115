// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/output_text.h"

#include <algorithm>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/model/blow_traits.h"
#include "core/model/chain_words.h"
#include "core/report/output_words.h"
#include "ui/plot/figure_units.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

QString shown(double value, const ShownUnit& unit) {
    return quantityText(value, unit, QLocale());
}

/// Returns the place of the largest compression or tension over all sections; nullopt without sections.
std::optional<RodForce> stringPlaceOf(const Output& output, const SolvedBlow& blow) {
    const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
    if (stresses.empty()) return std::nullopt;
    const auto [section, peak] = largestStress(stresses, *output.load);
    const DrillString& drill = blow.scenario.drillString;
    const double length = allSections(drill)[section]->length;
    // Stresses differ where sections meet: take a place slightly inside of this section.
    constexpr double inside = 1e-9;
    const double share = std::clamp(peak.place / length, inside, 1 - inside);
    return RodForce{peak.stress, shareOfString(drill, {section, share}), peak.time / blow.scales.time};
}

}  // namespace

ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size) {
    return FigureUnits{units, {}}.of(figureQuantity({&output, OutputUnits::dimensionless}, size));
}

bool haveSameUnit(const Output& output, const SolvedBlow& one, const SolvedBlow& other, UnitSystem units) {
    if (areOfOneKind(one.scenario, other.scenario)) return true;
    return units != UnitSystem::dimensionless || output.measure == Measure::number || output.isOnlySi();
}

std::optional<double> comparableNumber(const Output& output, const SolvedBlow& blow, UnitSystem units) {
    if (!blow.fault.isEmpty()) return std::nullopt;
    const std::optional<double> value = output.value({blow.summary, blow.scenario, blow.thrustMargin()});
    if (!value || !std::isfinite(*value)) return std::nullopt;
    if (output.measure == Measure::share || output.measure == Measure::energy) return 100 * *value;
    const bool isPlain = output.isOnlySi() || output.measure == Measure::number;
    if (isPlain || units == UnitSystem::dimensionless) return value;
    if (blow.scenario.form == ScenarioForm::dimensionless) return std::nullopt;
    return *value * (output.measure == Measure::work ? blow.scales.energy : output.scale(blow.scales));
}

QString outputText(const Output& output, const SolvedBlow& blow) {
    const std::optional<double> found = output.value({blow.summary, blow.scenario});
    if (!found) return {};
    const double value = *found;
    switch (output.measure) {
        case Measure::number:
            return numberText(value, 4, QLocale());
        case Measure::error:
            return magnitudeText(value, QLocale());
        case Measure::work:
            return shown(value, blow.units.energy);
        case Measure::share:
        case Measure::energy:
            // Shares of the energy are known to 1e-12.
            return percentText(std::abs(value) < 1e-12 ? 0 : value, 4, QLocale());
        default:
            return shown(value, outputUnit(output, blow.units, value));
    }
}

QString impulseText(const Output& output, const SolvedBlow& blow) {
    const QString text = outputText(output, blow);
    const std::optional<double> share = output.value({blow.summary, blow.scenario});
    if (!share || blow.units.impulse.dimensionless) return text;
    return text + QStringLiteral(" = ") + numberText(*share, 3, QLocale()) + QChar(QChar::Nbsp) +
           QStringLiteral("I₀");
}

QString hammerEnergyText(const SolvedBlow& blow) {
    constexpr double ofItself = 1;
    return shown(ofItself, blow.units.energy);
}

QString corErrorText(const SolvedBlow& blow) {
    return tr("Numerical error ± %1").arg(magnitudeText(blow.summary.corError, QLocale()));
}

std::optional<RodForce> placeOf(const Output& output, const SolvedBlow& blow) {
    if (!output.load) return std::nullopt;
    const std::optional<RodForces>& forces = blow.summary.rodForces;
    const std::optional<RodForce> force =
        forces ? std::optional((*forces)[*output.load]) : stringPlaceOf(output, blow);
    return force && force->size > 0 ? force : std::nullopt;
}

QString placeText(const Output& output, const SolvedBlow& blow) {
    const std::optional<RodForce> found = placeOf(output, blow);
    if (!found) return {};
    const RodForce& force = *found;
    const QString time = shown(force.time, blow.units.time);
    if (force.section < 0) return tr("in the hammer, %1").arg(time);
    if (blow.request.units == UnitSystem::dimensionless && blow.summary.rodForces)
        return tr("at x/L = %1, t = %2").arg(numberText(force.section, 3, QLocale()), time);
    return translated(chainWords(blow.scenario).peakPlace).arg(shown(force.section, blow.units.length), time);
}

QString largestStressText(const SolvedBlow& blow) {
    const Output &compression = *findOutput("peak_compression"), &tension = *findOutput("peak_tension");
    if (placeText(compression, blow).isEmpty() || placeText(tension, blow).isEmpty()) return {};
    return tr("During the blow, the largest compression is %1 (%2), the largest tension %3 (%4).")
        .arg(outputText(compression, blow), placeText(compression, blow), outputText(tension, blow),
             placeText(tension, blow));
}

QString placeText(const SolvedBlow& blow, double section) {
    const Scenario& scenario = blow.request.scenario;
    const QLocale locale;
    if (!hasUnits(scenario)) return tr("x/L = %1").arg(numberText(section, 3, locale));
    const double x = section * chainProperties(scenario).length;
    return (x < 0 ? tr("%1 from the face of the hammer") : translated(chainWords(scenario).place))
        .arg(quantityText(std::abs(x), blow.units.of(UnitKind::length, x), locale));
}

}  // namespace drillwave

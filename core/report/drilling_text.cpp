// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/drilling_report.h"

#include <algorithm>
#include <cmath>

#include "core/contact/contact_law.h"
#include "core/report/alert_words.h"
#include "core/report/report_text.h"
#include "core/study/drilling/drilling_statistics.h"
#include "core/text/text_layout.h"

namespace drillwave {

namespace {

/// Decimals of the mean number of contacts of a blow.
constexpr int statisticDigits = 5;

constexpr const char* rateLabel = translatable("penetration rate");
constexpr const char* shareLabel = translatable("contact share");
constexpr const char* motionLabel = translatable("motion");
constexpr const char* energyLabel = translatable("energy");
constexpr const char* balancesLabel = translatable("balances");

/// A line of one of these labels, what is behind them in one column.
std::string labelled(const char* label, const Message& text, const ReadingStyle& style) {
    std::size_t widest = 0;
    for (const char* each : {rateLabel, shareLabel, motionLabel, energyLabel, balancesLabel})
        widest = std::max(widest, columnsOf(style.said(each)));
    return "  " + leftAligned(style.said(label), widest + 1) + style.said(text) + "\n";
}

std::string percent(double share, int digits, const ReadingStyle& style) {
    return style.number(100 * share, digits) + " %";
}

/// 0.05 d0.
std::string contactLimitText(const DrillingResult& result, OutputUnits units, const ReadingStyle& style) {
    const double limit =
        scaleOf(DrillingMeasure::length, result).value(contactLimit / lawUnitOfPenetration, units);
    return units == OutputUnits::si ? style.quantity(limit, Quantity::length, 2)
                                    : style.number(limit, 2) + " d0";
}

std::string motionLines(const DrillingResult& result, OutputUnits units, const ReadingStyle& style) {
    const double rate = result.spread(quantityPlace(&DrillingBlow::penetration)).mean *
                        result.units.length() * result.frequencyUsed;
    return labelled(rateLabel,
                    {translatable(
                         "up to %1: an upper limit (all rock under the bit breaks, cuttings are removed)"),
                     {style.rate(rate, 4)}},
                    style) +
           labelled(
               shareLabel,
               {translatable("%1 of the blows start within %2 of the rock"),
                {percent(result.statistics->contactShare, 4, style), contactLimitText(result, units, style)}},
               style) +
           labelled(motionLabel, regimeWords(result, style), style);
}

std::string balanceLines(const DrillingResult& result, const ReadingStyle& style) {
    const DrillingLedger& ledger = result.ledger;
    const auto share = [&](double part) {
        return percent(std::round(1000 * part / (ledger.hammer + ledger.feed)) / 1000, 3, style);
    };
    return labelled(
               energyLabel,
               {translatable(
                    "rock %1, damper %2, waves %3, new rock faces %4 of the energy from hammer and feed"),
                {share(ledger.rock), share(ledger.damper), share(ledger.waves), share(ledger.faces)}},
               style) +
           labelled(balancesLabel,
                    {translatable("momentum to %1, energy to %2"),
                     {style.bound(std::abs(result.momentumResidual)),
                      style.bound(std::abs(result.energyResidual))}},
                    style);
}

}  // namespace

TextGrid sequenceGrid(const DrillingResult& result, OutputUnits units, const ReadingStyle& style) {
    const auto titles = [&]() -> std::vector<std::string> {
        return {style.said({translatable("%1 blows"),
                            {std::to_string(result.settings.blows - result.settings.settle)}}),
                style.said(translatable("mean")),
                style.isPrinted() ? "±" : "+-",
                style.said(translatable("deviation")),
                "5 %",
                style.said(translatable("median")),
                "95 %"};
    };
    TextGrid grid;
    grid.add(titles());
    for (std::size_t q = 0; q < blowQuantities.size(); ++q) {
        const BlowQuantity& quantity = blowQuantities[q];
        if (!quantity.title) continue;
        const DrillingScale scale = scaleOf(quantity.measure, result);
        const auto formatted = [&](double number, int digits) {
            const double shown = scale.value(number, units);
            return units == OutputUnits::si && quantity.measure != DrillingMeasure::count
                       ? style.quantity(shown, scale.quantity, digits)
                       : style.number(shown, digits);
        };
        const BlowSpread& spread = result.spread(q);
        const std::optional<double> error = result.meanError(q);
        grid.add({style.said(quantity.title), formatted(spread.mean, statisticDigits),
                  error ? formatted(withoutRounding(*error), 2) : "",
                  formatted(withoutRounding(spread.deviation), 3), formatted(spread.q05, 4),
                  formatted(spread.q50, 4), formatted(spread.q95, 4)});
    }
    return grid;
}

std::string drillingText(const DrillingReport& report, OutputUnits units, const ReadingStyle& style) {
    const DrillingResult& result = report.result;
    std::string text = headingOf(result.scenario, style);
    text += "\n";
    for (const Message& sentence : drillingSentences(report, style)) text += paragraph(style.said(sentence));
    text +=
        "\n  " +
        style.said({translatable(
                        "phi = %1 (feed force over mean force of the blows), n_b = %2 round trips per blow"),
                    {style.number(result.groups.phi, 4), style.number(result.groups.roundTrips, 4)}}) +
        "\n";
    if (result.statistics)
        text += "\n" + sequenceGrid(result, units, style).text() + "\n" + motionLines(result, units, style);
    if (!result.blows.empty()) text += balanceLines(result, style);
    if (!result.alerts.empty()) text += "\n";
    for (const Alert& alert : result.alerts) text += paragraph(alertText(alert, style));
    return text;
}

}  // namespace drillwave

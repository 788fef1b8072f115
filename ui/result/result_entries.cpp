// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_entries.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/model/blow_traits.h"
#include "ui/result/feed_text.h"
#include "ui/result/output_text.h"
#include "ui/result/output_unit.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

ResultEntry::Number numberOf(const Output& output) {
    if (output.measure == Measure::error) return nullptr;
    return
        [&output](const SolvedBlow& blow, UnitSystem units) { return comparableNumber(output, blow, units); };
}

ResultEntry::Text textOf(const Output& output) {
    switch (output.measure) {
        case Measure::impulse:
            return [&output](const SolvedBlow& blow) { return impulseText(output, blow); };
        default:
            return [&output](const SolvedBlow& blow) { return outputText(output, blow); };
    }
}

}  // namespace

QList<ResultEntry> outputEntries(OutputGroup group) {
    std::vector<const Output*> wanted;
    for (const Output& output : outputs())
        if (output.group == group) wanted.push_back(&output);
    std::ranges::stable_sort(wanted, {}, &Output::order);
    QList<ResultEntry> entries;
    for (const Output* const each : wanted) {
        const Output& output = *each;
        const auto concerns = [&output](const Scenario& scenario) { return output.concerns(scenario); };
        entries.append({.name = coreText(output.label()),
                        .meaning = coreText(output.note),
                        .text = textOf(output),
                        .part = output.part,
                        .number = numberOf(output),
                        .concerns = concerns,
                        .output = &output});
        if (!output.load) continue;
        entries.append(
            {.meaning = tr("Where in the rod it is first that large, and when: a click leads there"),
             .text = [&output](const SolvedBlow& blow) { return placeText(output, blow); },
             .place = &output,
             .concerns = concerns});
    }
    return entries;
}

QList<ResultEntry> thrustEntries(const WorstNeed& worst, const ResultEntry::Number& worstOf) {
    return {
        {.name = tr("margin, this blow"),
         .meaning = tr("Effective feed force less what this blow requires, and as a share of that"),
         .text = thrustMarginText,
         .number = [](const SolvedBlow& blow, UnitSystem) { return thrustMargin(blow); },
         .change = marginChangeText},
        {.name = tr("required, this blow"),
         .meaning = tr("Mean force that balances this blow, which starts at rest on the rock"),
         .text = thrustNeededText,
         .number =
             [](const SolvedBlow& blow, UnitSystem) {
                 return thrustNeeded(blow.scenario, blow.summary.cor, blow.summary.transferred);
             }},
        {.name = tr("return in time"),
         .meaning = tr("At this feed an undamped rigid rod is back at the rock before the next blow"),
         .text = returnInTimeText,
         .number =
             [](const SolvedBlow& blow, UnitSystem) {
                 return thrustNeeded(blow.scenario, 2 * blow.summary.cor, blow.summary.transferred);
             }},
        {.name = tr("required, every gap"),
         .meaning =
             tr("The largest force required by this blow, by 95 % of all gaps, on rigid rock, and by the "
                "worst gap on elastic rock"),
         .text = [&worst](const SolvedBlow& blow) { return worstNeedText(worst, blow); },
         .note = [&worst](const SolvedBlow&) { return worst.problem(); },
         .objectName = worstName,
         .number = worstOf,
         .concerns = gapHasPeriod},
        {.meaning =
             tr("Effective feed force less the largest of the four, and as a share of that: thrust_margin of "
                "commands and files"),
         .text = [&worst](const SolvedBlow& blow) { return worstMarginText(worst, blow); },
         .objectName = worstName,
         .warning = [&worst](const SolvedBlow& blow) { return isShortOfWorst(worst, blow); },
         .concerns = gapHasPeriod},
        {.name = tr("installed"),
         .meaning = tr("Feed force of the drill rig"),
         .text = thrustInstalledText,
         .number = [](const SolvedBlow& blow, UnitSystem) { return blow.scenario.drill.thrust; }},
    };
}

ResultEntry hammerEnergyEntry() {
    return {.name = tr("hammer energy E₀"),
            .meaning = tr(
                "Energy of the hammer before the blow; all shares are of it, its work on the string is less"),
            .text = hammerEnergyText,
            .number = [](const SolvedBlow& blow, UnitSystem) { return blow.scales.energy; },
            .concerns = [](const Scenario& scenario) { return concerns(OutputOf::hammer, scenario); }};
}

ResultEntry corEntry() {
    return {.name = tr("COR e"),
            .meaning = tr("Coefficient of restitution: momentum after the blow over momentum before it, "
                          "reversed, e = −pf/p0"),
            .text = [](const SolvedBlow& blow) { return numberText(blow.summary.cor, 4, QLocale()); },
            .note = corErrorText,
            .weight = ResultEntry::Weight::heavy,
            .objectName = QStringLiteral("cor"),
            .number = numberOf(*findOutput("cor"))};
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/quick_march.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

constexpr long fewestBlows = 100;

}  // namespace

DrillingSettings windowSettingsOf(const Scenario& scenario) {
    // As many as the command takes where fewer would not reach beyond the settling.
    const bool isShort = scenario.drill.settle.value_or(0) < static_cast<double>(scanBlows);
    DrillingSettings settings =
        isShort ? drillingSettingsOf(scenario, scanBlows) : drillingSettingsOf(scenario);
    if (!scenario.drill.blows && !scenario.drill.settle) settings.settle = scanSettle;
    return settings;
}

DrillingRequest quickWants() {
    return {.lyapunov = false};
}

QuickMarch quickMarchOf(const Scenario& scenario, double seconds) {
    QuickMarch march{.settings = windowSettingsOf(scenario)};
    const double ofBlow = drillingWork(scenario, march.settings, quickWants()) / workOfSecond /
                          static_cast<double>(march.settings.blows);
    const double fit = std::floor(seconds / ofBlow);
    const long least = std::min(march.settings.blows, fewestBlows);
    if (fit < static_cast<double>(march.settings.blows)) {
        const double share =
            static_cast<double>(march.settings.settle) / static_cast<double>(march.settings.blows);
        march.settings.blows = std::max(least, static_cast<long>(std::max(fit, 0.0)));
        march.settings.settle = static_cast<long>(share * static_cast<double>(march.settings.blows));
    }
    march.seconds = ofBlow * static_cast<double>(march.settings.blows);
    march.isWithinTime = fit >= static_cast<double>(least);
    return march;
}

}  // namespace drillwave

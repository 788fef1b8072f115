// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_alerts.h"

#include <algorithm>
#include <cmath>

#include "core/blow/feed_estimate.h"

namespace drillwave {

namespace {

/// A share of the momentum of a hammer that passes after it has separated is in the way.
constexpr double mostLateShare = 0.02;

/// Departure of the shank from its mean place at a blow above which the stroke would be another one [m].
constexpr double mostShankOffset = 5e-3;

/// Relative rounding of the frequency above which there is an alert.
constexpr double toldRounding = 1e-5;

/// Energy residual over the hammer work above which there is an alert: 1 of 1050 random rods and 5 of 400
/// strings had one.
constexpr double toldResidual = 1e-3;

/// λ above which motion is chaotic.
constexpr double chaotic = 0.05;

void addShankOffset(const DrillingResult& result, std::vector<Alert>& alerts) {
    double mean = 0, most = 0;
    const auto settle = static_cast<std::size_t>(result.settings.settle);
    if (result.blows.size() <= settle) return;
    for (std::size_t i = settle; i < result.blows.size(); ++i) mean += result.blows[i].shankOffset;
    mean /= static_cast<double>(result.blows.size() - settle);
    for (std::size_t i = settle; i < result.blows.size(); ++i)
        most = std::max(most, std::abs(result.blows[i].shankOffset - mean));
    most *= result.units.length();
    if (most > mostShankOffset)
        alerts.push_back(
            {AlertLevel::warning, AlertCode::shankOff, {}, {{"offset", most, Quantity::length}}});
}

}  // namespace

std::vector<Alert> drillingAlerts(const DrillingResult& result, const AlertCauses& causes) {
    std::vector<Alert> alerts;
    const Drill& drill = result.scenario.drill;
    const auto add = [&](AlertLevel level, AlertCode code, std::vector<AlertArgument> arguments = {}) {
        alerts.push_back({level, code, {}, std::move(arguments)});
    };
    if (result.outcome == DrillingOutcome::pushedBack) {
        const double needed = result.meanImpulse * result.units.impulse() * result.frequencyUsed;
        add(AlertLevel::warning, AlertCode::pushedBack,
            {{"force", feedForceOf(result.scenario)->effective(), Quantity::force},
             {"needed", needed, Quantity::force}});
    }
    if (!result.hasLoss) add(AlertLevel::information, AlertCode::noWaveLoss);
    if (std::abs(causes.rounding) > toldRounding)
        add(AlertLevel::information, AlertCode::frequencyRounded,
            {{"frequency", *drill.blowFrequency, Quantity::frequency},
             {"used", result.frequencyUsed, Quantity::frequency}});
    if (causes.lateShare > mostLateShare)
        add(AlertLevel::warning, AlertCode::restrikeInTheWay, {{"share", causes.lateShare}});
    if (causes.hasMachine) {
        add(AlertLevel::information, AlertCode::damperAssumed);
        if (result.outcome != DrillingOutcome::pushedBack) addShankOffset(result, alerts);
    }
    if (std::abs(result.energyResidual) > toldResidual)
        add(AlertLevel::warning, AlertCode::energyUnbalanced, {{"share", std::abs(result.energyResidual)}});
    if (!result.statistics) return alerts;
    if (result.cellsDecideMotion) add(AlertLevel::warning, AlertCode::coexistingMotions);
    if (!result.statistics->isSettled) add(AlertLevel::warning, AlertCode::notSettled);
    if (result.statistics->period == 0 || (result.lyapunov && result.lyapunov->value > chaotic))
        add(AlertLevel::information, AlertCode::irregularMotion);
    return alerts;
}

}  // namespace drillwave

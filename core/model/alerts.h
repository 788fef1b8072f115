// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks on a valid scenario and its result, as codes with numbers: report/alert_words.h makes sentences of
// them.
#pragma once

#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

enum class AlertLevel { information, warning };

/// Subjects of alerts (files §5.1).
enum class AlertCode {
    implausibleValue,
    longPulse,
    defaultHammer,
    pistonImpedance,
    gapWithoutEffect,
    thrustBelowNeeded,
    superRebound,
    severalContacts,
    closedFormInvalid,
    inputDecides,
    reducedAccuracy,
    stressAboveYield,
    stressAboveFatigue,
    residualWaves,
    lengthsRounded,
    wavesThinned,
    blowNotOver,
    stressesLeftOut,
    cornersWithoutEffect,
    // of many blows
    pushedBack,
    noWaveLoss,
    restrikeInTheWay,
    shankOff,
    frequencyRounded,
    notSettled,
    coexistingMotions,
    irregularMotion,
    energyUnbalanced,
    damperAssumed,
};

/// "outside_plausible_range", "pulse_longer_than_round_trip", …
std::string_view name(AlertCode code);

/// Number in an alert.
struct AlertArgument {
    std::string_view name;  ///< of static storage: "cor", or the key of a parameter
    double value = 0;       ///< SI
    Quantity quantity = Quantity::ratio;
    bool operator==(const AlertArgument&) const = default;
};

/// A remark on a valid scenario or its result.
struct Alert {
    AlertLevel level = AlertLevel::information;
    AlertCode code = AlertCode::implausibleValue;
    std::string parameter;  ///< key of the subject, may be empty
    std::vector<AlertArgument> arguments;
    Message subject = {};  ///< words of the section that it is about, "3rd rod"; or empty
    bool operator==(const Alert&) const = default;

    bool has(std::string_view argument) const;
    /// The argument of that name, which must be there.
    const AlertArgument& argument(std::string_view name) const;
};

/// Values outside their plausible range, and assumptions of the model that the scenario strains.
std::vector<Alert> alertsFor(const Scenario& scenario);

}  // namespace drillwave

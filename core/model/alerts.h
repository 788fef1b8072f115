// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings and notes on a valid scenario and its result, as codes with numbers. report/alert_words.h turns
// them into sentences.
#pragma once

#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

enum class AlertLevel { information, warning };

/// Subjects of warnings and notes (files §5.1).
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
    // simulations of many blows
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

/// Returns the name of a code in JSON: "outside_plausible_range", "pulse_longer_than_round_trip".
std::string_view name(AlertCode code);

/// Named number in a warning or note.
struct AlertArgument {
    /// Name of the number in the message: "cor" (coefficient of restitution) or a parameter key. The text
    /// must have static storage duration.
    std::string_view name;
    double value = 0;  ///< value in SI
    Quantity quantity = Quantity::ratio;
    bool operator==(const AlertArgument&) const = default;
};

/// Warning or note on a valid scenario or its result.
struct Alert {
    AlertLevel level = AlertLevel::information;
    AlertCode code = AlertCode::implausibleValue;
    std::string parameter;  ///< key of the parameter concerned; may be empty
    std::vector<AlertArgument> arguments;
    Message subject = {};  ///< name of the section or table concerned, such as "3rd rod"; may be empty
    bool operator==(const Alert&) const = default;

    bool has(std::string_view argument) const;
    /// Returns the argument with this name. Requires that there is one.
    const AlertArgument& argument(std::string_view name) const;
};

/// Returns warnings and notes known before solving: values outside their typical range, and assumptions of
/// the model that the scenario violates.
std::vector<Alert> alertsFor(const Scenario& scenario);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a scenario can be drilled with, blow after blow.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

// Results of many blows under a feed (drilling §5), from which the outputs `drill_…` are taken.

/// Gaps and penetrations are multiples of d0, impulses of I0, forces of F0. Empty where there is no number:
/// no statistics of a machine that is pushed back, and no numbers that were not requested.
struct DrillNumbers {
    using Number = std::optional<double>;
    Number gapMean, gapDeviation, gap05, gap50, gap95;  ///< at the blow; ≥ 0
    Number penetration;                                 ///< mean of a blow
    Number penetrationError;                            ///< of that, 95 %
    Number penetrationRate;                             ///< [m/s]
    Number rockImpulse;                                 ///< mean
    Number peakForce;                                   ///< mean of the largest of each blow
    Number damperForce;                                 ///< largest
    Number contactShare;                                ///< blows that begin within 0.01 d0 of the rock
    Number contacts;                                    ///< mean of a blow
    Number period;                                      ///< 1 … 16 blows; 0: it does not repeat
    Number lyapunov;                                    ///< λ per blow
    Number thrustNumber;                                ///< φ
    Number roundTrips;                                  ///< n_b
    Number momentumResidual;                            ///< over N Fe/f
    Number energyResidual;                              ///< over the hammer work
};

/// Which of them take marches of their own.
struct RequiredMarches {
    bool any = false;
    bool lyapunov = false;
    bool penetrationError = false;
};

/// Default number of blows that are marched for each value of a study of many values, and of transient blows
/// among them.
inline constexpr long scanBlows = 300, scanSettle = 100;

/// Number of blows that are followed, and of transient blows at the start that are excluded from statistics.
struct DrillLength {
    long blows = scanBlows;
    long settle = scanSettle;
};

/// Returns the length for studies of many values, as the scenario sets it. By default a fifth of the blows is
/// excluded as transient.
DrillLength scanLengthOf(const Scenario& scenario);

/// Returns why a valid scenario cannot be drilled with, each with its key: "drill.thrust: is missing …".
/// Empty if it can be.
std::vector<Message> drillProblems(const Scenario& scenario, const DrillLength& length);

/// Returns the problems of a study of many values, in one line.
Message drillProblem(const Scenario& scenario);

}  // namespace drillwave

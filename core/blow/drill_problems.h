// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether the blows of a scenario can be computed in succession, and the numbers that such sequences
// give.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

// Results of many blows under a feed (drilling §5), from which the outputs `drill_…` are taken

/// Statistics of many blows. Unless another unit is given, lengths are in d0, impulses in I0, forces in F0. A
/// number is empty if it was not requested, or if the machine is pushed back, since no steady motion exists
/// then.
struct DrillNumbers {
    using Number = std::optional<double>;
    /// Mean, standard deviation, and 5, 50 and 95 % quantiles of the gap between bit and rock when the hammer
    /// strikes; ≥ 0. They are taken over the counted blows, in units of d0 = 2 I0/Z.
    Number gapMean, gapDeviation, gap05, gap50, gap95;
    /// Mean penetration of the bit per blow, in units of d0.
    Number penetration;
    /// Bound of the error of the mean penetration per blow at 95 % confidence, in units of d0.
    Number penetrationError;
    /// Mean penetration rate (length drilled per time), in m/s.
    Number penetrationRate;
    /// Mean impulse on the rock per blow, in units of I0.
    Number rockImpulse;
    /// Mean over all blows of the largest impact force in each, in units of F0.
    Number peakForce;
    /// Largest force of all blows in the damper between machine and rod, in units of F0.
    Number damperForce;
    /// Share of blows that start with the bit within 0.05 d0 of the rock; 0 … 1.
    Number contactShare;
    /// Mean number of contacts of bit and rock per blow.
    Number contacts;
    /// Period of the steady motion: number of blows, 1 … 16, after which it repeats; 0 if it does not repeat.
    Number period;
    /// Lyapunov exponent λ per blow; above 0, individual blows are not reproducible.
    Number lyapunov;
    /// Ratio φ = Fe/(f I0) of the effective feed force to the mean force of the blows.
    Number thrustNumber;
    /// Number n_b of round trips of a wave between two blows.
    Number roundTrips;
    /// Error of the momentum balance over N blows, as a share of N Fe/f. This is the impulse of the effective
    /// feed force Fe during N blows at the blow frequency f.
    Number momentumResidual;
    /// Error of the energy balance, as a share of the hammer work.
    Number energyResidual;
};

/// Sequences of blows that must be computed to get the requested outputs.
struct RequiredMarches {
    /// Whether any output requires a sequence of blows.
    bool any = false;
    /// Whether the Lyapunov exponent is required. It is found from a second sequence of blows next to the
    /// first one.
    bool lyapunov = false;
    /// Whether the error of the penetration per blow is required. It is found from a second sequence of blows
    /// with other time steps.
    bool penetrationError = false;
};

/// Default length of a sequence of blows in a study that computes one sequence for each of many values.
/// `scanBlows` includes the `scanSettle` transient blows at the start, which the statistics exclude.
inline constexpr long scanBlows = 300, scanSettle = 100;

/// Number of blows of a sequence, and of transient blows at its start that the statistics exclude.
struct DrillLength {
    long blows = scanBlows;
    long settle = scanSettle;
};

/// Returns the length of each sequence of blows in a study that computes one sequence for each of many
/// values. The scenario sets the length. If it sets only the number of blows, a fifth of them are transient.
DrillLength scanLengthOf(const Scenario& scenario);

/// Returns the reasons why a sequence of blows cannot be computed for a valid scenario. Each begins with the
/// key in question: "drill.thrust: is missing …". Returns an empty list if it can be computed.
std::vector<Message> drillProblems(const Scenario& scenario, const DrillLength& length);

/// Returns the reasons why a study of many values cannot compute sequences of blows for this scenario, as one
/// line. Empty if it can.
Message drillProblem(const Scenario& scenario);

}  // namespace drillwave

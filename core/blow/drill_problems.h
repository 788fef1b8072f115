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
    /// Largest damper force of all blows, in units of F0.
    Number damperForce;
    /// Share of blows that start with the bit within 0.05 d0 of the rock; 0 … 1.
    Number contactShare;
    /// Mean number of contacts of bit and rock per blow.
    Number contacts;
    /// Number of blows, 1 … 16, after which the motion repeats; 0 if it does not repeat.
    Number period;
    /// Lyapunov exponent λ per blow; above 0, individual blows are not reproducible.
    Number lyapunov;
    /// Ratio φ = Fe/(f I0) of the effective feed force to the mean force of the blows.
    Number thrustNumber;
    /// Number n_b of round trips of a wave between two blows.
    Number roundTrips;
    /// Error of the momentum balance over N blows, as a share of the impulse N Fe/f of the effective feed
    /// force Fe at the blow frequency f.
    Number momentumResidual;
    /// Error of the energy balance, as a share of the hammer work.
    Number energyResidual;
};

/// Sequences of blows that the requested outputs need.
struct RequiredMarches {
    /// Whether any output requires a sequence of blows.
    bool any = false;
    /// Whether the Lyapunov exponent is required, which takes a second sequence.
    bool lyapunov = false;
    /// Whether the error of the penetration is required, which takes a sequence with other time steps.
    bool penetrationError = false;
};

/// Default number of blows for each value in a study of many values, and number of transient blows among
/// them.
inline constexpr long scanBlows = 300, scanSettle = 100;

/// Number of blows of a sequence, and of transient blows at its start that the statistics exclude.
struct DrillLength {
    long blows = scanBlows;
    long settle = scanSettle;
};

/// Returns the number of blows and of transient blows for each value in a study of many values, as the
/// scenario sets them. If the scenario only sets the number of blows, a fifth of them are transient.
DrillLength scanLengthOf(const Scenario& scenario);

/// Returns the reasons why a sequence of blows cannot be computed for a valid scenario. Each begins with the
/// key in question: "drill.thrust: is missing …". Returns an empty list if it can be computed.
std::vector<Message> drillProblems(const Scenario& scenario, const DrillLength& length);

/// Returns the reasons why no sequence of blows can be computed in a study of many values, as one line; empty
/// if a sequence can be computed.
Message drillProblem(const Scenario& scenario);

}  // namespace drillwave

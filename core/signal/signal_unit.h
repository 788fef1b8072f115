// SPDX-License-Identifier: GPL-3.0-or-later
// What the numbers of a recorded signal are: a force, a strain, or the output of a bridge of strain gauges.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace drillwave {

enum class SignalKind {
    force,   ///< in N
    strain,  ///< in m/m
    bridge,  ///< output over supply of a Wheatstone bridge, V/V
};

/// One number of the file is so many N, m/m or V/V.
struct SignalUnit {
    std::string_view name;  ///< "kN", "microstrain", "mV/V"
    double factor = 1;
    bool operator==(const SignalUnit&) const = default;
};

/// The units of a kind, the commonest first.
std::vector<SignalUnit> signalUnits(SignalKind kind);

/// The unit of that name of whatever kind; case counts.
struct NamedSignalUnit {
    SignalKind kind = SignalKind::force;
    SignalUnit unit;
    bool operator==(const NamedSignalUnit&) const = default;
};
std::optional<NamedSignalUnit> findSignalUnit(std::string_view name);

/// Where strain gauges sit, and how a bridge tells their strain: N = E A ε, ε = 4 r/(k n).
struct GaugedBar {
    double axialStiffness = 0;  ///< E A [N], > 0
    double gaugeFactor = 2;     ///< k > 0, of the gauges; for bridges
    double activeGauges = 1;    ///< n: 1 quarter bridge, 2, 4 full bridge that see ±ε
    bool operator==(const GaugedBar&) const = default;
};

/// N of normal force that one number of the file stands for.
double forcePerNumber(SignalKind kind, double unitFactor, const GaugedBar& bar);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a blow as the window writes them.
#pragma once

#include <QString>

#include "core/blow/outputs.h"
#include "ui/job/solved_blow.h"

namespace drillwave {

/// An output in the units of the blow; empty where there is none.
QString outputText(const Output& output, const SolvedBlow& blow);

/// An impulse in its unit, and as a multiple of that of the hammer: "72.92 N s = 1.43 I₀".
QString impulseText(const Output& output, const SolvedBlow& blow);

/// The energy of a hammer that is followed, before the blow.
QString hammerEnergyText(const SolvedBlow& blow);

/// "numerical error ± 6·10⁻¹⁴".
QString corErrorText(const SolvedBlow& blow);

/// Where in the rod a largest force is, and when. Empty where there is none.
QString placeText(const Output& output, const SolvedBlow& blow);
/// The place itself: x/L, below 0 in the hammer of a string, and t/t0; nothing where it is not known, or
/// where there is no such stress.
std::optional<RodForce> placeOf(const Output& output, const SolvedBlow& blow);

}  // namespace drillwave

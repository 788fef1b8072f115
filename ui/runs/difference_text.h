// SPDX-License-Identifier: GPL-3.0-or-later
// Differences of results as text.
#pragma once

#include <QString>
#include <optional>

#include "core/model/scenario.h"

namespace drillwave {

class UnitChoice;

/// (value − reference)/|reference|; nothing where the reference is zero.
std::optional<double> relativeDifference(double value, double reference);

/// The relative difference: "+32 %", "−0.4 %", "±0 %", "≈0 %" below a hundredth; empty for nothing. Beyond a
/// thousand percent of a positive reference as a factor, "×12.3".
QString relativeText(double value, double reference);

/// "+0.2047", "−3.1", "±0".
QString signedText(double difference, int digits = 4);

// Differences between two scenarios, in few words.

/// Returns the values of the second scenario that differ, in the units of the fields: "k 300 MN/m, L 12 ft",
/// "half sine". At most a few changes, the rest as "…". Empty if only the titles differ.
QString changeWords(const Scenario& before, const Scenario& after, const UnitChoice& units);

}  // namespace drillwave

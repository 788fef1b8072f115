// SPDX-License-Identifier: GPL-3.0-or-later
// Differences between results, and between scenarios, as text.
#pragma once

#include <QString>
#include <optional>

#include "core/model/scenario.h"

namespace drillwave {

class UnitChoice;

/// Returns (value − reference)/|reference|; nothing if the reference is zero or a number is not finite.
std::optional<double> relativeDifference(double value, double reference);

/// Returns the relative difference as text: "+32 %", "−0.4 %", "±0 %", or "≈0 %" below 0.01 %. An increase of
/// more than 1000 % over a positive reference is given as a factor, "×12.3". Empty if the reference is zero
/// or a number is not finite.
QString relativeText(double value, double reference);

/// Returns a difference with its sign: "+0.2047", "−3.1", "±0". `digits` are significant digits.
QString signedText(double difference, int digits = 4);

// Differences between two scenarios in a few words.

/// Returns the values in which `after` differs from `before`, in the units of the input fields: "k 300 MN/m,
/// L 12 ft", "half sine". At most four changes are listed, then "…". Empty if only the titles differ.
QString changeWords(const Scenario& before, const Scenario& after, const UnitChoice& units);

}  // namespace drillwave

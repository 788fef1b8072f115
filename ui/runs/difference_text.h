// SPDX-License-Identifier: GPL-3.0-or-later
// Differences of results as text.
#pragma once

#include <QString>
#include <optional>

namespace drillwave {

/// value/reference − 1, by the size of the reference; nothing where that is zero.
std::optional<double> relativeDifference(double value, double reference);

/// "+32 %", "−0.4 %", "±0 %", "≈0 %" below a hundredth; empty for nothing. Beyond a thousand percent as a
/// factor, "×12.3".
QString percentText(const std::optional<double>& relative);

/// "+0.2047", "−3.1", "±0".
QString signedText(double difference);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Some of the samples of a curve, so chosen that the straight lines between them stay close to all of it.
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace drillwave {

/// At most `most` (≥ 2) of the samples, the first and the last among them, such that the lines between them
/// are, to a fraction of a percent, as close to all samples as this search can have them: for a deviation it
/// goes along the samples once, each line as long as it may be, and the deviation is bisected. Times
/// increase. The indices in order; all where there are no more than `most`. Ends early when it is stopped.
std::vector<std::size_t> thinnedCurve(std::span<const double> time, std::span<const double> value,
                                      std::size_t most, const std::stop_token& stop = {});

}  // namespace drillwave

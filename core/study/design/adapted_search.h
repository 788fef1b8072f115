// SPDX-License-Identifier: GPL-3.0-or-later
// A search for the largest value in a box that learns which way a ridge runs.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

namespace drillwave {

/// Range and duration of an adapted search.
struct AdaptedSearch {
    double spread = 0.03;       ///< standard deviation of the first steps, of the width of the box
    double leastSpread = 1e-9;  ///< it ends there
    int steps = 1000;           ///< at most
    std::uint64_t seed = 1;
};

/// Climbs from `place`, where the value is `value`, to a larger one; every coordinate stays in 0 … 1.
/// `valueAt` may return NaN where there is no value. Steps are normally distributed. After a step that leads
/// on the next ones are wider and more of them point that way, after others they are narrower: the (1+1)
/// evolution strategy with an adapted covariance matrix [Igel, Suttorp and Hansen, GECCO 2006]. So it follows
/// a ridge that is not along any coordinate, as kinks of e and of forces have. The same seed gives the same
/// result. Returns the number of values requested; a stop ends it early.
int climb(std::vector<double>& place, double& value,
          const std::function<double(const std::vector<double>&)>& valueAt, const AdaptedSearch& search,
          const std::stop_token& stop = {});

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Local search for a maximum in a box, which adapts to the direction of narrow ridges.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

namespace drillwave {

/// Settings of the search climb(): size of the first steps, criteria to end, and random seed.
struct AdaptedSearch {
    double spread = 0.03;  ///< standard deviation of the first steps, as a share of the box width
    /// Smallest standard deviation of the steps, as a share of the box width. The search ends below it.
    double leastSpread = 1e-9;
    int steps = 1000;  ///< maximum number of steps
    std::uint64_t seed = 1;
};

/// Climbs from the point `place` with objective `value` to a larger objective, and stores the result in both.
/// Returns the number of calls of `valueAt`. Every coordinate stays in 0 … 1; `valueAt` may return NaN at
/// points without a value.
/// Uses the (1+1) evolution strategy with an adapted covariance matrix [Igel, Suttorp and Hansen, GECCO
/// 2006]. Steps are normally distributed. After a successful step, steps get wider and more of them take that
/// direction; after failures they get narrower. Hence the search also follows narrow ridges oblique to the
/// coordinates. The same seed gives the same result. A stop request ends the search early.
int climb(std::vector<double>& place, double& value,
          const std::function<double(const std::vector<double>&)>& valueAt, const AdaptedSearch& search,
          const std::stop_token& stop = {});

}  // namespace drillwave

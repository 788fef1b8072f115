// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/thinned_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace drillwave {
namespace {

/// How far behind the last place where a line could have ended a longer one is looked for: keeps the work
/// proportional to the number of samples.
constexpr std::size_t lookAhead = 64;

/// Of the bisection: the deviation is known to 20.7/2^12 = 0.5 % of itself.
constexpr int halvings = 12;
constexpr double smallestDeviation = 1e-9;  // of the range of the values

/// The slopes of lines from one sample that pass all later ones within a deviation.
struct Cone {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    void narrow(double rise, double deviation, double run) {
        low = std::max(low, (rise - deviation) / run);
        high = std::min(high, (rise + deviation) / run);
    }
    bool isEmpty() const { return low > high; }
    bool contains(double slope) const { return low <= slope && slope <= high; }
};

/// The end of the longest line from a sample within the deviation.
std::size_t lineEnd(std::span<const double> time, std::span<const double> value, std::size_t from,
                    double deviation) {
    Cone cone;
    std::size_t end = from + 1;
    for (std::size_t j = from + 1; j < time.size(); ++j) {
        const double run = time[j] - time[from];
        const double rise = value[j] - value[from];
        if (cone.contains(rise / run)) end = j;
        cone.narrow(rise, deviation, run);
        if (cone.isEmpty() || j > end + lookAhead) break;
    }
    return end;
}

/// Nothing where it takes more than `most` samples.
std::optional<std::vector<std::size_t>> within(std::span<const double> time, std::span<const double> value,
                                               double deviation, std::size_t most,
                                               const std::stop_token& stop) {
    std::vector<std::size_t> kept{0};
    while (kept.back() + 1 < time.size()) {
        if (kept.size() == most || stop.stop_requested()) return std::nullopt;
        kept.push_back(lineEnd(time, value, kept.back(), deviation));
    }
    return kept;
}

}  // namespace

std::vector<std::size_t> thinnedCurve(std::span<const double> time, std::span<const double> value,
                                      std::size_t most, const std::stop_token& stop) {
    assert(most >= 2 && time.size() == value.size());
    std::vector<std::size_t> kept(time.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    if (kept.size() <= most) return kept;
    const auto [low, high] = std::ranges::minmax(value);
    const double range = high - low;
    kept = {0, time.size() - 1};  // within the whole range
    if (!(range > 0)) return kept;
    double good = std::log(range);
    double bad = good + std::log(smallestDeviation);
    for (int i = 0; i <= halvings; ++i) {
        // The smallest first: curves of straight lines need no more.
        const double tried = i == 0 ? bad : (good + bad) / 2;
        std::optional<std::vector<std::size_t>> found = within(time, value, std::exp(tried), most, stop);
        if (stop.stop_requested()) break;
        (found ? good : bad) = tried;
        if (found) kept = std::move(*found);
        if (i == 0 && found) break;
    }
    return kept;
}

}  // namespace drillwave

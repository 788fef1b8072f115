// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/signal_recipe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "core/numeric/compensated_sum.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

/// How far behind the last place where a line could have ended a longer one is looked for: keeps the work
/// proportional to the number of samples.
constexpr std::size_t lookAhead = 64;

/// Steps of the bisection: the deviation is known to 20.7/2^12 = 0.5 % of itself.
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

/// A blow is written into files: nine digits of its length and of its peak say more than any measurement.
constexpr double finest = 1e-9;

constexpr double edgeShare = 0.02;  // of the peak, where a blow begins and ends

using Points = std::vector<TablePoint>;

double impulseOf(std::span<const double> time, std::span<const double> force) {
    CompensatedSum<double> sum;
    for (std::size_t i = 1; i < time.size(); ++i)
        sum += (time[i] - time[i - 1]) * (force[i] / 2 + force[i - 1] / 2);
    return sum;
}

double impulseOf(const Points& points) {
    CompensatedSum<double> sum;
    for (std::size_t i = 1; i < points.size(); ++i)
        sum += (points[i].time - points[i - 1].time) * (points[i].force / 2 + points[i - 1].force / 2);
    return sum;
}

/// Multiples of a power of ten that is at most `finest` of a size, as the doubles nearest to them.
class DecimalGrid {
  public:
    explicit DecimalGrid(double size) {
        // Nothing is finer than the doubles, whose least powers of ten have no inverse.
        if (size * finest < std::numeric_limits<double>::min()) return;
        m_exponent = static_cast<int>(std::floor(std::log10(size * finest)));
        m_power = std::pow(10, std::abs(m_exponent));
    }

    double steps(double value) const {
        return std::round(m_exponent < 0 ? value * m_power : value / m_power);
    }
    double at(double steps) const { return m_exponent < 0 ? steps / m_power : steps * m_power; }

  private:
    int m_exponent = 0;
    double m_power = std::numeric_limits<double>::denorm_min();
};

/// The largest distance of a sample from the lines between the points, whose times are those of samples less
/// `origin`.
double largestDeviation(std::span<const double> time, std::span<const double> force, const Points& points,
                        const std::vector<std::size_t>& kept) {
    double largest = 0;
    for (std::size_t k = 1; k < kept.size(); ++k) {
        const double run = time[kept[k]] - time[kept[k - 1]];
        const double begin = points[k - 1].force, rise = points[k].force - begin;
        for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i) {
            const double line = begin + rise * ((time[i] - time[kept[k - 1]]) / run);
            largest = std::max(largest, std::abs(force[i] - line));
        }
    }
    return largest;
}

class SignalShaper {
  public:
    SignalShaper(const Samples& samples, const SignalRecipe& recipe) : m_samples(samples), m_recipe(recipe) {}

    ShapedSignal shape(const std::stop_token& stop) {
        m_result.zero = zeroOf(m_samples, m_recipe);
        if (!trim()) return refused("fewer than two samples are left between the times: widen them");
        toForces();
        if (m_recipe.negatives == Negatives::clipped) clip();
        if (const std::string problem = scale(); !problem.empty()) return refused(problem);
        if (isBlow())
            if (const std::string problem = blowProblem(); !problem.empty()) return refused(problem);
        thin(stop);
        return std::move(m_result);
    }

  private:
    bool isBlow() const { return m_recipe.use == SignalUse::blow; }

    static ShapedSignal refused(const std::string& problem) {
        ShapedSignal none;
        none.problem = problem;
        return none;
    }

    bool trim() {
        const std::vector<double>& time = m_samples.time;
        const auto begin = m_recipe.from ? std::ranges::lower_bound(time, *m_recipe.from) : time.begin();
        const auto end = m_recipe.to ? std::ranges::upper_bound(time, *m_recipe.to) : time.end();
        if (end - begin < 2) return false;
        m_begin = static_cast<std::size_t>(begin - time.begin());
        m_result.samples = static_cast<std::size_t>(end - begin);
        m_time = std::span(time).subspan(m_begin, m_result.samples);
        m_result.start = m_time.front();
        return true;
    }

    void toForces() {
        m_force.resize(m_result.samples);
        for (std::size_t i = 0; i < m_force.size(); ++i)
            m_force[i] = m_recipe.forcePerNumber * (m_samples.value[m_begin + i] - m_result.zero);
    }

    void clip() {
        const double before = impulseOf(m_time, m_force);
        for (double& force : m_force)
            if (force < 0) {
                force = 0;
                ++m_result.clipped;
            }
        if (m_result.clipped > 0) m_result.clippedImpulse = impulseOf(m_time, m_force) - before;
    }

    std::string scale() {
        double factor = m_recipe.scaling == Scaling::byFactor ? m_recipe.factor : 1;
        if (m_recipe.scaling == Scaling::toImpulse) {
            const double impulse = impulseOf(m_time, m_force);
            factor = m_recipe.impulse / impulse;
            if (!(impulse > 0) || !std::isfinite(factor))
                return "the impulse is " + formatNumber(impulse) +
                       " N s, which no factor makes the wanted one: check the sign and the times";
        }
        if (factor == 1) return {};
        for (double& force : m_force) force *= factor;
        m_result.clippedImpulse *= factor;
        return {};
    }

    std::string blowProblem() const {
        const auto [low, high] = std::ranges::minmax(m_force);
        if (low < 0)
            return "forces go down to " + formatNumber(low) +
                   " N, and a hammer only pushes: clip what is negative, or turn the sign";
        if (!(high > 0)) return "no force is greater than 0: check the sign, the zero line and the times";
        if (!std::isfinite(high)) return "the forces are too large: check the unit";
        return {};
    }

    void thin(const std::stop_token& stop) {
        const std::vector<std::size_t> kept = thinnedCurve(m_time, m_force, m_recipe.points, stop);
        Points points;
        points.reserve(kept.size());
        for (const std::size_t i : kept) points.push_back({m_time[i], m_force[i]});
        const double whole = impulseOf(m_time, m_force);
        m_result.deviation = largestDeviation(m_time, m_force, points, kept);
        if (isBlow()) {
            keepImpulse(points, whole);
            settleBlow(points);
            m_result.deviation = largestDeviation(m_time, m_force, points, kept);
        }
        m_result.impulse = impulseOf(points);
        m_result.impulseChange = m_result.impulse - whole;
        // Thinning may have left the largest sample out.
        const auto peak = std::ranges::max_element(m_force, {}, [](double force) { return std::abs(force); });
        m_result.peak = *peak;
        m_result.peakTime = m_time[static_cast<std::size_t>(peak - m_force.begin())];
        m_result.points = std::move(points);
    }

    /// Where that is a matter of the thinning: the chords of an arc, all on one side of it, are made good by
    /// little more than their distance. A bias of noise is not.
    void keepImpulse(Points& points, double whole) const {
        constexpr double most = 2;  // distances that the peak may be moved by
        const double peak = std::ranges::max(points, {}, &TablePoint::force).force;
        const double factor = whole / impulseOf(points);
        if (!(std::abs(factor - 1) * peak <= most * m_result.deviation)) return;
        for (TablePoint& point : points) point.force *= factor;
    }

    /// Its time begins at 0, its digits end.
    static void settleBlow(Points& points) {
        const double origin = points.front().time;
        const DecimalGrid times(points.back().time - origin);
        const DecimalGrid forces(std::ranges::max(points, {}, &TablePoint::force).force);
        double before = -1;  // [steps]: a jump takes one
        for (TablePoint& point : points) {
            before = std::max(before + 1, times.steps(point.time - origin));
            point.time = times.at(before);
            point.force = forces.at(forces.steps(point.force));
        }
    }

    const Samples& m_samples;
    const SignalRecipe& m_recipe;
    std::size_t m_begin = 0;
    std::span<const double> m_time;
    std::vector<double> m_force;
    ShapedSignal m_result;
};

std::size_t peakIndex(const Samples& samples, double zero) {
    const auto peak =
        std::ranges::max_element(samples.value, {}, [zero](double value) { return std::abs(value - zero); });
    return static_cast<std::size_t>(peak - samples.value.begin());
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

double zeroOf(const Samples& samples, const SignalRecipe& recipe) {
    if (recipe.zeroLine == ZeroLine::asRecorded) return 0;
    if (recipe.zeroLine == ZeroLine::chosen) return recipe.zeroValue;
    CompensatedSum<double> sum;
    std::size_t count = 0;
    for (; count < samples.time.size(); ++count) {
        if (count > 0 && samples.time[count] > samples.time.front() + recipe.zeroSpan) break;
        sum += samples.value[count];
    }
    return sum / static_cast<double>(count);
}

ShapedSignal shapedSignal(const Samples& samples, const SignalRecipe& recipe, const std::stop_token& stop) {
    return SignalShaper(samples, recipe).shape(stop);
}

std::optional<RecordSpan> spanAroundPeak(const Samples& samples, const SignalRecipe& recipe) {
    const double zero = zeroOf(samples, recipe);
    const std::size_t peak = peakIndex(samples, zero);
    const double height = samples.value[peak] - zero;
    if (height == 0) return std::nullopt;
    const auto isInside = [&](std::size_t i) { return (samples.value[i] - zero) / height > edgeShare; };
    std::size_t from = peak, to = peak;
    while (from > 0 && isInside(from)) --from;
    while (to + 1 < samples.value.size() && isInside(to)) ++to;
    return RecordSpan{samples.time[from], samples.time[to]};
}

double signOfPeak(const Samples& samples, const SignalRecipe& recipe) {
    const double zero = zeroOf(samples, recipe);
    return samples.value[peakIndex(samples, zero)] < zero ? -1 : 1;
}

}  // namespace drillwave

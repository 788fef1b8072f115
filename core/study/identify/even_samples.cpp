// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/even_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

constexpr double evenToShare = 0.02;     ///< steps as equal as that are taken as they are
constexpr double gapSteps = 20;          ///< a longer pause is a gap
constexpr double closestStep = 0.45e-6;  ///< samples closer than that are averaged [s]
constexpr double averagedStep = 0.8e-6;  ///< to about that [s]
constexpr double quietBetweenBlows = 1e-3;
constexpr double shareOfLaterBlow = 0.3;

/// Smallest difference between two values that differ by more than rounding; 0 where there is none.
double smallestDifference(const std::vector<double>& values) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double range = sorted.back() - sorted.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double difference = sorted[i] - sorted[i - 1];
        if (difference > 1e-9 * range) least = std::min(least, difference);
    }
    return std::isfinite(least) ? least : 0;
}

/// Marks runs of at least four samples at the largest or smallest value, where that value is more frequent
/// than its neighbour allows.
void markClipped(const std::vector<double>& values, double recorderStep, std::vector<bool>& isClipped) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (!(*high > *low)) return;
    for (const double limit : {*low, *high}) {
        std::size_t atLimit = 0, beside = 0, longest = 0, run = 0;
        for (const double value : values) {
            const bool is = std::abs(value - limit) < 0.25 * recorderStep;
            run = is ? run + 1 : 0;
            longest = std::max(longest, run);
            if (is)
                ++atLimit;
            else if (std::abs(value - limit) < 1.5 * recorderStep)
                ++beside;
        }
        if (longest < 4 || atLimit <= 2 * beside) continue;
        if (isClipped.empty()) isClipped.assign(values.size(), false);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (std::abs(values[i] - limit) < 0.25 * recorderStep) isClipped[i] = true;
    }
}

void averageInGroups(std::vector<double>& values, std::size_t group) {
    const std::size_t count = values.size() / group;
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < group; ++k) sum += values[i * group + k];
        values[i] = sum / static_cast<double>(group);
    }
    values.resize(count);
}

/// Calls `use` with the number of each even time, the time, and the recorded sample before it.
template <class Use>
void visitEvenTimes(const std::vector<double>& time, double start, double step, std::size_t count, Use use) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted = start + static_cast<double>(i) * step;
        while (at + 2 < time.size() && time[at + 1] < wanted) ++at;
        use(i, wanted, at);
    }
}

void interpolateToEven(const std::vector<double>& time, double start, double step, std::size_t count,
                       std::vector<double>& values) {
    if (values.empty()) return;
    std::vector<double> even(count);
    visitEvenTimes(time, start, step, count, [&](std::size_t i, double wanted, std::size_t at) {
        const double share = std::clamp((wanted - time[at]) / (time[at + 1] - time[at]), 0.0, 1.0);
        even[i] = values[at] + share * (values[at + 1] - values[at]);
    });
    values = std::move(even);
}

/// Marks even samples with no recorded one within three quarters of a step.
std::vector<bool> missingSamples(const std::vector<double>& time, double start, double step,
                                 std::size_t count) {
    std::vector<bool> isMissing(count);
    visitEvenTimes(time, start, step, count, [&](std::size_t i, double wanted, std::size_t at) {
        isMissing[i] = std::min(std::abs(wanted - time[at]), std::abs(time[at + 1] - wanted)) > 0.75 * step;
    });
    return isMissing;
}

}  // namespace

EvenSamples evenSamples(const GaugeRecord& record) {
    EvenSamples even;
    const std::vector<double>& time = record.time;
    std::vector<double> steps(time.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = time[i + 1] - time[i];
    std::vector<double> sorted = steps;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    even.step = sorted[sorted.size() / 2];
    even.start = time.front();
    // stamps that are rounded have a median of their own: the mean step is that of the clock
    bool isEven = true;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i] > gapSteps * even.step && !even.gap) even.gap = {time[i], time[i + 1]};
        if (std::abs(steps[i] - even.step) > evenToShare * even.step) isEven = false;
    }
    for (const GaugeChannel& gauge : record.gauges) {
        even.force.push_back(gauge.force);
        even.opposite.push_back(gauge.opposite);
        even.isClipped.emplace_back();
        if (gauge.opposite.empty()) {
            even.recorderStep.push_back(smallestDifference(gauge.force));
            markClipped(gauge.force, even.recorderStep.back(), even.isClipped.back());
        } else {
            std::vector<double> one = gauge.force, other = gauge.force;
            for (std::size_t i = 0; i < one.size(); ++i) {
                one[i] += gauge.opposite[i];
                other[i] -= gauge.opposite[i];
            }
            even.recorderStep.push_back(std::max(smallestDifference(one), smallestDifference(other)));
            markClipped(one, smallestDifference(one), even.isClipped.back());
            markClipped(other, smallestDifference(other), even.isClipped.back());
        }
    }
    if (!isEven) {
        const double span = time.back() - time.front();
        if (span > 0 && std::abs(span / static_cast<double>(steps.size()) / even.step - 1) < 0.1)
            even.step = span / static_cast<double>(steps.size());
        const auto count = static_cast<std::size_t>(
            std::min(span / even.step + 1.5, 4.0 * static_cast<double>(time.size())));
        even.isMissing = missingSamples(time, even.start, even.step, count);
        for (std::vector<double>& values : even.force)
            interpolateToEven(time, even.start, even.step, count, values);
        for (std::vector<double>& values : even.opposite)
            interpolateToEven(time, even.start, even.step, count, values);
        for (std::vector<bool>& marks : even.isClipped) {
            if (marks.empty()) continue;
            std::vector<bool> moved(count, false);
            for (std::size_t i = 0; i < marks.size(); ++i) {
                const auto at = static_cast<std::size_t>((time[i] - even.start) / even.step + 0.5);
                if (marks[i] && at < count) moved[at] = true;
            }
            marks = std::move(moved);
        }
    }
    if (even.step < closestStep) {
        const auto group = static_cast<std::size_t>(std::max(2.0, std::round(averagedStep / even.step)));
        for (std::vector<double>& values : even.force) averageInGroups(values, group);
        for (std::vector<double>& values : even.opposite) averageInGroups(values, group);
        for (std::vector<bool>& marks : even.isClipped) {
            const std::size_t count = marks.size() / group;
            for (std::size_t i = 0; i < count; ++i) {
                bool any = false;
                for (std::size_t k = 0; k < group; ++k) any = any || marks[i * group + k];
                marks[i] = any;
            }
            marks.resize(count);
        }
        even.start += even.step * static_cast<double>(group - 1) / 2;
        even.step *= static_cast<double>(group);
    }
    return even;
}

FrontFound findFront(const std::vector<double>& force, std::size_t from, std::size_t to, double step) {
    FrontFound found;
    const auto margin = static_cast<std::size_t>(20e-6 / step + 0.5);
    std::size_t level = std::min<std::size_t>(to - from, 50);  // samples of the level
    if (level < 2) return found;
    for (int round = 0; round < 3; ++round) {
        double sum = 0, squares = 0;
        for (std::size_t i = from; i < from + level; ++i) sum += force[i];
        found.zero = sum / static_cast<double>(level);
        for (std::size_t i = from; i < from + level; ++i)
            squares += (force[i] - found.zero) * (force[i] - found.zero);
        found.deviation = std::sqrt(squares / static_cast<double>(level));
        found.peak = 0;
        for (std::size_t i = from; i < to; ++i)
            found.peak = std::max(found.peak, std::abs(force[i] - found.zero));
        const double threshold = std::max(6 * found.deviation, 0.05 * found.peak);
        found.isFound = false;
        for (std::size_t i = from; i < to; ++i)
            if (std::abs(force[i] - found.zero) > threshold) {
                found.front = i;
                found.isFound = true;
                break;
            }
        if (!found.isFound) return found;
        const std::size_t before = found.front - from;
        const std::size_t next = before > margin + 2 ? before - margin : level;
        if (next == level) break;
        level = next;
    }
    return found;
}

std::vector<std::pair<std::size_t, std::size_t>> blowRanges(const std::vector<double>& force, double step) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    const FrontFound first = findFront(force, 0, force.size(), step);
    if (!first.isFound) return {{0, force.size()}};
    const double loud = std::max(6 * first.deviation, 0.05 * first.peak);
    const auto pause = static_cast<std::size_t>(quietBetweenBlows / step);
    std::vector<std::size_t> fronts{first.front};
    std::vector<std::size_t> quietFrom{0};
    std::size_t lastLoud = first.front;
    for (std::size_t i = first.front; i < force.size(); ++i) {
        if (std::abs(force[i] - first.zero) <= loud) continue;
        if (i - lastLoud > pause) {
            double peak = 0;
            for (std::size_t k = i; k < std::min(force.size(), i + pause); ++k)
                peak = std::max(peak, std::abs(force[k] - first.zero));
            if (peak > shareOfLaterBlow * first.peak) {
                fronts.push_back(i);
                quietFrom.push_back(lastLoud + (i - lastLoud) / 4);
            }
        }
        lastLoud = i;
    }
    const auto margin = static_cast<std::size_t>(20e-6 / step);
    for (std::size_t b = 0; b < fronts.size(); ++b)
        ranges.emplace_back(quietFrom[b], b + 1 < fronts.size() ? fronts[b + 1] - margin : force.size());
    return ranges;
}

double sampleAt(const std::vector<double>& samples, double place) {
    const double floor = std::floor(place);
    const auto i = static_cast<std::ptrdiff_t>(floor);
    const auto count = static_cast<std::ptrdiff_t>(samples.size());
    const auto value = [&](std::ptrdiff_t k) {
        return k >= 0 && k < count ? samples[static_cast<std::size_t>(k)] : 0.0;
    };
    if (i < -2 || i > count) return 0;
    const double u = place - floor;
    const double p0 = value(i - 1), p1 = value(i), p2 = value(i + 1), p3 = value(i + 2);
    return p1 + 0.5 * u * (p2 - p0 + u * (2 * p0 - 5 * p1 + 4 * p2 - p3 + u * (3 * (p1 - p2) + p3 - p0)));
}

void smoothSamples(std::vector<double>& values, double step, double deviation) {
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3 * deviation / step));
    if (reach < 1 || values.empty()) return;
    std::vector<double> kernel(static_cast<std::size_t>(reach) + 1);
    for (std::ptrdiff_t k = 0; k <= reach; ++k)
        kernel[static_cast<std::size_t>(k)] =
            std::exp(-0.5 * std::pow(static_cast<double>(k) * step / deviation, 2));
    const auto count = static_cast<std::ptrdiff_t>(values.size());
    const std::vector<double> given = values;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        double sum = 0, weight = 0;
        const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, i - reach),
                             to = std::min(count - 1, i + reach);
        for (std::ptrdiff_t k = from; k <= to; ++k) {
            const double w = kernel[static_cast<std::size_t>(std::abs(k - i))];
            sum += w * given[static_cast<std::size_t>(k)];
            weight += w;
        }
        values[static_cast<std::size_t>(i)] = sum / weight;
    }
}

}  // namespace drillwave

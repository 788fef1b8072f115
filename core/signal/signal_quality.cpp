// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/signal_quality.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/numeric/compensated_sum.h"
#include "core/text/handy_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr std::size_t fewestQuiet = 50;     // samples, for a zero line
constexpr double frontShare = 0.05;         // of the peak, above which a blow has begun
constexpr double beforeFront = 20e-6;       // [s] that belong to the front
constexpr double muchOffset = 0.02;         // of the peak
constexpr double muchDrift = 0.02;          // of the peak in a millisecond
constexpr double manyErrors = 4;            // standard errors between both halves
constexpr std::size_t fewestFlat = 4;       // equal samples in a row
constexpr double unevenStep = 0.02;         // of the usual step
constexpr double clockSpread = 0.3;         // steps within it are those of one clock
constexpr double pause = 1.5;               // usual steps
constexpr double blowShare = 0.5;           // of the peak, for a further blow
constexpr double quietBetweenBlows = 1e-3;  // [s]: waves in a rod come back sooner
constexpr double muchBending = 0.05;        // of the peak
constexpr double coarseStep = 2e-3;         // of the peak: a recorder of 9 bits
constexpr std::size_t fewestLevels = 16;    // different values, for steps to be seen

double meanOf(std::span<const double> values) {
    CompensatedSum<double> sum;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : static_cast<double>(sum) / static_cast<double>(values.size());
}

double deviationOf(std::span<const double> values, double mean) {
    CompensatedSum<double> sum;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return values.empty() ? 0 : std::sqrt(static_cast<double>(sum) / static_cast<double>(values.size()));
}

class QualityJudge {
  public:
    explicit QualityJudge(const Samples& samples)
        : m_time(samples.time), m_value(samples.value), m_all(samples) {}

    SignalQuality judge() {
        findZero();
        const double size = std::abs(m_quality.peak);
        if (!(size > 0)) return m_quality;
        judgeSteps(size);
        judgeZero(size);
        judgeTop();
        judgeClock();
        countBlows(size);
        if (!m_all.halfDifference.empty())
            m_quality.gaugeDifference = deviationOf(m_all.halfDifference, 0) / size;
        return m_quality;
    }

  private:
    /// From the beginning to 20 µs before the first value that is no noise; the mean of that is the zero
    /// line.
    void findZero() {
        const std::size_t count = m_value.size();
        double zero =
            meanOf(std::span(m_value).first(std::min(count, std::max<std::size_t>(10, count / 50))));
        for (int round = 0; round < 2; ++round) {
            const auto peak = std::ranges::max_element(
                m_value, {}, [zero](double value) { return std::abs(value - zero); });
            m_quality.peak = *peak - zero;
            const double threshold = frontShare * std::abs(m_quality.peak);
            std::size_t front = 0;
            while (front < count && std::abs(m_value[front] - zero) <= threshold) ++front;
            m_quiet = front;
            const double end = front < count ? m_time[front] - beforeFront : m_time.back();
            while (m_quiet > 0 && m_time[m_quiet - 1] > end) --m_quiet;
            if (m_quiet < fewestQuiet) break;
            zero = meanOf(std::span(m_value).first(m_quiet));
        }
        m_quality.zero = m_quiet < fewestQuiet ? 0 : zero;
        const double now = m_quality.zero;
        const auto peak =
            std::ranges::max_element(m_value, {}, [now](double value) { return std::abs(value - now); });
        m_peakAt = static_cast<std::size_t>(peak - m_value.begin());
        m_quality.peak = *peak - now;
    }

    void judgeZero(double size) {
        if (m_quiet < fewestQuiet) return;
        const std::span<const double> quiet = std::span(m_value).first(m_quiet);
        m_noise = deviationOf(quiet, m_quality.zero);
        m_quality.noise = m_noise / size;
        m_quality.offset = m_quality.zero / size;
        m_quality.isQuantised = m_quality.step > coarseStep && m_noise < m_step / 2;
        const double first = meanOf(quiet.first(m_quiet / 2)), second = meanOf(quiet.subspan(m_quiet / 2));
        const double error = m_noise * 2 / std::sqrt(static_cast<double>(m_quiet));
        const double length = (m_time[m_quiet - 1] - m_time.front()) / 2;
        const auto inMillisecond = [&](double change, double time) { return change / size * 1e-3 / time; };
        if (std::abs(second - first) > manyErrors * error && length > 0)
            m_quality.drift = inMillisecond(second - first, length);
        // The end of the record, where it is as quiet as its beginning.
        const std::size_t tail = std::max<std::size_t>(fewestQuiet, m_value.size() / 20);
        if (m_value.size() < 4 * tail) return;
        const std::span<const double> last = std::span(m_value).last(tail);
        const double mean = meanOf(last);
        const double run = (m_time.back() - m_time.front());
        if (deviationOf(last, mean) <= 3 * m_noise + 1e-3 * size && run > 0 &&
            std::abs(mean - m_quality.zero) > muchDrift * size &&
            std::abs(mean - m_quality.zero) > manyErrors * error)
            m_quality.drift = inMillisecond(mean - m_quality.zero, run);
    }

    /// The smallest difference of two values, where most differences are multiples of it.
    void judgeSteps(double size) {
        constexpr std::size_t most = 100'000;
        const std::size_t from = m_peakAt > most / 2 ? m_peakAt - most / 2 : 0;
        const std::size_t count = std::min(most, m_value.size() - from);
        std::vector<double> levels(m_value.begin() + static_cast<std::ptrdiff_t>(from),
                                   m_value.begin() + static_cast<std::ptrdiff_t>(from + count));
        std::ranges::sort(levels);
        const double tiny = 1e-9 * size;
        levels.erase(
            std::unique(levels.begin(), levels.end(), [tiny](double a, double b) { return b - a <= tiny; }),
            levels.end());
        if (levels.size() < fewestLevels || 2 * levels.size() > count) return;
        double step = HUGE_VAL;
        for (std::size_t i = 1; i < levels.size(); ++i) step = std::min(step, levels[i] - levels[i - 1]);
        std::size_t multiples = 0;
        for (std::size_t i = 1; i < levels.size(); ++i) {
            const double ratio = (levels[i] - levels[i - 1]) / step;
            multiples += std::abs(ratio - std::round(ratio)) < 0.1;
        }
        if (10 * multiples < 9 * (levels.size() - 1)) return;
        m_step = step;
        m_quality.step = step / size;
    }

    /// Equal values at the largest or at the smallest one: a recorder at its limit, unless the record is
    /// computed and so has no noise, or steps leave values equal.
    void judgeTop() {
        const auto [low, high] = std::ranges::minmax(m_value);
        for (const double top : {low, high}) {
            if (std::abs(top - m_quality.zero) < std::abs(m_quality.peak) / 2) continue;
            std::size_t run = 0, longest = 0, equal = 0;
            for (const double value : m_value) {
                run = value == top ? run + 1 : 0;
                longest = std::max(longest, run);
                equal += value == top;
            }
            if (longest <= m_quality.flatSamples) continue;
            m_quality.flatSamples = longest;
            m_quality.flatTop = top;
            // The neighbour by a step is what the peak of a signal that is not cut has, too.
            double neighbour = -top;
            bool any = false;
            for (const double value : m_value) {
                if (value == top || std::abs(value - m_quality.zero) < std::abs(top - m_quality.zero) / 2)
                    continue;
                if (!any || std::abs(value - top) < std::abs(neighbour - top)) neighbour = value;
                any = true;
            }
            const auto beside = static_cast<std::size_t>(std::ranges::count(m_value, neighbour));
            m_quality.isClipped = longest >= fewestFlat && hasNoise() && any && equal > 2 * beside;
        }
    }

    /// A computed record is quiet: its values before the front do not change.
    bool hasNoise() const {
        if (m_quiet < fewestQuiet) return m_value.size() >= 10 * fewestFlat && isRough();
        return m_noise > std::max(m_step / 2, 1e-9 * std::abs(m_quality.peak));
    }

    /// Without a quiet beginning: whether the rise to the top goes up and down.
    bool isRough() const {
        std::size_t turns = 0;
        for (std::size_t i = 2; i < m_value.size(); ++i)
            turns += (m_value[i] - m_value[i - 1]) * (m_value[i - 1] - m_value[i - 2]) < 0;
        return turns > m_value.size() / 10;
    }

    void judgeClock() {
        std::vector<double> runs;
        runs.reserve(m_time.size());
        for (std::size_t i = 1; i < m_time.size(); ++i) runs.push_back(m_time[i] - m_time[i - 1]);
        std::vector<double> sorted = runs;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::ranges::nth_element(sorted, middle);
        const double usual = *middle;
        std::size_t near = 0;
        double worst = 0, longest = 0;
        for (const double step : runs) {
            const double off = std::abs(step / usual - 1);
            near += off <= clockSpread;
            if (off <= clockSpread) worst = std::max(worst, off);
            longest = std::max(longest, step);
        }
        if (10 * near < 9 * runs.size() || runs.size() < fewestQuiet) return;  // not the steps of a clock
        m_quality.jitter = worst;
        m_quality.hasJitter = worst > unevenStep;
        if (longest > pause * usual) m_quality.gap = longest;
    }

    void countBlows(double size) {
        const double sign = m_quality.peak < 0 ? -1 : 1;
        const double quietLevel = std::max(frontShare * size, 6 * m_noise);
        if (quietLevel > blowShare * size / 2) return;
        std::size_t fronts = 0;
        std::size_t quiet = 0;
        double quietFrom = m_time.front();
        bool wasQuiet = true;  // long enough before the present front
        for (std::size_t i = 0; i < m_value.size(); ++i) {
            const double height = sign * (m_value[i] - m_quality.zero);
            if (std::abs(height) < quietLevel) {
                if (quiet++ == 0) quietFrom = m_time[i];
                if (quiet >= fewestQuiet && m_time[i] - quietFrom >= quietBetweenBlows) wasQuiet = true;
            } else {
                quiet = 0;
                if (height > blowShare * size && wasQuiet) {
                    ++fronts;
                    wasQuiet = false;
                }
            }
        }
        m_quality.blows = std::max<std::size_t>(1, fronts);
    }

    const std::vector<double>& m_time;
    const std::vector<double>& m_value;
    const Samples& m_all;
    SignalQuality m_quality;
    std::size_t m_quiet = 0;  // samples before the front
    std::size_t m_peakAt = 0;
    double m_noise = 0;  // as in the table
    double m_step = 0;
};

std::string percent(double share) {
    return rounded(100 * share, 2) + " %";
}

std::string timeText(double seconds) {
    return inHandyUnit(seconds, Quantity::time, 4);
}

}  // namespace

SignalQuality signalQuality(const Samples& samples) {
    return QualityJudge(samples).judge();
}

std::vector<SignalRemark> qualityRemarks(const SignalQuality& quality, const Samples& samples) {
    std::vector<SignalRemark> remarks;
    if (quality.isClipped)
        remarks.push_back({"clipped",
                           {translatable("%1 equal samples at the largest value, %2: clipped?"),
                            {std::to_string(quality.flatSamples), rounded(quality.flatTop)}}});
    if (quality.offset && std::abs(*quality.offset) > muchOffset)
        remarks.push_back(
            {"offset",
             {translatable("before the blow the record is at %1 of its peak: set the zero line"),
              {percent(*quality.offset)}}});
    if (quality.drift && std::abs(*quality.drift) > muchDrift)
        remarks.push_back(
            {"drift",
             {translatable("the zero line drifts by %1 of the peak per ms"), {percent(*quality.drift)}}});
    if (quality.isQuantised)
        remarks.push_back({"quantised",
                           {translatable("the resolution of the recorder is %1 of the peak, coarser than the "
                                         "noise: use a smaller range"),
                            {percent(quality.step)}}});
    if (quality.hasJitter)
        remarks.push_back(
            {"jitter",
             {translatable("time steps differ from the usual step by up to %1"), {percent(quality.jitter)}}});
    if (quality.blows > 1)
        remarks.push_back({"several_blows",
                           {translatable("the record holds %1 blows: choose one by its range of time"),
                            {std::to_string(quality.blows)}}});
    if (quality.gaugeDifference && *quality.gaugeDifference > muchBending)
        remarks.push_back({"opposite_gauges",
                           {translatable("opposite gauges differ: half their difference is %1 of the peak "
                                         "(rms); check for bending or a loose gauge"),
                            {percent(*quality.gaugeDifference)}}});
    if (quality.gap > 0 && samples.skipped == 0)
        remarks.push_back({"gap", {translatable("the times have a gap of %1"), {timeText(quality.gap)}}});
    return remarks;
}

}  // namespace drillwave

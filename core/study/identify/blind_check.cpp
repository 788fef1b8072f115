// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/blind_check.h"

#include <algorithm>
#include <cmath>

#include "core/study/identify/even_samples.h"

namespace drillwave {

namespace {

constexpr double longestShift = 30e-6;  ///< places of both gauges, and delays of the channels [s]
constexpr double zeroBefore = 40e-6;    ///< before the wave arrives, beyond its longest shift [s]
constexpr std::size_t leastCompared = 20;

/// Mean squares of measured minus predicted force, as it is and times the gain that fits best.
struct ShiftedPower {
    double power = 0, scaledPower = 0, gain = 1;
};

/// Compares measured and predicted force when the prediction comes `shift` later.
class ShiftedComparison {
  public:
    ShiftedComparison(std::vector<double> measured, std::vector<double> predicted, double first, double ratio)
        : m_measured(std::move(measured)),
          m_predicted(std::move(predicted)),
          m_first(first),
          m_ratio(ratio) {}
    /// `shift` in steps of the prediction.
    ShiftedPower at(double shift) const {
        double measuredSquare = 0, predictedSquare = 0, product = 0;
        for (std::size_t i = 0; i < m_measured.size(); ++i) {
            const double predicted =
                sampleAt(m_predicted, m_first + static_cast<double>(i) * m_ratio - shift);
            measuredSquare += m_measured[i] * m_measured[i];
            predictedSquare += predicted * predicted;
            product += m_measured[i] * predicted;
        }
        const auto count = static_cast<double>(m_measured.size());
        const double gain = predictedSquare > 0 ? product / predictedSquare : 1;
        return {(measuredSquare - 2 * product + predictedSquare) / count,
                std::max(0.0, measuredSquare - gain * product) / count, gain};
    }

  private:
    std::vector<double> m_measured, m_predicted;
    double m_first, m_ratio;
};

}  // namespace

std::optional<BlindCheck> blindCheck(const GaugeRecord& given, double distance, RecordModel& model,
                                     const LawFit& fit) {
    if (given.behind.size() != given.time.size() || given.behind.empty()) return std::nullopt;
    const PreparedRecord& record = model.record();
    GaugeRecord only;
    only.time = given.time;
    only.gauges.push_back({"behind", distance, given.behind, {}});
    const EvenSamples even = evenSamples(only);
    const std::vector<double>& force = even.force.front();

    const double lag = fit.values[static_cast<Eigen::Index>(model.find(UnknownKind::lag))];
    const double trip = record.roundTrip + lag;
    // The wave at the gauge reaches the specimen after half the round trip, and the other gauge after that.
    const double delay = trip / 2 + distance / record.places.front().waveSpeed;
    const auto sampleOf = [&](double time) { return (record.startTime + time - even.start) / even.step; };
    const std::size_t last = model.firstReturning() + model.returningCount() - 1;
    const double from = std::max(0.0, sampleOf(delay - zeroBefore));
    const double to =
        std::min(static_cast<double>(force.size()) - 1, sampleOf(record.timeOf(last) - trip + delay));
    const auto first = static_cast<std::size_t>(from);
    if (to < from + leastCompared) return std::nullopt;

    const auto quietEnd = static_cast<std::size_t>(std::max(1.0, from));
    double zero = 0;
    for (std::size_t i = 0; i < quietEnd; ++i) zero += force[i] / static_cast<double>(quietEnd);
    std::vector<double> measured;
    double peak = 0;
    for (std::size_t i = first; i <= static_cast<std::size_t>(to); ++i) {
        measured.push_back(record.sign * (force[i] - zero));
        peak = std::max(peak, std::abs(measured.back()));
    }
    if (!(peak > 0)) return std::nullopt;
    const std::vector<double> predicted =
        model.dispersed(model.solved(fit.values).rockForce(), distance, fit.values);
    const double firstTime = even.start + static_cast<double>(first) * even.step - record.startTime - delay;
    const ShiftedComparison comparison(measured, predicted,
                                       (firstTime - model.gridStart()) / model.gridStep(),
                                       even.step / model.gridStep());
    BlindCheck check;
    ShiftedPower closest = comparison.at(0), alike = closest;
    for (double shift = -longestShift; shift <= longestShift; shift += model.gridStep()) {
        const ShiftedPower shifted = comparison.at(shift / model.gridStep());
        if (shifted.scaledPower < alike.scaledPower) alike = shifted;
        if (shifted.power >= closest.power) continue;
        closest = shifted;
        check.shift = shift;
    }
    check.error = std::sqrt(std::max(0.0, closest.power)) / peak;
    check.gain = alike.gain;
    check.scaledError = std::sqrt(alike.scaledPower) / peak;
    return check;
}

}  // namespace drillwave

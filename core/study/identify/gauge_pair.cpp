// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/gauge_pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/study/identify/even_samples.h"

namespace drillwave {

namespace {

constexpr double passageGaussian = 8e-6;  ///< as for the misfit: fronts are sharper than samples [s]

struct PassageFit {
    double gain = 1;
    double power = 0;  ///< mean square of what is left [N²]
};

/// Mean square on the first passage that the times of sharp fronts leave, known to a sample only [N²].
double frontPower(const PreparedRecord& record) {
    double power = 0;
    for (const PreparedGauge& gauge : record.gauges) {
        const double noise = frontNoise * gauge.noise.deviation();
        for (std::size_t i = record.front; i + 1 < gauge.force.size(); ++i) {
            if (record.timeOf(i) > record.roundTrip) break;
            const double change = std::max(0.0, std::abs(gauge.force[i + 1] - gauge.force[i]) - noise);
            power += std::pow(frontError * change * record.step, 2);
        }
    }
    // a pulse of unit area through the Gaussian has the power 1/(2√π σ)
    return power / (2 * std::sqrt(std::numbers::pi) * passageGaussian) / record.roundTrip;
}

/// Both signals below 16 kHz, in which the sampling of sharp fronts does not show.
class Passage {
  public:
    explicit Passage(const PreparedRecord& record) : m_record(record) {
        for (const PreparedGauge& gauge : record.gauges) {
            std::vector<double> slow = gauge.force;
            smoothSamples(slow, record.step, passageGaussian);
            m_signals.push_back(std::move(slow));
        }
    }
    PassageFit fit(double shift) const;

  private:
    const PreparedRecord& m_record;
    std::vector<std::vector<double>> m_signals;
};

PassageFit Passage::fit(double shift) const {
    double cross = 0, square = 0, other = 0;
    std::size_t count = 0;
    const double places = shift / m_record.step;
    for (std::size_t i = 0; i < m_signals[0].size(); ++i) {
        const double t = m_record.timeOf(i);
        if (t < -20e-6) continue;
        if (t > m_record.roundTrip - 8e-6 - 2 * passageGaussian) break;
        const double p1 = m_signals[0][i], p2 = sampleAt(m_signals[1], static_cast<double>(i) - places);
        cross += p2 * p1;
        square += p1 * p1;
        other += p2 * p2;
        ++count;
    }
    PassageFit fit;
    fit.gain = square > 0 ? cross / square : 1;
    fit.power = (other - fit.gain * cross) / static_cast<double>(std::max<std::size_t>(count, 1));
    if (std::abs(fit.gain) > 0) fit.power /= fit.gain * fit.gain;
    return fit;
}

}  // namespace

void matchSecondGauge(PreparedRecord& record) {
    constexpr double range = 15e-6;
    const Passage passage(record);
    double best = record.transit, least = passage.fit(best).power;
    for (double shift = record.transit - range; shift <= record.transit + range; shift += record.step / 2) {
        const double power = passage.fit(shift).power;
        if (power < least) least = power, best = shift;
    }
    double low = best - record.step / 2, high = best + record.step / 2;
    constexpr double golden = 0.618033988749895;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double atA = passage.fit(a).power, atB = passage.fit(b).power;
    for (int i = 0; i < 24; ++i) {
        if (atA < atB) {
            high = b, b = a, atB = atA;
            a = high - golden * (high - low);
            atA = passage.fit(a).power;
        } else {
            low = a, a = b, atA = atB;
            b = low + golden * (high - low);
            atB = passage.fit(b).power;
        }
    }
    record.secondShift = (low + high) / 2;
    record.secondGain = passage.fit(record.secondShift).gain;
}

SeparatedWaves separateWaves(const PreparedRecord& record,
                             const std::vector<const std::vector<double>*>& signals, double transit) {
    const std::vector<double>& near = *signals[0];
    const std::size_t count = near.size();
    SeparatedWaves waves;
    waves.incident.assign(count, 0);
    waves.returning.assign(count, 0);
    if (!record.isPair()) {
        const double returns = record.roundTrip + std::min(0.0, record.shift) - 40e-6;
        for (std::size_t i = 0; i < count; ++i) {
            const double t = record.timeOf(i);
            if (t >= -20e-6 && t < record.incidentEnd) waves.incident[i] = near[i];
            if (t >= returns) waves.returning[i] = near[i];
        }
        return waves;
    }
    const std::vector<double>& far = *signals[1];
    const double shift = record.secondShift / record.step, trip = 2 * transit / record.step;
    for (std::size_t i = 0; i < count; ++i) {
        if (record.timeOf(i) < -20e-6) continue;
        const double at = static_cast<double>(i);
        const double before = at - trip;
        double incident = sampleAt(far, at - shift) / record.secondGain;
        // what is before the front is zero by definition: the recursion begins there
        if (before > static_cast<double>(record.front) - 20e-6 / record.step + 2)
            incident += sampleAt(waves.incident, before) - sampleAt(near, before);
        waves.incident[i] = incident;
        waves.returning[i] = near[i] - incident;
    }
    return waves;
}

SeparatedWaves separateWaves(const PreparedRecord& record) {
    std::vector<const std::vector<double>*> signals;
    for (const PreparedGauge& gauge : record.gauges) signals.push_back(&gauge.force);
    return separateWaves(record, signals, record.transit);
}

double passageDifference(const PreparedRecord& record) {
    const PassageFit fit = Passage(record).fit(record.secondShift);
    const auto span =
        std::max<std::size_t>(1, static_cast<std::size_t>(3.545 * passageGaussian / record.step));
    const double one = record.gauges[0].noise.deviationOfMean(span);
    const double two = record.gauges[1].noise.deviationOfMean(span) / std::abs(record.secondGain);
    const double noise = one * one + two * two;
    const double independent = std::max(4.0, record.roundTrip / (3.545 * passageGaussian));
    const double explained = noise * (1 + 2 * std::sqrt(2 / independent)) + 2 * frontPower(record);
    return std::sqrt(std::max(0.0, fit.power - explained)) / record.peak;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/gauge_pair.h"

#include <algorithm>
#include <cmath>

#include "core/study/identify/even_samples.h"

namespace drillwave {

namespace {

struct PassageFit {
    double gain = 1;
    double power = 0;  ///< mean square of what is left [N²]
};

PassageFit fitPassage(const PreparedRecord& record, double shift) {
    const std::vector<double>& near = record.gauges[0].force;
    const std::vector<double>& far = record.gauges[1].force;
    double cross = 0, square = 0, other = 0;
    std::size_t count = 0;
    const double places = shift / record.step;
    for (std::size_t i = 0; i < near.size(); ++i) {
        const double t = record.timeOf(i);
        if (t < -20e-6) continue;
        if (t > record.roundTrip - 8e-6) break;
        const double p2 = sampleAt(far, static_cast<double>(i) - places);
        cross += p2 * near[i];
        square += near[i] * near[i];
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
    double best = record.transit, least = fitPassage(record, best).power;
    for (double shift = record.transit - range; shift <= record.transit + range; shift += record.step / 2) {
        const double power = fitPassage(record, shift).power;
        if (power < least) least = power, best = shift;
    }
    double low = best - record.step / 2, high = best + record.step / 2;
    constexpr double golden = 0.618033988749895;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double atA = fitPassage(record, a).power, atB = fitPassage(record, b).power;
    for (int i = 0; i < 24; ++i) {
        if (atA < atB) {
            high = b, b = a, atB = atA;
            a = high - golden * (high - low);
            atA = fitPassage(record, a).power;
        } else {
            low = a, a = b, atA = atB;
            b = low + golden * (high - low);
            atB = fitPassage(record, b).power;
        }
    }
    record.secondShift = (low + high) / 2;
    record.secondGain = fitPassage(record, record.secondShift).gain;
}

SeparatedWaves separateWaves(const PreparedRecord& record, const std::vector<const std::vector<double>*>& signals,
                             double transit) {
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
    const PassageFit fit = fitPassage(record, record.secondShift);
    const double one = record.gauges[0].noise.deviation();
    const double two = record.gauges[1].noise.deviation() / std::abs(record.secondGain);
    // cubic interpolation takes some of the noise of the far gauge away: count it in full, with its scatter
    const double noise = one * one + two * two;
    const double count = std::max(10.0, record.roundTrip / record.step);
    return std::sqrt(std::max(0.0, fit.power - noise * (1 + 2 * std::sqrt(2 / count)))) / record.peak;
}

}  // namespace drillwave

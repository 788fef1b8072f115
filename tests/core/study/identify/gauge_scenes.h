// SPDX-License-Identifier: GPL-3.0-or-later
// Records that gauges would see, from small steps or from the solvers, and what goes wrong at a rig.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/blow/blow_waves.h"
#include "core/model/scales.h"
#include "core/study/identify/gauge_noise.h"
#include "core/study/identify/identify_study.h"

namespace drillwave {

/// A record with the rock that made it.
struct GaugeScene {
    std::string kind;
    IdentifyQuestion question;
    double stiffness = 0, gamma = 0, gap = 0;  ///< truth; of laws with no such number NaN
    bool mustIdentify = false;                 ///< an ordinary rig with nothing wrong
    bool mustRefuse = false;
};

/// Random numbers that are the same everywhere.
class SceneRandom {
  public:
    explicit SceneRandom(std::uint64_t seed) : m_engine(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(m_engine() >> 11) * 0x1p-53);
    }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    double normal() { return standardNormal(m_engine); }
    bool chance(double share) { return uniform(0, 1) < share; }
    int below(int count) { return std::min(count - 1, static_cast<int>(uniform(0, count))); }

  private:
    std::mt19937_64 m_engine;
};

/// Law of the rock for small steps: the force for a penetration and its rate, with memory of its own.
using SteppedRock = std::function<double(double penetration, double rate, double step)>;

/// Bilinear, or any loading curve with slope k/γ below its largest force; a dashpot beside it.
inline SteppedRock loadingRock(std::function<double(double)> loading, double elastic, double dashpot = 0) {
    return [loading, elastic, dashpot, largest = 0.0, deepest = 0.0](double u, double rate, double) mutable {
        if (u > deepest) {
            deepest = u;
            largest = std::max(largest, loading(u));
        }
        const double spring = std::max(0.0, largest - elastic * (deepest - u));
        return spring > 0 ? std::max(0.0, spring + dashpot * rate) : 0.0;
    };
}

/// Incident wave over time [N] at the gauge, from t = 0.
using IncidentWave = std::function<double(double)>;

/// A rod of one section with a gauge on it: waves by steps of 0.05 µs.
struct RodRig {
    double length = 3.66, diameter = 0.039, bore = 0.0145;
    double modulus = 210e9, density = 7850;
    double ahead = 1.83;   ///< of the gauge, truly [m]
    double stated = 1.83;  ///< by the file [m]
    double speed() const { return std::sqrt(modulus / density); }
    double area() const { return std::numbers::pi / 4 * (diameter * diameter - bore * bore); }
    double impedance() const { return area() * std::sqrt(modulus * density); }
};

/// P at the gauge at evenly spaced times from −before to `end`, the reflection behind the gauge left out.
inline std::vector<double> rodRecord(const RodRig& rig, const IncidentWave& f, SteppedRock rock, double gap,
                                     double step, double before, double end) {
    const double fine = 0.05e-6, z = rig.impedance(), trip = 2 * rig.ahead / rig.speed();
    std::vector<double> b;
    double u = -gap, force = 0;
    for (double t = 0; t < end; t += fine) {
        const double g = f(t);
        double rate = (2 * g - force) / z;
        const double half = u + rate * fine / 2;
        force = half > 0 ? rock(half, rate, fine) : 0;
        rate = (2 * g - force) / z;
        u += rate * fine;
        b.push_back(force - g);
    }
    std::vector<double> record;
    for (double t = -before; t < end; t += step) {
        double value = t >= 0 ? f(t) : 0;
        const double at = (t - trip) / fine;
        if (at >= 0 && at + 1 < static_cast<double>(b.size())) {
            const auto i = static_cast<std::size_t>(at);
            value += b[i] + (at - static_cast<double>(i)) * (b[i + 1] - b[i]);
        }
        record.push_back(value);
    }
    return record;
}

/// Forces at places of a string, compression positive, by the solver of strings.
inline std::vector<std::vector<double>> stringRecords(const Scenario& scenario,
                                                      const std::vector<double>& distances, double step,
                                                      double before, double end, double& arrival) {
    Scenario solved = scenario;
    solved.drillString.endTime = end + 2e-3;
    const Blow blow = solveBlow(solved, {}, Detail::histories);
    const BlowWaves waves(blow);
    const double length = stringProperties(solved.drillString).length;
    std::vector<std::vector<double>> records;
    // the time at which the far gauge begins
    const double far = *std::max_element(distances.begin(), distances.end());
    arrival = 0;
    for (double t = 0; t < 2e-3; t += step) {
        if (std::abs(waves.value(WaveQuantity::force, 1 - far / length, t / blow.scales.time)) < 0.02)
            continue;
        arrival = t;
        break;
    }
    for (const double distance : distances) {
        std::vector<double> record;
        for (double t = arrival - before; t < arrival + end; t += step) {
            double sum = 0;  // coarse recorders average, fine ones take points
            const int parts = step > 1.5e-6 ? 8 : 1;
            for (int p = 0; p < parts; ++p) {
                const double at = t + (p + 0.5 - parts / 2.0) / parts * step * (parts > 1 ? 1 : 0);
                if (at >= 0)
                    sum -= blow.scales.force *
                           waves.value(WaveQuantity::force, 1 - distance / length, at / blow.scales.time) /
                           parts;
            }
            record.push_back(sum);
        }
        records.push_back(std::move(record));
    }
    return records;
}

/// Adds noise of a kind to a signal: "white", "ar", "band", "slow" (1/f), "tone".
inline void addNoise(std::vector<double>& signal, const std::string& kind, double deviation, double step,
                     SceneRandom& random) {
    if (kind == "white") {
        for (double& value : signal) value += deviation * random.normal();
    } else if (kind == "ar") {
        double noise = deviation * random.normal();
        for (double& value : signal) {
            value += noise;
            noise = 0.95 * noise + std::sqrt(1 - 0.95 * 0.95) * deviation * random.normal();
        }
    } else if (kind == "band") {  // white noise through a filter of 20 kHz
        const double part = 1 - std::exp(-2 * std::numbers::pi * 20e3 * step);
        double one = 0, two = 0;
        for (int i = 0; i < 400; ++i) one += part * (random.normal() - one), two += part * (one - two);
        const double scale = deviation / std::sqrt(part / (2 - part)) * 1.4;
        for (double& value : signal) {
            one += part * (random.normal() - one);
            two += part * (one - two);
            value += scale * two;
        }
    } else if (kind == "slow") {
        const double low = 20, high = 0.4 / step;
        const int count = 200;
        for (int i = 0; i < count; ++i) {
            const double frequency = low * std::pow(high / low, (i + 0.5) / count);
            const double amplitude = deviation * std::sqrt(2.0 / count), phase = random.uniform(0, 6.2832);
            for (std::size_t k = 0; k < signal.size(); ++k)
                signal[k] +=
                    amplitude *
                    std::sin(2 * std::numbers::pi * frequency * step * static_cast<double>(k) + phase);
        }
    } else if (kind == "tone") {
        const double phase = random.uniform(0, 6.2832);
        for (std::size_t k = 0; k < signal.size(); ++k)
            signal[k] +=
                deviation * (0.5 * random.normal() +
                             std::sin(2 * std::numbers::pi * 2000 * step * static_cast<double>(k) + phase));
    }
}

}  // namespace drillwave

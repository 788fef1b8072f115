// SPDX-License-Identifier: GPL-3.0-or-later
// Records for the coverage of intervals: one rod, nine rocks, three noise levels (theory of identification
// §13.2), and what the intervals of many records say.
#pragma once

#include <map>

#include "tests/core/study/identify/scene_kinds.h"

namespace drillwave {

/// Bilinear rock (T4).
struct CoverageRock {
    double stiffness = 0;  ///< [N/m]
    double gamma = 0;
    double gap = 0;  ///< [m]
};

inline constexpr CoverageRock coverageRocks[] = {
    {60e6, 0.08, 0}, {60e6, 0.2, 0.1e-3},   {60e6, 0.4, 0.25e-3}, {130e6, 0.08, 1e-4}, {130e6, 0.2, 2.5e-4},
    {130e6, 0.4, 0}, {250e6, 0.08, 2.5e-4}, {250e6, 0.2, 0},      {250e6, 0.4, 1e-4}};
inline constexpr double coverageNoises[] = {0.005, 0.02, 0.05};  // deviation over the peak

/// A blow of 200 kN and 220 µs (sine squared) on a rod, with noise of a colour of addNoise().
inline GaugeScene coverageScene(const std::string& colour, const CoverageRock& rock, double noise,
                                std::uint64_t seed) {
    constexpr double peak = 200e3, length = 220e-6, step = 1e-6, before = 300e-6;
    const RodRig rig;
    const IncidentWave f = [](double t) {
        return t > 0 && t < length ? peak * std::pow(std::sin(std::numbers::pi * t / length), 2) : 0.0;
    };
    const double k = rock.stiffness;
    std::vector<double> record = rodRecord(
        rig, f, loadingRock([k](double u) { return k * u; }, k / rock.gamma), rock.gap, step, before, 1.4e-3);
    SceneRandom random(seed * 104729 + 3);
    addNoise(record, colour, noise * peak, step, random);
    GaugeScene scene;
    scene.kind = colour;
    scene.question.scenario = rodScenario(rig);
    GaugeRecord made;
    made.file = colour;
    for (std::size_t i = 0; i < record.size(); ++i) made.time.push_back(static_cast<double>(i) * step);
    made.gauges.push_back({"strain", rig.stated, std::move(record), {}});
    scene.question.records.push_back(std::move(made));
    scene.stiffness = k;
    scene.gamma = rock.gamma;
    scene.gap = rock.gap;
    return scene;
}

/// Half-width without the sizes that a simulated record holds exactly.
inline double halfWidthOfRecord(const IdentifiedParameter& parameter) {
    double sum = parameter.halfWidth * parameter.halfWidth;
    for (const BudgetRow& row : parameter.budget)
        for (const char* exact : {"diameter", "bore", "length", "place", "material", "gain", "timing"})
            if (row.source == exact) sum -= row.effect * row.effect;
    return std::sqrt(std::max(sum, parameter.noise * parameter.noise));
}

/// Errors of the intervals of k, γ and gap of many records.
struct CoverageTally {
    int intervals[3] = {0, 0, 0}, held[3] = {0, 0, 0};
    std::map<std::string, std::vector<double>> errors[3];  ///< in standard deviations, by rock and noise
    int records = 0, silent = 0;                           ///< refused or rejected

    void add(const GaugeScene& scene, const RecordAnswer& answer, const std::string& cell) {
        ++records;
        if (answer.refusal || answer.model == ModelVerdict::rejected) {
            ++silent;
            return;
        }
        const double truths[] = {scene.stiffness, scene.gamma, scene.gap};
        for (std::size_t i = 0; i < 3; ++i) {
            const IdentifiedParameter& parameter = answer.parameters[i];
            if (parameter.verdict != ParameterVerdict::identified &&
                parameter.verdict != ParameterVerdict::uncertain && i < 2)
                continue;
            if (parameter.verdict == ParameterVerdict::notSeen) continue;
            const double error = i == 2 ? parameter.value - truths[i] : std::log(parameter.value / truths[i]);
            const double width = halfWidthOfRecord(parameter);
            ++intervals[i];
            held[i] += std::abs(error) <= width ? 1 : 0;
            errors[i][cell].push_back(1.96 * error / width);
        }
    }
    /// Share of the intervals of parameter `i` that hold the truth.
    double share(std::size_t i) const { return intervals[i] ? double(held[i]) / intervals[i] : NAN; }
    /// Mean error of parameter `i` over all records [standard deviations].
    double bias(std::size_t i) const {
        double sum = 0;
        int count = 0;
        for (const auto& [cell, values] : errors[i])
            for (const double value : values) sum += value, ++count;
        return count ? sum / count : NAN;
    }
};

/// All rocks and noise levels in one colour of noise; each record has noise of its own, so that errors are
/// independent.
inline CoverageTally coverageOf(const std::string& colour, int seeds, std::uint64_t first = 1) {
    CoverageTally tally;
    constexpr std::uint64_t cells = std::size(coverageRocks) * std::size(coverageNoises);
    std::uint64_t number = 0;  // of the cell
    for (const CoverageRock& rock : coverageRocks)
        for (const double noise : coverageNoises) {
            for (int i = 0; i < seeds; ++i) {
                const GaugeScene scene = coverageScene(
                    colour, rock, noise, (first + static_cast<std::uint64_t>(i)) * cells + number);
                char cell[80];
                std::snprintf(cell, sizeof cell, "k %.0f MN/m gamma %.2f gap %.2f mm noise %.1f %%",
                              1e-6 * rock.stiffness, rock.gamma, 1e3 * rock.gap, 100 * noise);
                tally.add(scene, runIdentify(scene.question).records.front(), cell);
            }
            ++number;
        }
    return tally;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of records of identify_scenes: ordinary rigs, and troubles that people report.
#pragma once

#include <chrono>
#include <limits>

#include "tests/core/study/identify/gauge_scenes.h"

namespace drillwave {

inline std::vector<std::string> sceneKinds() {
    return {"rod",        "ar",           "band",      "slow",        "tone",           "piston",  "string",
            "string_one", "hum",          "ac",        "fast_ac",     "bending",        "pair",    "pair_off",
            "distance",   "speed",        "clock",     "worn_rod",    "worn_bit",       "bits",    "ringing",
            "jump",       "soft_gain",    "filter",    "slow_filter", "channel_filter", "dashpot", "power",
            "hardening",  "chipping",     "preloaded", "double_hit",  "bursts",         "growing", "delay",
            "late_loss",  "play",         "corner",    "stiff",       "soft",           "cut",     "clip",
            "low_rate",   "head_missing", "gain_jump"};
}

/// A rod scenario for the question of a rig.
inline Scenario rodScenario(const RodRig& rig) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensional;
    scenario.rod.length = rig.length;
    scenario.rod.diameter = rig.diameter;
    scenario.rod.bore = rig.bore;
    scenario.rod.youngsModulus = rig.modulus;
    scenario.rod.density = rig.density;
    return scenario;
}

/// A pulse of a hammer: rectangle with a rise, half sine, stepped piston, exponential, with an adapter's
/// tail.
inline IncidentWave pulseOf(SceneRandom& random, double force, bool withTail) {
    const int shape = random.below(4);
    const double rise = random.uniform(12e-6, 40e-6), length = random.uniform(130e-6, 260e-6);
    const double share = random.uniform(0.1, 0.3), second = random.uniform(0.4, 0.9) * length;
    const double ring = withTail ? random.uniform(0.005, 0.02) : 0, ringing = random.uniform(6e3, 15e3);
    return [=](double t) {
        if (t < 0) return 0.0;
        const auto ramp = [&](double at) {
            return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(at / rise, 0.0, 1.0));
        };
        double value = 0;
        if (shape == 0) value = ramp(t) - ramp(t - length);
        if (shape == 1) value = t < 1.3 * length ? std::sin(std::numbers::pi * t / (1.3 * length)) : 0;
        if (shape == 2) value = ramp(t) * (t < length ? 1 : 0) + (t >= length ? 1 - ramp(t - length) : 0);
        if (shape == 3) value = ramp(t) * std::exp(-t / (0.8 * length)) * (1 - ramp(t - 2 * length));
        if (shape == 2) {  // steps of a stepped piston behind it
            const double step = ramp(t - length) - ramp(t - length - second);
            value += share * step * 0.6;
        }
        if (ring > 0)
            value += ring * std::sin(2 * std::numbers::pi * ringing * t) * std::exp(-t / 150e-6) * ramp(t);
        return force * value;
    };
}

/// One rod record with its question; troubles change what is in between.
class RodSceneMaker {
  public:
    RodSceneMaker(const std::string& kind, std::uint64_t seed) : m_kind(kind), m_random(seed * 7919 + 17) {
        m_scene.kind = kind;
    }

    GaugeScene make() {
        SceneRandom& random = m_random;
        RodRig rig;
        const double sizes[][2] = {
            {0.039, 0.0145}, {0.032, 0.0}, {0.0455, 0.017}, {0.052, 0.021}, {0.025, 0.007}};
        const auto& size = sizes[random.below(5)];
        rig.diameter = size[0];
        rig.bore = size[1];
        rig.ahead = rig.stated = random.uniform(1.7, 2.6);
        rig.length = rig.ahead + random.uniform(1.6, 2.6);
        const double z = rig.impedance(), force = z * random.uniform(3.5, 5.5);
        const double beta = random.logUniform(0.35, 2.2);
        double k = beta * z / 200e-6, gamma = random.uniform(0.07, 0.35),
               gap = random.chance(0.5) ? 0 : random.uniform(2e-5, 4e-4);
        double step = random.chance(0.3) ? 0.5e-6 : random.chance(0.5) ? 1e-6 : 2e-6;
        if (is("low_rate")) step = random.uniform(4e-6, 8e-6);
        if (is("stiff")) k = random.uniform(5, 60) * z / 200e-6;
        if (is("soft")) k = random.uniform(0.05, 0.25) * z / 200e-6;
        IncidentWave f = pulseOf(random, force, is("piston"));
        if (is("double_hit")) {
            const double later = random.uniform(180e-6, 330e-6), share = random.uniform(0.15, 0.5);
            const IncidentWave first = f;
            f = [=](double t) { return first(t) + share * first(t - later); };
        }
        double trip = 2 * rig.ahead / rig.speed();
        double end = trip + std::min(700e-6, 2 * (rig.length - rig.ahead) / rig.speed());
        if (is("cut")) end = trip + random.uniform(80e-6, 200e-6);
        m_scene.question.scenario = rodScenario(rig);
        // what the file does not know
        if (is("distance")) rig.stated = rig.ahead * random.uniform(0.93, 1.08);
        if (is("speed")) rig.modulus *= 1 + (random.chance(0.5) ? 1 : -1) * random.uniform(0.02, 0.05);
        if (is("worn_rod")) {
            rig.diameter -= random.uniform(0.2e-3, 0.9e-3);
            m_scene.question.known.push_back({"rod.diameter", 1e-3});
        }
        double elastic = k / gamma;
        SteppedRock rock = loadingRock([k](double u) { return k * u; }, elastic);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        double truthK = k, truthGamma = gamma, truthGap = gap;
        const double peakPenetration = force / k;
        if (is("corner")) {
            const double corner = random.uniform(0.3, 0.9) * force, slope = random.uniform(0.25, 0.6);
            k *= 1.6;
            truthK = k;
            elastic = k / gamma;
            rock = loadingRock(
                [k, corner, slope](double u) {
                    return k * u < corner ? k * u : corner + slope * (k * u - corner);
                },
                elastic);
        }
        if (is("power")) {
            const double p = random.uniform(1.15, 1.6), u1 = 0.6 * peakPenetration;
            rock = loadingRock([k, p, u1](double u) { return u > 0 ? k * u1 * std::pow(u / u1, p) : 0.0; },
                               1.6 * elastic);
            truthK = truthGamma = nan;
        }
        if (is("hardening")) {
            const double a = random.uniform(0.25, 0.45) * force, b = random.uniform(0.7, 1.1) * force;
            rock = loadingRock(
                [k, a, b](double u) {
                    const double first = 1.5 * k * u;
                    if (first < a) return first;
                    const double second = a + 0.15 * (first - a);
                    return second < b ? second : b + 1.2 * ((first - a) - (b - a) / 0.15);
                },
                elastic);
            truthK = 1.5 * k;
            truthGamma = 1.5 * gamma;
        }
        if (is("dashpot"))
            rock = loadingRock([k](double u) { return k * u; }, elastic, z * random.uniform(0.02, 0.15));
        if (is("chipping")) {
            const double at = random.uniform(0.3, 0.7) * peakPenetration, drop = random.uniform(0.2, 0.5);
            rock = [k, elastic, at, drop, largest = 0.0, deepest = 0.0, fallen = false](double u, double,
                                                                                        double) mutable {
                if (u > deepest) {
                    deepest = u;
                    if (!fallen && u > at) fallen = true;
                    largest = fallen ? k * (u - drop * at) : k * u;
                }
                return std::max(0.0, largest - elastic * (deepest - u));
            };
        }
        if (is("preloaded")) {
            const double before = random.uniform(0.1, 0.4) * force;
            const double deep = before / k;
            gap = 0;
            truthGap = nan;
            rock = loadingRock(
                [=](double u) {
                    const double d = u + deep - before * gamma / k * 1.0;
                    return d < deep ? before - elastic * (deep - d) : k * d;
                },
                elastic);
            truthGamma = gamma;
        }
        std::vector<double> record = rodRecord(rig, f, rock, gap, step, before(), end);
        double peak = 0;
        for (const double value : record) peak = std::max(peak, std::abs(value));
        distort(rig, record, step, peak, f);
        const double noise = random.uniform(0.002, 0.015) * peak;
        const std::string colour = is("ar") || is("band") || is("slow") || is("tone") ? m_kind : "white";
        std::vector<double> opposite;
        if (is("pair") || is("pair_off")) {
            const double frequency = random.logUniform(600, 6000),
                         amplitude = random.uniform(0.03, 0.1) * peak;
            const double phase = random.uniform(0, 6.28),
                         stays = is("pair_off") ? random.uniform(-0.08, 0.08) : 0;
            for (std::size_t i = 0; i < record.size(); ++i) {
                const double t = static_cast<double>(i) * step - before();
                const double bend = t > 0
                                        ? amplitude * std::sin(2 * std::numbers::pi * frequency * t + phase) *
                                              std::min(1.0, t / 50e-6)
                                        : 0;
                record[i] += stays * bend;
                opposite.push_back(bend + noise * 0.7 * random.normal());
            }
        }
        addNoise(record, colour, noise, step, random);
        if (is("bursts")) {
            const double from = random.uniform(0.2, 0.8) * end, to = from + random.uniform(100e-6, 300e-6);
            for (std::size_t i = 0; i < record.size(); ++i) {
                const double t = static_cast<double>(i) * step - before();
                if (t > from && t < to) record[i] += 0.05 * peak * random.normal();
            }
        }
        digitise(record, step, peak);
        finish(rig, record, opposite, step);
        m_scene.stiffness = truthK;
        if (is("speed")) m_scene.stiffness = truthK;
        m_scene.gamma = truthGamma;
        m_scene.gap = truthGap;
        m_scene.mustIdentify = is("rod") || is("piston");
        m_scene.mustRefuse = is("clip");
        return m_scene;
    }

  private:
    bool is(const char* kind) const { return m_kind == kind; }
    double before() const { return is("low_rate") ? 700e-6 : 200e-6; }

    void distort(const RodRig& rig, std::vector<double>& record, double step, double peak,
                 const IncidentWave&) {
        SceneRandom& random = m_random;
        const auto each = [&](auto change) {
            for (std::size_t i = 0; i < record.size(); ++i)
                change(record[i], static_cast<double>(i) * step - before());
        };
        const double pi = std::numbers::pi;
        if (is("hum")) {
            const double amplitude = random.uniform(0.01, 0.08) * peak, phase = random.uniform(0, 6.28);
            each([&](double& v, double t) { v += amplitude * std::sin(2 * pi * 50 * t + phase); });
        }
        if (is("ac") || is("fast_ac")) {
            const double tau = is("ac") ? random.uniform(3.5e-3, 15e-3) : random.uniform(0.4e-3, 2.5e-3);
            double low = 0;
            each([&](double& v, double) {
                low += step / tau * (v - low);
                v -= low;
            });
        }
        if (is("bending") || is("growing")) {
            const double frequency = random.logUniform(400, 6000),
                         amplitude = random.uniform(0.02, 0.07) * peak;
            const double phase = random.uniform(0, 6.28),
                         grow = is("growing") ? random.uniform(200e-6, 600e-6) : 50e-6;
            each([&](double& v, double t) {
                const double share = std::min(is("growing") ? 2.0 : 1.0, t / grow);
                if (t > 0) v += amplitude * share * std::sin(2 * pi * frequency * t + phase);
            });
        }
        if (is("ringing")) {
            const double frequency = random.logUniform(700, 4000),
                         amplitude = random.uniform(0.02, 0.06) * peak;
            const double phase = random.uniform(0, 6.28);
            each([&](double& v, double t) {
                v += amplitude * std::sin(2 * pi * frequency * t + phase) * std::exp(-(t + before()) / 3e-3);
            });
        }
        const double trip = 2 * rig.ahead / rig.speed();
        if (is("jump")) {
            const double at = random.uniform(0.05, 1.5) * trip, size = random.uniform(-0.05, 0.05) * peak;
            each([&](double& v, double t) {
                if (t > at) v += size;
            });
        }
        if (is("soft_gain")) {
            const double soft = random.uniform(0.03, 0.15);
            each([&](double& v, double) { v *= 1 - soft * std::pow(v / peak, 2); });
        }
        if (is("gain_jump")) {
            const double at = random.uniform(0.3, 1.2) * trip, change = 1 - random.uniform(0.03, 0.15);
            each([&](double& v, double t) {
                if (t > at) v *= change;
            });
        }
        if (is("filter") || is("slow_filter")) {
            const double corner = is("filter") ? random.uniform(10e3, 40e3) : random.uniform(2e3, 8e3);
            const double part = 1 - std::exp(-2 * pi * corner * step);
            double one = 0, two = 0;
            each([&](double& v, double) {
                one += part * (v - one);
                two += part * (one - two);
                v = two;
            });
        }
    }

    void digitise(std::vector<double>& record, double, double peak) {
        if (is("bits")) {
            const double q = 2.4 * peak / std::exp2(m_random.uniform(7.5, 10.5));
            const double offset = m_random.uniform(0, 1);
            for (double& value : record) value = q * (std::floor(value / q + offset));
        }
        if (is("clip")) {
            const double limit = m_random.uniform(0.85, 0.98) * peak;
            for (double& value : record) value = std::clamp(value, -limit, limit);
        }
    }

    void finish(const RodRig& rig, std::vector<double>& record, std::vector<double>& opposite, double step) {
        GaugeRecord made;
        made.file = m_kind;
        double clock = 1;
        if (is("clock")) clock = 1 + (m_random.chance(0.5) ? 1 : -1) * m_random.uniform(0.01, 0.02);
        for (std::size_t i = 0; i < record.size(); ++i)
            made.time.push_back((static_cast<double>(i) * step - before()) * clock);
        // a recorder keeps a few digits
        const double digit =
            is("bits") ? 0 : 1e-5 * std::abs(*std::max_element(record.begin(), record.end()));
        if (digit > 0)
            for (double& value : record) value = digit * std::round(value / digit);
        // strain gauges: the file's area makes forces of strains, the truth another one
        const RodRig file = [&] {
            RodRig of;
            of.diameter = m_scene.question.scenario.rod.diameter;
            of.bore = m_scene.question.scenario.rod.bore;
            of.modulus = m_scene.question.scenario.rod.youngsModulus;
            return of;
        }();
        const double scale = file.area() * file.modulus / (rig.area() * rig.modulus);
        for (double& value : record) value *= -scale;
        for (double& value : opposite) value *= -scale;
        made.gauges.push_back({"strain", rig.stated, std::move(record), std::move(opposite)});
        m_scene.question.records.push_back(std::move(made));
    }

    std::string m_kind;
    SceneRandom m_random;
    GaugeScene m_scene;
};

/// A string with a hammer, one gauge or two on its last rod.
inline GaugeScene stringScene(const std::string& kind, std::uint64_t seed) {
    SceneRandom random(seed * 6007 + 5);
    GaugeScene scene;
    scene.kind = kind;
    Scenario scenario;
    scenario.form = ScenarioForm::string;
    DrillString& chain = scenario.drillString;
    const double rods[][2] = {{0.039, 0.0145}, {0.0455, 0.017}, {0.052, 0.021}};
    const auto& size = rods[random.below(3)];
    const double rodLength = random.chance(0.5) ? 3.66 : 3.05, coupling = size[0] * 1.4;
    const auto add = [&](const char* name, double length, double diameter, double bore) {
        Section section;
        section.name = name;
        section.length = length;
        section.diameter = diameter;
        section.bore = bore;
        chain.parts.push_back({1, false, {section}});
    };
    chain.hammer.velocity = random.uniform(8, 11);
    const auto addHammer = [&](double length, double diameter) {
        Section section;
        section.length = length;
        section.diameter = diameter;
        chain.hammer.sections.push_back(section);
    };
    if (random.chance(0.6)) addHammer(random.uniform(0.2, 0.35), size[0] * random.uniform(1, 1.25));
    addHammer(random.uniform(0.2, 0.35), size[0] * random.uniform(0.92, 1.05));
    add("adapter", random.uniform(0.4, 0.55), size[0] * 1.15, size[1] * 0.9);
    add("coupling", 0.19, coupling, size[1]);
    add("rod", rodLength, size[0], size[1]);
    if (random.chance(0.5)) {
        add("coupling", 0.19, coupling, size[1]);
        add("rod", rodLength, size[0], size[1]);
    }
    add("bit skirt", random.uniform(0.05, 0.09), coupling, size[1]);
    add("bit head", random.uniform(0.045, 0.07), size[0] * random.uniform(1.7, 2.1), 0);
    const double z = propertiesOf(chain.parts[2].sections[0], chain.material).impedance;
    scenario.bitRock.stiffness = random.logUniform(0.35, 2.2) * z / 200e-6;
    scenario.bitRock.gamma = random.uniform(0.07, 0.35);
    scenario.bitRock.gap = random.chance(0.5) ? 0 : random.uniform(2e-5, 3e-4);
    const double head =
        chain.parts.back().sections[0].length + chain.parts[chain.parts.size() - 2].sections[0].length;
    const double step = random.chance(0.5) ? 1e-6 : 2e-6;
    Scenario truth = scenario;
    const auto section = [&](std::size_t fromEnd) -> Section& {
        return truth.drillString.parts[truth.drillString.parts.size() - fromEnd].sections[0];
    };
    if (kind == "worn_bit") {
        section(1).length -= random.uniform(0.004, 0.015);
        section(1).diameter -= random.uniform(0, 0.003);
    }
    if (kind == "late_loss") section(3).loss = random.uniform(0.02, 0.1);
    if (kind == "play") section(3).massAfter = random.uniform(0.2, 1.0);
    std::vector<double> distances{head + random.uniform(0.7, 1.2)};
    if (kind == "string_one")
        distances = {head + rodLength * random.uniform(0.62, 0.7)};
    else
        distances.push_back(distances[0] + random.uniform(1.0, 1.6));
    double arrival = 0;
    auto records =
        stringRecords(truth, distances, step, 220e-6, kind == "string_one" ? 2e-3 : 1.6e-3, arrival);
    double peak = 0;
    for (const double value : records[0]) peak = std::max(peak, std::abs(value));
    const double noise = random.uniform(0.002, 0.01) * peak;
    if (kind == "delay") {
        const auto shift = static_cast<std::size_t>(random.uniform(1, 5e-6 / step + 1.5));
        records[1].erase(records[1].begin(), records[1].begin() + static_cast<std::ptrdiff_t>(shift));
        records[1].resize(records[0].size(), records[1].back());
    }
    if (kind == "channel_filter") {
        const double part = 1 - std::exp(-2 * std::numbers::pi * random.uniform(8e3, 30e3) * step);
        double low = 0;
        for (double& value : records[1]) value = low += part * (value - low);
    }
    for (std::vector<double>& record : records) addNoise(record, "white", noise, step, random);
    scene.question.scenario = scenario;
    if (kind == "head_missing") scene.question.scenario.drillString.parts.pop_back();
    GaugeRecord made;
    made.file = kind;
    for (std::size_t i = 0; i < records[0].size(); ++i) made.time.push_back(static_cast<double>(i) * step);
    const double less = kind == "head_missing" ? chain.parts.back().sections[0].length : 0;
    for (std::size_t g = 0; g < records.size(); ++g) {
        for (double& value : records[g]) value *= -1;
        made.gauges.push_back({g ? "far" : "near", distances[g] - less, records[g], {}});
    }
    scene.question.records.push_back(std::move(made));
    scene.stiffness = truth.bitRock.stiffness;
    scene.gamma = truth.bitRock.gamma;
    scene.gap = truth.bitRock.gap;
    scene.mustIdentify = kind == "string";
    return scene;
}

inline GaugeScene sceneOf(const std::string& kind, std::uint64_t seed) {
    for (const char* ofString :
         {"string", "string_one", "worn_bit", "late_loss", "play", "delay", "channel_filter", "head_missing"})
        if (kind == ofString) return stringScene(kind, seed);
    return RodSceneMaker(kind, seed).make();
}

}  // namespace drillwave

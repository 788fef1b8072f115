// SPDX-License-Identifier: GPL-3.0-or-later
// Drill strings for tests of their solver: reference cases and random ones.
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/wave/network/network_solver.h"
#include "tests/support/scene.h"

namespace drillwave::test {

/// Units of a dimensionless problem, in SI.
struct NetworkUnits {
    double impedance = 1;  ///< Zr [kg/s]
    double time = 1;       ///< t0 [s]
    double velocity = 1;   ///< F0/Zr, half the impact velocity [m/s]

    double force() const { return impedance * velocity; }
    double momentum() const { return force() * time; }
    double energy() const { return momentum() * velocity; }
    double length() const { return velocity * time; }
};

/// Returns a problem with a hammer of one section that strikes a string; the caller adds the sections.
inline Problem struck() {
    Problem problem;
    problem.drive = ElasticHammer{};
    problem.sections.clear();
    return problem;
}

inline ElasticHammer& hammerOf(Problem& problem) {
    return std::get<ElasticHammer>(problem.drive);
}

/// Reference case from tests/cases/string_cases.json.
struct NetworkCase {
    std::string id;
    Problem problem = struck();
    NetworkUnits units;
    std::vector<double> areas;  ///< cross-sections of hammer and string [m²]
    QJsonObject reference;
};

inline NetworkCase networkCase(const QJsonObject& json) {
    NetworkCase scene;
    scene.id = json["id"].toString().toStdString();
    Problem& problem = scene.problem;
    NetworkUnits& units = scene.units;
    units.velocity = json["velocity"].toDouble() / hammerOf(problem).velocity;
    const QJsonArray hammer = json["piston"].toArray(), string = json["string"].toArray();
    hammerOf(problem).sections = std::size_t(hammer.size());
    const auto add = [&](const QJsonValue& value) {
        const double modulus = value["youngs_modulus"].toDouble(), density = value["density"].toDouble();
        UniformSection section;
        section.impedance = value["area"].toDouble() * std::sqrt(modulus * density);
        section.transitTime = value["length"].toDouble() / std::sqrt(modulus / density);
        section.decay = value["attenuation"].toDouble() * value["length"].toDouble();
        problem.sections.push_back(section);
        scene.areas.push_back(value["area"].toDouble());
    };
    for (const QJsonValue value : hammer) add(value);
    for (const QJsonValue value : string) add(value);
    for (const QJsonValue value : json["joints"].toArray()) {
        UniformSection& near =
            problem.sections[problem.hammerSections() + std::size_t(value["after"].toInt())];
        near.massAfter = value["mass"].toDouble();
        near.loss = value["loss"].toDouble();
    }
    problem.sections.back().massAfter = json["bit_mass"].toDouble();
    units.time = 0;
    for (std::size_t j = 0; j < problem.hammerSections(); ++j)
        units.time += 2 * problem.sections[j].transitTime;
    units.impedance = problem.sections.back().impedance;
    for (UniformSection& section : problem.sections) {
        section.impedance /= units.impedance;
        section.transitTime /= units.time;
        section.massAfter /= units.impedance * units.time;
    }
    const double scale = units.time / units.impedance;
    const QJsonObject contact = json["contact"].toObject(), rock = json["rock"].toObject();
    if (contact["stiffness"].toDouble() > 0)
        hammerOf(problem).face.stiffness = contact["stiffness"].toDouble() * scale;
    hammerOf(problem).face.restrike = contact["restrike"].toBool();
    problem.law = {rock["stiffness"].toDouble() * scale, rock["gamma"].toDouble()};
    problem.gap = rock["gap"].toDouble() / (2 * units.length());
    problem.endTime = json["end_time"].toDouble() / units.time;
    scene.reference = json["reference"].toObject();
    return scene;
}

inline std::vector<NetworkCase> networkCases() {
    QFile file(DRILLWAVE_SOURCE_DIR "/tests/cases/string_cases.json");
    std::vector<NetworkCase> cases;
    if (!file.open(QIODevice::ReadOnly)) return cases;
    for (const QJsonValue value : QJsonDocument::fromJson(file.readAll())["cases"].toArray())
        cases.push_back(networkCase(value.toObject()));
    return cases;
}

/// Returns a random problem with one to three sections of hammer and up to seven of string. Round trips are
/// multiples of 0.05 t0, and optional features occur at random.
inline Problem randomNetwork(Chance& chance) {
    Problem problem = struck();
    const double cell = 0.05;
    hammerOf(problem).sections = 1 + chance.below(3);
    const std::size_t count = problem.hammerSections() + 1 + chance.below(7);
    for (std::size_t j = 0; j < count; ++j) {
        UniformSection section;
        section.impedance = chance.below(4) == 0 ? 1 : chance.logarithmic(0.3, 4);
        const bool hammer = j < problem.hammerSections();
        section.transitTime = cell / 2 * (1 + chance.below(hammer ? 10 : 60));
        if (chance.below(8) == 0) section.massAfter = chance.logarithmic(1e-3, 0.5);
        if (!hammer && chance.below(10) == 0) section.loss = 0.1 * chance.fraction();
        if (!hammer && chance.below(10) == 0) section.decay = 0.1 * chance.fraction();
        problem.sections.push_back(section);
    }
    if (chance.below(5) == 0) hammerOf(problem).face.stiffness = chance.logarithmic(1, 100);
    hammerOf(problem).face.restrike = chance.below(4) != 0;
    problem.law = {chance.logarithmic(0.01, 30), chance.below(5) == 0 ? 1 : chance.logarithmic(0.05, 1)};
    if (chance.below(3) == 0) problem.gap = chance.fraction();
    problem.endTime = 10 + 30 * chance.fraction();
    return problem;
}

/// Returns the case with this id.
inline const NetworkCase& caseCalled(const std::string& id) {
    static const std::vector<NetworkCase> cases = networkCases();
    return *std::find_if(cases.begin(), cases.end(), [&](const NetworkCase& each) { return each.id == id; });
}

/// Returns a uniform rod with these groups as a drill string. A hammer of the same impedance, half the pulse
/// long, strikes it once, which acts like a rectangular pulse. The motion is computed until `endTime`.
inline Problem rodAsString(const Groups& groups, double endTime) {
    Problem problem = struck();
    problem.sections = {{.impedance = 1, .transitTime = 0.5}, {.impedance = 1, .transitTime = groups.tau}};
    hammerOf(problem).face.restrike = false;
    problem.law = {groups.beta, groups.gamma};
    problem.gap = groups.delta;
    problem.endTime = endTime;
    return problem;
}

inline Impact solvedWithWaves(const Problem& problem) {
    NetworkSettings settings;
    settings.wants = {.events = true, .forces = true, .histories = true};
    return solveNetwork(problem, settings);
}

}  // namespace drillwave::test

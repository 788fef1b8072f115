// SPDX-License-Identifier: GPL-3.0-or-later
// Conditions that must hold for every scenario file that can be read, and a set of texts to start from.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"

namespace drillwave::test {

/// Returns the texts of all built-in examples, and texts with features that no example has.
inline std::vector<std::string> corpusOfTexts() {
    std::vector<std::string> corpus;
    for (const Example& example : builtInExamples()) corpus.emplace_back(example.text);
    corpus.push_back(
        "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10}\npulse:\n  shape: table\n"
        "  points:\n  - [0, 0]\n  - [0.5, 1]\n  - [1, 0]\n");
    corpus.push_back(
        "drillwave: 1\nrod: {length: 1 m, area: 10 cm^2, youngs_modulus: 30e6 psi, density: 7.8 g/cm^3}\n"
        "pulse: {shape: trapezoid, duration: 0.1 ms, force: 200 kN, rise: 0.1}\n"
        "bit_rock: {stiffness: \"1 GN/m\", gamma: 1}\n");
    corpus.push_back(
        "drillwave: 2\nend_time: 9 ms\nhammer:\n  sections:\n  - length: 300 mm  # rear\n    area: 20 cm^2\n"
        "  velocity: 9 m/s\n  restrike: false\nstring:\n- repeat: 2\n  of:\n  - name: \"a, b\"\n"
        "    length: 1 ft\n    diameter: 2 in\n    loss: 0.02\n- {length: 1 m, diameter: 3 cm, attenuation: "
        "1 1/km}\n"
        "bit_rock: {stiffness: 1 GN/m, gamma: 1}\n");
    corpus.push_back(
        "\xEF\xBB\xBF{drillwave: 1, dimensionless: {beta: 1, gamma: 1, tau: 1}, pulse: {shape: piston, "
        "impedance_ratio: 3}}\r\n");
    return corpus;
}

/// Returns true if a text can be read as a scenario. Then checks all conditions that must hold for it; throws
/// std::logic_error if one does not.
inline bool readAndSaved(const std::string& text) {
    ScenarioDocument document;
    try {
        document = parseScenario(text, "");
    } catch (const ScenarioError& error) {
        if (error.problems().empty()) throw std::logic_error("refused without a reason");
        return false;
    }
    if (!validate(document.scenario).empty()) throw std::logic_error("an invalid scenario was read");
    if (writeScenario(document) != text) throw std::logic_error("an unchanged text was not kept");
    const Groups groups = groupsOf(document.scenario);
    if (!(groups.beta > 0 && groups.tau > 0)) throw std::logic_error("the groups are no groups");
    const PulseForce force = pulseForceOf(document.scenario);
    if (!force.isRigidBody() && force.impulseUntil(force.end) != 1)
        throw std::logic_error("the impulse is not 1");
    // The scenario must be the same after writing it completely, and after changing the text in part.
    if (parseScenario(scenarioText(document.scenario), "").scenario != document.scenario)
        throw std::logic_error("written anew it is another scenario");
    double& gamma =
        hasUnits(document.scenario) ? document.scenario.bitRock.gamma : document.scenario.groups.gamma;
    const double before = gamma;
    gamma = 0.375;
    // Invalid if a corner of the law is steeper than 1/γ.
    if (!validate(document.scenario).empty()) gamma = before;
    document.scenario.title = "changed: yes";
    if (parseScenario(writeScenario(document), "").scenario != document.scenario)
        throw std::logic_error("patched it is another scenario");
    return true;
}

}  // namespace drillwave::test

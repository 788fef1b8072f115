// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of random scenarios: rods and drill strings like those used in practice.
#pragma once

#include <cmath>
#include <string>

#include "core/text/units.h"
#include "tests/support/scene.h"

namespace drillwave::test {

inline std::string number(double value) {
    return formatNumber(value);
}

/// Returns a random length from `low` to `high` [mm], rounded to 10 mm, as text with its unit.
inline std::string length(Chance& chance, double low, double high) {
    return number(10 * std::round((low + (high - low) * chance.fraction()) / 10)) + " mm";
}

inline std::string pulseText(Chance& chance) {
    const std::string size = ", duration: " + number(80 + 300 * chance.fraction()) +
                             " us, impulse: " + number(20 + 60 * chance.fraction()) + " N s}\n";
    switch (chance.below(4)) {
        case 0:
            return "pulse: {shape: rectangular" + size;
        case 1:
            return "pulse: {shape: half_sine" + size;
        case 2:
            return "pulse: {shape: triangular" + size;
        default: {
            std::string points;
            double time = 0;
            for (int i = 0; i < 5; ++i, time += 40 + 40 * chance.fraction())
                points += "[" + number(time) + " us, " +
                          number(i % 4 == 0 ? 0 : 50 + 200 * chance.fraction()) + " kN]" +
                          (i < 4 ? ", " : "");
            return "pulse: {shape: table, points: [" + points + "]}\n";
        }
    }
}

/// Returns the text of one section; at random it is conical, or has a loss, an attenuation or a mass.
inline std::string section(Chance& chance, const std::string& length, double diameter, bool mayLose) {
    std::string text = "{length: " + length + ", diameter: " + number(diameter) + " mm";
    if (chance.oneIn(4))
        text += ", end_diameter: " + number(diameter * (0.7 + 0.6 * chance.fraction())) + " mm";
    if (mayLose && chance.oneIn(3)) text += ", loss: " + number(5 * chance.fraction()) + " %";
    if (mayLose && chance.oneIn(5)) text += ", attenuation: " + number(0.003 * chance.fraction()) + " 1/m";
    if (mayLose && chance.oneIn(6)) text += ", mass_after: " + number(chance.fraction()) + " kg";
    return text + "}";
}

inline std::string stringText(Chance& chance) {
    std::string text;
    const double diameter = 32 + 16 * chance.fraction();
    if (chance.oneIn(3)) {
        text = pulseText(chance);
    } else {
        text = "hammer:\n  velocity: " + number(7 + 5 * chance.fraction()) + " m/s\n";
        if (chance.oneIn(4)) text += "  face_stiffness: " + number(chance.logarithmic(3, 50)) + " GN/m\n";
        if (chance.oneIn(2)) text += "  restrike: false\n";
        text += "  sections:\n";
        for (unsigned i = 0; i <= chance.below(2); ++i)
            text +=
                "    - " +
                section(chance, length(chance, 100, 400), diameter * (1 + 0.5 * chance.fraction()), false) +
                "\n";
    }
    text += "string:\n  - " + section(chance, length(chance, 300, 600), 1.2 * diameter, true) + "\n";
    for (unsigned i = 0; i <= chance.below(2); ++i)
        text += "  - {length: " + length(chance, 100, 250) + ", diameter: " + number(1.4 * diameter) +
                " mm}\n  - " + section(chance, length(chance, 400, 1000), diameter, true) + "\n";
    return text + "  - " + section(chance, length(chance, 50, 200), 1.8 * diameter, false) + "\n";
}

inline std::string randomScenarioText(Chance& chance) {
    std::string text;
    if (chance.oneIn(2))
        text = "drillwave: 2\n" + stringText(chance);
    else
        text = "drillwave: 1\n" + pulseText(chance) + "rod: {length: " + number(2 + 6 * chance.fraction()) +
               " m, diameter: " + number(30 + 20 * chance.fraction()) +
               " mm, youngs_modulus: 210 GPa, density: 7850 kg/m^3}\n";
    text += "bit_rock: {stiffness: " + number(chance.logarithmic(40, 800)) +
            " MN/m, gamma: " + number(chance.oneIn(5) ? 1 : chance.logarithmic(0.05, 0.8)) +
            ", gap: " + number(chance.oneIn(2) ? 0 : chance.fraction()) + " mm}\n";
    return text + "drill: {blow_frequency: " + number(20 + 40 * chance.fraction()) + " Hz, thrust: 12 kN}\n";
}

}  // namespace drillwave::test

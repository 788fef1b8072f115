// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of scenario files as a user would write them.
#pragma once

#include <QFile>
#include <QTest>
#include <stdexcept>
#include <string>

#include "core/yaml/scenario_file.h"

namespace drillwave::test {

inline constexpr const char* t38 = R"(drillwave: 1                      # format number, first key, required
title: T38 rod, medium rock       # optional
rod:
  length: 3.66 m
  diameter: 38 mm                 # or  area: 1134 mm^2
  bore: 14.5 mm                   # optional flushing hole, default 0
  youngs_modulus: 210 GPa
  density: 7850 kg/m^3
pulse:
  shape: rectangular
  duration: 200 us                # t0
  impulse: 51 N s                 # I0
bit_rock:
  stiffness: 105 MN/m             # k, primary loading
  gamma: 0.1
  gap: 0 mm                       # d
drill:                            # optional
  blow_frequency: 60 Hz
  thrust: 8 kN                    # installed feed force
)";

/// Text with the same values as the program writes it; some optional keys are left out.
inline constexpr const char* plainT38 = R"(drillwave: 1
title: T38
rod:
  length: 3.66 m
  diameter: 38 mm
  bore: 14.5 mm
  youngs_modulus: 210 GPa
  density: 7850 kg/m^3
pulse:
  shape: rectangular
  duration: 200 us
  impulse: 51 N s
bit_rock:
  stiffness: 105 MN/m
  gamma: 0.1
  gap: 0 mm
drill:
  thrust: 8 kN
)";

inline constexpr const char* figure4b = R"(drillwave: 1
title: Fig. 4 (b) of the paper
dimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}
pulse: {shape: rectangular}
)";

inline ScenarioDocument parsed(const std::string& text) {
    return parseScenario(text, "test.yaml");
}

/// Compares two texts as QString, so that a failed test shows the difference.
inline void compareText(const std::string& text, const std::string& expected) {
    if (text != expected) qInfo("%s", text.c_str());
    QCOMPARE(QString::fromStdString(text), QString::fromStdString(expected));
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the test text does not hold " + from);
    return text.replace(at, from.size(), to);
}

inline void writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

inline std::string rodWithPulse(const std::string& pulse) {
    const std::string text(t38);
    const std::size_t from = text.find("pulse:");
    return text.substr(0, from) + pulse + text.substr(text.find("bit_rock:"));
}

}  // namespace drillwave::test

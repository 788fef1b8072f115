// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of parsed YAML to a scenario, with all errors and their positions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/design_setup.h"
#include "core/model/scenario.h"
#include "core/model/validation.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {

/// Format numbers of scenario files: `rodFormat` for a uniform rod, `stringFormat` for a hammer and a drill
/// string.
inline constexpr int rodFormat = 1;
inline constexpr int stringFormat = 2;
/// Newest format number of scenario files that this program reads.
inline constexpr int newestFormat = stringFormat;

/// Largest size of a scenario file in bytes.
inline constexpr std::size_t maximumScenarioBytes = std::size_t{1} << 20;

/// Scenario that was read, valid if there are no errors, and the settings of its design study.
struct ReadScenario {
    Scenario scenario;
    DesignSetup design;
    std::vector<InputProblem> problems;
    bool unreadable = false;  ///< whether the text, or a file that it names, cannot be read
};

/// Reads and validates a scenario. `source` is the name of the text in messages. The path of a table file is
/// relative to that of `source`. If `tablePoints` is given, these points are used and the table file is not
/// opened.
ReadScenario readScenario(std::string_view text, const std::string& source,
                          const TablePoints* tablePoints = nullptr);

}  // namespace drillwave

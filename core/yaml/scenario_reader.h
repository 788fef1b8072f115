// SPDX-License-Identifier: GPL-3.0-or-later
// From the tree of a YAML text to a scenario, with every problem and its place.
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

/// Format number of a file of a uniform rod, and of a hammer and a string.
inline constexpr int rodFormat = 1;
inline constexpr int stringFormat = 2;
/// The newest format number that this program reads.
inline constexpr int newestFormat = stringFormat;

/// Most bytes of a scenario file.
inline constexpr std::size_t maximumScenarioBytes = std::size_t{1} << 20;

/// A scenario, valid if there are no problems, and the set-up of its design study.
struct ReadScenario {
    Scenario scenario;
    DesignSetup design;
    std::vector<InputProblem> problems;
    bool unreadable = false;  ///< what is wrong is that the text, or a file it names, cannot be read
};

/// Reads and validates. `source` names the text, and a table file is looked for beside it; with `tablePoints`
/// given these are taken for the content of that file, which is then not opened.
ReadScenario readScenario(std::string_view text, const std::string& source,
                          const TablePoints* tablePoints = nullptr);

}  // namespace drillwave

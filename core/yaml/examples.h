// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios of resources/examples, which are built into the program.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace drillwave {

/// Scenario file that is built into the program.
struct Example {
    std::string name;         ///< file name without ".yaml", e.g. "paper_fig4a"
    std::string title;        ///< title of the scenario
    std::string explanation;  ///< first comment of the file as one paragraph, which says what to look at
    std::string_view text;    ///< contents of the file, byte for byte
    /// Whether the example has a hammer and a drill string of sections instead of a uniform rod.
    bool ofString = false;
};

/// Returns all examples: first the figures of the paper, then the drilling cases, drill strings last.
std::span<const Example> builtInExamples();

/// Returns the example with this name, such as "paper_fig4a", or nullptr.
const Example* findExample(std::string_view name);

/// Returns the example with which the window opens: a T38 rod in medium rock.
const Example& defaultExample();

}  // namespace drillwave

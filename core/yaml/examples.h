// SPDX-License-Identifier: GPL-3.0-or-later
// The scenarios of resources/examples, built into the program.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace drillwave {

/// Built-in scenario file.
struct Example {
    std::string name;         ///< file name without ".yaml", e.g. "paper_fig4a"
    std::string title;        ///< the scenario's title
    std::string explanation;  ///< its first comment as one paragraph: what to look at
    std::string_view text;    ///< the file, byte for byte
    bool ofString = false;    ///< a hammer and a string of sections, no uniform rod
};

/// Returns all examples: the paper's figures first, then the drilling cases, drill strings last.
std::span<const Example> builtInExamples();

/// The example of that name, or nullptr.
const Example* findExample(std::string_view name);

/// The case that the window opens with: a T38 rod in medium rock.
const Example& defaultExample();

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Command line of the program when it opens the window instead of running a command.
#pragma once

#include <span>
#include <string>

#include "core/text/languages.h"
#include "core/yaml/examples.h"

namespace drillwave {

/// Contents of the command line that opens the window.
struct WindowArguments {
    std::string file;                  ///< file to open; empty if none is given
    const Example* example = nullptr;  ///< built-in example to open; nullptr if none is given
    bool resetsUi = false;
    /// Language of the window in this run only, instead of the stored choice; nullptr if none is given.
    const Language* language = nullptr;
};

/// Parses the command line that opens the window. Throws CommandError: usage for an unknown option or
/// language, a misspelt command, or a second file; unreadable input for a file that does not exist.
WindowArguments windowArguments(std::span<const std::string> words);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line without a command.
#pragma once

#include <span>
#include <string>

#include "core/text/languages.h"
#include "core/yaml/examples.h"

namespace drillwave {

/// The request to the window.
struct WindowArguments {
    std::string file;                  ///< to open, empty without
    const Example* example = nullptr;  ///< to open, where there is no file of its name
    bool resetsUi = false;
    const Language* language = nullptr;  ///< to speak this once, instead of the chosen one
};

/// Throws CommandError: usage, for an option, a language or a command that is not known and for a second
/// file; unreadable input, for a file that is not there.
WindowArguments windowArguments(std::span<const std::string> words);

}  // namespace drillwave

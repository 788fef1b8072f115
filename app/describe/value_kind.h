// SPDX-License-Identifier: GPL-3.0-or-later
// What a word of a command line may be, from the tables that the commands are made of: for a shell to
// complete.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"

namespace drillwave {

enum class ValueKind {
    free,       ///< a number, or whatever else nobody can guess
    folder,     ///< for a result
    file,       ///< to read or to write
    scenario,   ///< a file, or the name of an example
    example,    ///< the name of one
    parameter,  ///< KEY=…, of the table of parameters
    output,     ///< one of the table of outputs
    outputs,    ///< several, with commas between them
    formats,    ///< of pictures, likewise
    method,
    language,
    rod,
    hammer,
    rock,
    topic,  ///< of `help`
};

/// Its name, which the scripts of shells use.
std::string_view name(ValueKind kind);

/// What an option takes.
ValueKind valueKind(const OptionSpec& option);

/// What stands where no option is: of the first operand, and of all behind it.
ValueKind operandKind(const Command& command);

/// The words of a kind that has a list of them, of parameters with "=" behind; else none.
std::vector<std::string> wordsOf(ValueKind kind);

}  // namespace drillwave

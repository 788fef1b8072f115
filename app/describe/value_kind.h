// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of words on a command line, from the tables that the commands are made of: for completion by a
// shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"

namespace drillwave {

enum class ValueKind {
    free,           ///< a number, or whatever else nobody can guess
    folder,         ///< for a result
    file,           ///< to read or to write
    scenario,       ///< a file, or the name of an example
    example,        ///< the name of one
    parameter,      ///< KEY=…, of the table of parameters and of sections; with the values of words
    choice,         ///< KEY=… as a parameter has, or presets by name: hammer=NAME
    aim,            ///< max:OUTPUT@STATISTIC, or min:…
    limit,          ///< OUTPUT@STATISTIC=…
    statistic,      ///< "mean", what follows the @ of an aim or a limit
    output,         ///< one of the table of outputs
    outputs,        ///< several, with commas between them
    formats,        ///< formats of pictures, with commas between them
    reportStudies,  ///< several studies of `report --with`, with commas between them
    method,
    language,
    rod,
    hammer,
    rock,
    topic,  ///< of `help`
};

/// Returns its name, which the scripts of shells use.
std::string_view name(ValueKind kind);

/// Options that may stand before a command.
inline constexpr std::string_view programOptions[]{"--help", "--version", "--language", "--reset-ui"};

/// Returns the kind of an option's value.
ValueKind valueKind(const OptionSpec& option);

/// Returns the kind of the operands of a command: of the first one and of all after it.
ValueKind operandKind(const Command& command);

/// Returns whether words of a kind are typed in stages, up to the next of "=", ":" and "@".
bool isStaged(ValueKind kind);

/// Returns whether several words of a kind are typed with commas between them.
bool isList(ValueKind kind);

/// Returns the words of a kind that has a list of them, parameters followed by "="; else none. Aims and
/// limits end with "@". Words that agree up to one of "=", ":" and "@" are neighbours.
std::vector<std::string> wordsOf(ValueKind kind);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of words on a command line, derived from the tables of commands and options, so that a shell can
// complete them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"

namespace drillwave {

enum class ValueKind {
    free,       ///< a number or another text that cannot be completed
    folder,     ///< a folder to write results into
    file,       ///< a file to read or to write
    scenario,   ///< a scenario file, or the name of a built-in example
    example,    ///< the name of a built-in example
    parameter,  ///< "KEY=…", a key of the parameters or of string sections; complete with its value if that
                ///< is a word
    choice,     ///< "KEY=…", or a preset by its name, "hammer=NAME": a design variable
    aim,        ///< "max:OUTPUT@STATISTIC" or "min:OUTPUT@STATISTIC": an objective
    limit,      ///< "OUTPUT@STATISTIC=…", a bound of a result
    statistic,  ///< "mean", the word after the @ of an objective or a limit
    output,     ///< the name of one output
    outputs,    ///< output names, separated by commas
    formats,    ///< picture formats, separated by commas
    reportStudies,  ///< studies of `report --with`, separated by commas
    method,
    language,
    rod,
    hammer,
    rock,
    topic,  ///< a topic of the command `help`
};

/// Returns the name of a kind of command-line value in the completion scripts, for example "report_studies".
std::string_view name(ValueKind kind);

/// Options of the program itself, which may precede a command.
inline constexpr std::string_view programOptions[]{"--help", "--version", "--language", "--reset-ui"};

/// Returns the kind of value that an option takes, so that a shell can complete it.
ValueKind valueKind(const OptionSpec& option);

/// Returns the kind of value of the operands of a command, which is the same for all of them.
ValueKind operandKind(const Command& command);

/// Returns true if the shell completes words of a kind in stages, each ending at "=", ":" or "@".
bool isStaged(ValueKind kind);

/// Returns true if a value of this kind is a list of words separated by commas.
bool isList(ValueKind kind);

/// Returns all words to offer for a kind when a command line is completed; empty for kinds without a list,
/// such as files. Parameters end with "=" and limits with "@". Words with the same beginning up to "=", ":"
/// or "@" are adjacent, because completion stops there.
std::vector<std::string> wordsOf(ValueKind kind);

}  // namespace drillwave

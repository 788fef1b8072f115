// SPDX-License-Identifier: GPL-3.0-or-later
// Subcommands of the program, such as `run`, `sweep` and `map`.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "app/command_error.h"
#include "app/drawing.h"

namespace drillwave {

/// Description of one subcommand: its arguments, its help and the function that runs it.
struct Command {
    std::string_view name;
    std::string_view operands;  ///< operands in the help, "FILE CASES.csv"
    std::string_view summary;   ///< summary in the list of commands, one line
    std::string_view details;   ///< further lines of the help; may be empty
    /// Function that returns further help, generated from tables and printed after `details`; nullptr for
    /// none.
    std::string (*furtherHelp)(const ReadingStyle&) = nullptr;
    std::vector<OptionSpec> options;
    std::size_t leastOperands;
    std::size_t mostOperands;
    /// Function that returns true if these arguments request pictures; `run` then needs a Drawing.
    bool (*draws)(const Arguments&);
    /// Function that runs the command and returns the exit code. `drawing` is nullptr unless the arguments
    /// request pictures. Throws CommandError.
    std::function<ExitCode(const Arguments&, const Drawing* drawing)> run;
};

const Command& runCommand();
const Command& sweepCommand();
const Command& tableCommand();
const Command& curveCommand();
const Command& mapCommand();
const Command& drillCommand();
const Command& designCommand();
const Command& identifyCommand();
const Command& signalCommand();
const Command& reportCommand();
const Command& joinCommand();
const Command& figuresCommand();
const Command& stabilityCommand();
const Command& accuracyCommand();
const Command& validateCommand();
const Command& examplesCommand();
const Command& presetsCommand();

/// Returns all subcommands of the program, in the order of the help.
std::span<const Command* const> commands();

/// Returns the command of that name, or nullptr if there is none.
const Command* findCommand(std::string_view name);

/// Returns the parsed words that follow the subcommand. Throws CommandError (usage) for wrong options or a
/// wrong number of operands.
Arguments parseArguments(const Command& command, std::span<const std::string> words,
                         const Language& language = languages[0]);

}  // namespace drillwave

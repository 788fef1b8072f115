// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of the program.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "app/command_error.h"
#include "app/drawing.h"

namespace drillwave {

/// One subcommand: its arguments and its function.
struct Command {
    std::string_view name;
    std::string_view operands;  ///< for the help, "FILE CASES.csv"
    std::string_view summary;   ///< one line
    std::string_view details;   ///< further lines of its help, may be empty
    /// Further text from tables, after the details; nullptr for none.
    std::string (*furtherHelp)(const ReadingStyle&) = nullptr;
    std::vector<OptionSpec> options;
    std::size_t leastOperands;
    std::size_t mostOperands;
    /// Whether these arguments ask for pictures.
    bool (*draws)(const Arguments&);
    /// Does the work; there is a drawing where the arguments ask for one. Throws CommandError.
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

/// Returns all commands, in the order of the help.
std::span<const Command* const> commands();

/// The one of that name, or none.
const Command* findCommand(std::string_view name);

/// Parses the words after the subcommand and checks the number of operands.
Arguments parseArguments(const Command& command, std::span<const std::string> words,
                         const Language& language = languages[0]);

}  // namespace drillwave

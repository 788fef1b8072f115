// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of --help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"

namespace drillwave {

/// Meanings of the exit codes, separated by commas; listed in §6 of the manual's chapter on commands.
inline constexpr std::string_view exitCodesHelp =
    "0 done, 1 internal error or out of memory, 2 wrong command line, 3 input cannot be read,\n4 output "
    "cannot be written, 5 scenario invalid, 6 a case could not be solved, 130 interrupted";

/// Summary of the command `help`, and the description of its TOPIC.
inline constexpr std::string_view helpSummary =
    "print the help of a command, parameter or output, or a chapter of the manual";
inline constexpr std::string_view helpDetails =
    "TOPIC is a command (run), an option (--shard), a parameter (bit_rock.gamma), an output (cor) or "
    "a\nsymbol (e). It can also be a chapter of the manual (theory) or a section of it (theory 10). For\nany "
    "other word (feed, units, exit codes), the places of the manual that contain it are printed,\nthe best "
    "first.";

/// Summary of the command `version`.
inline constexpr std::string_view versionSummary = "print the version of the program";

/// Returns an option as shown in the help: with the placeholder of its value, such as "--set KEY=VALUE", or
/// as "--json" for a switch.
std::string synopsis(const OptionSpec& option);

/// Returns the options of a command and --language, but neither --help nor --version.
std::vector<OptionSpec> optionsOf(const Command& command);

/// Returns the part of a command's help that follows its options; empty if there is none.
std::string detailsOf(const Command& command, const ReadingStyle& style = plainStyle());

/// Returns the help of the whole program.
std::string programHelp(const ReadingStyle& style = plainStyle());

/// Returns the help of one subcommand.
std::string commandHelp(const Command& command, const ReadingStyle& style = plainStyle());

/// Returns the help of `help` or `version`, which are not objects of type Command; empty for other names.
std::string ownHelp(std::string_view name, const ReadingStyle& style = plainStyle());

/// Returns all help texts in English. Their translations are in the catalogues under the context "help".
std::vector<std::string_view> helpTexts();

}  // namespace drillwave

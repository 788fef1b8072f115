// SPDX-License-Identifier: GPL-3.0-or-later
// Text of --help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"

namespace drillwave {

/// Meaning of the exit codes, separated by commas (commands §6).
inline constexpr std::string_view exitCodesHelp =
    "0 done, 1 internal error or out of memory, 2 usage, 3 input cannot be read,\n"
    "4 output cannot be written, 5 scenario invalid, 6 a case could not be solved, 130 interrupted";

/// Help of the command `help`, and its topics.
inline constexpr std::string_view helpSummary =
    "print the help of a command, parameter or output, or a chapter of the manual";
inline constexpr std::string_view helpDetails =
    "TOPIC is a command (run), a chapter of the manual (theory) or a section of it (theory 10), a\n"
    "parameter (bit_rock.gamma), an output (cor), a symbol (e) or an option (--shard). For any other\n"
    "word (feed, units, exit codes), the places of the manual that contain it are printed, the best\n"
    "first.";

/// The summary of `version`.
inline constexpr std::string_view versionSummary = "print the version of the program";

/// "--set KEY=VALUE", "--json".
std::string synopsis(const OptionSpec& option);

/// The options of a command and those that every command has, for completions: --help and --version apart.
std::vector<OptionSpec> optionsOf(const Command& command);

/// Returns the part of a command's help below its options; empty where there is none.
std::string detailsOf(const Command& command, const ReadingStyle& style = plainStyle());

/// Help of the whole program.
std::string programHelp(const ReadingStyle& style = plainStyle());

/// Help of one subcommand.
std::string commandHelp(const Command& command, const ReadingStyle& style = plainStyle());

/// Help of `help` and `version`, which are no Command; empty for other names.
std::string ownHelp(std::string_view name, const ReadingStyle& style = plainStyle());

/// The English texts of all that, which the catalogues have as "help".
std::vector<std::string_view> helpTexts();

}  // namespace drillwave

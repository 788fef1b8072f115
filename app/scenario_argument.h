// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario that a command line names.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "core/archive/result_scenario.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// The option that changes a scenario; all of them come with scenarioOptions().
inline constexpr OptionSpec setOption{"set", "KEY=VALUE",
                                      "change parameters of the scenario, such as rod.length=4.27m beta=0.8",
                                      OptionSpec::Times::list};

/// The options of a command that takes a scenario: --set and the presets, then those of its own.
std::vector<OptionSpec> scenarioOptions(const std::vector<OptionSpec>& own = {});

/// Help for the operand FILE.
inline constexpr std::string_view scenarioOperandHelp =
    "FILE is a scenario, a result file that contains its scenario (summary.json, histories.csv,\n"
    "map.csv.yaml …), the name of a built-in example, or - for standard input.";

/// Loads the scenario that FILE names (loadScenarioFile()), applies the presets and then every --set:
/// pulse.shape first, then physical parameters, then groups, whatever their order. The scenario is valid.
/// Reports on stderr if the file is from a newer program. Throws CommandError.
ScenarioInput loadScenarioInput(const std::string& path, const Arguments& arguments);

/// Loads it for a command that solves exactly, and reports if a result was solved by another method.
ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments);

/// The options that name a file which is read.
inline constexpr std::string_view inputOptions[] = {"presets", "draws", "signal"};

/// Returns every file that a command reads: its operands, those of inputOptions, and the table of the
/// scenario's blow.
std::vector<std::string> inputsOf(const Arguments& arguments, const ScenarioDocument& document);

/// Throws CommandError (usage) if `output`, which the command writes, is one of these.
void checkOutputIsNoInput(const std::string& output, const Arguments& arguments,
                          const ScenarioDocument& document);

/// Throws CommandError (usage) if `output` is one of the `inputs`.
void checkNotInputFile(const std::string& output, const std::vector<std::string>& inputs);

/// Throws CommandError (usage) if a --set sets a parameter of an axis, which the word in `words` quotes: one
/// would silently undo the other. `scenario` is the result of loadScenarioInput().
void checkNotSet(const Arguments& arguments, const Scenario& scenario, std::span<const SweepAxis> axes,
                 std::span<const std::string> words);

/// A line on stderr in the language of the reader.
void printRemark(const Message& remark, const ReadingStyle& style);

/// Prints one line on stderr for each value outside its usual range, which is most often a mistyped unit:
/// call it before work that such a value may make long.
void remarkOnValues(const Scenario& scenario, const std::string& path, const ReadingStyle& style);

/// Just loads a scenario file, the scenario of a result, a built-in example where there is no file of that
/// name, or standard input. Throws CommandError with every problem of the file.
ScenarioInput loadScenarioFile(const std::string& path, const ReadingStyle& style = plainStyle());

/// Does the same in two steps: reads the bytes that FILE names, and parses them.
std::string inputBytes(const std::string& path, const ReadingStyle& style);
ScenarioInput parsedInput(std::string_view bytes, const std::string& path);

/// Throws what a scenario could not be loaded for as a CommandError.
[[noreturn]] void rethrow(const ScenarioError& error);

}  // namespace drillwave

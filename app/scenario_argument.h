// SPDX-License-Identifier: GPL-3.0-or-later
// Loading and changing the scenario that a command line names.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "core/archive/result_scenario.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// Option --set, which changes parameters of the scenario; scenarioOptions() includes it.
inline constexpr OptionSpec setOption{"set", "KEY=VALUE",
                                      "change parameters of the scenario, such as rod.length=4.27m beta=0.8",
                                      OptionSpec::Times::list};

/// Returns the descriptions of all options of a command that reads a scenario. They are --set, the presets,
/// those in `own`, and --signal with its reading options.
std::vector<OptionSpec> scenarioOptions(const std::vector<OptionSpec>& own = {});

/// Help on the operand FILE.
inline constexpr std::string_view scenarioOperandHelp =
    "FILE is a scenario, a result file that contains its scenario (summary.json, histories.csv,\n"
    "map.csv.yaml …), the name of a built-in example, or - for standard input.";

/// Returns the scenario that FILE names, with the presets, --signal and then every --set applied. Settings
/// are applied in a fixed order: pulse.shape, physical parameters, groups. The scenario is valid. Prints a
/// note on stderr if another version of the program wrote the file. Throws CommandError.
ScenarioInput loadScenarioInput(const std::string& path, const Arguments& arguments);

/// Returns the scenario of loadScenarioInput() for a command that only solves exactly. Prints a note on
/// stderr if FILE is a result solved by another method. Throws CommandError.
ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments);

/// Names of the options whose value is the name of a file to read.
inline constexpr std::string_view inputOptions[] = {"presets", "draws", "signal"};

/// Returns every file that a command reads. These are its operands, the values of options such as --signal
/// (inputOptions), and the CSV file of the scenario's hammer force.
std::vector<std::string> inputsOf(const Arguments& arguments, const ScenarioDocument& document);

/// Throws CommandError (usage) if `output`, a file that the command writes, is a file that it also reads (see
/// inputsOf()).
void checkOutputIsNoInput(const std::string& output, const Arguments& arguments,
                          const ScenarioDocument& document);

/// Throws CommandError (usage) if `output` is one of the `inputs`.
void checkNotInputFile(const std::string& output, const std::vector<std::string>& inputs);

/// Throws CommandError (usage) if --set sets a parameter that an axis varies, because the axis would
/// overwrite it. `words` are the command-line words of `axes`; `scenario` is from loadScenarioInput().
void checkNotSet(const Arguments& arguments, const Scenario& scenario, std::span<const SweepAxis> axes,
                 std::span<const std::string> words);

/// Prints a line on stderr in the language of `style`.
void printRemark(const Message& remark, const ReadingStyle& style);

/// Prints a warning on stderr for each value outside its typical range, which is usually a mistyped unit.
/// Call it before work that such a value may prolong.
void remarkOnValues(const Scenario& scenario, const std::string& path, const ReadingStyle& style);

/// Returns the scenario of a file, of a result, of standard input ("-") or of a built-in example. If a file
/// and an example have the same name, the file is used. Applies no options. Throws CommandError with every
/// error in the file.
ScenarioInput loadScenarioFile(const std::string& path, const ReadingStyle& style = plainStyle());

/// Returns the bytes of the file or built-in example that `path` names (first step of loadScenarioFile()).
/// Throws CommandError.
std::string inputBytes(const std::string& path, const ReadingStyle& style);
/// Returns the scenario in the bytes of a file (second step of loadScenarioFile()); `path` names it in
/// messages. Throws CommandError with every error in the file.
ScenarioInput parsedInput(std::string_view bytes, const std::string& path);

/// Throws the CommandError for a scenario that could not be loaded: unreadable input or invalid scenario.
[[noreturn]] void rethrow(const ScenarioError& error);

}  // namespace drillwave

// The scenario that a command line names.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/file/scenario_file.h"

namespace drillwave {

/// The options of every command that takes a scenario.
inline constexpr OptionSpec setOption{"set", "KEY=VALUE", "change parameters, e.g. rod.length=4.27m beta=0.8",
                                      OptionSpec::Times::list};

/// Loads a scenario file, or the scenario in the "#" lines of a CSV file that `run -o` wrote, and applies
/// every --set: pulse.shape first, then physical parameters, then groups, whatever their order. The scenario
/// is valid. Throws CommandError.
ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments);

/// Throws CommandError (usage) if `output`, which the command writes, is one of the files that are read: the
/// scenario file, its table of a pulse, or one of the `others`.
void checkOutputIsNoInput(const std::string& output, const std::string& scenarioPath,
                          const ScenarioDocument& document, const std::vector<std::string>& others = {});

/// Throws CommandError (usage) if a --set sets what another option, which `what` quotes, is to change: one
/// would silently undo the other.
void checkNotSet(const Arguments& arguments, std::string_view key, const std::string& what);

/// One line on stderr for each value outside its usual range, which is most often a mistyped unit: to be
/// called before work that such a value may make long.
void remarkOnValues(const Scenario& scenario, const std::string& path);

/// Just loads a scenario file or the scenario of a result. Throws CommandError with every problem of the
/// file.
ScenarioDocument loadScenarioFile(const std::string& path);

}  // namespace drillwave

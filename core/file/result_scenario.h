// The scenario of an earlier run, from the CSV files it left behind.
#pragma once

#include <string>
#include <string_view>

#include "core/file/scenario_file.h"

namespace drillwave {

/// Whether the name says that it is a CSV file ("….csv", however written).
bool isCsvName(std::string_view path);

/// The scenario in the "#" lines at the top of a histories.csv or events.csv, which is complete in itself.
/// Throws ScenarioError: unreadable when the file does not begin with one.
ScenarioDocument loadResultScenario(const std::string& path);

/// A scenario file, or, where isCsvName(), the scenario of a result. Throws ScenarioError.
ScenarioDocument loadScenarioOrResult(const std::string& path);

/// The scenario as it is solved, complete in itself: points that came from a file are written out. Throws
/// ScenarioError where that would be larger than 1 MiB.
std::string completeScenarioText(ScenarioDocument document);

}  // namespace drillwave

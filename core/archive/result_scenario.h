// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario of an earlier run, read from the files of its results.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/text/message.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Largest number of bytes that are read from a file of results, 4 MiB. A scenario has at most 1 MiB as YAML,
/// but is longer in JSON or with "# " before each line. It is at the beginning of a CSV file or HTML page, so
/// the rest need not be read.
inline constexpr std::size_t maximumInputBytes = std::size_t{1} << 22;

/// Scenario, with information on the file that contained it.
struct ScenarioInput {
    ScenarioDocument document;
    /// Whether the file is a result: JSON, CSV, an HTML report, or the record next to a CSV file. Such a file
    /// contains more than the scenario, so the scenario must not be saved over it.
    bool isResult = false;
    std::string version;                 ///< version of the program that wrote the file; empty if unknown
    std::optional<MethodChoice> method;  ///< method by which the scenario was solved; nullopt if unknown
};

/// Returns whether a path is that of a CSV file ("….csv", in any capitals).
bool isCsvName(std::string_view path);

/// Returns the scenario in a text of any kind: a scenario file, the JSON output of a command, the record
/// (YAML) next to a CSV file, a CSV file or an HTML report. Skips a byte order mark. `source` is the name of
/// the text in messages; if it ends in ".csv", ".json" or ".html", the text must be a result. Throws
/// ScenarioError if the text contains no valid scenario.
ScenarioInput parseInput(std::string_view text, const std::string& source);

/// Returns the scenario in a file of any kind, such as a scenario file, JSON, CSV or HTML. Reads at most
/// maximumInputBytes. Throws ScenarioError if the file cannot be read or contains no valid scenario.
ScenarioInput loadInput(const std::string& path);

/// Returns the scenario in a file of results. Throws ScenarioError if the file is not a result, or contains
/// no valid scenario.
ScenarioDocument loadResultScenario(const std::string& path);

/// Returns whether a version ("0.2.0") is newer than another one; false if one of them is not a version.
bool isNewerVersion(std::string_view version, std::string_view than);

/// Returns the complete text of a scenario, with the points of a force table written into it, so that no
/// other file is needed. If this text exceeds the limit of 1 MiB, it contains the absolute path of the table
/// file instead. Throws ScenarioError if even that text is too large.
std::string completeScenarioText(ScenarioDocument document);

// Changes in results since older versions (manual, upgrading).

/// Returns a sentence on results that have changed since `version` ("0.2.0") solved this scenario: "Written
/// by Drillwave 0.2.0. These results have changed since: … (manual, Upgrading)." Empty if nothing has
/// changed, or the version is unknown.
Message changesSentence(std::string_view version, const Scenario& scenario);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario of an earlier run, from the files it left behind.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/text/message.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Most bytes of an input that are read: a scenario may have 1 MiB, with "# " before each of its lines or as
/// text in JSON, beside thousands of events, more; of a CSV file or a page only the top matters.
inline constexpr std::size_t maximumInputBytes = std::size_t{1} << 22;

/// Scenario, with information from the file that contained it.
struct ScenarioInput {
    ScenarioDocument document;
    /// A result, whose bytes are not those of the scenario: JSON, CSV, or the record beside a CSV file.
    bool isResult = false;
    std::string version;                 ///< of the program that wrote the file; empty if unknown
    std::optional<MethodChoice> method;  ///< how it was solved; nothing if unknown
};

/// Returns whether the name is that of a CSV file ("….csv", in any case).
bool isCsvName(std::string_view path);

/// The scenario of a text, whatever kind of file it is from: a scenario file; the JSON object of a command,
/// with the scenario as its text; the record beside a CSV file of rows; a CSV file that begins with its
/// scenario in "#" lines; a report in HTML. A byte order mark in front is skipped. `source` names the text in
/// messages, and where it ends in ".csv", ".json" or ".html" the text is taken for a result. Throws
/// ScenarioError.
ScenarioInput parseInput(std::string_view text, const std::string& source);

/// The same for a regular file of at most maximumInputBytes, of a CSV file or a page its top. Throws
/// ScenarioError.
ScenarioInput loadInput(const std::string& path);

/// Returns the scenario of a result. Throws ScenarioError: unreadable if the file has none.
ScenarioDocument loadResultScenario(const std::string& path);

/// Whether a version ("0.2.0") is newer than another one; false where one of them is no version.
bool isNewerVersion(std::string_view version, std::string_view than);

/// The scenario as it is solved, complete in itself: points that came from a file are written out or, where
/// that would be more than a scenario file may have, their file is named by its absolute path. Throws
/// ScenarioError where there is no such file either.
std::string completeScenarioText(ScenarioDocument document);

// Changes in results since older versions (manual, upgrading).

/// Says which numbers of a result that `version` ("0.2.0") wrote of this scenario have changed: "Written by
/// Drillwave 0.2.0. These results have changed since: … (manual, Upgrading)." Empty where none has, or the
/// version is not known.
Message changesSentence(std::string_view version, const Scenario& scenario);

}  // namespace drillwave

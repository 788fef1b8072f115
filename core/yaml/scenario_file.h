// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario files (files §1): YAML, read strictly with positions of errors, and written so that everything
// unchanged remains.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/design_setup.h"
#include "core/model/scenario.h"
#include "core/model/validation.h"
#include "core/text/message.h"

namespace drillwave {

/// Exception that says why a scenario could not be loaded, with all errors.
class ScenarioError : public std::runtime_error {
  public:
    enum class Kind {
        unreadable,  ///< the file cannot be opened, is too large, not text, or not YAML (exit code 3)
        invalid,     ///< the file is readable but not a valid scenario (exit code 5)
    };
    ScenarioError(Kind kind, std::string source, std::vector<InputProblem> problems);

    Kind kind() const { return m_kind; }
    const std::vector<InputProblem>& problems() const { return m_problems; }
    /// Returns a translatable message for each error, with its position: "file:line:column: text".
    std::vector<Message> messages() const;
    /// Returns a message in English for each error, with its position: "file:line:column: text".
    std::vector<std::string> lines() const;

  private:
    Kind m_kind;
    std::string m_source;
    std::vector<InputProblem> m_problems;
};

/// Scenario together with the text of its file, so that saving preserves comments, order and units.
struct ScenarioDocument {
    Scenario scenario;
    std::string text;  ///< text as it was read; empty for a new scenario
    /// File name, for messages and to find a table file with a relative path; may be empty.
    std::string source;
    DesignSetup design = {};  ///< settings of the design study; other studies ignore them
    /// Warnings about the quality of the measured record that replaced the hammer force.
    std::vector<Message> recordRemarks = {};
};

/// Reads a scenario file of at most 1 MiB. The path of a table file in it is relative to the folder of the
/// scenario file. Throws ScenarioError with all errors.
ScenarioDocument loadScenario(const std::string& path);

/// Reads a scenario from text; `source` names it in messages. Throws ScenarioError with all errors.
ScenarioDocument parseScenario(std::string_view text, const std::string& source);

/// Returns scenario and design of a document as YAML text. If they are unchanged, this is `document.text`,
/// byte for byte. Otherwise changed values are replaced in place if possible, else the file is rewritten.
/// Reading the result gives the same scenario, except values that it does not use (see
/// withoutUnusedValues()). Throws ScenarioError if the text would be larger than 1 MiB. Requires a valid
/// scenario.
std::string writeScenario(const ScenarioDocument& document);

// Comment lines at the top of a scenario in a result: which program wrote it, and how it was solved.

/// Beginnings of the comment lines that the program writes above the scenario in a result file, in this
/// order. Only the first line is always present.
inline constexpr std::string_view writtenRemark = "# Written by Drillwave ";
inline constexpr std::string_view solvedRemark = "# Solved by method ";
inline constexpr std::string_view columnsRemark = "# Columns: ";

/// Returns the length in bytes of the comment lines at the beginning of a text that describe a result,
/// including a byte order mark. The scenario begins after them. Returns 0 if the text does not begin with
/// such a comment.
std::size_t remarksLength(std::string_view yaml);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario files (files §1): YAML read strictly with positions, written so that nothing unchanged moves.
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

/// Why a scenario could not be loaded.
class ScenarioError : public std::runtime_error {
  public:
    enum class Kind {
        unreadable,  ///< the file cannot be opened, is too large, not text, or not YAML (exit code 3)
        invalid,     ///< it was read but is not a valid scenario (exit code 5)
    };
    ScenarioError(Kind kind, std::string source, std::vector<InputProblem> problems);

    Kind kind() const { return m_kind; }
    const std::vector<InputProblem>& problems() const { return m_problems; }
    /// "file:line:column: text" for each problem.
    std::vector<Message> messages() const;
    /// The same in English.
    std::vector<std::string> lines() const;

  private:
    Kind m_kind;
    std::string m_source;
    std::vector<InputProblem> m_problems;
};

/// Scenario together with its text, so that saving keeps comments, order and units.
struct ScenarioDocument {
    Scenario scenario;
    std::string text;    ///< the bytes read, empty for a new scenario
    std::string source;  ///< file name for messages and for resolving a relative table file, may be empty
    DesignSetup design = {};  ///< of its design study; studies other than that ignore it
    std::vector<Message> recordRemarks =
        {};  ///< on the quality of the record that took the place of its blow
};

/// Reads at most 1 MiB. Throws ScenarioError with every problem. A `table` pulse with a file is read relative
/// to it.
ScenarioDocument loadScenario(const std::string& path);

/// Does the same for text in memory; `source` names it in messages.
ScenarioDocument parseScenario(std::string_view text, const std::string& source);

/// Returns the document's scenario and design as YAML text. Byte for byte `document.text` if it still has
/// both; otherwise the changed values are patched in place where that is possible, or the file is rewritten.
/// Reading the result gives the same scenario, except values that its form and shape do not use (see
/// withoutUnusedValues()). Throws ScenarioError if the text would be larger than 1 MiB. Requires a valid
/// scenario.
std::string writeScenario(const ScenarioDocument& document);

// The comment lines at the top of a scenario's text that describe a result: the program that wrote it, and
// how it was solved.

/// How they begin, in this order; all but the first may be absent.
inline constexpr std::string_view writtenRemark = "# Written by Drillwave ";
inline constexpr std::string_view solvedRemark = "# Solved by method ";
inline constexpr std::string_view columnsRemark = "# Columns: ";

/// Bytes of these lines, with a byte order mark in front of them; 0 for a text that does not begin with them.
std::size_t remarksLength(std::string_view yaml);

}  // namespace drillwave

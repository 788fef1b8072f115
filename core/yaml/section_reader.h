// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of the sections of a scenario file: their keys are checked, their values are read by the table of
// parameters.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/model/validation.h"
#include "core/text/text_input.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {

// Errors in the text of a scenario, with their positions.

/// Collector of the errors in one text, at most 100. It returns them sorted by their position.
class ProblemList {
  public:
    explicit ProblemList(std::string_view text) : m_text(text) {}

    /// Adds the error "key = value (reason)" to the list, with line and column of the byte at `offset` in the
    /// text.
    void reportValue(std::size_t offset, std::string_view key, std::string_view value, const Message& reason);
    /// Adds the error "key (reason)" to the list, with line and column of the byte at `offset` in the text.
    void reportKey(std::size_t offset, std::string_view key, const Message& reason);
    /// Adds an error to the list. Its line and column are already set.
    void report(InputProblem problem);
    /// Adds an error to the list, with line and column of the byte at `offset` in the text.
    void reportAt(std::size_t offset, InputProblem problem);

    bool empty() const { return m_problems.empty(); }
    /// Returns line and column of a byte of the text, counted from 1.
    TextPosition position(std::size_t offset) const { return positionOf(m_text, offset); }
    /// Returns whether an error was reported for this key.
    bool concerns(std::string_view key) const { return m_keys.contains(std::string(key)); }
    /// Returns the errors in order of line and column. If there were more than 100, the others are left out
    /// and the last item gives their number.
    std::vector<InputProblem> take();

  private:
    std::string_view m_text;
    std::vector<InputProblem> m_problems;
    std::set<std::string> m_keys;
    std::size_t m_leftOut = 0;
};

/// Key of a YAML map and its value.
struct YamlEntry {
    const YamlNode* key = nullptr;
    const YamlNode* value = nullptr;
    /// Returns the byte offset in the text at which to report an error: that of the value, or that of the key
    /// if the value is absent.
    std::size_t place() const;
};
using YamlEntries = std::map<std::string, YamlEntry, std::less<>>;

/// Returns the key of a number in a section: "rod.length" for "rod" and "length".
std::string joinedKey(std::string_view section, std::string_view key);

/// Reader of the sections of a scenario file. It stores values in a scenario and collects errors.
class SectionReader {
  public:
    explicit SectionReader(std::string_view text) : m_problems(text) {}

    Scenario& scenario() { return m_scenario; }
    ProblemList& problems() { return m_problems; }
    bool dimensional() const { return m_scenario.form == ScenarioForm::dimensional; }

    /// Returns the entries of a map that have known keys. Reports an error for each unknown key, and for a
    /// key that occurs twice.
    YamlEntries entriesOf(const YamlNode& map, std::string_view section,
                          const std::vector<std::string_view>& known);
    /// Returns the entries of the section `name` of a scenario file; none if the section is empty. Allowed
    /// keys are `moreKeys` and those of the parameters in `group`, such as "rod"; others are reported as
    /// errors. Returns nullopt and reports an error if the section is missing or is not a map.
    std::optional<YamlEntries> section(const YamlEntries& file, std::string_view name, std::string_view group,
                                       std::vector<std::string_view> moreKeys = {});

    /// Treatment of parameters in a file that do not apply to the scenario: an error (`checked`), or no error
    /// (`ignored`).
    enum class Applicability { checked, ignored };
    /// Sets every parameter of the section `group` that is present in the file. The order is that of the
    /// table of parameters, because a mean force can be converted to an impulse only after the duration is
    /// set.
    void readParameters(const YamlEntries& entries, std::string_view group, Applicability applicability);

    /// Reports an error for each required parameter of `group`, such as "rod", that is missing. If two
    /// parameters exclude each other, such as mean force and impulse, exactly one must be given. Parameters
    /// that do not apply to the scenario are not required.
    void requireParameters(const YamlEntries& entries, std::string_view group);
    /// Reports an error if a parameter is missing. `entries` are those of its section of the file.
    void require(const YamlEntries& entries, const Parameter& parameter);
    /// Reports an error if the file does not give the shape of the hammer force.
    void requireShape(const YamlEntries& entries);
    /// Reports an error unless exactly one of the two keys is present.
    void requireOneOf(const YamlEntries& entries, std::string_view section, std::string_view one,
                      std::string_view other);
    void reportMissing(std::string_view section, std::string_view key, const Message& reason);
    /// Returns whether the key is present. A misspelt form of the key also counts. It was already reported as
    /// an unknown key, so the key must not be reported as missing too.
    bool isThere(const YamlEntries& entries, std::string_view section, std::string_view key) const;

    /// Stores the byte offset of a key in the text, so that errors found later can give its position.
    void setPlace(std::string_view key, std::size_t offset) { m_places[std::string(key)] = offset; }
    std::optional<std::size_t> placeOf(std::string_view key) const;

    /// Sets one numeric parameter, or reports why the value is wrong. `path` is its name in messages
    /// (default: its key in the file).
    void readNumber(const Parameter& parameter, const YamlEntry& entry, std::string path = {});

  private:
    ProblemList m_problems;
    Scenario m_scenario;
    std::map<std::string, std::size_t, std::less<>> m_places;
    std::set<std::string, std::less<>> m_mistyped;  // keys that an unknown key is probably meant to be
};

}  // namespace drillwave

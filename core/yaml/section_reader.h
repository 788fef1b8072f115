// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of a scenario file: their keys checked, their values read through the parameter table.
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

// Problems of a scenario text, collected with their places.

/// Collects the problems of one text, up to a limit that a person would still read, in the order of the text.
class ProblemList {
  public:
    explicit ProblemList(std::string_view text) : m_text(text) {}

    /// "key = value (reason)" at a byte of the text.
    void reportValue(std::size_t offset, std::string_view key, std::string_view value, const Message& reason);
    /// "key (reason)" at a byte of the text.
    void reportKey(std::size_t offset, std::string_view key, const Message& reason);
    /// A problem as it is, its place being known already.
    void report(InputProblem problem);
    /// Reports a problem at a byte of the text.
    void reportAt(std::size_t offset, InputProblem problem);

    bool empty() const { return m_problems.empty(); }
    /// Line and column of a byte of the text.
    TextPosition position(std::size_t offset) const { return positionOf(m_text, offset); }
    /// Whether something was reported about that key.
    bool concerns(std::string_view key) const { return m_keys.contains(std::string(key)); }
    /// Returns the problems by line and column; the last one gives the number of those left out.
    std::vector<InputProblem> take();

  private:
    std::string_view m_text;
    std::vector<InputProblem> m_problems;
    std::set<std::string> m_keys;
    std::size_t m_leftOut = 0;
};

/// Key of a map and its value.
struct YamlEntry {
    const YamlNode* key = nullptr;
    const YamlNode* value = nullptr;
    /// Returns the place to point at: the value, or the key of an absent one.
    std::size_t place() const;
};
using YamlEntries = std::map<std::string, YamlEntry, std::less<>>;

/// "rod" and "length" are "rod.length".
std::string joinedKey(std::string_view section, std::string_view key);

/// Reads sections into a scenario, collecting problems.
class SectionReader {
  public:
    explicit SectionReader(std::string_view text) : m_problems(text) {}

    Scenario& scenario() { return m_scenario; }
    ProblemList& problems() { return m_problems; }
    bool dimensional() const { return m_scenario.form == ScenarioForm::dimensional; }

    /// The entries of a map with known keys; reports the others, and keys that come twice.
    YamlEntries entriesOf(const YamlNode& map, std::string_view section,
                          const std::vector<std::string_view>& known);
    /// The entries of a section whose keys are those parameters of `group` and some more; nullopt if it is
    /// missing or no map, which is reported.
    std::optional<YamlEntries> section(const YamlEntries& file, std::string_view name, std::string_view group,
                                       std::vector<std::string_view> moreKeys = {});

    /// Whether a parameter that does not apply to the scenario is reported as such.
    enum class Applicability { checked, ignored };
    /// Assigns every parameter of the group that is there, in the order of the table (a force needs its
    /// duration).
    void readParameters(const YamlEntries& entries, std::string_view group, Applicability applicability);

    /// Reports parameters that are missing from a section, among those of the group that apply to the
    /// scenario, and those beside their rival.
    void requireParameters(const YamlEntries& entries, std::string_view group);
    /// Reports the parameter if it is missing from its section.
    void require(const YamlEntries& entries, const Parameter& parameter);
    /// Reports the shape of the pulse if it is missing.
    void requireShape(const YamlEntries& entries);
    /// Reports it unless exactly one of the two keys is present.
    void requireOneOf(const YamlEntries& entries, std::string_view section, std::string_view one,
                      std::string_view other);
    void reportMissing(std::string_view section, std::string_view key, const Message& reason);
    /// Given, or mistyped, which is reported already.
    bool isThere(const YamlEntries& entries, std::string_view section, std::string_view key) const;

    /// Remembers the place of a key of the scenario, for later problems.
    void setPlace(std::string_view key, std::size_t offset) { m_places[std::string(key)] = offset; }
    std::optional<std::size_t> placeOf(std::string_view key) const;

    /// Assigns one number; `path` is how messages call it, by default as its key stands in a file.
    void readNumber(const Parameter& parameter, const YamlEntry& entry, std::string path = {});

  private:
    ProblemList m_problems;
    Scenario m_scenario;
    std::map<std::string, std::size_t, std::less<>> m_places;
    std::set<std::string, std::less<>> m_mistyped;  // keys that an unknown one is likely to mean
};

}  // namespace drillwave

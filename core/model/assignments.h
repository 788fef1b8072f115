// SPDX-License-Identifier: GPL-3.0-or-later
// Keys and values that one scenario is given: the order in which to set them, and contradictions.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns whether setting one key undoes the other, in any scenario: the same key, a group and the physical
/// parameter it moves, mean force and impulse, area and diameters.
bool areRivals(std::string_view a, std::string_view b);

/// Returns why two keys cannot both be set, to be written after them: "set the same thing" if they are
/// rivals; "set one section, …" if both set one that the file has once. Empty if they can. The scenarios are
/// as for meetingProblem().
Message rivalProblem(std::string_view a, const Scenario& ofA, std::string_view b, const Scenario& ofB);

/// Two keys of Assignments that cannot both be set.
struct RivalPair {
    std::size_t one = 0, other = 0;  ///< one < other
    Message problem;                 ///< rivalProblem()
};

/// A key, and the parameter that it names, if any.
struct AssignedKey {
    std::string_view key;
    KeptParameter parameter;
};

/// Keys that are set together, numbered as they were added. Their values stay with the caller: a word of the
/// command line, an axis of a sweep, a cell of a table.
class Assignments {
  public:
    Assignments() = default;
    explicit Assignments(const std::vector<std::string_view>& keys);

    /// Adds a key, known or not, under the next number.
    void add(std::string_view key);
    /// The next number sets nothing.
    void skip();

    /// Returns the numbers of the keys in the order in which a scenario takes them: the shape, which decides
    /// what applies (and with it everything that is not in the table of parameters); physical parameters in
    /// the order of the table; for a string the repeat, then sections by name, then by place; the groups,
    /// which move physical parameters.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// Which of them are set, where not all are.
    using IsSet = std::function<bool(std::size_t)>;
    /// Returns the first two rivals, in any scenario.
    std::optional<RivalPair> rivals(const IsSet& isSet = {}) const;
    /// The first two that are about one section of a scenario in which all is set.
    std::optional<RivalPair> meeting(const Scenario& scenario, const IsSet& isSet = {}) const;

    /// Returns whether the hammer blow depends on the key: on its own parameters and, for a piston, those of
    /// the rod; for a string, on all of hammer and string.
    bool movesPulse(std::size_t number) const;
    /// Whether it does on any of the keys.
    bool movePulse() const;

  private:
    std::vector<std::optional<AssignedKey>> m_keys;  // none: sets nothing
    std::vector<std::size_t> m_order;
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    Pairs m_rivals;
    Pairs m_mayMeet;  // in one section
};

// Parameters in which scenarios differ.

/// Returns the value of a parameter in SI; for the material of a rod also that of all sections of a string,
/// and vice versa. Nothing where it does not apply or is not given.
std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter);

/// Returns the parameters that at least one scenario gives (isGiven()) and that differ between scenarios, in
/// the order of the table, then those of sections by place. Values that only follow from others are left out,
/// such as the groups of a scenario in physical units; so is one of two parameters that are the same number
/// of a rod and of a string.
std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios);

}  // namespace drillwave

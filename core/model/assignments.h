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

/// Whether setting one key undoes what setting the other did, whatever the scenario: the same key, a group
/// and the physical parameter it moves, mean force and impulse, area and diameters.
bool areRivals(std::string_view a, std::string_view b);

/// Why two keys cannot both be set, as what stands behind them: "set the same thing" where they are rivals;
/// "set one section, …" where both are about one that stands in the file once. Empty when they can. The
/// scenarios are as for meetingProblem().
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

    /// The next number is that of this key, known or not.
    void add(std::string_view key);
    /// The next number sets nothing.
    void skip();

    /// The numbers of the keys in the order in which a scenario takes them: the shape, which decides what
    /// applies (and with it whatever is not in the table of parameters); physical parameters in the order of
    /// the table; of a string the repeat, then sections by name, then by place; the groups, which move
    /// physical parameters.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// Which of them are set, where not all are.
    using IsSet = std::function<bool(std::size_t)>;
    /// The first two that are rivals, whatever they are set in.
    std::optional<RivalPair> rivals(const IsSet& isSet = {}) const;
    /// The first two that are about one section of a scenario in which all is set.
    std::optional<RivalPair> meeting(const Scenario& scenario, const IsSet& isSet = {}) const;

    /// Whether the hammer blow depends on the key: it has its own parameters and, for a piston, the rod's;
    /// that of a string all of hammer and string.
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

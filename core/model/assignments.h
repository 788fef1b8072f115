// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that are set together in a scenario: the order in which to set them, and keys that contradict each
// other.
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

/// Returns whether setting one key undoes the other in every scenario. Examples are equal keys, a
/// dimensionless group and the parameter that it changes, mean force and impulse, area and diameter.
bool areRivals(std::string_view a, std::string_view b);

/// Returns why keys `a` and `b` cannot both be set: "set the same thing", or "set one section: …". The text
/// follows the two keys in a message; empty if both can be set. `a` is set in the scenario `ofA`, `b` in
/// `ofB`. The two scenarios may differ only in the number of repeats.
Message rivalProblem(std::string_view a, const Scenario& ofA, std::string_view b, const Scenario& ofB);

/// Two keys that cannot both be set, because they contradict each other, and the reason.
struct RivalPair {
    std::size_t one = 0, other = 0;  ///< indices of the two keys, one < other
    Message problem;                 ///< reason, "set the same thing"; see rivalProblem()
};

/// Key of a parameter to be set, and the parameter. `parameter` is empty for unknown keys, and for keys whose
/// value is a word, such as "pulse.shape".
struct AssignedKey {
    std::string_view key;
    KeptParameter parameter;
};

/// List of keys to be set together, numbered from 0 in the order in which they are added. Their values stay
/// with the caller, such as a command line, a sweep or a table.
class Assignments {
  public:
    Assignments() = default;
    explicit Assignments(const std::vector<std::string_view>& keys);

    /// Adds a key; its number is 0 for the first key, then 1, … A key without a parameter is also allowed.
    void add(std::string_view key);
    /// Adds a number without a key, for example for a table column that sets no parameter. The numbers of the
    /// keys are then equal to the column indices.
    void skip();

    /// Returns the numbers of the keys in the order in which their values must be set. First come keys that
    /// are not in the table of parameters, such as the shape of the force, which decides which parameters
    /// apply. Physical parameters follow in the order of the table. For a drill string, the number of repeats
    /// comes next, then sections by name, then sections by number. The dimensionless groups, which change
    /// physical parameters, are last.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// Function that returns whether the key with the given number is set. If it is empty, all keys are set.
    using IsSet = std::function<bool(std::size_t)>;
    /// Returns the first two keys that contradict each other whatever the scenario is, such as area and
    /// diameter. Returns nullopt if there are none. Keys for which `isSet` is false are ignored.
    std::optional<RivalPair> rivals(const IsSet& isSet = {}) const;
    /// Returns the first two keys that set the same section of this scenario. Either one key has its number
    /// and the other its name, or both have numbers of copies in one repeat. Returns nullopt if there are
    /// none. Keys for which `isSet` is false are ignored. All values must already be set in the scenario.
    std::optional<RivalPair> meeting(const Scenario& scenario, const IsSet& isSet = {}) const;

    /// Returns whether the hammer force may depend on the key with this number, because it begins with
    /// "pulse.", "rod.", "hammer.", "material." or "string.".
    bool movesPulse(std::size_t number) const;
    /// Returns whether the hammer force may depend on any of the keys. If so, it must be computed again after
    /// their values are set.
    bool movePulse() const;

  private:
    std::vector<std::optional<AssignedKey>> m_keys;  // nullopt for a number that stands for no key
    std::vector<std::size_t> m_order;
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    Pairs m_rivals;
    Pairs m_mayMeet;  // pairs of numbers that may set the same section
};

// Parameters in which scenarios differ.

/// Returns the value of a parameter in SI; nullopt if it does not apply or is not given. A parameter of the
/// material, such as density, applies to both forms: it is that of the uniform rod or of the drill string.
std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter);

/// Returns the parameters whose values differ between the scenarios: those of the table of parameters, then
/// of corners of the loading curve, then of sections by position. Left out are parameters that no scenario
/// gives (isGiven()), as they are computed from others. A number that rod and string share, such as density,
/// is listed once.
std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios);

}  // namespace drillwave

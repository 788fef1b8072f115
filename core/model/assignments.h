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

/// Returns whether setting one key undoes the other in every scenario. This holds for equal keys, a group and
/// the parameter it changes, mean force and impulse, area and diameters.
bool areRivals(std::string_view a, std::string_view b);

/// Returns why keys `a` and `b` cannot both be set: "set the same thing", or "set one section: …". The words
/// follow the two keys in a message. Empty if both can be set. A section number in `a` refers to the scenario
/// `ofA`, one in `b` to `ofB`. The two scenarios may differ only in the number of repeats.
Message rivalProblem(std::string_view a, const Scenario& ofA, std::string_view b, const Scenario& ofB);

/// Indices of two keys of Assignments that cannot both be set, and the reason.
struct RivalPair {
    std::size_t one = 0, other = 0;  ///< indices of the two keys, one < other
    Message problem;                 ///< reason, "set the same thing"; see rivalProblem()
};

/// Key of a parameter to be set. `parameter` is empty for keys without a numeric parameter, such as
/// "pulse.shape".
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

    /// Adds a key of a parameter under the next number, 0 for the first. Unknown keys are allowed.
    void add(std::string_view key);
    /// Leaves the next number without a key.
    void skip();

    /// Returns the numbers of the keys in the order in which they must be set. First the shape of the force,
    /// which decides what applies, and all other keys that are not in the table of parameters. Then physical
    /// parameters in the order of the table. For a drill string then the repeat, sections by name, and
    /// sections by position. Finally the groups, which change physical parameters.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// Function that returns whether the key of a number is set; if empty, all keys are set.
    using IsSet = std::function<bool(std::size_t)>;
    /// Returns the first two keys that contradict each other in every scenario, such as area and diameter, or
    /// nullopt. Only keys for which `isSet` is true count.
    std::optional<RivalPair> rivals(const IsSet& isSet = {}) const;
    /// Returns the first two keys that set the same section of this scenario, at least one of them by the
    /// section's number; nullopt if there are none. Only keys for which `isSet` is true count. All values
    /// must already be assigned.
    std::optional<RivalPair> meeting(const Scenario& scenario, const IsSet& isSet = {}) const;

    /// Returns whether the hammer force may depend on this key, because it begins with "pulse.", "rod.",
    /// "hammer.", "material." or "string.".
    bool movesPulse(std::size_t number) const;
    /// Returns whether the hammer force may depend on any of the keys.
    bool movePulse() const;

  private:
    std::vector<std::optional<AssignedKey>> m_keys;  // nullopt for a number that stands for no key
    std::vector<std::size_t> m_order;
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    Pairs m_rivals;
    Pairs m_mayMeet;  // pairs of numbers that may set the same section
};

// Parameters in which scenarios differ.

/// Returns the value of a parameter in SI; nullopt if it does not apply or is not given. The material of a
/// uniform rod and that of all sections of a string count as the same parameter.
std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter);

/// Returns the parameters that differ between scenarios: those of the table of parameters in its order, then
/// those of sections by position. At least one scenario must give the parameter (isGiven()); values derived
/// from others, such as groups, are left out. A number that a rod and a string share, such as density, is
/// listed once.
std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios);

}  // namespace drillwave

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

/// Returns why keys `a` and `b` cannot both be set, as words that follow the two keys in a message: "set the
/// same thing", or "set one section: …". Empty if both can be set. Sections of `a` are those of the scenario
/// `ofA`, sections of `b` those of `ofB`. The two scenarios may differ only in the number of repeats.
Message rivalProblem(std::string_view a, const Scenario& ofA, std::string_view b, const Scenario& ofB);

/// Two keys to be set that contradict each other, and the reason.
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

    /// Adds a key under the next number, 0 for the first. Keys that are no parameter are allowed.
    void add(std::string_view key);
    /// Skips one number: it has no key. The number may stand for a column of a table that sets no parameter.
    void skip();

    /// Returns the numbers of the keys in the order in which they must be set. The shape of the force, which
    /// decides what applies, and other keys that are not in the table of parameters are first. Physical
    /// parameters follow in the order of the table. For a drill string the repeat comes next, then sections
    /// by name, then sections by number. The groups, which change physical parameters, are last.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// Function that returns whether the key with the given number is set. If it is empty, all keys are set.
    using IsSet = std::function<bool(std::size_t)>;
    /// Returns the first two keys that contradict each other in every scenario, such as area and diameter.
    /// Returns nullopt if there are none. Only keys for which `isSet` is true count.
    std::optional<RivalPair> rivals(const IsSet& isSet = {}) const;
    /// Returns the first two keys that set the same section of this scenario: one by number and one by name,
    /// or both by numbers of copies in a repeat. Returns nullopt if there are none. Only keys for which
    /// `isSet` is true count. All values must already be assigned.
    std::optional<RivalPair> meeting(const Scenario& scenario, const IsSet& isSet = {}) const;

    /// Returns whether the hammer force may depend on the key with this number, because it begins with
    /// "pulse.", "rod.", "hammer.", "material." or "string.".
    bool movesPulse(std::size_t number) const;
    /// Returns whether the hammer force may depend on any of the keys, so that it must be computed again
    /// after they are set.
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

/// Returns the parameters whose values differ between the scenarios: those of the table of parameters, then
/// of corners of the loading curve, then of sections by position. At least one scenario must give the
/// parameter (isGiven()); values derived from others, such as groups, are left out. A number that rod and
/// string share, such as density, is listed once.
std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios);

}  // namespace drillwave

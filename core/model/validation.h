// SPDX-License-Identifier: GPL-3.0-or-later
// One pure check of a scenario that returns every problem at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/drill_string.h"
#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Problem of a scenario. Line and column are 1-based, 0 if it is not from a file.
struct InputProblem {
    std::string key;  ///< "bit_rock.gamma", may be empty
    Message text;     ///< "bit_rock.gamma = 1.3 (must be in (0, 1])"
    int line = 0;
    int column = 0;
    std::string source = {};  ///< the file it is in, where that is not the scenario file (a pulse table)
    /// "bit_rock.gamma must be in (0, 1]", without the value: for counts. Set by validate() only.
    Message reason = {};
    bool operator==(const InputProblem&) const = default;
};

/// Returns a problem from a key, its value or none where it has none, and a reason: "must be in (0, 1]".
InputProblem valueProblem(std::string_view key, std::string_view value, const Message& reason);

/// Returns every hard-range violation and inconsistency (rise + fall > 1, bore ≥ diameter, table times not
/// increasing, a hammer or string without sections, groups not finite or zero after conversion), physical
/// parameters first. Empty if the scenario can be solved.
std::vector<InputProblem> validate(const Scenario& scenario);

/// Returns all problems in one line, as the reason why the scenario is refused; empty if it is valid.
Message invalidity(const Scenario& scenario);

/// First reason why points are no hammer force, and its point (from 0).
struct PointProblem {
    std::size_t index = 0;
    Message reason;  ///< "point 3 must be later than the one before it"; empty when the points will do
};
PointProblem pointProblem(const TablePoints& points);

// Problems of the sections of a hammer and a string.

/// Returns every problem of the sections: none at all, too many, numbers out of range, names that are places,
/// a bore as wide as the section, derived values that overflow. Keys are by place ("string.3.bore").
std::vector<InputProblem> sectionProblems(const DrillString& drillString);

/// Returns the message on more than maximumSections of a string or a hammer.
Message tooManySections(std::uint64_t count);

}  // namespace drillwave

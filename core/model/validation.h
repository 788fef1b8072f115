// SPDX-License-Identifier: GPL-3.0-or-later
// Check of a scenario that returns all errors at once.
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

/// Error in a scenario. Line and column count from 1; they are 0 if the scenario is not from a file.
struct InputProblem {
    std::string key;  ///< key of the wrong value, "bit_rock.gamma"; may be empty
    Message text;     ///< message with key and value: "bit_rock.gamma = 1.3 (must be in (0, 1])"
    int line = 0;
    int column = 0;
    /// File with the error, if that is not the scenario file but a table of the hammer force; else empty.
    std::string source = {};
    /// Message without the value, "bit_rock.gamma must be in (0, 1]", by which studies count how often an
    /// error occurs. Set only by validate().
    Message reason = {};
    bool operator==(const InputProblem&) const = default;
};

/// Returns the error for a key with a wrong value. `value` may be empty; an example of `reason` is "must be
/// in (0, 1]".
InputProblem valueProblem(std::string_view key, std::string_view value, const Message& reason);

/// Returns all errors of a scenario, those of physical parameters first; empty if it can be solved. Errors
/// are values outside their allowed range, and contradictions such as bore ≥ diameter or rise + fall > 1.
/// Dimensionless groups that become infinite, NaN or zero when computed from the other parameters are errors
/// too.
std::vector<InputProblem> validate(const Scenario& scenario);

/// Returns all errors of a scenario as one message, "; " between them; empty if it is valid.
Message invalidity(const Scenario& scenario);

/// First error in a list of points (time, force) that is to be a hammer force, and the index of the wrong
/// point, from 0.
struct PointProblem {
    std::size_t index = 0;
    /// Reason why the points are no valid hammer force, "point 3 must be later than the one before it"; empty
    /// if they are valid.
    Message reason;
};
/// Returns the first error of the points of a tabulated hammer force; `reason` is empty if there is none.
PointProblem pointProblem(const TablePoints& points);

// Errors in the sections of a hammer and a drill string.

/// Returns all errors of the sections of hammer and string, with keys by position ("string.3.bore"). Such
/// errors are no sections or too many, a number outside its range, or a bore as wide as the section. Names
/// that could be read as a position, and derived values that overflow, are errors too.
std::vector<InputProblem> sectionProblems(const DrillString& drillString);

/// Returns the error message for a hammer or string with `count` sections, which is more than
/// maximumSections.
Message tooManySections(std::uint64_t count);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of parameters: scenario files, --set, sweep axes, CSV headers, form rows, tooltips and
// messages all take keys, symbols, units, ranges and meanings from here (files §2).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/model/scenario.h"
#include "core/text/units.h"

namespace drillwave {

/// A range of a parameter in SI. An open end is excluded.
struct Range {
    double low;
    double high;
    bool lowOpen = false;
    std::string_view whyNotMore = {};  ///< why there is an upper end, for messages; may be empty
    bool contains(double value) const;
    /// "in (0, 1]", "greater than 0", "at least 0", for messages.
    std::string text() const;
};

enum class SliderScale { linear, logarithmic };

/// Where a parameter belongs in a form or file: "rod", "pulse", "bit_rock", "drill" or "groups".
struct Parameter {
    std::string_view key;      ///< path in files and on the command line, e.g. "rod.length", "beta"
    std::string_view label;    ///< words for a form row, e.g. "length"
    std::string_view symbol;   ///< symbol of the paper, may be empty
    std::string_view meaning;  ///< one line, for tooltips and help
    Quantity quantity;
    std::string_view unit;  ///< customary unit for display and file output, e.g. "mm"
    Range hard;             ///< outside: the scenario is invalid
    Range plausible;        ///< outside: an alert; also the range of a slider
    SliderScale slider;
    /// Whether the parameter has a meaning in this scenario (form, pulse shape, area or diameter).
    bool (*applies)(const Scenario&);
    /// The value in SI, or nullopt where an optional parameter is not given. Requires applies().
    std::optional<double> (*value)(const Scenario&);
    /// Sets the value in SI (no range check). Groups of a dimensional scenario move the physical parameter
    /// (beta the stiffness, tau the rod length, delta the gap). Requires applies().
    void (*assign)(Scenario&, double);

    /// The customary unit.
    const Unit& displayUnit() const;
    std::string_view section() const;   ///< the part of the key before the dot; "groups" for the four groups
    std::string_view localKey() const;  ///< the part behind the dot: the key inside its section of a file
};

/// All numeric parameters, physical ones first, the groups last, in the order of scenario files.
std::span<const Parameter> parameters();

/// The parameter of that key, or nullptr.
const Parameter* findParameter(std::string_view key);

/// Whether the parameter is what the user gave, and not what follows from something else (the groups of a
/// dimensional scenario; the impulse where the mean force was given).
bool isGiven(const Parameter& parameter, const Scenario& scenario);

/// Why `value` (SI, finite or not) is outside the hard range: "must be in (0, 1]"; empty when it is inside.
std::string rangeProblem(const Parameter& parameter, double value);

/// Why the scenario does not hold `wanted` (SI) now that it was assigned: what is kept is the physical value
/// of a group, or the impulse of a force, and that may be at the end of double precision. "cannot be kept …";
/// empty when it reads back to 1e-12. Requires applies().
std::string readBackProblem(const Parameter& parameter, const Scenario& scenario, double wanted);

}  // namespace drillwave

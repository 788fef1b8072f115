// SPDX-License-Identifier: GPL-3.0-or-later
// Range of a study: a parameter from start to end, or with a list of values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Range of a parameter in a study: from `start` to `stop` (in SI), in equal steps or, if `logarithmic`, in
/// equal ratios.
struct StudyRange {
    KeptParameter parameter = {};
    double start = 0;
    double stop = 0;
    bool logarithmic = false;
    bool operator==(const StudyRange&) const = default;

    /// Returns the range as an argument of the command line, such as "bit_rock.stiffness=10 MN/m:10000 MN/m".
    /// The suffix of tail() and the number of values are left out. Reading the text gives the same doubles.
    std::string text() const;
    /// Returns ":log" for a logarithmic range, else an empty text.
    std::string tail() const { return logarithmic ? ":log" : ""; }
    /// Returns the number of values that a study of this range has, at most `most` (≥ 2). For a parameter of
    /// whole numbers, it is at most the number of whole numbers in the range.
    std::uint64_t pointsWithin(std::uint64_t most) const;
};

/// Returns a number rounded to four significant digits, as a user would type it.
double readable(double shown);

/// Returns the value nearest to `si` (in SI) that has one significant digit in the unit of the parameter.
double readableNear(const Parameter& parameter, double si);

/// Returns a range around the value of a parameter in the scenario. Its ends are round numbers within the
/// allowed range. Requires a parameter that applies to the scenario.
StudyRange rangeAround(const Parameter& parameter, const Scenario& scenario);

/// Returns a range like rangeAround(), for a study of many blows. A range of feed forces starts at f I0 less
/// the weight of the machine: blow frequency times impulse is the mean reaction. Below it the machine is
/// pushed back.
StudyRange rangeOfManyBlows(const Parameter& parameter, const Scenario& scenario);

/// Parameter with a list of values (in SI); a study draws one curve for each value.
struct StudyFamily {
    KeptParameter parameter = {};  ///< parameter; nullptr for none
    std::vector<double> values;
    bool operator==(const StudyFamily&) const = default;

    /// Returns parameter and values as an argument of the command line, such as "gamma=0.01,0.1,1"; empty if
    /// there is no parameter.
    std::string text() const;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Range of a study: a parameter from start to end, or over a list of values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

namespace drillwave {

/// A parameter from `start` to `stop` (SI), in even steps or in even ratios.
struct StudyRange {
    KeptParameter parameter = {};
    double start = 0;
    double stop = 0;
    bool logarithmic = false;
    bool operator==(const StudyRange&) const = default;

    /// Returns the words of the command line, "bit_rock.stiffness=10 MN/m:10000 MN/m", which read back as the
    /// same doubles; the suffix ":log" or a count is in tail().
    std::string text() const;
    /// ":log", or nothing.
    std::string tail() const { return logarithmic ? ":log" : ""; }
    /// Returns the number of values of a study that takes at most `most` (≥ 2); for whole numbers, as many as
    /// are whole numbers.
    std::uint64_t pointsWithin(std::uint64_t most) const;
};

/// In four digits, as one types it.
double readable(double shown);

/// The nearest value with one significant digit in the unit that the parameter is shown in.
double readableNear(const Parameter& parameter, double si);

/// A range around the value that a parameter has in the scenario, with ends that are easily read and inside
/// its hard range. Requires applies().
StudyRange rangeAround(const Parameter& parameter, const Scenario& scenario);

/// The same of a study of many blows: no thrust below their mean reaction f I0, which pushes the machine
/// back.
StudyRange rangeOfManyBlows(const Parameter& parameter, const Scenario& scenario);

/// A parameter with each of some values (SI).
struct StudyFamily {
    KeptParameter parameter = {};  ///< or none
    std::vector<double> values;
    bool operator==(const StudyFamily&) const = default;

    /// As on the command line, "gamma=0.01,0.1,1"; empty for none.
    std::string text() const;
};

}  // namespace drillwave

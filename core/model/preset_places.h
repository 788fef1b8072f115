// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a varied parameter that presets have.
#pragma once

#include <span>
#include <vector>

#include "core/model/preset.h"
#include "core/text/message.h"

namespace drillwave {

/// Value that a parameter has if a preset is used, with the name of the preset, for a mark in a plot over
/// this parameter.
struct PresetPlace {
    Message name;   ///< name of the preset, or names of several
    double si = 0;  ///< value of the parameter with the preset, in SI
    bool operator==(const PresetPlace&) const = default;
};

/// Returns the values that a parameter has after applying each preset, ascending, for marks in a plot.
/// Included are presets that set this parameter, or one that determines it: the stiffness determines β.
/// Presets with equal values are joined into one item, with the names of the first two. Empty for a
/// dimensionless scenario, which cannot use presets. Requires a parameter that applies to the scenario.
std::vector<PresetPlace> presetPlaces(std::span<const Preset> presets, const Parameter& parameter,
                                      const Scenario& scenario);

/// Preset as a mark in a contour map over two parameters: its name and its values of both parameters.
struct PresetPoint {
    Message name;
    double x = 0;  ///< value of the first parameter in SI
    double y = 0;  ///< value of the second parameter in SI
    bool operator==(const PresetPoint&) const = default;
};

/// Returns the presets that set both parameters `x` and `y`, with their values. A contour map over `x` and
/// `y` shows them as marks.
std::vector<PresetPoint> presetPoints(std::span<const Preset> presets, const Parameter& x, const Parameter& y,
                                      const Scenario& scenario);

}  // namespace drillwave

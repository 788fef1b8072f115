// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a varied parameter that presets have.
#pragma once

#include <span>
#include <vector>

#include "core/model/preset.h"
#include "core/text/message.h"

namespace drillwave {

/// Value that a parameter has in a scenario if a preset is used, with the name of the preset.
struct PresetPlace {
    Message name;   ///< name of the preset, or names of several
    double si = 0;  ///< value of the parameter with the preset, in SI
    bool operator==(const PresetPlace&) const = default;
};

/// Returns the presets that set a parameter (or one that determines it, as the stiffness determines β), by
/// ascending value. Presets with equal values are joined, with the names of the first two. Empty for a
/// dimensionless scenario, which cannot use presets. Requires a parameter that applies to the scenario.
std::vector<PresetPlace> presetPlaces(std::span<const Preset> presets, const Parameter& parameter,
                                      const Scenario& scenario);

/// Preset as a point of a map over two parameters.
struct PresetPoint {
    Message name;
    double x = 0;  ///< value of the first parameter in SI
    double y = 0;  ///< value of the second parameter in SI
    bool operator==(const PresetPoint&) const = default;
};

/// Returns the presets that set both parameters, with their values.
std::vector<PresetPoint> presetPoints(std::span<const Preset> presets, const Parameter& x, const Parameter& y,
                                      const Scenario& scenario);

}  // namespace drillwave

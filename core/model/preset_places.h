// SPDX-License-Identifier: GPL-3.0-or-later
// Values of presets along a parameter that a study varies.
#pragma once

#include <span>
#include <vector>

#include "core/model/preset.h"
#include "core/text/message.h"

namespace drillwave {

/// A preset's value of a parameter in a scenario.
struct PresetPlace {
    Message name;   ///< of the preset
    double si = 0;  ///< the value of the parameter with the preset taken
    bool operator==(const PresetPlace&) const = default;
};

/// The presets that set a parameter, or what it follows from (β the stiffness), by ascending value. Several
/// of one value are one place with the names of the first two. None in a dimensionless scenario, where
/// presets have no meaning. Requires applies().
std::vector<PresetPlace> presetPlaces(std::span<const Preset> presets, const Parameter& parameter,
                                      const Scenario& scenario);

/// A preset as a point of a map.
struct PresetPoint {
    Message name;
    double x = 0;  ///< SI
    double y = 0;  ///< SI
    bool operator==(const PresetPoint&) const = default;
};

/// The presets that set both parameters.
std::vector<PresetPoint> presetPoints(std::span<const Preset> presets, const Parameter& x, const Parameter& y,
                                      const Scenario& scenario);

}  // namespace drillwave

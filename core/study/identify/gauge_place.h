// SPDX-License-Identifier: GPL-3.0-or-later
// Where a gauge is on rod or string, and what lies between it and the rock.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/study/identify/chain_model.h"
#include "core/text/message.h"

namespace drillwave {

/// A section of the string towards the bit, whose sizes a fit may vary.
struct SizedSection {
    std::string name;      ///< "bit head", "section 7" where it has none
    std::string key;       ///< "string.bit_head" or "string.7", without its field
    double length = 0;     ///< [m]
    double impedance = 0;  ///< mean [N s/m]
    bool isGivenByArea = false;
    double diameter = 0, bore = 0;  ///< [m] at its near end; diameter of a full bar where given by area
};

/// Place of a gauge on the uniform part of one section.
struct GaugePlace {
    SizedSection section;                  ///< that the gauge is on
    std::size_t index = 0;                 ///< of that section, from 0 at the struck end
    double waveSpeed = 0;                  ///< c there [m/s]
    double axialStiffness = 0;             ///< E A [N]
    double youngsModulus = 0;              ///< [Pa]
    double attenuation = 0;                ///< α [1/m]
    double ahead = 0;                      ///< a, to the far end of the section [m]
    double behind = 0;                     ///< to its near end [m]
    double fromStruckEnd = 0;              ///< x [m]
    std::vector<SizedSection> towardsBit;  ///< sections between gauge and rock
    RockEnd end;                           ///< the same as the model takes them
};

/// The place that far from the bit face of a valid scenario with units; nothing where that is not on the
/// string, or on a cone.
std::optional<GaugePlace> gaugePlace(const Scenario& scenario, double distance);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Position of a strain gauge on the rod or string, and the sections between it and the rock.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/study/identify/chain_model.h"
#include "core/text/message.h"

namespace drillwave {

/// Section of rod or string whose sizes (length, diameters) a fit may change within their tolerances.
struct SizedSection {
    std::string name;  ///< name for messages, such as "bit head"; "section 7" if the section has no name
    /// Key of the section in scenario files, without a field name after it, such as "string.bit_head".
    std::string key;
    double length = 0;     ///< length of the section [m]
    double impedance = 0;  ///< mean characteristic impedance [N s/m]
    bool isGivenByArea = false;
    /// Outer and inner diameter [m], at the hammer end of a conical section. If only the area is given,
    /// `diameter` is that of a solid bar.
    double diameter = 0, bore = 0;
};

/// Position of a strain gauge on a uniform section of rod or string.
struct GaugePlace {
    SizedSection section;                  ///< section that the gauge is on
    std::size_t index = 0;                 ///< index of that section, from 0 at the struck end
    double waveSpeed = 0;                  ///< wave speed c of that section [m/s]
    double axialStiffness = 0;             ///< axial stiffness E A [N]
    double youngsModulus = 0;              ///< Young's modulus [Pa]
    double attenuation = 0;                ///< amplitude decay α of waves per length [1/m]
    double ahead = 0;                      ///< distance a from the gauge to the bit end of its section [m]
    double behind = 0;                     ///< distance from the gauge to the hammer end of its section [m]
    double fromStruckEnd = 0;              ///< distance x from the struck end of rod or string [m]
    std::vector<SizedSection> towardsBit;  ///< sections between the gauge's section and the rock
    RockEnd end;                           ///< the same sections in the form used by the wave model
};

/// Returns the position of a strain gauge on rod or string at a distance [m] from the bit face. Empty if that
/// point is not on the string or is on a cone. Requires a valid scenario with units.
std::optional<GaugePlace> gaugePlace(const Scenario& scenario, double distance);

}  // namespace drillwave

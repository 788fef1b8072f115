// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of a uniform rod to a drill string, and back.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Scenario after conversion to another form.
struct Conversion {
    Scenario scenario;
    /// Sentences on features of the original that the converted scenario lacks or only approximates.
    std::vector<Message> lost;
};

/// Returns a rod as a section of a drill string. The section has its own material only if that of the rod
/// differs from `material`.
Section sectionOf(const Rod& rod, const Material& material);

/// Returns why a scenario cannot be converted to a drill string: it is one already, it has no units, or it
/// has no hammer. Empty if it can.
Message whyNoString(const Scenario& scenario);

/// Returns the rod as the only section of a drill string under the same force, of any shape. Requires a
/// uniform rod with units.
Scenario oneSectionOf(const Scenario& scenario);

/// Returns the rod as a drill string of one section. A piston becomes a hammer whose motion is simulated. A
/// rectangular force becomes a hammer of the same impulse, with the impedance Z of the rod and the length c
/// t0/2. Other forces stay as they are. With a hammer, lengths are rounded by roundedLength(), and the hammer
/// does not strike again after it has separated. Except for this rounding, a rectangular force gives the same
/// results as for the uniform rod. So does a piston whose impedance is at most that of the rod (theory of
/// strings, §10). Requires whyNoString() to be empty.
Conversion stringOf(const Scenario& scenario);

/// Returns the scenario of a drill string with its hammer replaced by a prescribed force. The force is that
/// of a uniform piston with the mass, velocity and transit time of the hammer. Requires a drill string that
/// is struck by a hammer.
Conversion forcedStringOf(const Scenario& scenario);

/// Returns the scenario under a prescribed force: the result of forcedStringOf() if a hammer of sections
/// strikes, otherwise the scenario unchanged.
Scenario withForce(const Scenario& scenario);

/// Returns a drill string converted to a uniform rod. Sizes and material are those of ruleSection(), the
/// transit time is that of the whole string. A prescribed force remains. A hammer is replaced by the force of
/// a uniform piston with its mass, velocity and transit time. Requires a drill string.
Conversion uniformRodOf(const Scenario& scenario);

// Conversion of dimensionless groups to a rig with the same groups.

/// Rod, mean force and duration that turn a dimensionless scenario into one with physical units.
struct RigChoice {
    /// Rod that gives cross-section, material and strengths of the new scenario. Its length is ignored; the
    /// new length is τ c t0.
    Rod rod;
    double meanForce = 255e3;  ///< mean hammer force F0 [N]
    double duration = 200e-6;  ///< duration of the hammer force t0 [s]
};

/// Returns a scenario in physical units with the groups, shape of the force and loading curve of a
/// dimensionless one. Uses L = τ c t0, I0 = F0 t0, k = β Z/t0 and d = 2 δ I0/Z. A piston gets the material of
/// the rod. Points of a force table are copied into the scenario. Requires a dimensionless scenario and
/// positive values.
Scenario rigOf(const Scenario& groups, const RigChoice& choice);

}  // namespace drillwave

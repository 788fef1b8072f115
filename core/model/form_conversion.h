// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of a uniform rod to a drill string, and back.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Scenario after conversion to another form, for example from a uniform rod to a drill string.
struct Conversion {
    Scenario scenario;
    /// Sentences that describe what the converted scenario lacks or only approximates, compared with the
    /// original one.
    std::vector<Message> lost;
};

/// Returns a rod as a section of a drill string. The section has its own material only if that of the rod
/// differs from `material`.
Section sectionOf(const Rod& rod, const Material& material);

/// Returns why a scenario cannot be converted to a drill string: it is one already, it has no units, or it
/// has no hammer. Empty if it can.
Message whyNoString(const Scenario& scenario);

/// Returns the scenario as a drill string with the rod as its only section. The hammer force remains, of any
/// shape. Requires a uniform rod in physical units.
Scenario oneSectionOf(const Scenario& scenario);

/// Returns the uniform rod converted to a drill string of one section. A piston becomes a hammer whose motion
/// is simulated. A rectangular force becomes a hammer of the same impulse, with the impedance Z of the rod
/// and the length c t0/2. Other forces remain prescribed. With a hammer, lengths are rounded by
/// roundedLength(), and the hammer does not strike again after it has separated. Apart from this rounding, a
/// rectangular force gives the same results as the uniform rod. This also holds for a piston whose impedance
/// is at most that of the rod (theory of strings, §10). Requires whyNoString() to be empty.
Conversion stringOf(const Scenario& scenario);

/// Returns the scenario of a drill string with its hammer replaced by a prescribed force. The force is that
/// of a uniform piston with the mass, velocity and transit time of the hammer. Requires a drill string that
/// is struck by a hammer.
Conversion forcedStringOf(const Scenario& scenario);

/// Returns the scenario under a prescribed force: the result of forcedStringOf() if a hammer of sections
/// strikes, otherwise the scenario unchanged.
Scenario withForce(const Scenario& scenario);

/// Returns a drill string converted to a uniform rod with the transit time of the whole string. Its
/// cross-section and material are those of ruleSection(). A prescribed force remains. A hammer is replaced by
/// the force of a uniform piston with its mass, velocity and transit time. Requires a drill string.
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

/// Returns a scenario in physical units that has the given dimensionless groups, shape of the force and
/// loading curve. Its rod length is L = τ c t0, its impulse I0 = F0 t0, its stiffness k = β Z/t0 and its gap
/// d = 2 δ I0/Z. A piston gets the material of the rod. Points of a force table are stored in the scenario
/// instead of a file. Requires a dimensionless scenario and positive values.
Scenario rigOf(const Scenario& groups, const RigChoice& choice);

}  // namespace drillwave

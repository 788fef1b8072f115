// SPDX-License-Identifier: GPL-3.0-or-later
// From a uniform rod to a drill string, and back.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// A scenario in another form.
struct Conversion {
    Scenario scenario;
    std::vector<Message> lost;  ///< sentences on what it no longer contains, or not exactly
};

/// Returns a rod as a section of that name; sets its own material only if it differs from `material`.
Section sectionOf(const Rod& rod, const Material& material);

/// Returns why a scenario cannot be a string: it has no units, or no hammer. Empty if it can.
Message whyNoString(const Scenario& scenario);

/// Returns the rod as the only section of a string under the same force, of any shape. Requires a uniform rod
/// with units.
Scenario oneSectionOf(const Scenario& scenario);

/// Returns the rod as a string of one section under the same force. A piston becomes a hammer whose motion is
/// simulated. A rectangular blow becomes a hammer of the same impulse, with the impedance Z of the rod and
/// the length c t0/2, to whole millimetres. The hammer does not strike again once it has separated. So
/// results are those of the uniform rod for a rectangular blow, and for a piston of no larger impedance than
/// the rod (theory of strings, §10). Requires whyNoString() to be empty.
Conversion stringOf(const Scenario& scenario);

/// Returns the same string under the force of a uniform piston with the mass, velocity and wave travel time
/// of its hammer. Requires a string that is struck by a hammer.
Conversion forcedStringOf(const Scenario& scenario);

/// Returns the scenario of forcedStringOf() if a hammer of sections strikes, else the scenario itself.
Scenario withForce(const Scenario& scenario);

/// Returns a uniform rod with the sizes and the material of the ruleSection() and the wave travel time of the
/// string, under the same force, or struck by a uniform piston with the mass, the velocity and the wave
/// travel time of the hammer.
/// Requires a string.
Conversion uniformRodOf(const Scenario& scenario);

// From dimensionless groups to a rig with the same groups.

/// Rod, force and duration, which the groups leave open.
struct RigChoice {
    Rod rod;                   ///< cross-section, material and strengths; its length follows from τ
    double meanForce = 255e3;  ///< F0 [N]
    double duration = 200e-6;  ///< t0 [s]
};

/// Returns the scenario in physical units with the groups, the shape of the blow and the loading curve of a
/// dimensionless one: L = τ c t0, I0 = F0 t0, k = β Z/t0, d = 2 δ I0/Z. A piston has the material of the rod.
/// The scenario contains the points of a table. Requires a dimensionless scenario and positive values.
Scenario rigOf(const Scenario& groups, const RigChoice& choice);

}  // namespace drillwave

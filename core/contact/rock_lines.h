// SPDX-License-Identifier: GPL-3.0-or-later
// The loading lines that a scenario gives the law of bit and rock (files §1.4).
#pragma once

#include "core/contact/bit_rock_law.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Gives the law the loading lines of the scenario, beside its β and γ. Requires a valid scenario.
void setLines(BitRockLaw& law, const Scenario& scenario);

/// Gives the law the lines of F = βU (U/U1)^(p − 1), U1 = `reference` > 0 in I0/Z, 0.3 ≤ p ≤ 3: straight
/// between the nodes U1 2^(i/4), i = −32 … 31, from zero to the first and on behind the last, and nowhere
/// steeper than β/γ (theory §1.1). So every solver follows the same law; the force is the power's to 0.38 %
/// of |p (p − 1)| and at U1 exactly. For p = 1 the law is bilinear.
void setPowerLines(BitRockLaw& law, double exponent, double reference);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// What can be seen of a hammer force: the tails of an exponential blow and of a staircase are long and empty.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"

namespace drillwave {

/// Times t/t0, ascending from 0, at which a curve of the impulse of the hammer is drawn: it is smooth inside
/// a segment. Only 0 in the reference case.
std::vector<double> impulseTimes(const PulseForce& pulse);

/// The first of these times [t0] at which the rod has practically the whole impulse: what follows cannot be
/// seen in a curve of the impulse or the momentum. 0 in the reference case.
double visibleImpulseEnd(const PulseForce& pulse);

/// The end [t0] of the segment in which that happens, of an exponential one just the time of it: what follows
/// cannot be seen among the waves, which show a segment from front to end. 0 in the reference case.
double visibleWavesEnd(const PulseForce& pulse);

/// Until when [t0] the curve of the force itself can be told from zero. 0 in the reference case.
double visibleForceEnd(const PulseForce& pulse);

}  // namespace drillwave

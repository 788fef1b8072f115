// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the recorded histories of an impact the state of any time is found.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

// Of an impact solved with Detail::histories. Times s are counted at the front end from impact.frontArrival,
// in t0; recorded times are those of impact.incident and impact.force, which leave out impact.skips and end
// where nothing but a repetition with the round trip 2τ follows.

/// The recorded time at which g and F are those of time s; s itself before the recording begins.
double recordedTime(const Impact& impact, double s);

/// For how long after s the recording can be followed without a jump to another part of it.
double uninterrupted(const Impact& impact, double s);

/// Duration of the periods left out before a recorded time.
double unrecordedBefore(const Impact& impact, double recorded);

/// g at times s < 0: the uniform wave 1/(2τ) of the reference case before first contact; 0 where a hammer
/// blow arrives later.
double waveBeforeArrival(const Impact& impact);

}  // namespace drillwave

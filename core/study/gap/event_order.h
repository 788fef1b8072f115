// SPDX-License-Identifier: GPL-3.0-or-later
// In which order things happen at the bit: what must change where a result has a kink.
#pragma once

#include <cstdint>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Returns a fingerprint of the sequence of events of a blow and of their order with the arrivals of the
/// fronts that the hammer force and earlier events send through the rod (multiples of 2τ later). While it
/// stays the same under a change of a parameter, results depend smoothly on it. Requires an impact solved
/// with Detail::events or more. Uses the first 32 events beside corners, the corners passed until then, and
/// 64 pieces of the hammer force.
std::uint64_t eventOrder(const Impact& impact, const PulseForce& pulse);

}  // namespace drillwave

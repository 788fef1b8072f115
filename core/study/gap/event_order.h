// SPDX-License-Identifier: GPL-3.0-or-later
// Order of the events at the bit during a blow. Results can only have a kink where this order changes.
#pragma once

#include <cstdint>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Returns a fingerprint (hash) of the order of events of a blow, including the arrivals of wave fronts at
/// the bit. While a parameter changes and the fingerprint does not, the results change smoothly, without a
/// kink.
/// Fronts start with the hammer force and earlier events and arrive multiples of 2τ later. Uses the first 32
/// events, the corners of the rock law passed until then, and 64 pieces of the hammer force. Requires an
/// impact solved with Detail::events or more.
std::uint64_t eventOrder(const Impact& impact, const PulseForce& pulse);

}  // namespace drillwave

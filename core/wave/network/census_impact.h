// SPDX-License-Identifier: GPL-3.0-or-later
// What a census tells of a blow: balances, rock and face.
#pragma once

#include "core/wave/impact.h"
#include "core/wave/network/census.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Energies, momenta and records at the time of the census; the rest is left as it is.
Impact impactOf(const Problem& problem, const CensusResult& census);

}  // namespace drillwave

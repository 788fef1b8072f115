// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces at every place of hammer and string while a blow lasts (strings §7).
#pragma once

#include <cstddef>
#include <limits>
#include <stop_token>
#include <vector>

#include "core/wave/impact.h"
#include "core/wave/network/string_waves.h"

namespace drillwave {

/// The largest compression and tension at the place ξ of a section until the blow is over, and from there to
/// `until`, and when; all have that place. One merge of the two waves that pass there, exact for their
/// cubics; at a jump both sides count, and where two meet all four.
SectionForces largestForcesAt(const StringWaves& waves, std::size_t section, double xi, double endOfBlow,
                              double until = std::numeric_limits<double>::infinity());

/// Those of one section at places in order, its ends among them.
using SectionEnvelope = std::vector<SectionForces>;

/// How fine an envelope is, and what it may cost.
struct EnvelopeGrid {
    int places = 400;             ///< in hammer and string, about, shared out by transit time
    int leastOfSection = 8;       ///< of a short one
    long mostSteps = 20'000'000;  ///< cells to be looked at; with more there are fewer places
};

/// Of every section, the rear of the hammer first. Where the largest forces of a section are known
/// (impact.sections), their places are among those of the envelope, and nothing is larger in a section that
/// is one uniform piece: the waves that were kept may be less exact. Requires waves that were kept. A stop
/// ends the work early: the sections that are left have no places.
std::vector<SectionEnvelope> stringEnvelope(const Impact& impact, const std::stop_token& stop = {},
                                            const EnvelopeGrid& grid = {});

}  // namespace drillwave

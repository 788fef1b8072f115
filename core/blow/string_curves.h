// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a drill string over time: at the bit, at the face of the hammer, and at a place in between.
#pragma once

#include <vector>

#include "core/model/drill_string.h"
#include "core/wave/field/rod_state.h"
#include "core/wave/impact.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/problem.h"

namespace drillwave {

/// A place in hammer or string; a uniform rod is one section.
struct StringPlace {
    std::size_t section = 0;  ///< of allSections()
    double share = 0;         ///< ξ, 0 at its rear end … 1
    bool operator==(const StringPlace&) const = default;
};

/// Where the rear of the hammer is, in lengths of the string from the shank: below 0, of one with a hammer.
double hammerRear(const DrillString& drillString);

/// The place at a share of the length of the string, 0 at the shank … 1 at the bit, below 0 in the hammer.
StringPlace stringPlace(const DrillString& drillString, double share);

/// The other way round.
double shareOfString(const DrillString& drillString, const StringPlace& place);

/// The middle of the longest section of the string, of the first where several are as long; of a rod.
StringPlace middleOfLongest(const DrillString& drillString);

/// Reads a blow whose waves were kept; it must outlive this.
class StringHistory {
  public:
    StringHistory(const Impact& impact, const Problem& problem, const StringPlace& place);

    RodState at(double time, TimeSide side = TimeSide::after) const;
    double end() const { return m_waves->end(); }
    /// From 0 to end(), a time twice where something jumps; chords follow the curves to about 1e-4 F0.
    std::vector<RodState> sampled() const;

  private:
    std::vector<double> pieceTimes() const;

    const Impact* m_impact;
    const Problem* m_problem;
    const StringWaves* m_waves;
    StringPlace m_place;
};

}  // namespace drillwave

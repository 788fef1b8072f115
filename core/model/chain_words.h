// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the subject of a scenario: its uniform rod, or its hammer and drill string.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// Sentences and labels that differ between a uniform rod and a drill string, in English and marked for
/// translation.
struct ChainWords {
    const char* kind;         ///< name of the kind of scenario, "uniform rod"
    const char* assumptions;  ///< sentence on what the model neglects
    /// Sentence that explains the symbols by which tables divide energies and momenta to get shares: "W is
    /// the work of the hammer."
    const char* references;
    const char* errors;  ///< sentence on what the stated errors of results include and leave out
    /// Label "pulse %1" for the shape of the hammer force; it follows the values of the dimensionless groups.
    /// Empty for a drill string, which the groups do not describe completely.
    const char* pulse = "";
    /// Sentence with the coefficient of restitution e as %1: "The rod rebounds with e = %1." Empty for a
    /// drill string, for which e is not a main result.
    const char* rebound = "";
    const char* stresses;  ///< title of the largest stresses
    /// Words for the default position of histories of force and velocity, "at the middle of the rod".
    const char* historyPlace;
    const char* blowCaption;    ///< caption of the histories over time, with their position as %1
    const char* stressCaption;  ///< caption of the largest stresses along the rod or string
    const char* place;          ///< text for a position along the rod or string, "%1 from the struck end"
    const char* peakPlace;      ///< text for the position %1 and time %2 of a largest stress
    const char* beyondEnd;      ///< message that a position is beyond the end, with the length as %1
};
const ChainWords& chainWords(const Scenario& scenario);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of files §4 for one solved blow, dimensionless.
#pragma once

#include <optional>

#include "core/blow/energy_ledger.h"
#include "core/blow/string_summary.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Everything of files §4, dimensionless.
struct ImpactSummary {
    double cor = 0;
    double impulse = 0;
    double peakForce = 0;            ///< F0
    double maxPenetration = 0;       ///< d0
    double residualPenetration = 0;  ///< d0
    double firstContactTime = 0;     ///< t0
    double separationTime = 0;       ///< t0
    double contactDuration = 0;      ///< t0
    double workRatio = 0;            ///< W/W0 [paper (2)]
    EnergyLedger energy;
    double momentumResidual = 0;  ///< of I0
    double corError = 0;
    double growth = 1;                         ///< Impact::growth
    int contacts = 0;                          ///< separate contacts
    std::optional<int> forcePeaks;             ///< forcePeaks(), where the histories were kept
    std::optional<RodForces> rodForces;        ///< [F0] where they were asked for; solveBlow() does
    std::optional<StringSummary> string = {};  ///< of a drill string alone

    /// What the hammer hands on, in I0: of a drill string the impulse of its face, else all of it.
    double transferred() const { return string ? string->faceImpulse : 1; }
};

/// Of an impact solved with Detail::ledger or more. From one of less detail what that asks for means
/// something; the rest is not a number or zero. From Detail::cor only `cor`, `impulse` and `corError` mean
/// anything.
ImpactSummary summarize(const Impact& impact, const Problem& problem);

/// Which numbers of the waves are wanted: each takes some time.
struct WaveNumbers {
    bool forcePeaks = true;
    RodForceChoice forces = {};
};

/// The same with the peaks of the impact force and the largest forces in the rod that are wanted where the
/// impact was solved with Detail::histories.
ImpactSummary summarizeWithWaves(const Impact& impact, const Problem& problem,
                                 const WaveNumbers& wanted = {});

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// A blow as the window needs it: asked for once, solved once, shared by everything that shows it.
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/blow/feed_verdict.h"
#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/model/validation.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/field/rod_forces.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/pages/rock/rock_curve.h"
#include "ui/pages/wave_picture/wave_picture.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// What is wanted. Pages that can be seen add what they need; the rest is not computed.
struct SolveRequest {
    Scenario scenario;
    UnitSystem units = UnitSystem::dimensionless;
    std::optional<double> section;  ///< x/L of the waves to be plotted, when the curves are wanted
    bool rock = false;              ///< whether the path in the force–penetration plane is wanted
    std::optional<WavePictureNeed> picture;
    std::uint64_t number = 0;   ///< counts what was asked: tells the answer to the last question
    std::stop_token stop = {};  ///< ends the work early, with a problem for an answer
};

/// The answer, never changed once made. `problem` is empty when the blow was solved; otherwise it says in a
/// sentence why not, and the numbers are not to be used.
struct SolvedBlow {
    SolveRequest request;
    QString problem;
    Groups groups;
    Scales scales;
    ShownUnits units;
    PulseForce pulse;
    Impact impact;
    ImpactSummary summary;
    RodForces rodForces;
    std::optional<FeedVerdict> feed;  ///< when a blow frequency is given
    std::vector<Alert> alerts;
    double runTime = 0;  ///< of the solve alone [s]
    std::optional<BlowCurves> curves;
    std::optional<RockCurve> rock;
    std::optional<WavePicture> picture;
};
using SolvedBlowPtr = std::shared_ptr<const SolvedBlow>;

/// Solves and prepares what was asked for. Never throws: whatever goes wrong is the answer's `problem`.
SolvedBlowPtr solveBlow(const SolveRequest& request, ExactSolver& solver) noexcept;

/// An answer that only says why there is none.
SolvedBlowPtr failedBlow(const SolveRequest& request, const QString& problem);

}  // namespace drillwave

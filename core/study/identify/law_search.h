// SPDX-License-Identifier: GPL-3.0-or-later
// Search for the solution of a rock law, from many start values or from the solution of another law.
#pragma once

#include <stop_token>

#include <Eigen/Core>

#include "core/study/identify/law_fit.h"

namespace drillwave {

/// Returns the largest force on the rock in the solution of a fit [N].
double largestForce(RecordModel& model, const LawFit& fit);

/// Returns the best fit from many start values. Fits the bilinear law, or only the timing of the scenario's
/// law. Section sizes and dispersion are fitted only after the best start is known. The weights of the
/// samples between blow and reflection are adapted to the waves found there.
LawFit fitFromStarts(RecordModel& model, const std::stop_token& stop);

/// Fits the bilinear law to a record, starting from `values`. These are the unknowns of the model `from`,
/// which has the same record but another transit time. Updates `values` and returns Σr².
double fitAgain(RecordModel& model, const RecordModel& from, Eigen::VectorXd& values,
                const std::stop_token& stop);

/// Replaces the solution by the lowest minimum of Σr² near it. Stores other minima and the best solutions for
/// other gaps in LawFit::nearby. These are needed because gap, zero lines and stiffness together can explain
/// a record in two ways. Towards another gap, Σr² rises less than its curvature at the minimum suggests.
void searchMinima(RecordModel& model, LawFit& fit, const std::stop_token& stop);

/// Returns the fit of another law, started from the solution of the bilinear one. `isFarOff` means that the
/// bilinear law does not fit the record. Its dispersion and its waves between blow and reflection are then
/// not reliable and are fitted again.
LawFit fitFrom(RecordModel& model, RecordModel& bilinear, const LawFit& from, bool isFarOff,
               const std::stop_token& stop);

/// Returns the fit of a law that includes the bilinear one, started at and near the bilinear solution. Both
/// models must have the same record.
LawFit fitNearby(RecordModel& model, RecordModel& bilinear, const LawFit& from, const std::stop_token& stop);

/// Repeats the fit of a model, starting from an existing solution, and stores the new solution in `fit`.
void refit(RecordModel& model, LawFit& fit, const std::stop_token& stop);

}  // namespace drillwave

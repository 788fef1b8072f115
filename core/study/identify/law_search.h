// SPDX-License-Identifier: GPL-3.0-or-later
// Search for the solution of a rock law, from many start values or from the solution of another law.
#pragma once

#include <stop_token>

#include <Eigen/Core>

#include "core/study/identify/law_fit.h"

namespace drillwave {

/// Returns the largest force on the rock [N] in the solution of a fit.
double largestForce(RecordModel& model, const LawFit& fit);

/// Returns the best fit from many start values. Fits the bilinear law, or with TrialLaw::held only timing and
/// disturbances. Section sizes and dispersion are fitted only after the best start is known. The weights of
/// the samples between blow and reflection are adapted to the stray waves found there.
LawFit fitFromStarts(RecordModel& model, const std::stop_token& stop);

/// Fits the bilinear law to a record again after a change of the transit time between its gauges. Before the
/// call, `values` are a solution of the model `from`, which has the old transit time. Stores the new solution
/// in `values` and returns its sum of squared residuals Σr².
double fitAgain(RecordModel& model, const RecordModel& from, Eigen::VectorXd& values,
                const std::stop_token& stop);

/// Searches other minima of Σr² near the solution, because gap, zero lines and stiffness together can explain
/// a record in two ways. The lowest minimum becomes the solution. Other minima, and the best solutions for
/// other gaps, are stored in LawFit::nearby.
void searchMinima(RecordModel& model, LawFit& fit, const std::stop_token& stop);

/// Returns the fit of another law, started from the solution `from` of the bilinear law. `isFarOff` means
/// that the bilinear law does not fit the record. Its dispersion and stray waves are then not reliable and
/// are fitted again.
LawFit fitFrom(RecordModel& model, RecordModel& bilinear, const LawFit& from, bool isFarOff,
               const std::stop_token& stop);

/// Returns the fit of a law that contains the bilinear law as a special case, started at and near the
/// bilinear solution `from`. Both models must have the same record.
LawFit fitNearby(RecordModel& model, RecordModel& bilinear, const LawFit& from, const std::stop_token& stop);

/// Fits the model again, starting from the solution in `fit`, and replaces it by the new solution.
void refit(RecordModel& model, LawFit& fit, const std::stop_token& stop);

}  // namespace drillwave

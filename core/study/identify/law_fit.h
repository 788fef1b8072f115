// SPDX-License-Identifier: GPL-3.0-or-later
// Least-squares fit of one rock law to one record, and the sensitivity of its solution to changes of the
// record.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include <Eigen/Core>

#include "core/study/identify/record_model.h"

namespace drillwave {

/// Alternative solution that fits a record almost as well as the best one.
struct NearbySolution {
    Eigen::VectorXd values;
    /// Rise of the sum of squared residuals Σr² above the lowest one, relative to the mean of r².
    double rise = 0;
    /// Whether the solution is a separate minimum of Σr². Otherwise it is the best solution for a given other
    /// gap.
    bool isMinimum = false;
};

/// Solution of a fit and its linearisation: changes δr of the residuals change the unknowns by −J⁺δr. J⁺ is
/// the pseudo-inverse of the Jacobian J.
class LawFit {
  public:
    LawFit() = default;

    TrialLaw law = TrialLaw::bilinear;
    Eigen::VectorXd values;  ///< fitted values, in the order and units of RecordModel::unknowns()
    Eigen::VectorXd residuals;
    double cost = 0;  ///< sum of squared weighted residuals, Σr²
    std::vector<NearbySolution> nearby;

    /// Computes and stores the Jacobian at the solution; required before the functions below.
    void linearise(RecordModel& model);
    /// Returns the change −J⁺δr of the unknowns for a change δr (`change`) of the residuals. Unknowns that
    /// are held fixed do not change.
    Eigen::VectorXd movedBy(const Eigen::VectorXd& change) const;
    /// Returns the change of the unknowns for a change δr (`change`) of the residuals if the gap is held
    /// fixed.
    Eigen::VectorXd movedWithoutGap(const Eigen::VectorXd& change) const;
    /// Returns δr + Jδθ: the part of a change δr (`change`) of the residuals that remains after the unknowns
    /// have changed by δθ (`moved`).
    Eigen::VectorXd left(const Eigen::VectorXd& change, const Eigen::VectorXd& moved) const;
    /// Returns the change of all unknowns if the mean of the prior of one unknown is raised by its 95 %
    /// tolerance.
    Eigen::VectorXd movedByPrior(const RecordModel& model, std::size_t unknown) const;
    /// Returns the derivative of all residuals with respect to one unknown, per unit of that unknown.
    Eigen::VectorXd column(std::size_t unknown) const;
    std::size_t unknownCount() const { return static_cast<std::size_t>(values.size()); }

  private:
    void factorise(std::size_t without, Eigen::MatrixXd& inverse) const;
    Eigen::VectorXd moved(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& change) const;

    Eigen::MatrixXd m_jacobian;  ///< Jacobian multiplied by the step of each unknown, one column each
    Eigen::VectorXd m_steps;
    Eigen::MatrixXd m_inverse, m_inverseWithoutGap;
};

/// Model of a record with its fit. Both are empty if no fit was made.
struct ModelFit {
    std::shared_ptr<RecordModel> model;
    LawFit fit;
};

/// Returns the start values of the unknowns for a search.
Eigen::VectorXd startValues(const RecordModel& model);

/// Minimises the sum of squared residuals Σr² by the Levenberg–Marquardt method within the bounds, starting
/// from `values`. Updates `values` and returns Σr². Takes at most `mostRounds` iterations.
double minimise(RecordModel& model, Eigen::VectorXd& values, int mostRounds, const std::stop_token& stop);

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

/// RMS [N] of waves between blow and reflection: below 6.6 kHz, beyond noise, without the zero line.
struct QuietErrors {
    double before = 0;  ///< RMS of waves until 120 µs before the incident wave is taken to end [N]
    double last = 0;    ///< RMS of waves in the last 120 µs before the incident wave is taken to end [N]
    bool hasBefore = false;
};
/// Returns the rms of waves between blow and reflection [N] for given values of the unknowns.
QuietErrors quietErrors(const RecordModel& model, const Eigen::VectorXd& values);
/// Returns the signal between blow and reflection minus the fitted zero line [N], smoothed by a Gaussian with
/// a standard deviation of 20 µs.
std::vector<double> quietLeft(const RecordModel& model, const Eigen::VectorXd& values);

}  // namespace drillwave

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
    /// Increase of Σr², the sum of squared residuals, over the best solution. It is divided by the mean of
    /// r², or by 1 if that is smaller.
    double rise = 0;
    /// Whether the solution is a separate minimum of Σr². Otherwise it is the best solution with the gap held
    /// at another value.
    bool isMinimum = false;
};

/// Solution of a fit, and its linearisation: a change δr of the residuals changes the unknowns by −J⁺δr. J⁺
/// is the pseudo-inverse of the Jacobian J.
class LawFit {
  public:
    LawFit() = default;

    TrialLaw law = TrialLaw::bilinear;
    Eigen::VectorXd values;  ///< fitted values, in the order and units of RecordModel::unknowns()
    Eigen::VectorXd residuals;
    double cost = 0;  ///< sum of squared weighted residuals, Σr²
    std::vector<NearbySolution> nearby;

    /// Computes and stores the Jacobian at the solution. movedBy(), left(), column() and similar functions
    /// require it.
    void linearise(RecordModel& model);
    /// Returns the change −J⁺δr of the unknowns that a change δr (`change`) of the residuals causes. J⁺ is
    /// the pseudo-inverse of the Jacobian. Unknowns that are held fixed do not change.
    Eigen::VectorXd movedBy(const Eigen::VectorXd& change) const;
    /// Returns the change of the unknowns that a change δr (`change`) of the residuals causes if the gap is
    /// held fixed.
    Eigen::VectorXd movedWithoutGap(const Eigen::VectorXd& change) const;
    /// Returns δr + Jδθ, with the Jacobian J. It is the part of the change δr (`change`) of the residuals
    /// that remains after the unknowns have changed by δθ (`moved`).
    Eigen::VectorXd left(const Eigen::VectorXd& change, const Eigen::VectorXd& moved) const;
    /// Returns the effect of a tolerance on the fit. It is the change of all unknowns if the mean of one
    /// prior is raised by its 95 % tolerance.
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

/// Model of a record, and the fit of this model. Both are empty if no fit was made.
struct ModelFit {
    std::shared_ptr<RecordModel> model;
    LawFit fit;
};

/// Returns the values of the unknowns from which a search for the best fit starts.
Eigen::VectorXd startValues(const RecordModel& model);

/// Moves the value of each unknown that is outside its bounds onto the nearest bound.
void clampToBounds(const RecordModel& model, Eigen::VectorXd& values);

/// Minimises the sum of squared residuals Σr² by the Levenberg–Marquardt method. Starts from `values`, keeps
/// within the bounds of the unknowns, and takes at most `mostRounds` iterations. Stores the solution in
/// `values` and returns its Σr².
double minimise(RecordModel& model, Eigen::VectorXd& values, int mostRounds, const std::stop_token& stop);

/// RMS [N] of stray waves at the gauge between the end of the blow and the arrival of its reflection. They
/// are taken below 6.6 kHz, minus noise and fitted zero line.
struct QuietErrors {
    double before = 0;  ///< RMS of waves until 120 µs before the incident wave is taken to end [N]
    double last = 0;    ///< RMS of waves in the last 120 µs before the incident wave is taken to end [N]
    bool hasBefore = false;
};
/// Returns the rms of stray waves [N] between the end of the blow and its reflection, for given values of the
/// unknowns.
QuietErrors quietErrors(const RecordModel& model, const Eigen::VectorXd& values);
/// Returns the force at the gauge between the end of the blow and its reflection [N], minus all fitted
/// disturbances such as the zero line. It is smoothed by a Gaussian with a standard deviation of 20 µs.
std::vector<double> quietLeft(const RecordModel& model, const Eigen::VectorXd& values);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of one law on one record, and how its answer moves with the record.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include <Eigen/Core>

#include "core/study/identify/record_model.h"

namespace drillwave {

/// A solution about as good as that of a fit.
struct NearbySolution {
    Eigen::VectorXd values;
    double rise = 0;         ///< of Σr² over the lowest one, in units of its mean
    bool isMinimum = false;  ///< a minimum of its own; otherwise the best one of another gap
};

/// Solution of a fit and its linearisation: changes δr of the residuals move the unknowns by −J⁺δr.
class LawFit {
  public:
    LawFit() = default;

    TrialLaw law = TrialLaw::bilinear;
    Eigen::VectorXd values;  ///< of the unknowns
    Eigen::VectorXd residuals;
    double cost = 0;  ///< Σr²
    std::vector<NearbySolution> nearby;

    /// Takes the Jacobian at the solution.
    void linearise(RecordModel& model);
    /// −J⁺δr; an unknown of which `isFixed` stays where it is.
    Eigen::VectorXd movedBy(const Eigen::VectorXd& change) const;
    Eigen::VectorXd movedWithoutGap(const Eigen::VectorXd& change) const;
    /// δr + Jδθ: what stays of a change of the residuals.
    Eigen::VectorXd left(const Eigen::VectorXd& change, const Eigen::VectorXd& moved) const;
    /// Movement of all unknowns when the mean of one prior moves by its 95 % tolerance.
    Eigen::VectorXd movedByPrior(const RecordModel& model, std::size_t unknown) const;
    /// Column of the Jacobian of an unknown, per unit.
    Eigen::VectorXd column(std::size_t unknown) const;
    std::size_t unknownCount() const { return static_cast<std::size_t>(values.size()); }

  private:
    void factorise(std::size_t without, Eigen::MatrixXd& inverse) const;
    Eigen::VectorXd moved(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& change) const;

    Eigen::MatrixXd m_jacobian;  ///< columns for one step of each unknown
    Eigen::VectorXd m_steps;
    Eigen::MatrixXd m_inverse, m_inverseWithoutGap;
};

/// Values that a search begins from.
Eigen::VectorXd startValues(const RecordModel& model);

/// Levenberg–Marquardt within the bounds, from `values` on; returns Σr².
double minimise(RecordModel& model, Eigen::VectorXd& values, int mostRounds, const std::stop_token& stop);

/// The largest force on the rock in a solution [N].
double largestForce(RecordModel& model, const LawFit& fit);

/// Bilinear, or the file's law with its timing, from many starts; sizes and dispersion are freed from the
/// best on, and the weights of the quiet stretch follow what is seen in it.
LawFit fitFromStarts(RecordModel& model, const std::stop_token& stop);

/// Takes the lowest minimum of Σr² about the solution. Keeps other minima, and the best solutions for other
/// gaps: a gap, the zero lines and the stiffness together can explain a record twice, and Σr² rises less
/// towards another gap than its curvature says.
void searchMinima(RecordModel& model, LawFit& fit, const std::stop_token& stop);

/// Another law from the solution of the bilinear one; where that fits badly, from several shares of
/// dispersion.
LawFit fitFrom(RecordModel& model, RecordModel& bilinear, const LawFit& from, bool searchesDispersion,
               const std::stop_token& stop);

/// A law that contains the bilinear one, from the solution of the bilinear one on and near it; of a model of
/// the same record.
LawFit fitNearby(RecordModel& model, RecordModel& bilinear, const LawFit& from, const std::stop_token& stop);

/// Again from a solution of the same model.
void refit(RecordModel& model, LawFit& fit, const std::stop_token& stop);

/// rms of what is in the quiet stretch below 6.6 kHz beyond noise, the zero line off [N].
struct QuietErrors {
    double before = 0;  ///< before its last 120 µs
    double last = 0;    ///< in the last 120 µs
    bool hasBefore = false;
};
QuietErrors quietErrors(const RecordModel& model, const Eigen::VectorXd& values);
/// The stretch less its zero line [N], smoothed by a Gaussian of 20 µs.
std::vector<double> quietLeft(const RecordModel& model, const Eigen::VectorXd& values);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/law_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/study/identify/even_samples.h"

namespace drillwave {

namespace {

using Eigen::Index;

constexpr double enoughChange = 1e-9;  ///< of Σr² in a round: the minimum
constexpr int dampingTries = 24;
constexpr double quietGaussian = 20e-6;  ///< −3 dB at 6.6 kHz [s]
constexpr double lastStretch = 120e-6;

/// Slope shapes and sizes act almost linearly: while searching they get one-sided differences.
bool isNearlyLinear(const Unknown& unknown) {
    return unknown.kind == Unknown::Kind::shape || unknown.kind == Unknown::Kind::length ||
           unknown.kind == Unknown::Kind::sectionImpedance || unknown.kind == Unknown::Kind::impedance;
}

/// Columns for one step of each unknown; `isFree` chooses those that are taken.
void differences(RecordModel& model, const Eigen::VectorXd& values, const Eigen::VectorXd& residuals,
                 bool isFinal, const std::vector<bool>& isFree, Eigen::MatrixXd& jacobian) {
    const std::vector<Unknown>& unknowns = model.unknowns();
    jacobian.setZero(residuals.size(), values.size());
    Eigen::VectorXd moved = values, above, below;
    for (Index j = 0; j < values.size(); ++j) {
        const Unknown& unknown = unknowns[static_cast<std::size_t>(j)];
        if (!isFree[static_cast<std::size_t>(j)]) continue;
        const double step = unknown.step;
        const bool canRise = values[j] + step <= unknown.high, canFall = values[j] - step >= unknown.low;
        if (canRise && canFall && (isFinal || !isNearlyLinear(unknown))) {
            moved[j] = values[j] + step;
            model.residuals(moved, above);
            moved[j] = values[j] - step;
            model.residuals(moved, below);
            jacobian.col(j) = (above - below) / 2;
        } else {
            const double way = canRise ? step : -step;
            moved[j] = values[j] + way;
            model.residuals(moved, above);
            jacobian.col(j) = (above - residuals) * (way > 0 ? 1 : -1);
        }
        moved[j] = values[j];
    }
}

/// Solves `normal`·way = `right` for the way from `values`, in steps of the unknowns. An unknown that would
/// pass a bound stops there; the others go where that is best for them.
Eigen::VectorXd wayWithin(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& values,
                          Eigen::MatrixXd normal, Eigen::VectorXd right) {
    std::vector<bool> isStopped(unknowns.size());
    Eigen::VectorXd way = normal.ldlt().solve(right);
    for (std::size_t round = 0; round < unknowns.size(); ++round) {
        bool isNew = false;
        for (Index j = 0; j < way.size(); ++j) {
            const Unknown& unknown = unknowns[static_cast<std::size_t>(j)];
            const double next = values[j] + way[j] * unknown.step;
            if (isStopped[static_cast<std::size_t>(j)] || (next >= unknown.low && next <= unknown.high))
                continue;
            isNew = isStopped[static_cast<std::size_t>(j)] = true;
            const double most =
                ((next < unknown.low ? unknown.low : unknown.high) - values[j]) / unknown.step;
            right -= normal.col(j) * most;
            normal.row(j).setZero();
            normal.col(j).setZero();
            normal(j, j) = 1;
            right[j] = most;
        }
        if (!isNew) break;
        way = normal.ldlt().solve(right);
    }
    return way;
}

}  // namespace

Eigen::VectorXd startValues(const RecordModel& model) {
    Eigen::VectorXd values(static_cast<Index>(model.unknowns().size()));
    for (std::size_t j = 0; j < model.unknowns().size(); ++j) {
        const Unknown& unknown = model.unknowns()[j];
        double value = unknown.mean;
        if (unknown.kind == Unknown::Kind::lag) value = model.record().shift;
        if (unknown.kind == Unknown::Kind::exponent) value = 1;
        if (unknown.kind == Unknown::Kind::dashpot) value = unknown.low + std::log(10.0);
        if (unknown.kind == Unknown::Kind::cornerForce) value = std::log(0.5 * model.record().peak);
        if (unknown.kind == Unknown::Kind::cornerSlope) value = 0;
        values[static_cast<Index>(j)] = value;
    }
    return values;
}

void clampToBounds(const RecordModel& model, Eigen::VectorXd& values) {
    for (std::size_t j = 0; j < model.unknowns().size(); ++j) {
        double& value = values[static_cast<Index>(j)];
        value = std::clamp(value, model.unknowns()[j].low, model.unknowns()[j].high);
    }
}

double minimise(RecordModel& model, Eigen::VectorXd& values, int mostRounds, const std::stop_token& stop) {
    const std::vector<Unknown>& unknowns = model.unknowns();
    const Index n = values.size();
    clampToBounds(model, values);
    Eigen::VectorXd residuals, tried, next;
    model.residuals(values, residuals);
    double cost = residuals.squaredNorm(), damping = 1e-3;
    Eigen::MatrixXd jacobian;
    for (int round = 0; round < mostRounds && !stop.stop_requested(); ++round) {
        std::vector<bool> isFree(unknowns.size());
        for (std::size_t j = 0; j < unknowns.size(); ++j) isFree[j] = !unknowns[j].isHeld;
        differences(model, values, residuals, false, isFree, jacobian);
        Eigen::VectorXd gradient = jacobian.transpose() * residuals;
        for (Index j = 0; j < n; ++j) {
            const Unknown& unknown = unknowns[static_cast<std::size_t>(j)];
            const bool isStuck = (values[j] <= unknown.low && gradient[j] > 0) ||
                                 (values[j] >= unknown.high && gradient[j] < 0);
            if (!isStuck) continue;
            jacobian.col(j).setZero();
            gradient[j] = 0;
        }
        const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
        const double largest = std::max(normal.diagonal().maxCoeff(), 1e-300);
        double fall = 0;
        for (int attempt = 0; attempt < dampingTries; ++attempt) {
            Eigen::MatrixXd damped = normal;
            for (Index j = 0; j < n; ++j) damped(j, j) += damping * normal(j, j) + 1e-13 * largest;
            const Eigen::VectorXd way = wayWithin(unknowns, values, std::move(damped), -gradient);
            tried = values;
            for (Index j = 0; j < n; ++j) tried[j] += way[j] * unknowns[static_cast<std::size_t>(j)].step;
            clampToBounds(model, tried);
            model.residuals(tried, next);
            const double now = next.squaredNorm();
            if (now < cost) {
                fall = cost - now;
                values = tried;
                residuals = next;
                cost = now;
                damping = std::max(damping / 6, 1e-10);
                break;
            }
            damping = std::min(damping * 4, 1e12);
        }
        if (fall <= enoughChange * cost) break;
    }
    return cost;
}

void LawFit::factorise(std::size_t without, Eigen::MatrixXd& inverse) const {
    Eigen::MatrixXd jacobian = m_jacobian;
    if (without < unknownCount()) jacobian.col(static_cast<Index>(without)).setZero();
    Eigen::VectorXd scales(jacobian.cols());
    for (Index j = 0; j < jacobian.cols(); ++j) {
        const double norm = jacobian.col(j).norm();
        scales[j] = norm > 1e-12 ? 1 / norm : 0;
        jacobian.col(j) *= scales[j];
    }
    Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    for (Index j = 0; j < normal.cols(); ++j) normal(j, j) += scales[j] > 0 ? 1e-12 : 1;
    inverse = scales.asDiagonal() *
              normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols())) *
              scales.asDiagonal();
}

void LawFit::linearise(RecordModel& model) {
    model.residuals(values, residuals);
    cost = residuals.squaredNorm();
    std::vector<bool> isFree;
    m_steps.resize(values.size());
    for (std::size_t j = 0; j < model.unknowns().size(); ++j) {
        isFree.push_back(!model.unknowns()[j].isHeld);
        m_steps[static_cast<Index>(j)] = model.unknowns()[j].step;
    }
    differences(model, values, residuals, true, isFree, m_jacobian);
    factorise(unknownCount(), m_inverse);
    factorise(model.find(Unknown::Kind::gap), m_inverseWithoutGap);
}

Eigen::VectorXd LawFit::moved(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& change) const {
    return -(m_steps.asDiagonal() * (inverse * (m_jacobian.transpose() * change)));
}

Eigen::VectorXd LawFit::movedBy(const Eigen::VectorXd& change) const {
    return moved(m_inverse, change);
}

Eigen::VectorXd LawFit::movedWithoutGap(const Eigen::VectorXd& change) const {
    return moved(m_inverseWithoutGap, change);
}

Eigen::VectorXd LawFit::left(const Eigen::VectorXd& change, const Eigen::VectorXd& way) const {
    return change + m_jacobian * way.cwiseQuotient(m_steps);
}

Eigen::VectorXd LawFit::movedByPrior(const RecordModel& model, std::size_t unknown) const {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(residuals.size());
    change[static_cast<Index>(model.priorRow(unknown))] = -1.96;
    return movedBy(change);
}

Eigen::VectorXd LawFit::column(std::size_t unknown) const {
    return m_jacobian.col(static_cast<Index>(unknown)) / m_steps[static_cast<Index>(unknown)];
}

std::vector<double> quietLeft(const RecordModel& model, const Eigen::VectorXd& values) {
    std::vector<double> left = model.quietSignal();
    for (std::size_t u = 0; u < model.unknowns().size(); ++u) {
        if (model.unknowns()[u].kind != Unknown::Kind::shape) continue;
        const LinearShape& shape = model.shapes()[model.unknowns()[u].index];
        for (std::size_t i = 0; i < left.size(); ++i)
            left[i] -= values[static_cast<Index>(u)] * shape.quiet[i];
    }
    smoothSamples(left, model.record().step, quietGaussian);
    return left;
}

QuietErrors quietErrors(const RecordModel& model, const Eigen::VectorXd& values) {
    QuietErrors errors;
    const PreparedRecord& record = model.record();
    const std::vector<double> left = quietLeft(model, values);
    if (left.empty()) return errors;
    // a Gaussian of σ passes as much noise as a mean over 2√π σ
    const auto span = std::max<std::size_t>(1, static_cast<std::size_t>(3.545 * quietGaussian / record.step));
    const double noise = record.gauges.front().noise.deviationOfMean(span);
    double powers[2] = {0, 0};
    std::size_t counts[2] = {0, 0};
    for (std::size_t i = 0; i < left.size(); ++i) {
        const int part = record.timeOf(model.firstQuiet() + i) < record.incidentEnd - lastStretch ? 0 : 1;
        powers[part] += left[i] * left[i];
        ++counts[part];
    }
    const auto beyond = [&](int part) {
        if (counts[part] == 0) return 0.0;
        const double independent =
            std::max(1.0, static_cast<double>(counts[part]) / static_cast<double>(span));
        const double scatter = 1 + 2 * std::sqrt(2 / independent);
        const double power = powers[part] / static_cast<double>(counts[part]);
        return power > noise * noise * scatter ? std::sqrt(power - noise * noise) : 0.0;
    };
    errors.before = beyond(0);
    errors.last = beyond(1);
    errors.hasBefore = static_cast<double>(counts[0]) * record.step > 40e-6;
    return errors;
}

}  // namespace drillwave

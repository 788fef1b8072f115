// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/adapted_search.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/numeric/normal_quantile.h"

namespace drillwave {
namespace {

/// Steps whose spread adapts to those that led on; names and constants as in the paper.
class AdaptedSteps {
  public:
    AdaptedSteps(Eigen::Index dimensions, const AdaptedSearch& search)
        : m_random(search.seed),
          m_sigma(search.spread),
          m_covariance(Eigen::MatrixXd::Identity(dimensions, dimensions)),
          m_root(m_covariance),
          m_path(Eigen::VectorXd::Zero(dimensions)),
          m_step(dimensions) {
        const auto n = static_cast<double>(dimensions);
        m_damping = 1 + n / 2;
        m_pathRate = 2 / (n + 2);
        m_covarianceRate = 2 / (n * n + 6);
    }

    double sigma() const { return m_sigma; }

    /// The next step, in widths of the box.
    Eigen::VectorXd next() {
        for (double& component : m_step) component = normal();
        m_step = m_root.triangularView<Eigen::Lower>() * m_step;
        return m_sigma * m_step;
    }

    /// Whether the last step led on.
    void learn(bool ledOn) {
        constexpr double target = 2.0 / 11, rate = 1.0 / 12, threshold = 0.44;
        m_successes = (1 - rate) * m_successes + (ledOn ? rate : 0);
        m_sigma *= std::exp((m_successes - target) / (1 - target) / m_damping);
        if (!ledOn) return;
        const bool isSlow = m_successes < threshold;
        m_path *= 1 - m_pathRate;
        if (isSlow) m_path += std::sqrt(m_pathRate * (2 - m_pathRate)) * m_step;
        const double kept = isSlow ? 0 : m_pathRate * (2 - m_pathRate);
        m_covariance = (1 - m_covarianceRate) * m_covariance +
                       m_covarianceRate * (m_path * m_path.transpose() + kept * m_covariance);
        const Eigen::LLT<Eigen::MatrixXd> root(m_covariance);
        if (root.info() == Eigen::Success) m_root = root.matrixL();
    }

  private:
    double normal() {
        constexpr double width = 0x1p-53;
        return normalQuantile((static_cast<double>(m_random() >> 11) + 0.5) * width);
    }

    std::mt19937_64 m_random;
    double m_sigma;
    double m_successes = 2.0 / 11;
    double m_damping = 1, m_pathRate = 1, m_covarianceRate = 1;
    Eigen::MatrixXd m_covariance, m_root;
    Eigen::VectorXd m_path, m_step;
};

}  // namespace

int climb(std::vector<double>& place, double& value,
          const std::function<double(const std::vector<double>&)>& valueAt, const AdaptedSearch& search,
          const std::stop_token& stop) {
    AdaptedSteps steps(static_cast<Eigen::Index>(place.size()), search);
    int asked = 0;
    std::vector<double> there(place.size());
    for (; asked < search.steps && steps.sigma() > search.leastSpread && !stop.stop_requested(); ++asked) {
        const Eigen::VectorXd step = steps.next();
        for (std::size_t i = 0; i < place.size(); ++i)
            there[i] = std::clamp(place[i] + step[static_cast<Eigen::Index>(i)], 0.0, 1.0);
        const double found = valueAt(there);
        const bool ledOn = found >= value;
        steps.learn(ledOn);
        if (!ledOn) continue;
        value = found;
        place = there;
    }
    return asked;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/proof/equation_residuals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "core/numeric/compensated_sum.h"
#include "core/wave/field/bit_history.h"

namespace drillwave {

namespace {

using Piece = PiecewisePolynomial::Piece;

/// Where in a piece, as fractions of its length: denser where layers are.
constexpr std::array<double, 9> inside{0.01, 0.05, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 0.98};

double derivative(const PiecewisePolynomial& f, const Piece& piece, double x) {
    const auto c = f.coefficients(piece);
    const double u = x / piece.scale;
    double sum = 0;
    for (std::size_t k = c.size(); k-- > 1;) sum = sum * u + double(k) * c[k];
    return sum / piece.scale;
}

/// The loading curve of the law, line by line as it is given: not the code of the solvers.
class LoadingCurve {
  public:
    explicit LoadingCurve(const BitRockLaw& law) : m_lines{{0, 0, law.firstSlope * law.beta}} {
        for (const LawCorner& corner : law.corners) {
            const Line& before = m_lines.back();
            m_lines.push_back({before.penetration + (corner.force - before.force) / before.slope,
                               corner.force, corner.slope * law.beta});
        }
    }
    /// At a penetration U ≥ 0.
    double force(double U) const {
        const Line& line = lineAt(U);
        return line.force + line.slope * (U - line.penetration);
    }
    double slope(double U) const { return lineAt(U).slope; }

  private:
    struct Line {
        double penetration, force, slope;  // where it begins
    };
    const Line& lineAt(double U) const {
        const auto behind = std::ranges::upper_bound(m_lines, U, {}, &Line::penetration);
        return behind == m_lines.begin() ? m_lines.front() : behind[-1];
    }
    std::vector<Line> m_lines;
};

/// Follows the front end along the recording, and the rock with its one number of memory.
class Checker {
  public:
    Checker(const Impact& impact, const Problem& problem)
        : m_impact(impact),
          m_hammer(problem.force()),
          m_roundTrip(2 * problem.transitTime()),
          m_loading(problem.law),
          m_unloading(problem.law.beta / problem.law.gamma),
          m_weight(1 / (1 + problem.law.beta / problem.law.gamma)),
          m_gap(2 * problem.firstGap()) {
        m_penetration = -m_gap;
        m_found.loadingLines = 1 + problem.law.corners.size();
    }

    void check(const Piece& incident, const Piece& force) {
        passSkips(incident.start);
        const double s = timeOfRecorded(m_impact, incident.start);
        checkLaw(incident, force, 0);
        for (const double fraction : inside) {
            const double x = fraction * incident.length;
            checkRate(incident, force, x);
            checkLaw(incident, force, x);
            if (isResolved(incident)) checkWave(incident, s, x);
            ++m_found.points;
        }
        checkLaw(incident, force, incident.length);
        m_penetration += 2 * m_impact.incident.integral(incident, incident.length) -
                         m_impact.force.integral(force, force.length);
    }

    const EquationResiduals& found() const { return m_found; }

  private:
    /// Returns whether the points of a piece can be distinguished from its ends 2τ later.
    bool isResolved(const Piece& piece) const {
        return piece.length > 1e4 * std::numeric_limits<double>::epsilon() * (piece.start + m_roundTrip);
    }

    /// Periods of free flight that were not recorded: each advances the front end like the one before them,
    /// by exactly 2 as long as only the hammer has acted.
    void passSkips(double recorded) {
        while (m_skips < m_impact.skips.size()) {
            const PeriodSkip& skip = m_impact.skips[m_skips];
            if (recorded + m_leftOut < skip.start) return;
            const auto travelled = [&](double at) { return 2 * m_impact.incident.integral(at); };
            const double last = m_deepest > 0 ? travelled(recorded) - travelled(recorded - m_roundTrip) : 2;
            m_penetration += last * std::round(skip.duration / m_roundTrip);
            m_leftOut += skip.duration;
            ++m_skips;
        }
    }

    double penetrationAt(const Piece& incident, const Piece& force, double x) const {
        return m_penetration +
               (2 * m_impact.incident.integral(incident, x) - m_impact.force.integral(force, x));
    }

    void checkLaw(const Piece& incident, const Piece& force, double x) {
        const double U = penetrationAt(incident, force, x);
        m_deepest = std::max(m_deepest, U);
        const double law =
            m_deepest > 0 ? std::max(0.0, m_loading.force(m_deepest) - m_unloading * (m_deepest - U)) : 0.0;
        const double F = m_impact.force.value(force, x);
        m_found.law = std::max(m_found.law, m_weight * std::abs(F - law));
        m_found.leastForce = std::min(m_found.leastForce, F);
    }

    void checkRate(const Piece& incident, const Piece& force, double x) {
        if (force.count == 0) return;  // apart
        const double drive = 2 * m_impact.incident.value(incident, x) - m_impact.force.value(force, x);
        const double change = derivative(m_impact.force, force, x);
        const double unloading = std::abs(change - m_unloading * drive);
        const double below = m_deepest - penetrationAt(incident, force, x);
        // about the deepest point, and about a corner, either line will do
        const double undecided = 1e-12 * (1 + m_deepest + m_gap);
        const auto onCurve = [&](double U) { return std::abs(change - m_loading.slope(U) * drive); };
        const double loading = std::min(onCurve(m_deepest - undecided), onCurve(m_deepest + undecided));
        const double residual = below > undecided    ? unloading
                                : below < -undecided ? loading
                                                     : std::min(loading, unloading);
        m_found.rate = std::max(m_found.rate, m_weight * residual);
    }

    void checkWave(const Piece& incident, double s, double x) {
        const double g = m_impact.incident.value(incident, x);
        // Periods that were left out are like the one before them: one round trip earlier is so in the
        // recording too.
        const double before = incident.start + x - m_roundTrip;
        const double expected =
            m_hammer(s + x) + (before < 0 ? incidentWave(m_impact, before)
                                          : m_impact.incident(before) - m_impact.force(before));
        m_found.wave = std::max(m_found.wave, m_weight * std::abs(g - expected));
    }

    const Impact& m_impact;
    const PulseForce& m_hammer;
    double m_roundTrip;  ///< 2τ: the equation has it by itself
    LoadingCurve m_loading;
    double m_unloading, m_weight, m_gap;
    EquationResiduals m_found;
    CompensatedSum<double> m_penetration;  ///< U at the beginning of the piece; negative: a gap
    double m_deepest = 0;                  ///< Um
    std::size_t m_skips = 0;
    double m_leftOut = 0;
};

}  // namespace

EquationResiduals equationResiduals(const Impact& impact, const Problem& problem) {
    assert(impact.hasHistories());
    Checker checker(impact, problem);
    const auto incident = impact.incident.pieces();
    const auto force = impact.force.pieces();
    for (std::size_t i = 0; i < incident.size(); ++i) checker.check(incident[i], force[i]);
    return checker.found();
}

}  // namespace drillwave

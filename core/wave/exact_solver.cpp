#include "core/wave/exact_solver.h"

#include <cmath>
#include <utility>

#include "core/wave/contact_march.h"
#include "core/wave/exponential_basis.h"
#include "core/wave/series_basis.h"

namespace drillwave {

struct ExactSolver::Workspace {
    ContactMarch<ExponentialBasis> closed;
    ContactMarch<SeriesBasis<double>> series;
};

ExactSolver::ExactSolver(long mostPieces)
    : m_workspace(std::make_unique<Workspace>()), m_mostPieces(mostPieces) {}
ExactSolver::~ExactSolver() = default;
ExactSolver::ExactSolver(ExactSolver&&) noexcept = default;
ExactSolver& ExactSolver::operator=(ExactSolver&&) noexcept = default;

Impact ExactSolver::solve(const PulseForce& pulse, const Groups& groups, Detail detail,
                          const std::stop_token& stop) {
    Impact impact;
    const bool inClosedForm =
        ExponentialBasis::suits(pulse, groups) &&
        m_workspace->closed.solve(pulse, groups, Detail::cor, impact, m_mostPieces, stop);
    if (inClosedForm && detail == Detail::cor) return impact;
    const Impact closed = inClosedForm ? std::exchange(impact, Impact{}) : Impact{};
    impact = Impact{};
    m_workspace->series.solve(pulse, groups, detail, impact, m_mostPieces, stop);
    if (inClosedForm && impact.outcome == closed.outcome) {  // the same digits whatever detail is asked for
        impact.cor = closed.cor;
        impact.corError = closed.corError;
        impact.impulse = closed.impulse;
    }
    if (impact.outcome == Outcome::rebounded && !std::isfinite(impact.cor + impact.corError)) {
        impact.outcome = Outcome::notSolved;
        impact.reason = "its numbers are beyond the range of double precision";
    }
    return impact;
}

}  // namespace drillwave

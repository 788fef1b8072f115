#include "core/wave/exact_solver.h"

#include "core/wave/contact_march.h"
#include "core/wave/series_basis.h"

namespace drillwave {

struct ExactSolver::Workspace {
    ContactMarch<SeriesBasis<double>> series;
};

ExactSolver::ExactSolver() : m_workspace(std::make_unique<Workspace>()) {}
ExactSolver::~ExactSolver() = default;
ExactSolver::ExactSolver(ExactSolver&&) noexcept = default;
ExactSolver& ExactSolver::operator=(ExactSolver&&) noexcept = default;

Impact ExactSolver::solve(const PulseForce& pulse, const Groups& groups, Detail detail) {
    Impact impact;
    m_workspace->series.solve(pulse, groups, detail, impact);
    return impact;
}

}  // namespace drillwave

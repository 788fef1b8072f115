// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the solvers is to be used, and one place to call it.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/blow/chain_solution.h"
#include "core/text/message.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/impact.h"
#include "core/wave/lattice/lattice_solver.h"
#include "core/wave/problem.h"

namespace drillwave {

/// How a blow is solved.
enum class Method {
    exact,       ///< from event to event (ExactSolver)
    lattice,     ///< the paper's algorithm (LatticeSolver)
    closedForm,  ///< the paper's analytical solution (solveClosedForm())
};

/// "closed_form" and so on, as on the command line.
std::string_view name(Method method);
std::optional<Method> findMethod(std::string_view name);
/// The name in a sentence, in English as it is asked for.
Message nameMessage(Method method);
/// All names, in the order of Method.
std::span<const std::string_view> methodNames();
/// Why a name is that of no method: "must be exact, lattice or closed_form"; empty when it is.
Message methodProblem(std::string_view name);
/// What results of drill strings say, which have one method.
inline constexpr std::string_view methodOfStrings = "polynomial_cells";

/// The segments of a lattice from text; nothing where they are no whole number that is permitted, for which
/// segmentsProblem() is the reason.
std::optional<int> segmentsIn(std::string_view text);
Message segmentsProblem();

/// A method with its settings.
struct MethodChoice {
    Method method = Method::exact;
    LatticeOptions lattice;  ///< counts for Method::lattice only
    bool operator==(const MethodChoice&) const = default;
};

/// "method exact", "method lattice, 1000 segments": how to ask for it again.
Message methodMessage(const MethodChoice& choice);
/// The same in English, as files have it.
std::string describe(const MethodChoice& choice);

/// Why a method says nothing about a blow that others can solve; empty when it does.
Message methodRefusal(Method method, const Problem& problem);

/// A wave piece of the exact solver is worth so many cells of a string.
inline constexpr long cellsOfPiece = 30;

/// What one blow may take; more, and it is not solved.
struct WorkLimits {
    long pieces = defaultWorkLimit;  ///< of wave, of the exact solver
    long cells = mostNetworkCells;   ///< of a string
};

/// Solves one blow after another by any method, keeping the workspace. One solver per thread.
class MethodSolver {
  public:
    explicit MethodSolver(const WorkLimits& limits = {})
        : m_exact(limits.pieces), m_mostCells(limits.cells) {}

    /// The problem is as for ExactSolver::solve(). A blow that the method refuses is not solved, with the
    /// reason. The closed form, which takes no time, does not look at `stop`.
    Impact solve(const Problem& problem, Detail detail, const MethodChoice& choice = {},
                 const std::stop_token& stop = {});

    /// The exact solver from now on: as ExactSolver::leaveOutLedger().
    void leaveOutLedger() { m_exact.leaveOutLedger(); }

    /// Of drill strings, which have one method. The cells that are permitted are those of the limits.
    ChainSolution solveString(const Scenario& scenario, NetworkSettings settings,
                              const std::stop_token& stop = {});
    long mostCells() const { return m_mostCells; }

  private:
    ExactSolver m_exact;
    std::optional<LatticeSolver> m_lattice;
    NetworkSolver m_strings;
    long m_mostCells;
};

}  // namespace drillwave

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

/// Method of solving a blow.
enum class Method {
    exact,       ///< from event to event (ExactSolver)
    lattice,     ///< the paper's algorithm (LatticeSolver)
    closedForm,  ///< the paper's analytical solution (solveClosedForm())
};

/// "closed_form" and so on, as on the command line.
std::string_view name(Method method);
std::optional<Method> findMethod(std::string_view name);
/// Returns the name as used in a sentence, as a message in English.
Message nameMessage(Method method);
/// Returns all names, in the order of Method.
std::span<const std::string_view> methodNames();
/// Returns why no method has that name: "must be exact, lattice or closed_form"; empty if one has.
Message methodProblem(std::string_view name);
/// Name of the only method for drill strings, as written into results.
inline constexpr std::string_view methodOfStrings = "polynomial_cells";

/// Returns the segments of a lattice read from text; nothing if they are no permitted whole number, for which
/// segmentsProblem() gives the reason.
std::optional<int> segmentsIn(std::string_view text);
Message segmentsProblem();

/// A method with its settings.
struct MethodChoice {
    Method method = Method::exact;
    LatticeOptions lattice;  ///< counts for Method::lattice only
    bool operator==(const MethodChoice&) const = default;
};

/// Returns "method exact", "method lattice, 1000 segments": the settings to repeat it.
Message methodMessage(const MethodChoice& choice);
/// Returns the same in English, as in files.
std::string describe(const MethodChoice& choice);

/// Returns why a method cannot solve a blow that others can; empty if it can.
Message methodRefusal(Method method, const Problem& problem);

/// Work of a wave piece of the exact solver, in cells of a string.
inline constexpr long cellsOfPiece = 30;

/// Limits of the work of one blow; a blow that needs more is not solved.
struct WorkLimits {
    long pieces = defaultWorkLimit;  ///< wave pieces of the exact solver
    long cells = mostNetworkCells;   ///< cells of a string
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

    /// Applies ExactSolver::leaveOutLedger() to the exact solver from now on.
    void leaveOutLedger() { m_exact.leaveOutLedger(); }

    /// Solves drill strings, which have only one method. The allowed number of cells is that of the limits.
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

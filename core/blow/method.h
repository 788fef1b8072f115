// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the solver, and a class that calls it.
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

/// Method of solving a blow on a uniform rod.
enum class Method {
    /// Exact solution, computed from one contact event to the next (ExactSolver).
    exact,
    /// Lattice algorithm of the underlying paper, with equal time steps (LatticeSolver).
    lattice,
    /// Analytical solution of the underlying paper for elastic rock and a rectangular force
    /// (solveClosedForm()).
    closedForm,
};

/// Returns the name of a method on the command line, such as "closed_form".
std::string_view name(Method method);
/// Returns the method with the given name; nullopt if there is none.
std::optional<Method> findMethod(std::string_view name);
/// Returns the name of a method for use in a sentence, as a translatable message.
Message nameMessage(Method method);
/// Returns the names of all methods, in the order of Method.
std::span<const std::string_view> methodNames();
/// Returns the reason why `name` is not a method: "must be exact, lattice or closed_form". Returns an empty
/// message if it is one.
Message methodProblem(std::string_view name);
/// Name of the method for drill strings in results; drill strings have no other method.
inline constexpr std::string_view methodOfStrings = "polynomial_cells";

/// Returns the number of segments of the rod that a text gives for the lattice method. Returns nullopt if the
/// text is not an allowed whole number; segmentsProblem() then gives the reason.
std::optional<int> segmentsIn(std::string_view text);
/// Returns the message that states how many segments the lattice method allows for the rod.
Message segmentsProblem();

/// Method of solving a blow, with its settings.
struct MethodChoice {
    Method method = Method::exact;
    LatticeOptions lattice;  ///< Settings of the lattice method; ignored for other methods.
    bool operator==(const MethodChoice&) const = default;
};

/// Returns method and settings as a message to the user, such as "method exact" or "method lattice, 1000
/// segments".
Message methodMessage(const MethodChoice& choice);
/// Returns method and settings in English words, as written in files.
std::string describe(const MethodChoice& choice);

/// Returns the reason why a method cannot solve a blow that other methods can solve; empty if the method can
/// solve it.
Message methodRefusal(Method method, const Problem& problem);

/// Computing time of one wave piece of the exact solver, in units of that of one cell (time step) of a drill
/// string. It converts a limit for one solver into that for the other.
inline constexpr long cellsOfPiece = 30;

/// Limits of the work of one blow. A blow that needs more is not solved.
struct WorkLimits {
    /// Maximum number of polynomial pieces of the waves that the exact solver may compute.
    long pieces = defaultWorkLimit;
    /// Maximum work for a drill string, in cells (time steps) times nodes (ends of sections).
    long cells = mostNetworkCells;
};

/// Solver for blows by any method, which reuses its memory from blow to blow. Each thread needs its own
/// solver.
class MethodSolver {
  public:
    /// Creates a solver with the given limits of work.
    explicit MethodSolver(const WorkLimits& limits = {})
        : m_exact(limits.pieces), m_mostCells(limits.cells) {}

    /// Returns the solution of a blow by the chosen method. The requirements on `problem` are those of
    /// ExactSolver::solve(). If the method cannot solve the blow, the result is not solved and contains the
    /// reason. The closed form ignores `stop`, because it needs hardly any time.
    Impact solve(const Problem& problem, Detail detail, const MethodChoice& choice = {},
                 const std::stop_token& stop = {});

    /// Makes the exact solver omit the check of the momentum and energy balances (sums of Detail::ledger) in
    /// all later blows with Detail::histories. The check would double the computing time.
    void leaveOutLedger() { m_exact.leaveOutLedger(); }

    /// Returns the solution of a blow on a drill string. The solver uses its own work limit
    /// (WorkLimits::cells), not that of `settings`.
    ChainSolution solveString(const Scenario& scenario, NetworkSettings settings,
                              const std::stop_token& stop = {});
    /// Returns the maximum work for a drill string, in cells (time steps) times nodes (ends of sections).
    long mostCells() const { return m_mostCells; }

  private:
    ExactSolver m_exact;
    std::optional<LatticeSolver> m_lattice;
    NetworkSolver m_strings;
    long m_mostCells;
};

}  // namespace drillwave

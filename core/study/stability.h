// Numerical stability: checks that a wrong solution cannot pass, over the stiff and extreme cases.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/stability_cases.h"
#include "core/wave/impact.h"

namespace drillwave {

/// What a case must keep to. Each mark is within ten times the worst value that the cases show, so that a
/// solver ten times worse fails; what the worst value is due to stands beside it.
struct StabilityMarks {
    double balance = 1e-11;
    double pull = 1e-12;
    double reach = 1e-9;
    double change = 1e-5;
    double limit = 1;
    double lattice = 3;
    double bound = 3;
};
inline constexpr StabilityMarks stabilityMarks{};

/// One case solved and checked. An empty optional: the check does not apply, or the histories were too long
/// to keep.
struct StabilityRow {
    StabilityCase stabilityCase;
    Outcome outcome = Outcome::notSolved;
    std::string reason;  ///< why it was not solved
    double cor = 0;
    double corError = 0;
    long pieces = 0;
    double seconds = 0;                ///< of the solve with Detail::summary
    double momentumResidual = 0;       ///< of I0: impulse of F against the waves that are left
    double energyResidual = 0;         ///< of the work W or of F0² t0/Z where that is larger: W, rock, waves
    std::optional<double> leastForce;  ///< smallest F, of the peak: the rock cannot pull
    std::optional<double> reach;  ///< farthest the free front end gets towards the rock after the end, d0/2
    double change = 0;            ///< of e over neighbours 1e-10 away in each parameter
    std::optional<double> limitDistance;    ///< |e − limit| over what theory allows, ≤ 1 is right
    std::optional<double> latticeDistance;  ///< |e − e of the lattice| over the lattice's own error estimate
    std::optional<double> boundDistance;    ///< |e − e in long double| over the stated errors of both
    std::vector<std::string> failures;      ///< the checks that failed, in words

    bool passed() const { return outcome == Outcome::rebounded && failures.empty(); }
};

struct StabilityReport {
    std::vector<StabilityRow> rows;  ///< in the order of the cases
    bool stopped = false;            ///< rows are missing
    std::size_t notSolved() const;
    std::size_t failed() const;  ///< solved, but a check failed
};

/// Solves and checks every case on `jobs` threads. `progress` is told how many rows are done.
StabilityReport checkStability(const std::vector<StabilityCase>& cases, int jobs, std::stop_token stop,
                               const std::function<void(std::uint64_t)>& progress);

}  // namespace drillwave

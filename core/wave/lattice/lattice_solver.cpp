// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/lattice/lattice_solver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text/message.h"
#include "core/wave/lattice/hammer_cells.h"
#include "core/wave/lattice/lattice_march.h"
#include "core/wave/problem.h"

namespace drillwave {

// The waves in the segments of the lattice: moved as the paper does, or standing in a ring.

// The rod of the paper's Appendix A: −Np and −Nn in each of L segments, all of them moved by one segment in
// every step. Begins when the hammer strikes: the first wave arrives L steps later.
class MovedWaves {
  public:
    // `uniform` is −Np = Nn everywhere at the beginning.
    void begin(int segments, double uniform, const PulseForce& pulse, double step) {
        m_positive.assign(static_cast<std::size_t>(segments), uniform);
        m_negative.assign(static_cast<std::size_t>(segments), -uniform);
        m_hammer = HammerCells(pulse, step);
    }
    // Steps from the strike of the hammer to the first arrival at the front end.
    static long stepsAhead(int segments) { return segments; }
    // Numbers moved in a step.
    static long movesPerStep(int segments) { return 2L * segments; }

    // The incident wave g at the front end, which holds the hammer force that was added at the rear end.
    double arriving(double /*hammer*/) const { return m_positive.back(); }

    // Moves every wave one segment on; `reflected` starts from the front end, the rear end is free apart
    // from the hammer.
    void step(double reflected) {
        const double entering = m_hammer.next() - m_negative.front();
        std::copy_backward(m_positive.begin(), m_positive.end() - 1, m_positive.end());
        std::copy(m_negative.begin() + 1, m_negative.end(), m_negative.begin());
        m_positive.front() = entering;
        m_negative.back() = reflected;
    }

  private:
    std::vector<double> m_positive, m_negative;  // −Np, −Nn; the first segment is at the rear end
    HammerCells m_hammer;
};

// The same numbers where they are: what leaves the front end is kept until it is back, 2L steps later.
class RingWaves {
  public:
    void begin(int segments, double uniform, const PulseForce&, double) {
        m_reflected.assign(2 * static_cast<std::size_t>(segments), -uniform);
        m_next = 0;
    }
    static long stepsAhead(int) { return 0; }
    static long movesPerStep(int) { return 1; }

    double arriving(double hammer) const { return hammer - m_reflected[m_next]; }
    void step(double reflected) {
        m_reflected[m_next] = reflected;
        if (++m_next == m_reflected.size()) m_next = 0;
    }

  private:
    std::vector<double> m_reflected;
    std::size_t m_next = 0;
};

namespace {

// Which coarser lattices tell how large the error of a lattice is.

constexpr int latticeCount = 8;
constexpr std::size_t leastAligned = 4;

/// Whether the force jumps after its beginning.
bool hasJumps(const PulseForce& pulse) {
    switch (pulse.shape) {
        case PulseShape::rectangular:
        case PulseShape::piston:
            return true;
        case PulseShape::table:
            return pulse(std::nextafter(pulse.end, 0)) > 1e-9 * pulse.peak;
        default:
            return false;
    }
}

/// How far on a circle the steps of a lattice are from having t0 at the fraction `phase` of one.
double phaseDistance(int segments, double tau, double phase) {
    const double away = segments / tau - phase;
    return std::abs(away - std::round(away));
}

/// A number of segments at most `radius` away whose steps have t0 at that fraction, or nearly so.
int nearWithPhase(int segments, int radius, double tau, double phase, double tolerance) {
    int best = segments;
    for (int away = 0; away <= radius; ++away)
        for (const int candidate : {segments - away, segments + away}) {
            if (phaseDistance(candidate, tau, phase) < phaseDistance(best, tau, phase)) best = candidate;
            if (phaseDistance(best, tau, phase) <= tolerance) return best;
        }
    return best;
}

// Numbers of segments between about 0.4 N and 0.75 N, irregularly spread.
//
// The error of a lattice depends on where in a step the hammer force jumps and the corners of the law fall,
// so that it goes up and down as N grows, within limits that fall with N. A jump falls on the fraction
// frac(N/τ) of a step, because all shapes jump at multiples of t0 only. Where that is 0 the lattice is much
// more accurate, and the ones to compare it with are such too, if there are any near by; elsewhere they are
// spread over all fractions.
std::vector<int> comparisonLattices(const Problem& problem, int segments) {
    // Ratios without a pattern: corners of the law fall on any fractions.
    constexpr double shares[latticeCount] = {0.4127, 0.7291, 0.5503, 0.4619, 0.6413, 0.5099, 0.6867, 0.5923};
    constexpr double exact = 1e-6, rough = 1.0 / 32;
    const int radius = segments / 40;
    const double tau = problem.transitTime();
    const bool jumps = hasJumps(problem.force());
    const bool isAligned = jumps && phaseDistance(segments, tau, 0) <= exact;
    std::vector<int> spread, aligned;
    for (int i = 0; i < latticeCount; ++i) {
        const int target = std::max(1, static_cast<int>(shares[i] * segments));
        spread.push_back(jumps ? nearWithPhase(target, radius, tau, double(i) / latticeCount, rough)
                               : target);
        if (!isAligned) continue;
        const int candidate = nearWithPhase(target, radius, tau, 0, exact);
        if (phaseDistance(candidate, tau, 0) <= exact && std::ranges::count(aligned, candidate) == 0)
            aligned.push_back(candidate);
    }
    return aligned.size() >= leastAligned ? aligned : spread;
}

}  // namespace

struct LatticeSolver::Workspace {
    LatticeMarch<MovedWaves> moved;
    LatticeMarch<RingWaves> ring;
};

LatticeSolver::LatticeSolver() : m_workspace(std::make_unique<Workspace>()) {}
LatticeSolver::~LatticeSolver() = default;
LatticeSolver::LatticeSolver(LatticeSolver&&) noexcept = default;
LatticeSolver& LatticeSolver::operator=(LatticeSolver&&) noexcept = default;

namespace {

/// As many times more segments than `segments` as `other` has fewer.
int finerInsteadOf(int other, int segments) {
    return static_cast<int>(std::ceil(double(segments) / other * segments));
}

/// How far lattices differ: max − min of the restitutions of this one and the others; NaN when some cannot be
/// solved, not even with as many times more segments as they had fewer.
template <class SolveCor>
double spread(double cor, int segments, const std::vector<int>& others, SolveCor solveCor) {
    double least = cor, most = cor;
    for (const int other : others) {
        double result = solveCor(other);
        if (std::isnan(result)) result = solveCor(finerInsteadOf(other, segments));
        if (std::isnan(result)) return result;
        least = std::fmin(least, result);
        most = std::fmax(most, result);
    }
    return most - least;
}

}  // namespace

Impact LatticeSolver::solve(const Problem& problem, Detail detail, const LatticeOptions& options,
                            const std::stop_token& stop) {
    Impact impact;
    impact.reason = Message::ofTable(rodRefusal(problem));
    if (!impact.reason.isEmpty()) return impact;
    auto& [moved, ring] = *m_workspace;
    if (options.waves == LatticeWaves::moved)
        moved.solve(problem, options.segments, detail, stop, impact);
    else
        ring.solve(problem, options.segments, detail, stop, impact);
    impact.corError = std::nan("");
    if (impact.outcome != Outcome::rebounded || options.estimate == ErrorEstimate::none) return impact;

    const auto corOf = [&](int segments) {
        Impact other;
        ring.solve(problem, segments, Detail::cor, stop, other);
        return other.outcome == Outcome::rebounded ? other.cor : std::nan("");
    };
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * (1 + std::sqrt(impact.pieces));
    const std::vector<int> others = comparisonLattices(problem, options.segments);
    impact.corError = 2 * spread(impact.cor, options.segments, others, corOf) + rounding;
    if (std::isnan(impact.corError)) {
        impact.outcome = Outcome::notSolved;
        impact.reason = stop.stop_requested()
                            ? "stopped"
                            : translatable(
                                  "lattices with other step lengths have no solution, so the error cannot be "
                                  "estimated; use more segments or the exact method");
    }
    return impact;
}

}  // namespace drillwave

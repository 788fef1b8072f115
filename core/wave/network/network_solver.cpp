// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/network_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/message.h"
#include "core/wave/network/network_march.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/work_limit.h"

namespace drillwave {

namespace {

/// How smooth waves have to be in the cells: cells in which a wave of the elastic line changes by more are
/// halved, and parts behind a front are as fine as that.
struct Smoothness {
    double mostChange;
    Grading grading;
    CutAt cutAt;
    double cellOfForce;  ///< longest for a force of a few smooth parts [t0]
};
constexpr Smoothness quickSmoothness{0.2, {0.3, 1.5, 24}, CutAt::jumps, 1 / 8.0};
constexpr Smoothness sureSmoothness{0.02, {0.15, 1.25, 100}, CutAt::corners, 1 / 64.0};

/// A force of more parts than that bends more often.
constexpr double segmentsOfShape = 8;

/// Maximum cells in round trips of hammer and string; round trips that share none are rounded to that.
constexpr double mostSharedCells = 2e6;
constexpr double roundedCells = 2e4;

/// Minimum cells for sections to keep their length: rounding moves every joint by up to half a cell.
constexpr double fewestRoundedCells = 100;

/// Maximum estimated work of one run, as a share of the permitted work.
constexpr double sharedShare = 0.5, roundedShare = 0.1;

/// Maximum number of swings of a bit mass in the round trip of all sections.
constexpr double mostSwings = 1e6;

/// Cells on their way at once: some hundreds of megabytes.
constexpr double mostHeld = 4e6;

/// Cells in the largest workspace that is kept, some tens of megabytes.
constexpr double mostKept = 3e5;

/// Error due to rounding in double precision [E0].
constexpr double leastError = 1e-13;

/// Factor from the difference of two solutions to the stated error: it covered all cases tried.
constexpr double covering = 4;

/// The energy balance of a quick run misses an error of the efficiency by up to 14 times where the faces have
/// a stiffness, by 5 on very soft rock; elsewhere it is far larger.
constexpr double coveringResidual = 20;

/// Under a force by up to 65 times: the steps of a staircase that are within cells.
constexpr double coveringForce = 100;

/// Waves lost by cells are missing in the energy by their square, but by their first power in the largest
/// force, which inelastic rock remembers, and on every rock in the shares of hammer, string and joints:
/// errors of quick runs are up to 0.03 times the root of the missing energy.
constexpr double coveringRoot = 0.06;

/// Smallest significant residual of a balance.
constexpr double leastResidual = std::numeric_limits<double>::epsilon();

double roundTripOf(const Problem& problem) {
    double sum = 0;
    for (const UniformSection& section : problem.sections) sum += 2 * section.transitTime;
    return sum;
}

/// How fast the force of a bit without a mass follows the wave on the steepest line [1/t0].
double elasticRate(const Problem& problem) {
    return problem.law.beta / problem.law.gamma / problem.sections.back().impedance;
}

/// Halves cells until the waves that force and rock make are smooth in them, as far as that is worth the
/// work.
void makeFine(CellGrid& grid, const Problem& problem, const Smoothness& smoothness) {
    constexpr double enoughCells = 4000;  // to all round trips: beyond it the parts behind fronts must do
    const double rate = elasticRate(problem);
    const double roundTrip = roundTripOf(problem);
    while (rate * grid.cell > smoothness.mostChange && roundTrip / grid.cell < enoughCells) grid.halve();
    if (!problem.isForced()) return;
    constexpr double enoughOfForce = 40'000;  // a table has as many corners as points
    const double longest =
        smoothness.cellOfForce /
        std::max(1.0, static_cast<double>(problem.force().segments.size()) / segmentsOfShape);
    while (grid.cell > longest && roundTrip / grid.cell < enoughOfForce) grid.halve();
}

/// Steps of t0 each: cells that divide t0 have all of them at one place.
bool isStaircase(const Problem& problem) {
    return problem.isForced() && problem.force().shape == PulseShape::piston;
}

NetworkWants wantsOf(NetworkWants wants, const Smoothness& smoothness) {
    wants.cutAt = smoothness.cutAt;
    wants.grading = smoothness.grading;
    wants.forcesIfTheyFit = smoothness.cutAt == CutAt::jumps;  // else there is a quick run that has them
    return wants;
}

/// Errors of the largest forces of a quick run were up to 330 times that root for 680 strings: a peak within
/// a cell takes little energy.
constexpr double coveringForces = 500;

/// The largest forces of a sure run against those of a quick one agree to no more than this.
constexpr double leastForcesError = 1e-6;

/// The largest force of one load in all sections.
double largestOf(const std::vector<SectionForces>& sections, Load load) {
    double largest = 0;
    for (const SectionForces& forces : sections) largest = std::max(largest, forces[load].force);
    return largest;
}

/// Returns what the largest forces of any run may be off as a share of them.
double forcesErrorOf(const Impact& impact) {
    if (impact.sections.empty()) return 0;
    const double missed = std::max(std::abs(impact.energyResidual()), leastResidual);
    return std::min(1.0, std::max(impact.efficiencyError, coveringForces * std::sqrt(missed)));
}

/// Returns what those of a sure run may be off, as a quick one tells.
double forcesErrorOf(const Impact& impact, const Impact& quick) {
    if (impact.sections.empty() || quick.sections.empty()) return forcesErrorOf(impact);
    double error = leastForcesError;
    for (const Load load : loads) {
        const double own = largestOf(impact.sections, load);
        if (own > 0) error = std::max(error, covering * std::abs(largestOf(quick.sections, load) / own - 1));
    }
    return std::min(1.0, error);
}

/// States the error that is known for any run.
void stateError(Impact& impact, const Problem& problem) {
    const double missed = std::abs(impact.energyResidual());
    impact.efficiencyError = std::max({leastError, impact.efficiencyError, missed});
    // the rounding of time moves a contact, and the force with it by as much as it rises meanwhile
    const double leastCorError = leastError * std::max(1.0, elasticRate(problem));
    impact.corError = std::max({leastCorError, impact.corError, missed});
}

/// States the error of a quick run, which is only known from the residual of its energy balance.
void stateErrorOfQuickRun(Impact& impact, const Problem& problem) {
    stateError(impact, problem);
    const double missed = std::abs(impact.energyResidual());
    double error = balanceError(impact);
    if (problem.isForced()) error = std::max(error, coveringForce * missed);
    const double ofShares = coveringRoot * std::sqrt(std::max(missed, leastResidual));
    if (!problem.law.isElastic()) error = std::max(error, ofShares);
    impact.efficiencyError = std::max({impact.efficiencyError, error, ofShares});
    impact.corError = std::max(impact.corError, error);
    impact.forcesError = forcesErrorOf(impact);
}

/// And what another run makes of it.
void stateError(Impact& impact, const Problem& problem, const Impact& other) {
    stateError(impact, problem);
    const auto widen = [](double& error, double difference) {
        error = std::max(error, covering * std::abs(difference));
    };
    widen(impact.efficiencyError, impact.efficiency() - other.efficiency());
    widen(impact.corError, impact.cor - other.cor);
}

}  // namespace

double balanceError(const Impact& impact) {
    return std::max(leastError, coveringResidual * std::abs(impact.energyResidual()));
}

std::string_view networkRefusal(const Problem& problem) {
    if (problem.isForced() && problem.force().isRigidBody())
        return translatable("polynomial cells need a force or a hammer; this rod arrives without waves");
    for (std::size_t j = 0; j < problem.hammerSections(); ++j)
        if (problem.sections[j].decay > 0 ||
            (j + 1 < problem.hammerSections() && problem.sections[j].loss > 0))
            return translatable(
                "losses inside the hammer are not modelled: give loss and attenuation only to the string");
    const double mass = problem.sections.back().massAfter;
    if (mass > 0) {
        const double slope = problem.law.beta / problem.law.gamma;
        const OscillationRates rates{problem.sections.back().impedance, mass, slope};
        if (rates.fastest() * roundTripOf(problem) > mostSwings)
            return translatable(
                "the bit mass oscillates too fast on this rock: leave it out (it is too small to matter), or "
                "give a softer rock");
    }
    return {};
}

bool usualGrid(const Problem& problem, CellGrid& grid) {
    const double least = roundTripOf(problem) / mostSharedCells;
    if (isStaircase(problem)) {
        std::vector<UniformSection> withTime = problem.sections;
        withTime.push_back({.transitTime = 0.5});  // whose round trip is t0
        if (shareGrid(withTime, least, grid)) {
            grid.roundTrips.pop_back();
            return true;
        }
    }
    return shareGrid(problem.sections, least, grid);
}

/// One blow is all that its functions are about: problem, settings and stop stay the same.
class NetworkSolver::Workspace {
  public:
    Impact solve(const Problem& problem, const NetworkSettings& settings, const std::stop_token& stop);
    /// Adds the waves of rounded round trips, as long cells as it takes to keep them.
    void addCoarseWaves(Impact& impact, const Problem& problem, const NetworkSettings& settings,
                        const std::stop_token& stop);
    /// Cells that it has room for.
    double held() const { return m_held; }

  private:
    Impact solveShared(const Problem& problem, const NetworkSettings& settings, const std::stop_token& stop);
    Impact solveRounded(const Problem& problem, const NetworkSettings& settings, const std::stop_token& stop);
    const ForeseenWork& planFine(const Problem& problem, const NetworkSettings& settings,
                                 const Smoothness& smoothness);
    const ForeseenWork& planRounded(const Problem& problem, double cell, const NetworkWants& wants);
    Impact run(const NetworkSettings& settings, const std::stop_token& stop);

    NetworkMarch m_march;
    CellGrid m_usual, m_grid;
    double m_held = 0;
};

Impact NetworkSolver::Workspace::solve(const Problem& problem, const NetworkSettings& settings,
                                       const std::stop_token& stop) {
    if (const std::string_view refusal = networkRefusal(problem); !refusal.empty())
        return Impact::unsolved(Message::ofTable(refusal));
    if (!usualGrid(problem, m_usual)) return solveRounded(problem, settings, stop);
    return solveShared(problem, settings, stop);
}

/// Round trips that share a cell.
Impact NetworkSolver::Workspace::solveShared(const Problem& problem, const NetworkSettings& settings,
                                             const std::stop_token& stop) {
    const ForeseenWork& foreseen = planFine(problem, settings, quickSmoothness);
    if (foreseen.work > sharedShare * static_cast<double>(settings.mostCells) || foreseen.held > mostHeld) {
        Impact rounded = solveRounded(problem, settings, stop);
        rounded.sharedCell = m_usual.cell;
        return rounded;
    }
    Impact quick = run(settings, stop);
    if (!quick.isSolved()) return quick;
    stateErrorOfQuickRun(quick, problem);
    if (settings.accuracy == NetworkAccuracy::quick) return quick;
    if (planFine(problem, settings, sureSmoothness).held > mostHeld) return quick;
    Impact sure = run(settings, stop);
    if (sure.hindrance == Hindrance::workLimit && settings.wants.forces) {
        // their forces are too much work: the quick run has some
        NetworkSettings less = settings;
        less.wants.forces = less.wants.reflections = false;
        planFine(problem, less, sureSmoothness);
        sure = run(less, stop);
        sure.sections = quick.sections;
        sure.forcesError = quick.forcesError;
        sure.jointReflection = quick.jointReflection;
        sure.leftOutForces = quick.leftOutForces;
        sure.forcesEnd = quick.forcesEnd;
    }
    if (!sure.isSolved()) return stop.stop_requested() ? sure : quick;
    if (!sure.waves) sure.waves = quick.waves;
    if (sure.forcesError == 0) sure.forcesError = forcesErrorOf(sure, quick);
    stateError(sure, problem, quick);
    sure.pieces += quick.pieces;
    return sure;
}

/// Round trips that share no cell: rounded, and rounded otherwise.
Impact NetworkSolver::Workspace::solveRounded(const Problem& problem, const NetworkSettings& settings,
                                              const std::stop_token& stop) {
    const NetworkWants wants = wantsOf(settings.wants, quickSmoothness);
    double cell = roundTripOf(problem) / roundedCells;
    const double foreseen = planRounded(problem, cell, wants).work;
    cell *= std::max(1.0, foreseen / roundedShare / static_cast<double>(settings.mostCells));
    if (cell * fewestRoundedCells > roundTripOf(problem))
        return Impact::unsolved(WorkLimitReason::steps, Hindrance::workLimit);
    planRounded(problem, cell, wants);
    Impact impact = run(settings, stop);
    for (const double other : {0.83, 1.19}) {
        if (!impact.isSolved()) return impact;
        planRounded(problem, other * cell, wantsOf({}, quickSmoothness));
        const Impact compared = run(settings, stop);
        if (!compared.isSolved()) return compared;
        stateError(impact, problem, compared);
    }
    impact.forcesError = forcesErrorOf(impact);
    return impact;
}

void NetworkSolver::Workspace::addCoarseWaves(Impact& impact, const Problem& problem,
                                              const NetworkSettings& settings, const std::stop_token& stop) {
    const NetworkWants wants = wantsOf({.histories = true}, quickSmoothness);
    const double roundTrip = roundTripOf(problem);
    for (double cell = roundTrip / roundedCells; cell * fewestRoundedCells <= roundTrip; cell *= 2) {
        planRounded(problem, cell, wants);
        const Impact coarse = run(settings, stop);
        if (stop.stop_requested()) return;
        if (coarse.isSolved() && coarse.waves) return impact.takeWavesOf(coarse);
    }
}

/// On cells that all round trips share, as fine as is wanted.
const ForeseenWork& NetworkSolver::Workspace::planFine(const Problem& problem,
                                                       const NetworkSettings& settings,
                                                       const Smoothness& smoothness) {
    m_grid = m_usual;
    makeFine(m_grid, problem, smoothness);
    for (int i = 0; i < settings.halvings; ++i) m_grid.halve();
    return m_march.plan(problem, m_grid, wantsOf(settings.wants, smoothness));
}

const ForeseenWork& NetworkSolver::Workspace::planRounded(const Problem& problem, double cell,
                                                          const NetworkWants& wants) {
    if (isStaircase(problem)) cell = 1 / std::ceil(1 / cell);
    roundGrid(problem.sections, cell, m_grid);
    return m_march.plan(problem, m_grid, wants);
}

Impact NetworkSolver::Workspace::run(const NetworkSettings& settings, const std::stop_token& stop) {
    Impact impact = m_march.run(settings.mostCells, stop);
    m_held = std::max(m_held, m_march.held());
    if (!impact.isSolved() || impact.balances()) return impact;
    return Impact::unsolved(translatable("its energies do not balance, so that its numbers are wrong"));
}

NetworkSolver::NetworkSolver() = default;
NetworkSolver::~NetworkSolver() = default;
NetworkSolver::NetworkSolver(NetworkSolver&&) noexcept = default;
NetworkSolver& NetworkSolver::operator=(NetworkSolver&&) noexcept = default;

Impact NetworkSolver::solve(const Problem& problem, const NetworkSettings& settings,
                            const std::stop_token& stop) {
    if (!m_workspace) m_workspace = std::make_unique<Workspace>();
    Impact impact = m_workspace->solve(problem, settings, stop);
    if (settings.wants.histories && settings.roundsForWaves && impact.isSolved() && !impact.waves)
        m_workspace->addCoarseWaves(impact, problem, settings, stop);
    if (impact.waves) {
        impact.incident = impact.waves->bitWave();
        impact.force = impact.waves->bitForce();
    }
    if (m_workspace->held() > mostKept) m_workspace.reset();
    return impact;
}

Impact solveNetwork(const Problem& problem, const NetworkSettings& settings, const std::stop_token& stop) {
    return NetworkSolver().solve(problem, settings, stop);
}

}  // namespace drillwave

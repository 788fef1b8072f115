// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/proof/string_accuracy.h"

#include <cmath>
#include <limits>

#include "core/blow/chain_solution.h"
#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/model/validation.h"
#include "core/text/enum_names.h"
#include "core/wave/network/network_solver.h"
#include "core/wave/network/plain_lattice.h"
#include "core/wave/problem.h"

namespace drillwave {

namespace {

constexpr int quickHalvings = 3, sureHalvings = 1, plainHalvings = 6;
constexpr double wantedRows = quickHalvings + 1 + sureHalvings + 1 + plainHalvings + 1;

RunTime timeOf(const auto& work, const std::stop_token& stop) {
    const double start = threadSeconds();
    work();
    return measureRunTime(work, threadSeconds() - start, stop, [] {});
}

}  // namespace

std::string_view name(StringMethod method) {
    static constexpr EnumNames<StringMethod> names{
        {{StringMethod::quick, "cells"}, {StringMethod::sure, "cells_cut"}, {StringMethod::plain, "plain"}}};
    return names[method];
}

StringAccuracy measureStringAccuracy(const Scenario& scenario, const std::stop_token& stop,
                                     const StringAccuracyRows& onRow, long mostCells) {
    StringAccuracy accuracy;
    accuracy.reason = invalidity(scenario);
    if (accuracy.reason.isEmpty() && !isString(scenario))
        accuracy.reason = translatable("cells are of drill strings (`drillwave: 2`)");
    if (!accuracy.reason.isEmpty()) return accuracy;
    NetworkSolver solver;
    // all on the same pieces of what is not uniform
    Problem problem = solveChain(scenario, {.wants = {}, .mostCells = mostCells}, solver, stop).problem;
    NetworkSettings finest;
    finest.halvings = sureHalvings + 1;
    finest.mostCells = mostCells;
    Impact reference = solver.solve(problem, finest, stop);
    if (!reference.isSolved()) {
        accuracy.reason = reference.reason;
        accuracy.isStopped = stop.stop_requested();
        return accuracy;
    }
    if (!problem.endTime) {  // all methods to the same end
        problem.endTime = reference.endTime;
        reference = solver.solve(problem, finest, stop);
    }
    accuracy.efficiency = reference.efficiency();
    accuracy.reference = reference.efficiencyError;
    const double seconds = scalesOf(scenario).time, p0 = reference.hammerImpulse;

    const auto add = [&](const StringAccuracyRow& row) {
        accuracy.isStopped = stop.stop_requested();  // its time is no time
        if (accuracy.isStopped) return;
        accuracy.rows.push_back(row);
        if (onRow) onRow(accuracy, static_cast<double>(accuracy.rows.size()) / wantedRows);
    };
    const auto addCells = [&](StringMethod method, int halvings) {
        NetworkSettings settings;
        settings.accuracy = method == StringMethod::quick ? NetworkAccuracy::quick : NetworkAccuracy::sure;
        settings.halvings = halvings;
        settings.mostCells = mostCells;
        const Impact impact = solver.solve(problem, settings, stop);
        if (!impact.isSolved()) return;
        add({method, impact.cell * seconds, std::abs(impact.efficiency() - accuracy.efficiency),
             impact.efficiencyError, std::abs(impact.impulse - reference.impulse) / p0, impact.pieces,
             timeOf([&] { solver.solve(problem, settings, stop); }, stop)});
    };
    for (int i = 0; i <= quickHalvings; ++i) addCells(StringMethod::quick, i);
    for (int i = 0; i <= sureHalvings; ++i) addCells(StringMethod::sure, i);

    CellGrid grid;
    const bool isShared = usualGrid(problem, grid);
    for (int i = 0; isShared && i <= plainHalvings && !stop.stop_requested(); ++i, grid.halve()) {
        const PlainBlow blow = solvePlainLattice(problem, grid, stop);
        add({StringMethod::plain, grid.cell * seconds, std::abs(blow.efficiency - accuracy.efficiency),
             std::numeric_limits<double>::quiet_NaN(), std::abs(blow.rockImpulse - reference.impulse / p0),
             blow.cells, timeOf([&] { solvePlainLattice(problem, grid, stop); }, stop)});
    }
    accuracy.isStopped = stop.stop_requested();
    return accuracy;
}

}  // namespace drillwave

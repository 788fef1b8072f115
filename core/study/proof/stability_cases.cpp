// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/proof/stability_cases.h"

#include <cmath>
#include <functional>

#include "core/contact/contact_law.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr PulseShape shapes[] = {PulseShape::rectangular, PulseShape::triangular,  PulseShape::halfSine,
                                 PulseShape::trapezoid,   PulseShape::exponential, PulseShape::piston,
                                 PulseShape::table,       PulseShape::rigidBody};

/// Blows that last for many t0.
bool isLong(PulseShape shape) {
    return shape == PulseShape::exponential || shape == PulseShape::piston;
}

/// Takes one named case with a default piston.
using Add = std::function<void(const char* name, PulseShape shape, Groups groups)>;

/// Outside what the header says is left out.
bool isAffordable(PulseShape shape, const Groups& g) {
    if (g.beta < 1e-6 && g.gamma < 1) return false;
    return g.tau >= 0.1 || !isLong(shape);
}

void addPublished(const Add& add) {
    add("paper Fig. 4 (a)", PulseShape::rectangular, {0.5, 1, 10, 0});
    add("paper Fig. 4 (b)", PulseShape::rectangular, {0.5, 0.1, 10, 0});
    add("paper Fig. 6, largest e", PulseShape::rectangular, {0.3, 1, 10, 0});
    add("paper Fig. 8, smallest e", PulseShape::rectangular, {0.5, 1, 10, 0.521});
    add("paper, reference case", PulseShape::rigidBody, {0.12892, 1, 10, 0});
}

void addTraps(const Add& add) {
    add("forceless contact over a long rod", PulseShape::rectangular, {50, 0.1, 1000, 0});
    add("forceless contact, elastic", PulseShape::halfSine, {50, 1, 1000, 0});
    add("tangential start of unloading", PulseShape::halfSine, {0.5, 0.1, 10, 0});
    add("tangential start, triangular blow", PulseShape::triangular, {5, 0.3, 0.7, 0});
    for (const double distance : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
        add("nearly equal rates", PulseShape::rectangular, {0.5, 1 - distance, 10, 0.1});
    add("rate of the blow equal to that of the rock", PulseShape::exponential, {1, 1, 3, 0.2});
    add("rate of the blow nearly that of the rock", PulseShape::exponential, {1 + 1e-9, 1, 3, 0.2});
    add("rate of the blow equal to that of unloading", PulseShape::exponential, {0.1, 0.1, 3, 0.2});
    add("many reflections, elastic", PulseShape::rectangular, {1e-6, 1, 0.6, 0});
    add("many reflections, inelastic", PulseShape::rectangular, {1e-5, 0.1, 0.6, 0});
    add("stiff layer", PulseShape::rectangular, {1e9, 1e-6, 10, 0.3});
    add("stiff layer under a smooth blow", PulseShape::halfSine, {1e9, 1e-6, 10, 0.3});
    add("stiff layer that decays to rounding", PulseShape::exponential,
        {583270827.9, 1.1046682e-06, 7.5, 0.00265});
    for (const double whole : {1.0, 2.0, 1000.0})
        add("gap that closes when a front arrives", PulseShape::rectangular, {0.5, 1, 10, whole});
    add("hammer pushes during several reflections", PulseShape::rectangular, {0.5, 1, 0.05, 0});
    add("hammer pushes, contact begins before it ends", PulseShape::halfSine, {5, 0.1, 0.05, 0.2});
    add("hammer pushes a rod against rigid rock", PulseShape::triangular, {2e6, 1e-3, 0.125, 0});
    add("contact lost and found within a layer", PulseShape::triangular,
        {1139756.7339493404, 1, 0.10451841308422448, 6.34e-05});
    // the force turns in the last digit of time before a front raises it again, or after that
    const auto turns = [&add](PulseShape shape, Groups groups) {
        add("force that turns as a front arrives", shape, groups);
    };
    turns(PulseShape::exponential, {4.98325, 0.680524, 0.63574, 0.5803234527990637});
    turns(PulseShape::exponential, {1.10626, 0.1, 0.35849, 0.43879244594666483});
    turns(PulseShape::exponential, {4.2106, 0.665556, 0.282805, 0.111163186073214});
    turns(PulseShape::exponential, {2, 0.05, std::nextafter(std::log(2.0) / 2, 0), 0});
    turns(PulseShape::rectangular,
          {3.9130558362526533, 0.42134946895830505, 0.13141871184587572, 0.14458317395972925});
    add("slow drift before a late second contact", PulseShape::rectangular, {0.01, 0.01, 10, 0.9});
    add("gap of a million periods", PulseShape::rectangular, {0.5, 0.1, 10, 1e6 + 0.5});
}

/// Each parameter through its whole range while the others stay.
void addScans(std::vector<StabilityCase>& cases) {
    struct Start {
        const char* name;
        Groups groups;
    };
    static constexpr Start starts[] = {{"soft elastic", {1e-3, 1, 0.6, 0}},
                                       {"middle", {0.5, 0.1, 10, 0.37}},
                                       {"stiff", {1e6, 1e-3, 3, 0.37}}};
    for (const PulseShape shape : shapes)
        for (const Start& start : starts) {
            const auto add = [&](const char* parameter, Groups groups) {
                if (shape == PulseShape::rigidBody) groups.delta = 0;
                if (isAffordable(shape, groups))
                    cases.push_back({std::string(start.name) + ", " + parameter, shape, 2, groups});
            };
            for (int k = -9; k <= 12; ++k) {
                Groups g = start.groups;
                g.beta = *parseNumber("1e" + formatNumber(k));
                add("beta", g);
            }
            for (int k = -9; k <= 0; ++k) {
                Groups g = start.groups;
                g.gamma = *parseNumber("1e" + formatNumber(k));
                add("gamma", g);
            }
            for (const double tau : {0.01, 0.03, 0.1, 0.3, 0.5, 1.0, 10.0, 100.0, 1e3, 1e4}) {
                Groups g = start.groups;
                g.tau = tau;
                add("tau", g);
            }
            for (const double delta : {1e-9, 1e-3, 0.5, 1.0, 1.5, 10.0, 1e3, 1e6, 1e6 + 0.37}) {
                Groups g = start.groups;
                g.delta = delta;
                if (shape != PulseShape::rigidBody) add("delta", g);
            }
        }
}

void addProducts(std::vector<StabilityCase>& cases) {
    for (const PulseShape shape : shapes)
        for (const double beta : {1e-5, 1e-2, 10.0, 1e5, 1e9, 1e12})
            for (const double gamma : {1e-6, 1e-2, 1 - 1e-9, 1.0})
                for (const double tau : {0.1, 0.5, 7.0, 1e4})
                    for (const double delta : {0.0, 0.37, 1e6}) {
                        const Groups groups{beta, gamma, tau, delta};
                        if (shape == PulseShape::rigidBody && delta > 0) continue;
                        // every layer of a long blow on a short stiff rod is resolved: minutes for the grid
                        if (isLong(shape) && tau < 0.5 && groups.beta / groups.gamma > 1e3) continue;
                        cases.push_back({"product of extremes", shape, 2, groups});
                    }
}

/// The hammer still pushes during several reflections, and contacts follow each other closely.
void addShortRods(const Add& add) {
    for (const PulseShape shape : shapes)
        for (const double tau : {0.05, 0.07, 0.13, 0.25, 0.4})
            for (const double beta : {1.0, 25.9, 400.0})
                for (const double gamma : {1.0, 0.1})
                    for (const double delta : {0.0, 0.3}) {
                        if (shape == PulseShape::rigidBody && delta > 0) continue;
                        if (isLong(shape) && tau < 0.1) continue;
                        add("short rod", shape, {beta, gamma, tau, delta});
                    }
    // an event that a search once placed before its start
    add("short rod", PulseShape::rectangular, {25.904579446675282, 0.1, 0.069132529248490504, 0});
    add("short rod", PulseShape::rectangular, {38.852926094687284, 1, 0.085693142742192113, 0});
}

/// Tens of contacts, each of which multiplies the rounding of those before: e hangs on the last digits.
void addChatter(std::vector<StabilityCase>& cases) {
    for (const double impedanceRatio : {3.0, 6.0, 10.0})
        for (const double beta : {1.3, 20.0, 300.0})
            for (const double gamma : {1.0, 0.3, 0.07})
                for (const double tau : {0.3, 0.7, 1.2})
                    cases.push_back(
                        {"chatter, piston", PulseShape::piston, impedanceRatio, {beta, gamma, tau, 0}});
    for (const double beta : {1.3, 20.0, 300.0})
        for (const double gamma : {1.0, 0.3, 0.07})
            for (const double tau : {0.15, 0.3, 0.7})
                cases.push_back({"chatter, exponential", PulseShape::exponential, 2, {beta, gamma, tau, 0}});
    cases.push_back({"chatter, e of no digits", PulseShape::piston, 15, {4.3, 0.07, 0.1, 0}});
    cases.push_back({"chatter, momentum of rounding",
                     PulseShape::piston,
                     4.865,
                     {3.1419362199829686, 1, 0.16017828902955503, 0}});
}

/// A measured blow in little: steep front, ripples, a tail.
const TablePoints& tablePoints() {
    static const TablePoints points{{0, 0},      {0.02, 0.4},  {0.05, 0.9}, {0.1, 1},    {0.2, 0.82},
                                    {0.3, 0.93}, {0.45, 0.71}, {0.6, 0.8},  {0.75, 0.3}, {1, 0}};
    return points;
}

PulseForce tableForce() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tablePoints = tablePoints();
    return pulseForceOf(scenario);
}

}  // namespace

Scenario scenarioOf(const StabilityCase& stabilityCase) {
    Scenario scenario;
    scenario.title = stabilityCase.name;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = stabilityCase.groups;
    scenario.pulse.shape = stabilityCase.shape;
    scenario.pulse.piston.impedanceRatio = stabilityCase.impedanceRatio;
    if (stabilityCase.shape == PulseShape::table) scenario.pulse.tablePoints = tablePoints();
    return scenario;
}

Problem problemOf(const StabilityCase& stabilityCase) {
    return problemOf(stabilityCase.shape == PulseShape::table
                         ? tableForce()
                         : pulseForceOf(stabilityCase.shape, stabilityCase.impedanceRatio),
                     stabilityCase.groups);
}

std::vector<StabilityCase> stabilityCases() {
    std::vector<StabilityCase> cases;
    const Add add = [&cases](const char* name, PulseShape shape, Groups groups) {
        cases.push_back({name, shape, 2, groups});
    };
    addPublished(add);
    addTraps(add);
    addShortRods(add);
    addChatter(cases);
    addScans(cases);
    addProducts(cases);
    return cases;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a drill string: solved, and in the terms of every other blow.
#pragma once

#include <stop_token>
#include <vector>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/scenario.h"
#include "core/wave/impact.h"
#include "core/wave/network/network_impact.h"
#include "core/wave/network/network_solver.h"

namespace drillwave {

/// What was solved, and how it came out. Units of Problem.
struct StringBlow {
    Problem problem;
    NetworkImpact impact;
};

/// Solves the blow of a valid drill string with a solver that keeps its workspace from blow to blow.
StringBlow solveString(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                       const std::stop_token& stop = {});

/// The events, numbers and histories that a uniform rod has too, in its units: forces in F0, impulses in p0;
/// those at the bit are known from time 0 to the end of the recording and count from t = 0, and nothing
/// repeats itself after it.
Impact impactOf(const StringBlow& blow);

/// The numbers of the blow. Where it is not solved, nothing.
ImpactSummary summarize(const Scenario& scenario, const StringBlow& blow);

/// A largest stress of a section, in SI, and where.
struct StressPeak {
    double stress = 0;  ///< [Pa], ≥ 0
    double place = 0;   ///< [m] from the rear end of the section
    double time = 0;    ///< [s]
};

/// Those of a section, in the spans of time of SectionForces.
struct SectionStress {
    StressPeak compression, tension, compressionAfter, tensionAfter;
};
/// Of every section of the hammer and then of the string, where the forces were asked for.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const StringBlow& blow);

/// A largest stress of a string, and where.
struct StringPeak {
    std::size_t section = 0;  ///< of sectionStresses()
    StressPeak peak;
};
/// The one that of a rod is called that, over all sections, of the first where several are as large. Requires
/// sections.
StringPeak largestStress(const std::vector<SectionStress>& stresses, RodForce RodForces::*which);

/// Whether the blow was followed beyond its end, so that there are stresses after it.
bool hasStressesAfter(const NetworkImpact& impact);

/// What the result of a string gives reason to say: sections beyond their strength, lengths that were
/// rounded, a blow that was not over. To be listed behind alertsFor(scenario).
std::vector<Alert> stringAlerts(const Scenario& scenario, const StringBlow& blow);

}  // namespace drillwave

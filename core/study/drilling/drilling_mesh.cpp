// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/model/section_pieces.h"
#include "core/study/drilling/drilling_case.h"

namespace drillwave {
namespace {

/// Pieces of a cone at most, for every cell in t0: their error falls as that of the cells does.
constexpr double piecesPerCell = 0.4;

/// A share of a cell that is rounding.
constexpr double sameCell = 1e-6;

/// Pieces of each section: none has a round trip of less than a cell.
std::vector<int> piecesOf(const std::vector<const Section*>& sections, const DrillingGrid& grid) {
    const double most = std::max(1.0, std::round(piecesPerCell / grid.cell));
    std::vector<int> counts;
    for (std::size_t j = 0; j < sections.size(); ++j) {
        const double trip = std::floor(grid.roundTrips[j] + sameCell);
        // a cone of whole cells is cut into pieces of whole cells
        const double fits = std::min(trip, most), cellsOfPiece = std::ceil(trip / fits);
        const bool isWhole =
            grid.roundTrips[j] == std::round(grid.roundTrips[j]) && std::fmod(trip, cellsOfPiece) == 0;
        const double count = isWhole ? trip / cellsOfPiece : fits;
        counts.push_back(isUniform(*sections[j]) ? 1 : std::max(1, static_cast<int>(count)));
    }
    return counts;
}

DrillingMesh meshOf(const Scenario& scenario, int cellsPerDuration,
                    DrillingGrid (*gridOf)(const DrillingProblem&, int)) {
    DrillingMesh mesh{.problem = drillingProblemOf(scenario, problemOf(scenario)), .grid = {}};
    mesh.grid = gridOf(mesh.problem, cellsPerDuration);
    if (hasUniformSections(scenario.drillString)) return mesh;
    const std::vector<int> counts = piecesOf(allSections(scenario.drillString), mesh.grid);
    mesh.problem = drillingProblemOf(scenario, problemOf(scenario, counts));
    mesh.grid.setSections(mesh.problem.blow.sections);
    mesh.grid.releasesAtOnce = mesh.grid.releasesAtOnce && mesh.grid.hasWholeTrips();
    return mesh;
}

}  // namespace

DrillingMesh drillingMeshOf(const Scenario& scenario, int cellsPerDuration) {
    return meshOf(scenario, cellsPerDuration, drillingGridOf);
}

DrillingMesh comparedDrillingMeshOf(const Scenario& scenario, int cellsPerDuration) {
    return meshOf(scenario, cellsPerDuration, comparedDrillingGridOf);
}

}  // namespace drillwave

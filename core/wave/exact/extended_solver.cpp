// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/extended_solver.h"

#include <memory>

#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/series_basis.h"

namespace drillwave {

Impact solveInExtendedPrecision(const Problem& problem, Detail detail, const std::stop_token& stop) {
    const auto march = std::make_unique<ContactMarch<SeriesBasis<long double>>>();
    const auto solve = [&](Detail wanted, const InputMove& move) {
        Impact impact;
        march->solve(problem, wanted, impact, {.stop = &stop, .move = move});
        return impact;
    };
    Impact impact = solve(detail, {});
    impact.corError += roundingOfHammer(problem.force());
    coverGrowth(impact, [&](const InputMove& move) { return solve(Detail::cor, move); });
    return impact;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/passing_march.h"

#include <memory>

#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/series_basis.h"

namespace drillwave {

Impact marchInPassing(const Problem& problem, long pieces, const HandOver& handOver,
                      const std::stop_token& stop) {
    MarchLimits limits;
    limits.pieces = pieces + 1;
    limits.stop = &stop;
    limits.handOver = &handOver;
    limits.ledger = false;
    Impact impact;
    std::make_unique<ContactMarch<SeriesBasis<double>>>()->solve(problem, Detail::histories, impact, limits);
    return impact;
}

}  // namespace drillwave

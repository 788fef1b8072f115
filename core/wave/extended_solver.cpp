#include "core/wave/extended_solver.h"

#include <memory>

#include "core/wave/contact_march.h"
#include "core/wave/series_basis.h"

namespace drillwave {

Impact solveInExtendedPrecision(const PulseForce& pulse, const Groups& groups, Detail detail) {
    const auto march = std::make_unique<ContactMarch<SeriesBasis<long double>>>();
    Impact impact;
    march->solve(pulse, groups, detail, impact);
    return impact;
}

}  // namespace drillwave

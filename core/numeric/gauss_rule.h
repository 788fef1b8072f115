// SPDX-License-Identifier: GPL-3.0-or-later
// Numerical integration of smooth functions.
#pragma once

#include <array>
#include <cstddef>

namespace drillwave {

/// Gauss–Legendre rule for integration over [0, 1]: ∫f ≈ Σ weights·f(nodes), with 16 nodes, exact for
/// polynomials up to degree 31.
struct GaussRule {
    static constexpr std::size_t count = 16;
    std::array<double, count> nodes;
    std::array<double, count> weights;
};

const GaussRule& gaussRule();

}  // namespace drillwave

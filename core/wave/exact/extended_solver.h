// SPDX-License-Identifier: GPL-3.0-or-later
// The exact solution once more, with more digits.
#pragma once

#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Solves like ExactSolver, in power series throughout and in long double: 64 bits of mantissa in place of 53
/// on x86. Several times slower. corError holds for that arithmetic, moved inputs included (input_move.h):
/// where the bit chatters, long double has few digits more than double.
///
/// The difference to ExactSolver shows the rounding and truncation of the latter, and what its closed
/// exponential pieces get wrong where it uses them. It does not show a mistake in the order or kind of
/// events: both march with the same code (ContactMarch). equationResiduals() does.
Impact solveInExtendedPrecision(const Problem& problem, Detail detail = Detail::cor,
                                const std::stop_token& stop = {});

}  // namespace drillwave

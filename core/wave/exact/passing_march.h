// SPDX-License-Identifier: GPL-3.0-or-later
// Histories too long to be kept, looked at while they are made.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Takes as much as it likes out of the histories of an impact that is being solved, from their beginning,
/// and returns how many pieces they should have when it is called again.
using HandOver = std::function<std::size_t(Impact&)>;

/// Histories of more pieces are too long to be kept for some numbers: 90 MB. The closed form has no more.
inline constexpr long mostPiecesKept = 100'000;

/// How many pieces are handed over at first.
inline constexpr std::size_t piecesHandedOver = 20'000;

/// Solves a blow once more that ExactSolver has solved in `pieces`, more than mostPiecesKept and so in power
/// series, and hands its histories over. What is left of them is in the impact returned.
Impact marchInPassing(const Problem& problem, long pieces, const HandOver& handOver,
                      const std::stop_token& stop);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// What takes a while to be solved is solved once, however often pages look at it.
#pragma once

#include "ui/job/solved_blow.h"

namespace drillwave {

/// Whether a blow is the answer to a request but for its units and pages, and worth being taken for it: of a
/// drill string; a rod is solved sooner than its histories are copied.
bool answersAgain(const SolvedBlow& before, const SolveRequest& request);

/// That blow, with the units and the pages of the request; as solveBlow() otherwise.
SolvedBlowPtr answerAgain(const SolvedBlow& before, const SolveRequest& request) noexcept;

}  // namespace drillwave

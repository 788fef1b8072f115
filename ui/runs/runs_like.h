// SPDX-License-Identifier: GPL-3.0-or-later
// Which runs can be laid over a blow.
#pragma once

#include "ui/runs/run.h"

namespace drillwave {

/// Those on rods for a rod, those on drill strings for a string: the others have other axes.
RunList runsLike(const Scenario& scenario, const RunList& runs);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs for tests of pages, without the list that normally holds them.
#pragma once

#include "ui/runs/runs.h"

namespace drillwave::test {

/// Returns a solved and visible run. `number` determines its letter, colour and dash pattern.
inline Run pinnedRun(int number, const SolvedBlowPtr& blow) {
    Run run;
    run.number = number;
    run.contents.scenario = blow->scenario;
    run.blow = blow;
    return run;
}

}  // namespace drillwave::test

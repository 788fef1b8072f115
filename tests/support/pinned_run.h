// SPDX-License-Identifier: GPL-3.0-or-later
// Runs for pages, without the list that pins them.
#pragma once

#include "ui/runs/runs.h"

namespace drillwave::test {

/// Run number `number`, with the letter, colour and dash of that, shown and solved.
inline Run pinnedRun(int number, const SolvedBlowPtr& blow) {
    Run run;
    run.number = number;
    run.contents.scenario = blow->scenario;
    run.blow = blow;
    return run;
}

}  // namespace drillwave::test

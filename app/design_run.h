// SPDX-License-Identifier: GPL-3.0-or-later
// A design study that is run by a command.
#pragma once

#include <string>

#include "app/interruption.h"
#include "core/study/design/design_study.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Threads, and how progress and problems are shown.
struct DesignRun {
    int jobs = 1;
    std::string path;  ///< of the scenario, for messages
    const ReadingStyle& style;
};

/// Runs a study with a progress bar; the findings have a robust best. Throws CommandError: interrupted;
/// unsolved if no design has statistics or none meets the limits.
DesignFindings findDesigns(const DesignStudy& study, const DesignRun& run, const Interruption& interruption);

}  // namespace drillwave

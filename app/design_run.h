// SPDX-License-Identifier: GPL-3.0-or-later
// Execution of a design study by a command.
#pragma once

#include <string>

#include "app/interruption.h"
#include "core/study/design/design_study.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Settings for running a design study in a command: number of threads, and the name of the scenario and the
/// style in messages.
struct DesignRun {
    int jobs = 1;
    std::string path;  ///< name of the scenario in messages
    const ReadingStyle& style;
};

/// Computes a design study and returns its results, which include a best design (BestDesigns::robust). Shows
/// a progress bar. Throws CommandError: interrupted; unsolved if no design has statistics or no design meets
/// the limits.
DesignFindings findDesigns(const DesignStudy& study, const DesignRun& run, const Interruption& interruption);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Execution of a design study by a command.
#pragma once

#include <string>

#include "app/interruption.h"
#include "core/study/design/design_study.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Settings for running a design study: threads, and the name and style used in messages.
struct DesignRun {
    int jobs = 1;
    std::string path;  ///< name of the scenario in messages
    const ReadingStyle& style;
};

/// Returns the findings of a design study, which include a design that is best for uncertain rock. Shows a
/// progress bar. Throws CommandError: interrupted; unsolved if no design has statistics or no design meets
/// the limits.
DesignFindings findDesigns(const DesignStudy& study, const DesignRun& run, const Interruption& interruption);

}  // namespace drillwave

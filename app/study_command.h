// SPDX-License-Identifier: GPL-3.0-or-later
// Command that runs a study described by a Study object.
#pragma once

#include "app/command.h"
#include "core/report/study.h"

namespace drillwave {

/// Returns the command `drillwave NAME FILE` that runs a study. It accepts the options of the study, and
/// --json, -o, --si, --plots, --force and --decimal-comma. The study must outlive the command.
Command studyCommand(const Study& study);

}  // namespace drillwave

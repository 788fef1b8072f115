// SPDX-License-Identifier: GPL-3.0-or-later
// The command of any study that is a value.
#pragma once

#include "app/command.h"
#include "core/report/study.h"

namespace drillwave {

/// `drillwave NAME FILE` with the options of the study and those that all studies have: --json, -o, --si,
/// --plots, --force, --decimal-comma. The study must outlive it.
Command studyCommand(const Study& study);

}  // namespace drillwave

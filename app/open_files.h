// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether the system's limit of open files leaves enough for a command.
#pragma once

#include "app/command_error.h"

namespace drillwave {

/// Returns the error for a file that could not be opened; `reason` is the system's error number (errno).
CommandError tooFewFiles(int reason);

/// Throws the error of tooFewFiles() if the limit of open files does not permit `count` more files now.
void checkOpenFiles(int count);

}  // namespace drillwave

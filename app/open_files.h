// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether the system's limit of open files leaves enough for a command.
#pragma once

#include "app/command_error.h"

namespace drillwave {

/// Returns the error to throw if the system permits no more open files; `reason` is its error number (errno).
CommandError tooFewFiles(int reason);

/// Throws CommandError (unwritable output) if the system's limit of open files does not permit `count` more
/// files now.
void checkOpenFiles(int count);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the limit of open files leaves what a command needs.
#pragma once

#include "app/command_error.h"

namespace drillwave {

/// Returns the error for a file that cannot be opened for this reason of the system (errno).
CommandError tooFewFiles(int reason);

/// Throws tooFewFiles() unless so many files can be opened now.
void checkOpenFiles(int count);

}  // namespace drillwave

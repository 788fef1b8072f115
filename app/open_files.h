// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the limit of open files leaves what a command needs.
#pragma once

#include "app/command_error.h"

namespace drillwave {

/// What a command ends with that cannot open a file for this reason of the system (errno).
CommandError tooFewFiles(int reason);

/// Throws it unless so many files can be opened now.
void checkOpenFiles(int count);

}  // namespace drillwave

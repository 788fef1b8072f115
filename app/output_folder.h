// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that a command writes: all of its files or none.
#pragma once

#include <string>
#include <vector>

#include "app/interruption.h"
#include "app/output_file.h"
#include "core/disk/whole_folder.h"

namespace drillwave {

/// Finds out before anything is computed whether files of these names can be written into a folder. Throws
/// CommandError (unwritable output).
void checkFolder(const std::string& path, const std::vector<std::string>& names, Overwrite overwrite);

/// Writes as writeWholeFolder() does; an interruption, if there is one, may end it before anything is
/// written, and not after. Throws CommandError: unwritable output; interrupted.
void writeFolder(const std::string& path, const FolderFiles& files, Overwrite overwrite,
                 const Interruption* interruption);

}  // namespace drillwave

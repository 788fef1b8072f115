// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a folder of results: all of its files or none.
#pragma once

#include <string>
#include <vector>

#include "app/interruption.h"
#include "app/output_file.h"
#include "core/disk/whole_folder.h"

namespace drillwave {

/// Throws CommandError (unwritable output) if files of these names cannot be written into the folder. Call it
/// before any computation.
void checkFolder(const std::string& path, const std::vector<std::string>& names, Overwrite overwrite);

/// Writes files into a folder: either all or none (see writeWholeFolder()). An interruption cancels this only
/// until the first file is in place; nullptr if there is none. Throws CommandError: unwritable output;
/// interrupted.
void writeFolder(const std::string& path, const FolderFiles& files, Overwrite overwrite,
                 const Interruption* interruption);

}  // namespace drillwave

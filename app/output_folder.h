// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that a command writes: all of its files or none.
#pragma once

#include <string>

#include "app/interruption.h"
#include "app/output_file.h"
#include "ui/export/whole_folder.h"

namespace drillwave {

/// Finds out before anything is computed whether files of these names can be written into a folder. Throws
/// CommandError (unwritable output).
void checkFolder(const std::string& path, const QStringList& names, Overwrite overwrite);

/// As writeWholeFolder(). Throws CommandError: unwritable output; interrupted, before anything was written.
void writeFolder(const std::string& path, const FolderFiles& files, Overwrite overwrite,
                 const Interruption& interruption);

/// What became of a folder, as an exception where it was not written.
void checkWritten(const FolderEnd& end, const std::string& path, const QStringList& names,
                  Overwrite overwrite, const Interruption& interruption);

ExistingFiles existingFiles(Overwrite overwrite);

}  // namespace drillwave

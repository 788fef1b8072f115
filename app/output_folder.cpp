// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_folder.h"

#include "app/command_error.h"

namespace drillwave {

namespace {

void checkNames(const std::string& path, const std::vector<std::string>& names, Overwrite overwrite) {
    for (const std::string& name : names) checkOverwrite(path + "/" + name, overwrite);
}

}  // namespace

void checkFolder(const std::string& path, const std::vector<std::string>& names, Overwrite overwrite) {
    checkName(path);
    if (const Message problem = folderProblem(path, {}, ExistingFiles::replaced); !problem.isEmpty())
        throw CommandError(ExitCode::unwritableOutput, problem.text());
    checkNames(path, names, overwrite);
}

void writeFolder(const std::string& path, const FolderFiles& files, Overwrite overwrite,
                 const Interruption& interruption) {
    const auto existing = overwrite == Overwrite::allowed ? ExistingFiles::replaced : ExistingFiles::kept;
    const FolderEnd end = writeWholeFolder(path, files, existing, interruption.token());
    if (end.isWritten()) return interruption.ignoreFromNowOn();
    interruption.check();
    // Another run may have been faster: that is said as it would have been before the work.
    checkNames(path, files.names(), overwrite);
    throw CommandError(ExitCode::unwritableOutput, end.problem.text());
}

}  // namespace drillwave

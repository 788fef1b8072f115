// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_folder.h"

#include "app/command_error.h"
#include "app/scenario_argument.h"
#include "core/disk/hidden_folder.h"

namespace drillwave {

namespace {

void checkNames(const std::string& path, const std::vector<std::string>& names, Overwrite overwrite) {
    for (const std::string& name : names) checkOverwrite(pathInside(path, name), overwrite);
}

}  // namespace

void checkFolder(const std::string& path, const std::vector<std::string>& names, Overwrite overwrite) {
    checkName(path);
    mendFolder(path);
    if (const Message problem = folderProblem(path, {}, ExistingFiles::replaced); !problem.isEmpty())
        throw CommandError(ExitCode::unwritableOutput, problem);
    checkNames(path, names, overwrite);
}

void writeFolder(const std::string& path, const FolderFiles& files, Overwrite overwrite,
                 const Interruption* interruption) {
    const auto existing = overwrite == Overwrite::allowed ? ExistingFiles::replaced : ExistingFiles::kept;
    const auto onLongWait = [&](const std::string& lock) {
        printRemark(
            {translatable(
                 "waiting for another run of drillwave, which holds the lock %1; Ctrl-C stops waiting"),
             {lock}},
            interruption ? interruption->style() : plainStyle());
    };
    FolderFiles rewritten = files;
    for (NamedFile& file : rewritten.files) file.bytes = bytesInSigns(file);
    const FolderEnd end = writeWholeFolder(
        path, rewritten, existing, interruption ? interruption->token() : std::stop_token(), onLongWait);
    if (end.isWritten()) {
        if (interruption) interruption->disable();
        return;
    }
    if (interruption) interruption->check();
    // Another run may have been faster: report that as before the work.
    checkNames(path, files.names(), overwrite);
    if (files.outdated) checkNames(path, files.outdated(path), overwrite);
    throw CommandError(ExitCode::unwritableOutput, end.problem);
}

}  // namespace drillwave

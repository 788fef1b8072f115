// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_folder.h"

#include "app/command_error.h"

namespace drillwave {

namespace {

void checkNames(const std::string& path, const QStringList& names, Overwrite overwrite) {
    for (const QString& name : names) checkOverwrite(path + "/" + name.toStdString(), overwrite);
}

}  // namespace

ExistingFiles existingFiles(Overwrite overwrite) {
    return overwrite == Overwrite::allowed ? ExistingFiles::replaced : ExistingFiles::kept;
}

void checkFolder(const std::string& path, const QStringList& names, Overwrite overwrite) {
    const QString problem = folderProblem(fileName(path), {}, ExistingFiles::replaced);
    if (!problem.isEmpty()) throw CommandError(ExitCode::unwritableOutput, problem.toStdString());
    checkNames(path, names, overwrite);
}

void writeFolder(const std::string& path, const FolderFiles& files, Overwrite overwrite,
                 const Interruption& interruption) {
    const FolderEnd end =
        writeWholeFolder(fileName(path), files, existingFiles(overwrite), interruption.token());
    checkWritten(end, path, files.names(), overwrite, interruption);
}

void checkWritten(const FolderEnd& end, const std::string& path, const QStringList& names,
                  Overwrite overwrite, const Interruption& interruption) {
    if (end.isWritten()) return interruption.ignoreFromNowOn();
    interruption.check();
    // Another run may have been faster: that is said as it would have been before the work.
    checkNames(path, names, overwrite);
    throw CommandError(ExitCode::unwritableOutput, end.problem.toStdString());
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are written into a folder together: all of them or none.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

class WholeFile;

/// File to be written, with its contents in memory.
struct NamedFile {
    std::string name;  ///< name without a folder
    std::string bytes;
};

/// Files to be written together into a folder.
struct FolderFiles {
    /// Files in order. The last one is removed first and written last, so that a folder that has it is
    /// complete, even after a power failure.
    std::vector<NamedFile> files;
    /// Function that returns the names of files that an earlier run wrote into the given folder, and which
    /// would not fit the new ones. With ExistingFiles::replaced these files are deleted or replaced. With
    /// ExistingFiles::kept any such file makes writing fail. May be empty.
    std::function<std::vector<std::string>(const std::string& folder)> outdated;
    /// File that is too long to keep in memory; nullptr if there is none. Its contents are already in the
    /// folder, under a temporary name or none. Its final name is given after all other files are written.
    WholeFile* last = nullptr;

    std::vector<std::string> names() const;
};

enum class ExistingFiles { kept, replaced };

/// Result of writing files into a folder.
struct FolderEnd {
    enum class Kind { written, stopped, failed } kind = Kind::written;
    Message problem;  ///< reason, for Kind::failed: one line that begins with the path
    bool isWritten() const { return kind == Kind::written; }
};

/// Callback for a long wait, with the path of the lock file. It is called once if another run has held the
/// lock of the folder for two seconds.
using OnLongWait = std::function<void(const std::string& lockPath)>;

/// Writes files into a folder, all of them or none, also after a failure or a stop request. Several runs of
/// this program may write there at the same time. If existing files are kept, at most one of these runs
/// succeeds; if they are replaced, the last run determines all files. Returns whether the files were written.
///
/// The files are first written into a hidden folder on the same disk. If `folder` does not exist yet, the
/// hidden folder is renamed to it. Otherwise the files are exchanged one by one, under a lock that other runs
/// respect. Exchanging whole folders would lose files that others put there meanwhile, disturb programs that
/// use the folder, and fail on mount points. All old files are removed before the first new one appears, so
/// that files of two sets are never mixed. If a run dies meanwhile, mendFolder(), with which every run
/// begins, repairs the folder. Other files are never changed. A symbolic link with the name of a new file is
/// replaced, not followed.
FolderEnd writeWholeFolder(const std::string& folder, const FolderFiles& files, ExistingFiles existing,
                           const std::stop_token& stop = {}, const OnLongWait& onLongWait = {});

/// Returns why writeWholeFolder() would fail, as far as this is known without writing; empty if no reason is
/// known.
Message folderProblem(const std::string& folder, const std::vector<std::string>& names,
                      ExistingFiles existing);

/// Returns the reason why this process cannot use the lock file of a folder, in one line that begins with its
/// path. Empty if it can, if another run holds the lock, or if there is no lock file.
Message lockProblem(const std::string& folder);

/// Returns whether the path exists, including a symbolic link without a target.
bool isThere(const std::string& path);

/// Returns the path of a file in a folder: "results/map.csv", and only "map.csv" for the folder ".".
std::string pathInside(const std::string& folder, const std::string& name);

}  // namespace drillwave

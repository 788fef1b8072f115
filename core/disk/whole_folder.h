// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a folder put in place together: all of them or none.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

class WholeFile;

/// A file to be, complete in memory.
struct NamedFile {
    std::string name;  ///< without a folder
    std::string bytes;
};

/// Files to be written into a folder.
struct FolderFiles {
    /// In the order of appearance: the last one goes first and comes last, so that even after a power failure
    /// a folder that has it is complete.
    std::vector<NamedFile> files;
    /// Names of files in the folder, whose path it is given, that an earlier set left and that would show
    /// something else than these: they go with the files that are replaced, and are in the way where existing
    /// ones are kept. May be empty.
    std::function<std::vector<std::string>(const std::string& folder)> outdated;
    /// File written after all others, too long for memory and already in the folder; or none.
    WholeFile* last = nullptr;

    std::vector<std::string> names() const;
};

enum class ExistingFiles { kept, replaced };

/// End of writing a folder.
struct FolderEnd {
    enum class Kind { written, stopped, failed } kind = Kind::written;
    Message problem;  ///< Kind::failed: one line that begins with the path
    bool isWritten() const { return kind == Kind::written; }
};

/// Called once with the path of the lock that another run has held for a while.
using OnLongWait = std::function<void(const std::string& lockPath)>;

/// Writes files into a folder, which afterwards holds all of them or is as it was: also on a failure, on a
/// stop, and with other runs of this program writing there at the same time, of which at most one succeeds
/// where existing files are kept, and the last one wins whole where they are replaced.
///
/// The files are written into a hidden folder on the same disk first. Where `folder` is not there yet, that
/// is renamed to it. Where it is, the files change places one by one, under a lock that other runs respect:
/// exchanging whole folders would lose what others put there meanwhile, pull the folder away from under
/// whoever works in it, and fail on mount points. All that is replaced goes before the first file comes, so
/// that never files of two sets stand side by side; a run that dies meanwhile leaves what mendFolder(), which
/// every run begins with, puts right. Files of other names are never touched. A link of such a name is
/// replaced, not followed.
FolderEnd writeWholeFolder(const std::string& folder, const FolderFiles& files, ExistingFiles existing,
                           const std::stop_token& stop = {}, const OnLongWait& onLongWait = {});

/// Returns why writeWholeFolder() would fail, as far as known without writing; empty if it should not.
Message folderProblem(const std::string& folder, const std::vector<std::string>& names,
                      ExistingFiles existing);

/// Why the lock of a folder cannot be opened, in one line that begins with its path; empty when it can or
/// there is none.
Message lockProblem(const std::string& folder);

/// Whether anything of that name is there, also a link that leads nowhere.
bool isThere(const std::string& path);

/// The path of a file in a folder; "." does not show.
std::string pathInside(const std::string& folder, const std::string& name);

}  // namespace drillwave

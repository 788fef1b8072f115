// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden folder in which new files wait until they replace those of the folder around it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/disk/whole_file.h"

namespace drillwave {

// Lock on a folder, respected by all runs of this program.

/// Lock on a folder: a hidden file in it that this process has locked. The destructor removes the file.
class FolderLock {
  public:
    static constexpr std::string_view fileName = ".drillwave.lock";

    explicit FolderLock(const std::string& folder) : m_path(folder + "/" + std::string(fileName)) {}
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Tries to take the lock. Returns 0 if this process now holds it, EWOULDBLOCK if another process does,
    /// else the errno. Leaves no file on a disk without locks. Does not follow a symbolic link at the path of
    /// the lock.
    int tryLock();

    const std::string& path() const { return m_path; }

  private:
    std::string m_path;
    int m_descriptor = -1;
};

/// Returns whether an error of tryLock() means that the disk does not support locks. A lock held by another
/// process is no such error.
bool isLockingUnsupported(int error);

/// Hidden folder for an exchange of files in the folder around it: `new` contains new files, `old` the
/// replaced ones. The destructor removes it with its contents. The process holds a lock on it. If the process
/// dies, its lock disappears. The next run then completes or undoes the exchange (mendFolder()).
class HiddenFolder {
  public:
    HiddenFolder() = default;
    ~HiddenFolder();
    HiddenFolder(const HiddenFolder&) = delete;
    HiddenFolder& operator=(const HiddenFolder&) = delete;

    /// Makes the hidden folder in `parent`. Returns 0, or the errno on failure.
    int make(const std::string& parent);
    bool isMade() const { return !m_path.empty(); }

    std::string newFolder() const { return m_path + "/new"; }
    std::string newFile(const std::string& name) const { return newFolder() + "/" + name; }
    std::string oldFile(const std::string& name) const { return m_path + "/old/" + name; }

    /// Writes the names of the files to be exchanged into the subfolder `new`, before the first file is
    /// moved. If this process dies before endExchange(), the next run repairs the folder that contains this
    /// hidden one. Returns an empty failure when done.
    WriteFailure beginExchange(const std::vector<std::string>& names);
    /// Ends an exchange of files by removing the list of names that beginExchange() wrote. Without this list,
    /// a later run sees nothing to repair. Requires that all files were moved, or none.
    void endExchange();

  private:
    std::string m_path;
    std::unique_ptr<FolderLock> m_lock;
};

/// Repairs a folder in which other runs of the program crashed while exchanging files. Restores files that
/// they had moved away, and removes their new files and hidden folders. A completed exchange remains valid.
/// Requires the lock of the folder.
void mendLockedFolder(const std::string& folder);

/// Repairs a folder in which runs of the program crashed while they exchanged files; see mendLockedFolder().
/// Takes the lock of the folder for this. Does nothing if another process holds the lock.
void mendFolder(const std::string& folder);

}  // namespace drillwave

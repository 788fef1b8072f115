// SPDX-License-Identifier: GPL-3.0-or-later
// Where files wait that are to change places with those of the folder around them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/disk/whole_file.h"

namespace drillwave {

// A lock on a folder among runs of this program.

/// A hidden file in the folder, held by the process and gone with it.
class FolderLock {
  public:
    static constexpr std::string_view fileName = ".drillwave.lock";

    explicit FolderLock(const std::string& folder) : m_path(folder + "/" + std::string(fileName)) {}
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Returns 0 when it is held, EWOULDBLOCK while another one holds it, or the errno of why not. Leaves no
    /// file behind on a disk without locks. Does not follow a link of that name.
    int tryLock();

    const std::string& path() const { return m_path; }

  private:
    std::string m_path;
    int m_descriptor = -1;
};

/// Returns whether an error of tryLock() means that the disk has no locks, not that one is held.
bool isLockingUnsupported(int error);

/// A folder with an unused name in another one: `new` holds new files, `old` the replaced ones. It is removed
/// with all that is still in it. Its run holds a lock while it lives; a folder left by a run that died is
/// recognised by its missing lock, and the next run repairs the exchange (mendFolder()).
class HiddenFolder {
  public:
    HiddenFolder() = default;
    ~HiddenFolder();
    HiddenFolder(const HiddenFolder&) = delete;
    HiddenFolder& operator=(const HiddenFolder&) = delete;

    /// 0, or the errno.
    int make(const std::string& parent);
    bool isMade() const { return !m_path.empty(); }

    std::string newFolder() const { return m_path + "/new"; }
    std::string newFile(const std::string& name) const { return newFolder() + "/" + name; }
    std::string oldFile(const std::string& name) const { return m_path + "/old/" + name; }

    /// Writes the list of names in `new`, before the first file is moved. Until endExchange() the next run
    /// repairs the folder around it if this run dies.
    WriteFailure beginExchange(const std::vector<std::string>& names);
    /// Ends an exchange in which all files were moved, or none.
    void endExchange();

  private:
    std::string m_path;
    std::unique_ptr<FolderLock> m_lock;
};

/// Restores the files that runs which died in the middle of an exchange had put aside in this folder, and
/// removes their new files and all else they left hidden. An exchange that only lacked cleaning stays done.
/// Requires the lock of the folder.
void mendLockedFolder(const std::string& folder);

/// Does the same under the lock, if there is anything to repair and nobody else holds the lock.
void mendFolder(const std::string& folder);

}  // namespace drillwave

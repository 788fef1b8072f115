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

/// Whether an error of tryLock() says that there are no locks on that disk, rather than that one is held.
bool areLocksUnknown(int error);

/// A folder with a name that nobody knows, in another one: `new` holds what is to come, `old` what had to
/// give way. It goes with all that is still in it. While its run lives it holds a lock; what a run that died
/// leaves is recognised by that, and mended by the next one (mendFolder()).
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

    /// Before the first file changes places: the names of those in `new`. Until endExchange() the folder
    /// around is mended if this run dies.
    WriteFailure beginExchange(const std::vector<std::string>& names);
    /// All have changed places, or none has.
    void endExchange();

  private:
    std::string m_path;
    std::unique_ptr<FolderLock> m_lock;
};

/// Brings the files back that runs which died in the middle of an exchange had put aside in this folder,
/// takes theirs away, and what else they left hidden. An exchange that was done but for cleaning stays done.
/// The caller holds the lock of the folder.
void mendLockedFolder(const std::string& folder);

/// The same under the lock, if there is anything to be mended and nobody else is at it.
void mendFolder(const std::string& folder);

}  // namespace drillwave

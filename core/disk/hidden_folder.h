// SPDX-License-Identifier: GPL-3.0-or-later
// Where files wait that are to change places with those of the folder around them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/disk/folder_lock.h"
#include "core/disk/whole_file.h"

namespace drillwave {

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

// SPDX-License-Identifier: GPL-3.0-or-later
// A lock on a folder among runs of this program.
#pragma once

#include <string>
#include <string_view>

namespace drillwave {

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

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>

namespace drillwave {

namespace {

/// Whether the path still leads to the open file: the one before may have taken it away meanwhile.
bool isStill(int descriptor, const std::string& path) {
    struct stat held {};
    struct stat there {};
    return ::fstat(descriptor, &held) == 0 && ::stat(path.c_str(), &there) == 0 &&
           held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

}  // namespace

FolderLock::~FolderLock() {
    if (m_descriptor < 0) return;
    ::unlink(m_path.c_str());
    ::close(m_descriptor);
}

int FolderLock::tryLock() {
    assert(m_descriptor < 0);
    const int descriptor = ::open(m_path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor < 0) return errno;
    int error = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == 0 && !isStill(descriptor, m_path)) error = EWOULDBLOCK;
    if (error == 0)
        m_descriptor = descriptor;
    else
        ::close(descriptor);
    return error;
}

}  // namespace drillwave

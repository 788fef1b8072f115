// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/folder_lock.h"

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
    return ::fstat(descriptor, &held) == 0 && ::lstat(path.c_str(), &there) == 0 &&
           held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

}  // namespace

bool areLocksUnknown(int error) {
    return error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP;
}

FolderLock::~FolderLock() {
    if (m_descriptor < 0) return;
    // Where it is gone with its folder, one of that name is somebody else's.
    if (isStill(m_descriptor, m_path)) ::unlink(m_path.c_str());
    ::close(m_descriptor);
}

int FolderLock::tryLock() {
    assert(m_descriptor < 0);
    // A link of that name could make a file anywhere, and a pipe would wait for a writer.
    constexpr int flags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    int descriptor = ::open(m_path.c_str(), O_CREAT | O_RDWR | flags, 0666);
    if (descriptor < 0) {
        // What another user has left, in a folder for all, cannot be written to but locked all the same.
        const int reason = errno;
        if (reason == EACCES) descriptor = ::open(m_path.c_str(), O_RDONLY | flags);
        if (descriptor < 0) return reason;
    }
    int error = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == 0 && !isStill(descriptor, m_path)) error = EWOULDBLOCK;
    // On a disk without locks nobody holds this one: it would be left behind.
    if (areLocksUnknown(error) && isStill(descriptor, m_path)) ::unlink(m_path.c_str());
    if (error == 0)
        m_descriptor = descriptor;
    else
        ::close(descriptor);
    return error;
}

}  // namespace drillwave

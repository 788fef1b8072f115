// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/hidden_folder.h"

#include <fcntl.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp() is POSIX
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/disk/file_bytes.h"
#include "core/disk/whole_folder.h"

namespace drillwave {

namespace {

/// Whether the path still leads to the open file: the one before may have taken it away meanwhile.
bool isStill(int descriptor, const std::string& path) {
    struct stat held {};
    struct stat there {};
    return ::fstat(descriptor, &held) == 0 && ::lstat(path.c_str(), &there) == 0 &&
           held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

namespace fs = std::filesystem;

constexpr std::string_view namesBegin = ".drillwave-";

std::string listIn(const std::string& hidden) {
    return hidden + "/exchange";
}

/// Names end with NUL, the only byte that they cannot hold.
std::vector<std::string> namesIn(const std::string& hidden) {
    constexpr std::size_t mostBytes = std::size_t{1} << 20;
    std::vector<std::string> names;
    const FileBytes list = readFile(listIn(hidden), mostBytes);
    std::string_view rest = list.bytes;
    for (std::size_t end = rest.find('\0'); end != std::string_view::npos; end = rest.find('\0')) {
        names.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end + 1);
    }
    return names;
}

std::vector<std::string> filesIn(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        names.push_back(entry->path().filename());
    return names;
}

/// Returns the folders that other runs, alive or dead, have hidden there.
std::vector<std::string> hiddenIn(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code ignored;
    for (const std::string& name : filesIn(folder))
        if (name.starts_with(namesBegin) && fs::is_directory(pathInside(folder, name), ignored))
            paths.push_back(pathInside(folder, name));
    return paths;
}

/// Restores the state before the exchange. Can be interrupted and repeated.
void takeBack(const std::string& folder, const std::string& hidden) {
    const std::string come = hidden + "/new", gone = hidden + "/old";
    for (const std::string& name : namesIn(hidden))
        if (!isThere(pathInside(come, name)))
            std::rename(pathInside(folder, name).c_str(), pathInside(come, name).c_str());
    // Files of that name put there meanwhile are kept.
    for (const std::string& name : filesIn(gone))
        if (!isThere(pathInside(folder, name)))
            std::rename(pathInside(gone, name).c_str(), pathInside(folder, name).c_str());
}

/// Removes everything but the lock: without it another run could begin to restore what is half removed.
void removeContents(const std::string& hidden) {
    std::error_code ignored;
    fs::remove(listIn(hidden), ignored);
    for (const std::string& name : filesIn(hidden))
        if (name != FolderLock::fileName) fs::remove_all(pathInside(hidden, name), ignored);
}

void mend(const std::string& folder, const std::string& hidden) {
    {
        FolderLock lock(hidden);
        if (lock.tryLock() != 0) return;
        if (!filesIn(hidden + "/new").empty()) takeBack(folder, hidden);
        removeContents(hidden);
    }
    // Stays if the run that is just making it has already locked it.
    ::rmdir(hidden.c_str());
}

/// One that can be locked, with what belongs into it. 0, or the errno: ENOENT or EWOULDBLOCK where a mending
/// run found it before it was locked, and took it for that of a dead one.
int makeLocked(const std::string& path, std::unique_ptr<FolderLock>& lock) {
    lock = std::make_unique<FolderLock>(path);
    int error = lock->tryLock();
    // On a disk without locks it also works, but is not repaired after a failure.
    if (isLockingUnsupported(error)) error = 0;
    for (const char* part : {"/new", "/old"}) {
        std::error_code problem;
        if (error == 0 && !fs::create_directory(path + part, problem)) error = problem.value();
    }
    return error;
}

}  // namespace

bool isLockingUnsupported(int error) {
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
        // A lock file of another user, in a folder for all, cannot be written to but can be locked.
        const int reason = errno;
        if (reason == EACCES) descriptor = ::open(m_path.c_str(), O_RDONLY | flags);
        if (descriptor < 0) return reason;
    }
    int error = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == 0 && !isStill(descriptor, m_path)) error = EWOULDBLOCK;
    // On a disk without locks nobody holds this one: it would be left there.
    if (isLockingUnsupported(error) && isStill(descriptor, m_path)) ::unlink(m_path.c_str());
    if (error == 0)
        m_descriptor = descriptor;
    else
        ::close(descriptor);
    return error;
}

HiddenFolder::~HiddenFolder() {
    if (m_path.empty()) return;
    removeContents(m_path);
    m_lock.reset();
    if (::rmdir(m_path.c_str()) == 0 || errno != ENOTEMPTY) return;
    // With the open file of the lock to spare, which may have been the last one permitted.
    removeContents(m_path);
    ::rmdir(m_path.c_str());
}

int HiddenFolder::make(const std::string& parent) {
    assert(!isMade());
    constexpr int mostAttempts = 100;
    int error = 0;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        std::string path = pathInside(parent, std::string(namesBegin) + "XXXXXX");
        if (!::mkdtemp(path.data())) return errno;
        error = makeLocked(path, m_lock);
        if (error == 0) {
            m_path = std::move(path);
            return 0;
        }
        const bool isTaken = error == ENOENT || error == EWOULDBLOCK;
        m_lock.reset();
        std::error_code ignored;
        if (!isTaken) fs::remove_all(path, ignored);
        ::rmdir(path.c_str());  // needs no open file, of which there may be none left
        if (!isTaken) break;
    }
    return error;
}

WriteFailure HiddenFolder::beginExchange(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += name + '\0';
    return replaceFile(listIn(m_path), list);
}

void HiddenFolder::endExchange() {
    ::unlink(listIn(m_path).c_str());
}

void mendLockedFolder(const std::string& folder) {
    for (const std::string& hidden : hiddenIn(folder)) mend(folder, hidden);
}

void mendFolder(const std::string& folder) {
    if (hiddenIn(folder).empty() && !isThere(pathInside(folder, std::string(FolderLock::fileName)))) return;
    FolderLock lock(folder);
    if (lock.tryLock() == 0) mendLockedFolder(folder);
}

}  // namespace drillwave

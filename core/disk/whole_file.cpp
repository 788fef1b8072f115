// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace drillwave {

namespace {

/// Names that nobody else has, for all tries of all processes.
std::string nameBeside(const std::string& path, int attempt) {
    return path + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt);
}

/// Does what takes a name that is free, with one name after the other; 0 or the errno.
template <class Take>
int takeFreeName(const std::string& path, std::string& name, const Take& take) {
    for (int attempt = 0;; ++attempt) {
        name = nameBeside(path, attempt);
        if (take(name) >= 0) return 0;
        if (errno != EEXIST) return errno;
    }
}

/// By which a file without a name can be given one.
std::string handleOf(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

}  // namespace

WriteFailure writeFailure(int error) {
    return {std::generic_category().message(error), error == ENOSPC};
}

std::string behindLinks(const std::string& path) {
    constexpr int mostLinks = 128;
    std::filesystem::path file = path;
    std::error_code error;
    for (int links = 0; std::filesystem::is_symlink(file, error); ++links) {
        const std::filesystem::path target = std::filesystem::read_symlink(file, error);
        if (error || links == mostLinks) return path;
        file = file.parent_path() / target;
    }
    return file;
}

WriteFailure writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR)
            return writeFailure(errno);
    }
    return {};
}

WholeFile::~WholeFile() {
    if (m_descriptor >= 0) ::close(m_descriptor);
    if (!m_beside.empty() && !m_isKept) ::unlink(m_beside.c_str());
}

WriteFailure WholeFile::open() {
    assert(m_descriptor < 0);
    struct stat before {};
    const bool exists = ::stat(m_path.c_str(), &before) == 0;
    if (exists && ::access(m_path.c_str(), W_OK) != 0) return writeFailure(errno);
    if (exists && S_ISDIR(before.st_mode)) return {"Filename refers to a directory", false};
    m_path = behindLinks(m_path);
    // Until it has the permissions of what it replaces, nobody else shall read it.
    const mode_t mode = exists ? 0600 : 0666;
    const std::filesystem::path folder = std::filesystem::path(m_path).parent_path();
    if (::access("/proc/self/fd", X_OK) == 0)
        m_descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
    if (m_descriptor < 0) {
        std::string name;
        const int error = takeFreeName(m_path, name, [&](const std::string& free) {
            return m_descriptor = ::open(free.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
        });
        if (error != 0) return writeFailure(error);
        m_beside = std::move(name);
    }
    if (exists && ::fchmod(m_descriptor, before.st_mode & 0777) != 0) return writeFailure(errno);
    return {};
}

WriteFailure WholeFile::openKept(const std::string& kept, std::uint64_t bytes) {
    assert(m_descriptor < 0);
    m_path = behindLinks(m_path);
    m_descriptor = ::open(kept.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (m_descriptor < 0 || ::ftruncate(m_descriptor, static_cast<off_t>(bytes)) != 0)
        return writeFailure(errno);
    m_beside = kept;
    m_isKept = true;
    return {};
}

WriteFailure WholeFile::write(std::string_view bytes) {
    assert(m_descriptor >= 0);
    if (!m_failure) m_failure = writeAll(m_descriptor, bytes);
    return m_failure;
}

WriteFailure WholeFile::commitAs(const std::string& path) {
    assert(m_descriptor >= 0);
    if (m_failure) return m_failure;
    // Some disks do not support it: then the file is as safe as it can be.
    ::fsync(m_descriptor);
    if (const WriteFailure failure = giveName(path)) return failure;
    // Disks of other machines may only report here that there was no room.
    if (::close(std::exchange(m_descriptor, -1)) != 0) return writeFailure(errno);
    if (std::rename(m_beside.c_str(), path.c_str()) != 0) return writeFailure(errno);
    m_beside.clear();
    return {};
}

WriteFailure WholeFile::giveName(const std::string& path) {
    if (!m_beside.empty()) return {};
    const std::string handle = handleOf(m_descriptor);
    std::string name;
    const int error = takeFreeName(path, name, [&](const std::string& free) {
        return ::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, free.c_str(), AT_SYMLINK_FOLLOW);
    });
    if (error != 0) return writeFailure(error);
    m_beside = std::move(name);
    return {};
}

WriteFailure replaceFile(const std::string& path, std::string_view bytes) {
    WholeFile file(path);
    if (const WriteFailure failure = file.open()) return failure;
    if (const WriteFailure failure = file.write(bytes)) return failure;
    return file.commit();
}

Message notWritten(const std::string& name, const WriteFailure& failure) {
    return {failure.isFull
                ? translatable("%1: cannot be written: %2; free some space or choose another place")
                : translatable("%1: cannot be written: %2; choose another place"),
            {name, failure.reason}};
}

}  // namespace drillwave

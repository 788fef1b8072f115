// SPDX-License-Identifier: GPL-3.0-or-later
// File that is written completely or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Reason why something could not be written; an empty reason means success.
struct WriteFailure {
    std::string reason;   ///< reason in the words of the operating system
    bool isFull = false;  ///< whether the disk is full, so that freeing space helps

    explicit operator bool() const { return !reason.empty(); }
};

/// Returns the reason, in words, for an error code (errno) of the operating system.
WriteFailure writeFailure(int error);

/// Writes all bytes to an open file. Returns an empty failure when done.
WriteFailure writeAll(int descriptor, std::string_view bytes);

/// Writer of new contents of a file, which replace the old contents all at once in commit(). Until then the
/// new file has no name, or a temporary name beside the old one if the disk requires it. Without commit()
/// nothing remains. A symbolic link stays a link to the file, and permissions stay.
class WholeFile {
  public:
    explicit WholeFile(std::string path) : m_path(std::move(path)) {}
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Opens the new file for writing. Either this or openKept() must be called first. Returns an empty
    /// failure when done.
    WriteFailure open();
    /// Opens the file `kept`, or makes it, for writing; commit() then makes it the new file. The first
    /// `bytes` bytes of it remain, and later writes are appended. It must be on the same disk. Without
    /// commit(), `kept` remains, so that writing can continue later. Returns an empty failure when done.
    WriteFailure openKept(const std::string& kept, std::uint64_t bytes);
    WriteFailure write(std::string_view bytes);
    /// Waits until all bytes are on the disk, and then replaces the file. Returns an empty failure when done.
    WriteFailure commit() { return commitAs(m_path); }
    /// Moves the new file to another path on the same disk, once all bytes are on the disk; the file at
    /// path() remains. The caller can then move it into place. Returns an empty failure when done.
    WriteFailure commitAs(const std::string& path);

    /// Returns the path of the file to be replaced. It is the path given; after open(), all symbolic links in
    /// it are resolved.
    const std::string& path() const { return m_path; }

  private:
    WriteFailure giveName(const std::string& path);

    std::string m_path;
    std::string m_beside;  // temporary name, empty if the file has none
    bool m_isKept = false;
    int m_descriptor = -1;
    WriteFailure m_failure;  // first failure of write()
};

/// Returns the path after resolving all symbolic links, even if the file does not exist yet. Returns the path
/// itself if the links form a circle.
std::string behindLinks(const std::string& path);

/// Writes a file so that old contents are replaced all at once. On failure the old file remains unchanged.
/// Returns an empty failure when done.
WriteFailure replaceFile(const std::string& path, std::string_view bytes);

/// Returns the message on a failure in one line that begins with `name`: "out.csv: cannot be written: …".
Message notWritten(const std::string& name, const WriteFailure& failure);

}  // namespace drillwave

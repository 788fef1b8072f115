// SPDX-License-Identifier: GPL-3.0-or-later
// A file written whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Why something could not be written; no reason where it was.
struct WriteFailure {
    std::string reason;   ///< as the system says it
    bool isFull = false;  ///< the disk is: it helps to free some space

    explicit operator bool() const { return !reason.empty(); }
};

/// The reason of an errno.
WriteFailure writeFailure(int error);

/// Writes all bytes to an open file.
WriteFailure writeAll(int descriptor, std::string_view bytes);

/// A file on its way. It has no name, or on disks that know no such files one of its own beside the file, and
/// takes the place of that in commit(); without, nothing is left of it. A link stays a link to the file,
/// permissions stay.
class WholeFile {
  public:
    explicit WholeFile(std::string path) : m_path(std::move(path)) {}
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Before anything else.
    WriteFailure open();
    /// Instead: goes on behind the first `bytes` of the file `kept` on the same disk, which stays where the
    /// file never takes its place.
    WriteFailure openKept(const std::string& kept, std::uint64_t bytes);
    WriteFailure write(std::string_view bytes);
    /// Puts the file in place when all of it is on the disk.
    WriteFailure commit() { return commitAs(m_path); }
    /// Gives it another name on the same disk instead, so that others can put it in place.
    WriteFailure commitAs(const std::string& path);

    /// Where it is to be: as given until open(), then behind all links.
    const std::string& path() const { return m_path; }

  private:
    WriteFailure giveName(const std::string& path);

    std::string m_path;
    std::string m_beside;  // its name meanwhile, empty without
    bool m_isKept = false;
    int m_descriptor = -1;
    WriteFailure m_failure;  // the first one of write()
};

/// The file behind a link to a link …, also where it is not there yet; the link itself where they go in a
/// circle.
std::string behindLinks(const std::string& path);

/// Writes a whole file at once. On a failure the file is as it was.
WriteFailure replaceFile(const std::string& path, std::string_view bytes);

/// The failure in one line that begins with `name`, by which people know the file.
Message notWritten(const std::string& name, const WriteFailure& failure);

}  // namespace drillwave

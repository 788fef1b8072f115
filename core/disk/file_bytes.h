// SPDX-License-Identifier: GPL-3.0-or-later
// Files read whole, within a limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Bytes of a file, or why it could not be read ("cannot be opened: No such file or directory").
struct FileBytes {
    std::string bytes;
    Message problem;
};

/// Reads a regular file of at most `maximumBytes`; anything else (a folder, a pipe, a device) is refused
/// unread.
FileBytes readFile(const std::string& path, std::size_t maximumBytes);

/// Reads without the limit, but only the first `bytes` of the file.
FileBytes readStart(const std::string& path, std::size_t bytes);

/// Returns the message that a file cannot be opened, as in FileBytes.
Message cannotBeOpened(const Message& reason);

// Size and checksum of a file, by which a changed one is known.

/// Size and checksum of the bytes taken so far.
struct FileSum {
    std::uint64_t bytes = 0;
    std::uint32_t crc32 = 0;  ///< CRC-32 of ISO 3309, as gzip and zip have it

    void take(std::string_view text);
    /// The checksum in 8 hexadecimal digits: "0a1b2c3d".
    std::string checksum() const;
    bool operator==(const FileSum&) const = default;
};

/// The number that a FileSum's checksum() writes; nothing of another text.
std::optional<std::uint32_t> checksumOf(std::string_view text);

/// The sum of a text.
FileSum sumOf(std::string_view text);
/// The sum of a stream from here to its end.
FileSum sumOf(std::istream& stream);

}  // namespace drillwave

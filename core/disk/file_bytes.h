// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of whole files up to a size limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Bytes of a file, or the reason why it could not be read: "cannot be opened: No such file or directory".
struct FileBytes {
    std::string bytes;
    Message problem;
};

/// Returns the bytes of a regular file of at most `maximumBytes`. A larger file, a folder, a pipe or a device
/// gives a problem instead.
FileBytes readFile(const std::string& path, std::size_t maximumBytes);

/// Returns at most the first `bytes` of a regular file, which may be longer.
FileBytes readStart(const std::string& path, std::size_t bytes);

/// Returns the message that a file cannot be opened for this reason: "cannot be opened: No such file or
/// directory".
Message cannotBeOpened(const Message& reason);

// Size and checksum of a file, by which changes are detected.

/// Size and CRC-32 of a sequence of bytes. It begins with 0 bytes; take() adds the bytes of a text.
struct FileSum {
    std::uint64_t bytes = 0;
    std::uint32_t crc32 = 0;  ///< CRC-32 of ISO 3309, as in gzip and zip

    void take(std::string_view text);
    /// Returns the CRC-32 as 8 hexadecimal digits: "0a1b2c3d".
    std::string checksum() const;
    bool operator==(const FileSum&) const = default;
};

/// Returns the CRC-32 that 8 hexadecimal digits ("0a1b2c3d") stand for; nullopt for any other text.
std::optional<std::uint32_t> checksumOf(std::string_view text);

/// Returns size and CRC-32 of a text.
FileSum sumOf(std::string_view text);
/// Returns size and CRC-32 of a stream from its current position to its end.
FileSum sumOf(std::istream& stream);

}  // namespace drillwave

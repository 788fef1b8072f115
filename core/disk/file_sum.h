// SPDX-License-Identifier: GPL-3.0-or-later
// Size and checksum of a file, by which a changed one is known.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace drillwave {

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/file_sum.h"

#include <zlib.h>

#include <array>
#include <charconv>
#include <vector>

namespace drillwave {

void FileSum::take(std::string_view text) {
    crc32 = static_cast<std::uint32_t>(
        ::crc32_z(crc32, reinterpret_cast<const unsigned char*>(text.data()), text.size()));
    bytes += text.size();
}

std::string FileSum::checksum() const {
    std::array<char, 8> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), crc32, 16);
    const std::string text(digits.data(), end.ptr);
    return std::string(digits.size() - text.size(), '0') + text;
}

std::optional<std::uint32_t> checksumOf(std::string_view text) {
    std::uint32_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (text.size() != 8 || read.ec != std::errc() || read.ptr != text.data() + text.size())
        return std::nullopt;
    return number;
}

FileSum sumOf(std::string_view text) {
    FileSum sum;
    sum.take(text);
    return sum;
}

FileSum sumOf(std::istream& stream) {
    FileSum sum;
    std::vector<char> block(std::size_t{1} << 18);
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        sum.take({block.data(), static_cast<std::size_t>(stream.gcount())});
    }
    return sum;
}

}  // namespace drillwave

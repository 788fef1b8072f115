// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/file_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace drillwave {

Message cannotBeOpened(const Message& reason) {
    return {translatable("cannot be opened: %1"), {reason}};
}

FileBytes readStart(const std::string& path, std::size_t bytes) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        return {{}, cannotBeOpened(error ? Message(error.message()) : Message(translatable("no such file")))};
    if (std::filesystem::is_directory(status)) return {{}, translatable("is a folder, not a file")};
    if (!std::filesystem::is_regular_file(status)) return {{}, translatable("is not a regular file")};
    std::ifstream in(path, std::ios::binary);
    if (!in) return {{}, cannotBeOpened(std::generic_category().message(errno))};
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    // One byte more than it should have, in case the file grows or its size was not told right.
    std::string start(error ? bytes : std::min<std::uintmax_t>(size + 1, bytes), '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (in.bad()) return {{}, {translatable("cannot be read: %1"), {std::generic_category().message(errno)}}};
    start.resize(static_cast<std::size_t>(in.gcount()));
    return {std::move(start), {}};
}

FileBytes readFile(const std::string& path, std::size_t maximumBytes) {
    // One byte more than allowed tells a file at the limit from one beyond, whatever its size was said to be.
    FileBytes file = readStart(path, maximumBytes + 1);
    if (file.bytes.size() > maximumBytes)
        return {{},
                {translatable("is larger than the limit of %1 KiB"), {std::to_string(maximumBytes / 1024)}}};
    return file;
}

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

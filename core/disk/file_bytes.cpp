// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

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
                {translatable("is larger than %1 KiB, too large to be meant"),
                 {std::to_string(maximumBytes / 1024)}}};
    return file;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Files read whole, within a limit.
#pragma once

#include <cstddef>
#include <string>

#include "core/text/message.h"

namespace drillwave {

/// What was read, or why not ("cannot be opened: No such file or directory").
struct FileBytes {
    std::string bytes;
    Message problem;
};

/// Reads a regular file of at most `maximumBytes`; anything else (a folder, a pipe, a device) is refused
/// unread.
FileBytes readFile(const std::string& path, std::size_t maximumBytes);

/// The same without the limit, but no more than the first `bytes` of it.
FileBytes readStart(const std::string& path, std::size_t bytes);

/// That a file cannot be opened, as FileBytes has it.
Message cannotBeOpened(const Message& reason);

}  // namespace drillwave

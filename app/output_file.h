// SPDX-License-Identifier: GPL-3.0-or-later
// Where a command writes: standard output, or a file that appears whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/file/whole_file.h"

namespace drillwave {

enum class Overwrite { refused, allowed };

/// Throws CommandError (unwritable output) for a name with bytes that are not UTF-8: records and messages
/// could not tell it.
void checkName(const std::string& path);

/// Throws CommandError (unwritable output) when a file of that name exists and may not be overwritten.
void checkOverwrite(const std::string& path, Overwrite overwrite);

/// One output. All failures throw CommandError (unwritable output), at opening already where they can be
/// known then.
class OutputFile {
  public:
    /// "-" is standard output. A device or pipe is written directly. Anything else goes to a temporary file
    /// beside it, which replaces it in commit() and vanishes without.
    OutputFile(const std::string& path, Overwrite overwrite);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view text);
    /// Finds out whether everything written so far has found room.
    void flush();
    /// Makes everything written visible and durable as far as the system tells.
    void commit();

  private:
    /// Throws where there is a failure.
    void check(const WriteFailure& failure) const;

    std::string m_path;
    std::unique_ptr<WholeFile> m_file;  // none for standard output and devices
    int m_device = -1;
};

/// Writes a whole file at once.
void writeFile(const std::string& path, std::string_view text, Overwrite overwrite);

}  // namespace drillwave

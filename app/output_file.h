// SPDX-License-Identifier: GPL-3.0-or-later
// Where a command writes: standard output, or a file that appears whole or not at all.
#pragma once

#include <QSaveFile>
#include <memory>
#include <string>
#include <string_view>

namespace drillwave {

enum class Overwrite { refused, allowed };

/// Throws CommandError (unwritable output) when a file of that name exists and may not be overwritten.
void checkOverwrite(const std::string& path, Overwrite overwrite);

/// The path as Qt takes it. Throws CommandError (unwritable output) for bytes that are no UTF-8, which Qt
/// would turn into another name.
QString fileName(const std::string& path);

/// One output. All failures throw CommandError (unwritable output), at opening already where they can be
/// known then.
class OutputFile {
  public:
    /// "-" is standard output. A device or pipe is written directly. Anything else goes to a temporary file
    /// beside it, which replaces it in commit() and vanishes without.
    OutputFile(const std::string& path, Overwrite overwrite);

    void write(std::string_view text);
    /// Finds out whether everything written so far has found room.
    void flush();
    /// Makes everything written visible and durable as far as the system tells.
    void commit();

  private:
    [[noreturn]] void fail() const;

    std::string m_path;
    std::unique_ptr<QFileDevice> m_file;
};

/// Writes a whole file at once.
void writeFile(const std::string& path, std::string_view text, Overwrite overwrite);

}  // namespace drillwave

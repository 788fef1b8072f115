// SPDX-License-Identifier: GPL-3.0-or-later
// Input of a command: a file, standard input, or a pipe.
#pragma once

#include <cstdint>
#include <fstream>
#include <istream>
#include <string>
#include <utility>

#include "core/disk/file_bytes.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Whether a word names standard input: "-".
bool isStandardInput(const std::string& path);

/// Returns the name of an input in messages: the path, or "standard input".
std::string inputName(const std::string& path);

/// Reads no more than the first `most` bytes of a file, of standard input ("-") or of a pipe. Waits for a
/// pipe to be written to, and reports that in `style`.
FileBytes readInput(const std::string& path, std::size_t most, const ReadingStyle& style);

/// Rows that are read twice, once for checking and once for solving. Rows from a pipe are kept in a temporary
/// file meanwhile, in bounded memory and on a bounded part of the disk.
class RereadableInput {
  public:
    /// A longer pipe has most likely no end: this is some ten million rows.
    static constexpr std::uint64_t mostKept = std::uint64_t{1} << 30;

    /// Keeps up to `most` bytes of a pipe. Throws CommandError: unreadable input, of a pipe also one that is
    /// longer; unwritable output where there is no room for a temporary file.
    explicit RereadableInput(const std::string& path, std::uint64_t most = mostKept,
                             const ReadingStyle& style = plainStyle());

    /// Returns the stream, at its beginning. Throws CommandError (unreadable input) if the disk fails.
    std::istream& stream() { return m_stream; }

  private:
    /// A file buffer that reports which file cannot be read.
    class Buffer : public std::filebuf {
      public:
        explicit Buffer(std::string name) : m_name(std::move(name)) {}

      protected:
        int_type underflow() override;

      private:
        std::string m_name;
    };

    void keep(const std::string& path, std::uint64_t most, const ReadingStyle& style);

    Buffer m_buffer;
    std::istream m_stream{&m_buffer};
};

}  // namespace drillwave

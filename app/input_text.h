// SPDX-License-Identifier: GPL-3.0-or-later
// Reading the input of a command from a file, standard input or a pipe.
#pragma once

#include <cstdint>
#include <fstream>
#include <istream>
#include <string>
#include <utility>

#include "core/disk/file_bytes.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Returns true if `path` is "-", which stands for standard input.
bool isStandardInput(const std::string& path);

/// Returns the name of an input in messages: the path, or "standard input".
std::string inputName(const std::string& path);

/// Returns at most the first `most` bytes of a file, of standard input ("-") or of a pipe. On failure it
/// returns the reason instead. If standard input is a terminal, asks for input on stderr in the language of
/// `style`.
FileBytes readInput(const std::string& path, std::size_t most, const ReadingStyle& style);

/// Input that is read twice: once to check its rows, and once to solve them. A pipe can only be read once, so
/// it is copied to a temporary file of limited size.
class RereadableInput {
  public:
    /// Largest input taken from a pipe [bytes], about ten million rows. A longer pipe probably never ends.
    static constexpr std::uint64_t mostKept = std::uint64_t{1} << 30;

    /// Opens a file, or copies up to `most` bytes of a pipe to a temporary file. Throws CommandError:
    /// unreadable input, also if the pipe is longer; unwritable output if the temporary file cannot be
    /// written.
    explicit RereadableInput(const std::string& path, std::uint64_t most = mostKept,
                             const ReadingStyle& style = plainStyle());

    /// Returns the stream, which starts at the beginning of the input. Reading throws CommandError
    /// (unreadable input) if the disk fails.
    std::istream& stream() { return m_stream; }

  private:
    /// File buffer whose errors contain the name of the file that cannot be read.
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

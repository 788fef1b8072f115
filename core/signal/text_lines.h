// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a text of unknown encoding and any length, one at a time in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// Reads UTF-8 and UTF-16 (with or without byte order mark) and, line by line, what is no UTF-8 as Latin-1;
/// lines end with LF, CR LF, or CR throughout.
class TextLines {
  public:
    explicit TextLines(std::istream& in) : m_in(in) {}

    /// The next line as UTF-8 without its end, good until the next call. False at the end, and where the text
    /// cannot be read on: problem().
    bool next(std::string_view& line);
    /// Of the last line, from 1.
    std::size_t number() const { return m_number; }
    /// Bytes taken from the stream so far.
    std::uint64_t bytesRead() const { return m_bytesRead; }
    /// Why it did not go on to the end: a line too long, or one that is no text; empty when all is well.
    const std::string& problem() const { return m_problem; }

  private:
    enum class Encoding { unknown, bytes, utf16LittleEndian, utf16BigEndian };

    bool fill();
    void findEncoding();
    void decodeUtf16();
    bool refuse(const char* reason);

    std::istream& m_in;
    Encoding m_encoding = Encoding::unknown;
    std::string m_raw;        // UTF-16 that is not decoded yet
    std::string m_text;       // what has been read and not been given away
    std::size_t m_at = 0;     // where the next line begins in it
    std::string m_converted;  // a line of Latin-1
    char m_end = '\n';
    bool m_isFirst = true;  // block
    std::size_t m_number = 0;
    std::uint64_t m_bytesRead = 0;
    std::string m_problem;
};

/// The first lines of a text, at most so many, each cut at 1000 bytes.
std::vector<std::string> firstLines(std::istream& in, std::size_t most);

}  // namespace drillwave

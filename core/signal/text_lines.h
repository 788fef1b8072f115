// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a text of unknown encoding and any length, one at a time in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// Encoding of the characters of a text.
enum class TextEncoding { found, utf8, windows1252, utf16LittleEndian, utf16BigEndian };

/// "utf-8", "windows-1252" (also "latin-1"), "utf-16le", "utf-16be", or nothing.
std::optional<TextEncoding> findEncoding(std::string_view name);
std::string_view name(TextEncoding encoding);

/// Reads UTF-8 and UTF-16 (with or without byte order mark) and, line by line, what is no UTF-8 as
/// Windows-1252, which has Latin-1 in it; lines end with LF, any number of CR before LF, or CR throughout.
/// NUL bytes that go on to the end of the stream end the text.
class TextLines {
  public:
    explicit TextLines(std::istream& in, TextEncoding wanted = TextEncoding::found)
        : m_in(in), m_wanted(wanted) {}

    /// The next line as UTF-8 without its end, good until the next call. False at the end, and where the text
    /// cannot be read on: problem().
    bool next(std::string_view& line);
    /// Instead of lines: moves all that is read ahead into `block`, where it is ASCII with LF only and so
    /// needs no decoding. False where next() is to be asked, also at the end. Does not count lines.
    bool takePlainBlock(std::string& block);
    /// Returns the number of the last line, from 1.
    std::size_t number() const { return m_number; }
    /// Returns the number of bytes taken from the stream so far.
    std::uint64_t bytesRead() const { return m_bytesRead; }
    /// Returns the encoding as far as it was read: UTF-8 until a line is something else.
    TextEncoding encoding() const;
    /// Whether NUL bytes stood where the text ended.
    bool hasNulTail() const { return m_hasNulTail; }
    /// The beginning of the text as UTF-8, as much as one block holds, before the first line is taken.
    std::string_view beginning();
    /// Why it did not go on to the end: a line too long, or one that is no text; empty when all is well.
    const std::string& problem() const { return m_problem; }

  private:
    enum class Encoding { unknown, bytes, utf16LittleEndian, utf16BigEndian };

    bool fill();
    void findEncoding();
    void decodeUtf16();
    bool refuse(std::string reason);
    bool endsInNuls(std::string_view line, std::size_t nul);
    std::string_view inUtf8(std::string_view line);

    std::istream& m_in;
    TextEncoding m_wanted;
    Encoding m_encoding = Encoding::unknown;
    std::string m_raw;        // UTF-16 that is not decoded yet
    std::string m_text;       // what has been read and not been given away
    std::size_t m_at = 0;     // where the next line begins in it
    std::string m_converted;  // a line of Latin-1
    char m_end = '\n';
    bool m_isFirst = true;  // block
    std::size_t m_number = 0;
    std::uint64_t m_bytesRead = 0;
    bool m_hasNulTail = false;
    bool m_hasWindows1252 = false;  // in a line that was given
    std::string m_problem;
};

/// The first lines of a text, at most so many, whole; fewer where they are long: no more after 4 MiB.
std::vector<std::string> firstLines(std::istream& in, std::size_t most,
                                    TextEncoding wanted = TextEncoding::found);

/// Names a file that begins so and is no text: "a zip archive". Empty for what may be a
/// table.
std::string_view knownFormat(std::string_view beginning);

}  // namespace drillwave

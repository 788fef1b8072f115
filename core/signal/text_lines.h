// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a text of unknown encoding and any length, one at a time in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// Encoding of a text; for `found`, the reader detects the encoding from the text.
enum class TextEncoding { found, utf8, windows1252, utf16LittleEndian, utf16BigEndian };

/// Returns the encoding with this name, or nullopt: "utf-8", "windows-1252" (also "latin-1"), "utf-16le",
/// "utf-16be".
std::optional<TextEncoding> findEncoding(std::string_view name);
std::string_view name(TextEncoding encoding);

/// Reader of the lines of a text in UTF-8 or UTF-16, with or without byte order mark. Lines that are not
/// UTF-8 are read as Windows-1252, which includes Latin-1. Lines end with LF, with CRs before LF, or with CR
/// throughout. NUL bytes up to the end of the stream end the text.
class TextLines {
  public:
    explicit TextLines(std::istream& in, TextEncoding wanted = TextEncoding::found)
        : m_in(in), m_wanted(wanted) {}

    /// Reads the next line as UTF-8 without its line end. `line` is valid until the next call. Returns false
    /// at the end of the text, or if it cannot be read further; see problem().
    bool next(std::string_view& line);
    /// Moves all bytes that were read ahead into `block`, which is faster than reading lines. Returns false
    /// at the end, or if the bytes need decoding because they are not ASCII with LF; use next() then. Does
    /// not count lines.
    bool takePlainBlock(std::string& block);
    /// Returns the number of the last line read, counted from 1.
    std::size_t number() const { return m_number; }
    /// Returns the number of bytes taken from the stream so far.
    std::uint64_t bytesRead() const { return m_bytesRead; }
    /// Returns the encoding found so far: UTF-8 until a line has another one.
    TextEncoding encoding() const;
    /// Returns whether the text ended with NUL bytes, as in a file that a recorder reserved but did not
    /// fill.
    bool hasNulTail() const { return m_hasNulTail; }
    /// Returns the beginning of the text as UTF-8: the first block that is read from the stream. Must be
    /// called before the first line is read.
    std::string_view beginning();
    /// Returns why reading stopped before the end: a line is too long, or is not text. Empty if it did not.
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
    std::string m_text;       // text that has been read but not returned
    std::size_t m_at = 0;     // position in m_text at which the next line begins
    std::string m_converted;  // line converted from Windows-1252
    char m_end = '\n';
    bool m_isFirst = true;  // the next block is the first one
    std::size_t m_number = 0;
    std::uint64_t m_bytesRead = 0;
    bool m_hasNulTail = false;
    bool m_hasWindows1252 = false;  // a line that was returned was in Windows-1252
    std::string m_problem;
};

/// Returns the first complete lines of a text as UTF-8, at most `most`. Stops after 4 MiB.
std::vector<std::string> firstLines(std::istream& in, std::size_t most,
                                    TextEncoding wanted = TextEncoding::found);

/// Returns the kind of a file that is not text, such as "a zip archive", recognised from its first bytes.
/// Empty if it may be a table.
std::string_view knownFormat(std::string_view beginning);

}  // namespace drillwave

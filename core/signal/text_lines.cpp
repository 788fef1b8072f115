// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/text_lines.h"

#include <algorithm>
#include <utility>

#include "core/text/message.h"
#include "core/text/name_text.h"
#include "core/text/text_input.h"

namespace drillwave {
namespace {

constexpr std::size_t blockBytes = std::size_t{1} << 18;
constexpr std::size_t longestLine = std::size_t{16} << 20;

/// Windows-1252 from 0x80 to 0x9F, 0 where it has nothing.
constexpr char16_t windowsCharacters[] = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                          0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                          0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                          0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

constexpr std::pair<std::string_view, TextEncoding> encodingNames[] = {
    {"utf-8", TextEncoding::utf8},
    {"windows-1252", TextEncoding::windows1252},
    {"utf-16le", TextEncoding::utf16LittleEndian},
    {"utf-16be", TextEncoding::utf16BigEndian},
    {"utf8", TextEncoding::utf8},
    {"latin-1", TextEncoding::windows1252},
    {"latin1", TextEncoding::windows1252},
    {"iso-8859-1", TextEncoding::windows1252},
    {"cp1252", TextEncoding::windows1252},
    {"utf-16", TextEncoding::utf16LittleEndian}};

unsigned byteOf(char c) {
    return static_cast<unsigned char>(c);
}

bool isAscii(std::string_view text) {
    unsigned any = 0;
    for (const char c : text) any |= byteOf(c);
    return any < 0x80;
}

void appendUtf8(std::string& text, char32_t c) {
    const auto add = [&text](char32_t byte) { text += static_cast<char>(byte); };
    if (c < 0x80) return add(c);
    if (c < 0x800) {
        add(0xC0 | c >> 6);
    } else {
        if (c < 0x10000) {
            add(0xE0 | c >> 12);
        } else {
            add(0xF0 | c >> 18);
            add(0x80 | (c >> 12 & 0x3F));
        }
        add(0x80 | (c >> 6 & 0x3F));
    }
    add(0x80 | (c & 0x3F));
}

std::size_t markLength(std::string_view raw, std::string_view mark) {
    return raw.starts_with(mark) ? mark.size() : 0;
}

}  // namespace

std::optional<TextEncoding> findEncoding(std::string_view name) {
    const std::string wanted = lowerCase(std::string(name));
    for (const auto& [written, encoding] : encodingNames)
        if (written == wanted) return encoding;
    return std::nullopt;
}

std::string_view name(TextEncoding encoding) {
    for (const auto& [written, found] : encodingNames)
        if (found == encoding) return written;
    return {};
}

TextEncoding TextLines::encoding() const {
    if (m_encoding == Encoding::utf16LittleEndian) return TextEncoding::utf16LittleEndian;
    if (m_encoding == Encoding::utf16BigEndian) return TextEncoding::utf16BigEndian;
    return m_hasWindows1252 || m_wanted == TextEncoding::windows1252 ? TextEncoding::windows1252
                                                                     : TextEncoding::utf8;
}

bool TextLines::refuse(std::string reason) {
    m_problem = std::move(reason);
    return false;
}

// By the byte order mark, or the zero bytes that Latin letters have in UTF-16.
void TextLines::findEncoding() {
    const std::string_view raw = m_raw;
    const bool even = raw.size() >= 2 && raw[0] != '\0' && raw[1] == '\0';
    const bool odd = raw.size() >= 2 && raw[0] == '\0' && raw[1] != '\0';
    if (m_wanted == TextEncoding::utf8 || m_wanted == TextEncoding::windows1252)
        m_encoding = Encoding::bytes;
    else if (m_wanted == TextEncoding::utf16BigEndian)
        m_encoding = Encoding::utf16BigEndian;
    else if (raw.starts_with("\xFF\xFE") || even || m_wanted == TextEncoding::utf16LittleEndian)
        m_encoding = Encoding::utf16LittleEndian;
    else if (raw.starts_with("\xFE\xFF") || odd)
        m_encoding = Encoding::utf16BigEndian;
    else
        m_encoding = Encoding::bytes;
    const std::string_view mark = m_encoding == Encoding::utf16LittleEndian ? "\xFF\xFE"
                                  : m_encoding == Encoding::utf16BigEndian  ? "\xFE\xFF"
                                                                            : "\xEF\xBB\xBF";
    m_raw.erase(0, markLength(raw, mark));
}

// A surrogate without its other half becomes the replacement character.
void TextLines::decodeUtf16() {
    const bool little = m_encoding == Encoding::utf16LittleEndian;
    const auto unit = [&](std::size_t at) -> char32_t {
        const unsigned first = byteOf(m_raw[at]), second = byteOf(m_raw[at + 1]);
        return little ? first | second << 8 : first << 8 | second;
    };
    constexpr char32_t replacement = 0xFFFD;
    std::size_t at = 0;
    for (; at + 1 < m_raw.size(); at += 2) {
        const char32_t high = unit(at);
        if (high < 0xD800 || high > 0xDFFF) {
            appendUtf8(m_text, high);
            continue;
        }
        if (at + 3 >= m_raw.size() && m_in) break;  // the other half is in the next block
        const char32_t low = at + 3 < m_raw.size() ? unit(at + 2) : 0;
        const bool pair = high < 0xDC00 && low >= 0xDC00 && low <= 0xDFFF;
        appendUtf8(m_text, pair ? 0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00) : replacement);
        if (pair) at += 2;
    }
    m_raw.erase(0, at);
}

// Another block behind what is left of the last one. False at the end of the stream.
bool TextLines::fill() {
    m_text.erase(0, m_at);
    m_at = 0;
    const std::size_t before = m_raw.size();
    m_raw.resize(before + blockBytes);
    m_in.read(m_raw.data() + before, static_cast<std::streamsize>(blockBytes));
    const auto count = static_cast<std::size_t>(m_in.gcount());
    m_raw.resize(before + count);
    m_bytesRead += count;
    if (m_encoding == Encoding::unknown) findEncoding();
    if (m_encoding == Encoding::bytes) {
        m_text += m_raw;
        m_raw.clear();
    } else {
        decodeUtf16();
    }
    if (std::exchange(m_isFirst, false) && m_text.find('\n') == std::string::npos &&
        m_text.find('\r') != std::string::npos)
        m_end = '\r';
    return count > 0;
}

// NUL bytes, and line ends among them, from there to the end of the stream.
bool TextLines::endsInNuls(std::string_view line, std::size_t nul) {
    const std::string_view ends("\0\r\n", 3);
    if (line.find_first_not_of(ends, nul) != std::string_view::npos) return false;
    // The line stays where it is: what is behind it is read into another text.
    if (std::string_view(m_text).find_first_not_of(ends, m_at) != std::string_view::npos) return false;
    std::string rest(blockBytes, '\0');
    do {
        m_in.read(rest.data(), static_cast<std::streamsize>(rest.size()));
        const auto count = static_cast<std::size_t>(m_in.gcount());
        m_bytesRead += count;
        if (std::string_view(rest.data(), count).find_first_not_of(ends) != std::string_view::npos)
            return false;
    } while (m_in);
    m_at = m_text.size();
    return m_hasNulTail = true;
}

std::string_view TextLines::inUtf8(std::string_view line) {
    m_converted.clear();
    for (const char c : line) {
        const unsigned byte = byteOf(c);
        const char16_t known = byte >= 0x80 && byte < 0xA0 ? windowsCharacters[byte - 0x80] : char16_t{0};
        appendUtf8(m_converted, known ? known : byte);
    }
    return m_converted;
}

std::string_view TextLines::beginning() {
    if (m_encoding == Encoding::unknown) fill();
    return m_text;
}

bool TextLines::takePlainBlock(std::string& block) {
    if (m_at == m_text.size() && (!m_problem.empty() || !fill())) return false;
    const std::string_view ahead = std::string_view(m_text).substr(m_at);
    const bool needsDecoding = m_encoding != Encoding::bytes || !isAscii(ahead) ||
                               ahead.find('\r') != std::string_view::npos ||
                               ahead.find('\0') != std::string_view::npos;
    if (ahead.empty() || needsDecoding) return false;
    if (m_at > 0) m_text.erase(0, m_at);
    block.swap(m_text);
    m_text.clear();
    m_at = 0;
    return true;
}

bool TextLines::next(std::string_view& line) {
    if (!m_problem.empty()) return false;
    std::size_t end = m_text.find(m_end, m_at);
    while (end == std::string::npos) {
        const std::size_t searched = m_text.size() - m_at;
        if (searched > longestLine || !fill()) break;
        end = m_text.find(m_end, searched);
    }
    const bool last = end == std::string::npos;
    if (last && m_at == m_text.size()) return false;
    ++m_number;
    line = std::string_view(m_text).substr(m_at, last ? std::string::npos : end - m_at);
    if (line.size() > longestLine)
        return refuse("the line is longer than " + std::to_string(longestLine) +
                      " bytes: this is no table of text");
    m_at = last ? m_text.size() : end + 1;
    while (line.ends_with('\r')) line.remove_suffix(1);
    if (const std::size_t nul = line.find('\0'); nul != std::string_view::npos) {
        if (!endsInNuls(line, nul)) return refuse("holds a NUL byte: this is no text");
        line = line.substr(0, nul);
        if (line.empty()) return false;
    }
    const bool isWindows = m_wanted == TextEncoding::windows1252 && m_encoding == Encoding::bytes;
    if (!isAscii(line) && (isWindows || !isUtf8(line))) {
        if (m_wanted == TextEncoding::utf8)
            return refuse("holds a byte that is not UTF-8: try another encoding");
        m_hasWindows1252 = true;
        line = inUtf8(line);
    }
    return true;
}

std::vector<std::string> firstLines(std::istream& in, std::size_t most, TextEncoding wanted) {
    TextLines text(in, wanted);
    std::vector<std::string> lines;
    std::string_view line;
    constexpr std::size_t mostBytes = std::size_t{4} << 20;
    for (std::size_t bytes = 0; lines.size() < most && bytes < mostBytes && text.next(line);
         bytes += line.size())
        lines.emplace_back(line);
    return lines;
}

std::string_view knownFormat(std::string_view beginning) {
    using namespace std::string_view_literals;
    if (beginning.starts_with("PK\3\4"))
        return beginning.find("xl/") != std::string_view::npos ||
                       beginning.find("[Content_Types].xml") != std::string_view::npos
                   ? translatable("an Excel workbook (.xlsx); save the sheet as CSV")
               : beginning.find("opendocument.spreadsheet") != std::string_view::npos
                   ? translatable("an OpenDocument spreadsheet (.ods); save the sheet as CSV")
                   : translatable("a zip archive; unpack it first");
    struct Signature {
        std::string_view bytes;
        std::string_view what;
    };
    static const Signature signatures[] = {
        {"\x1F\x8B"sv, translatable("compressed by gzip; unpack it first")},
        {"BZh"sv, translatable("compressed by bzip2; unpack it first")},
        {"\xFD"
         "7zXZ"sv,
         translatable("compressed by xz; unpack it first")},
        {"7z\xBC\xAF"sv, translatable("a 7-Zip archive; unpack it first")},
        {"\x28\xB5\x2F\xFD"sv, translatable("compressed by zstd; unpack it first")},
        {"\xD0\xCF\x11\xE0"sv, translatable("an old Excel workbook (.xls); save the sheet as CSV")},
        {"\x09\x08\x10\x00"sv, translatable("an old Excel workbook (.xls); save the sheet as CSV")},
        {"\x89HDF"sv, translatable("an HDF5 file (MATLAB 7.3 also writes it); export the channels as CSV")},
        {"MATLAB 5.0"sv, translatable("a MATLAB file; export the channels as CSV")},
        {"TDSm"sv, translatable("a TDMS file; export the channels as CSV")},
        {"\x93NUMPY"sv, translatable("a NumPy array; write it by numpy.savetxt")},
        {"PAR1"sv, translatable("a Parquet file; export the columns as CSV")},
        {"SQLite format 3"sv, translatable("an SQLite database; export a table as CSV")},
        {"%PDF"sv, translatable("a PDF document, not a table")},
        {"{\\rtf"sv, translatable("a document in RTF; save it as plain text")},
        {"\x89PNG"sv, translatable("a picture, not a table")},
        {"\xFF\xD8\xFF"sv, translatable("a picture, not a table")},
        {"RIFF"sv, translatable("a sound or video file (RIFF); export samples as CSV")},
        {"\xFF\xFE\0\0"sv, translatable("text in UTF-32; save it as UTF-8")},
        {"\0\0\xFE\xFF"sv, translatable("text in UTF-32; save it as UTF-8")},
        {"<?xml"sv, translatable("an XML document; save the sheet as CSV")},
        {"<html"sv, translatable("a web page; save the table as CSV")},
        {"<!DOCTYPE"sv, translatable("a web page; save the table as CSV")},
    };
    for (const Signature& signature : signatures)
        if (beginning.starts_with(signature.bytes)) return signature.what;
    return {};
}

}  // namespace drillwave

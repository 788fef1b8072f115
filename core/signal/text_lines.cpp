// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/text_lines.h"

#include <algorithm>
#include <utility>

#include "core/text/text_input.h"

namespace drillwave {
namespace {

constexpr std::size_t blockBytes = std::size_t{1} << 18;
constexpr std::size_t longestLine = std::size_t{1} << 16;
constexpr std::size_t longestPreview = 1000;

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

bool TextLines::refuse(const char* reason) {
    m_problem = reason;
    return false;
}

// By the byte order mark, or the zero bytes that Latin letters have in UTF-16.
void TextLines::findEncoding() {
    const std::string_view raw = m_raw;
    const bool even = raw.size() >= 2 && raw[0] != '\0' && raw[1] == '\0';
    const bool odd = raw.size() >= 2 && raw[0] == '\0' && raw[1] != '\0';
    if (raw.starts_with("\xFF\xFE") || even)
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
    if (line.size() > longestLine) return refuse("the line is longer than 65536 bytes");
    m_at = last ? m_text.size() : end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.find('\0') != std::string_view::npos) return refuse("holds a NUL byte: this is no text");
    if (!isAscii(line) && !isUtf8(line)) {
        m_converted.clear();
        for (const char c : line) appendUtf8(m_converted, byteOf(c));
        line = m_converted;
    }
    return true;
}

std::vector<std::string> firstLines(std::istream& in, std::size_t most) {
    TextLines text(in);
    std::vector<std::string> lines;
    std::string_view line;
    while (lines.size() < most && text.next(line)) {
        // Not in the middle of a character.
        std::size_t end = std::min(line.size(), longestPreview);
        while (end < line.size() && end > 0 && (byteOf(line[end]) & 0xC0) == 0x80) --end;
        lines.emplace_back(line.substr(0, end));
    }
    return lines;
}

}  // namespace drillwave

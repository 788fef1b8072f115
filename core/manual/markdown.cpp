// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/markdown.h"

#include <algorithm>
#include <utility>

#include "core/text/text_layout.h"

namespace drillwave {

namespace {

bool isBlank(char character) {
    return character == ' ' || character == '\t' || character == '\n';
}

// A star that begins or ends words, and is no sign of multiplication.
bool marks(std::string_view line, std::size_t at, std::size_t length) {
    const bool afterBlank = at == 0 || isBlank(line[at - 1]);
    const bool beforeBlank = at + length >= line.size() || isBlank(line[at + length]);
    return !(afterBlank && beforeBlank);
}

// Ends of "[words](target)" that begins at `at`: of the words, and of the whole; `npos` for no link.
struct LinkEnds {
    std::size_t words = std::string_view::npos;
    std::size_t behind = std::string_view::npos;
};
LinkEnds linkAt(std::string_view line, std::size_t at) {
    const std::size_t words = line.find("](", at);
    if (words == std::string_view::npos || line.substr(at + 1, words - at - 1).find('[') != line.npos)
        return {};
    const std::size_t end = line.find(')', words);
    return end == std::string_view::npos ? LinkEnds() : LinkEnds{words, end + 1};
}

using Kind = ManualBlock::Kind;

constexpr std::string_view fence = "```";
constexpr std::size_t codeIndent = 4;

std::size_t indentOf(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(indentOf(text));
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

// "- " or "12. " at its beginning, or nothing.
std::string_view itemMark(std::string_view line) {
    if (line.starts_with("- ")) return line.substr(0, 1);
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    return digits > 0 && line.substr(digits).starts_with(". ") ? line.substr(0, digits + 1)
                                                               : std::string_view();
}

// Cells stand between bars; one behind a backslash, or in code, is none.
std::vector<std::string> cellsOf(std::string_view line) {
    line = trimmed(line);
    line.remove_prefix(1);
    if (line.ends_with('|')) line.remove_suffix(1);
    std::vector<std::string> cells(1);
    bool inCode = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '`') inCode = !inCode;
        if (line[at] == '\\' && at + 1 < line.size() && line[at + 1] == '|')
            cells.back() += line[++at];
        else if (line[at] == '|' && !inCode)
            cells.emplace_back();
        else
            cells.back() += line[at];
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

bool isRule(std::string_view line) {
    return line.find_first_not_of("|-: ") == std::string_view::npos;
}

/// Reads line after line.
class MarkdownReader {
  public:
    explicit MarkdownReader(std::string_view text) : m_rest(text) {}

    std::vector<ManualBlock> read() {
        while (!m_rest.empty()) take(nextLine());
        while (!m_blocks.empty() && m_blocks.back().kind == Kind::code && m_blocks.back().text.empty())
            m_blocks.pop_back();
        return std::move(m_blocks);
    }

  private:
    std::string_view nextLine() {
        const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
        const std::string_view line = m_rest.substr(0, end);
        m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
        return line;
    }

    void take(std::string_view line) {
        const std::string_view words = trimmed(line);
        const std::size_t indent = indentOf(line);
        if (words.empty()) {
            m_isOpen = false;
        } else if (words.starts_with(fence)) {
            takeFenced(indent);
        } else if (const std::size_t level = line.find_first_not_of('#');
                   level > 0 && level < line.size() && line[level] == ' ') {
            m_inItem = false;
            add(Kind::heading, static_cast<int>(level), {}, trimmed(line.substr(level)));
            m_isOpen = false;
        } else if (words.starts_with('|')) {
            takeRow(words);
        } else if (const std::string_view mark = itemMark(words); !mark.empty()) {
            m_inItem = true;
            add(Kind::item, static_cast<int>(indent), mark, trimmed(words.substr(mark.size())));
        } else if (m_isOpen && m_blocks.back().kind != Kind::code && m_blocks.back().kind != Kind::table) {
            m_blocks.back().text += " " + std::string(words);
        } else if (indent >= codeIndent && !m_inItem) {
            takeCode(line.substr(codeIndent));
        } else {
            m_inItem = m_inItem && indent > 0;
            add(Kind::paragraph, m_inItem ? static_cast<int>(indent) : 0, {}, words);
        }
    }

    void add(Kind kind, int level, std::string_view mark, std::string_view text) {
        m_blocks.push_back({kind, level, std::string(mark), std::string(text)});
        m_isOpen = true;
    }

    void takeFenced(std::size_t indent) {
        add(Kind::code, static_cast<int>(indent), {}, {});
        while (!m_rest.empty()) {
            const std::string_view line = nextLine();
            if (trimmed(line) == fence) break;
            m_blocks.back().text += std::string(line.substr(std::min(indent, indentOf(line)))) + "\n";
        }
        m_isOpen = false;
    }

    // A blank line between two lines of code is code, too.
    void takeCode(std::string_view line) {
        const bool goesOn = !m_blocks.empty() && m_blocks.back().kind == Kind::code && m_isOpen;
        if (!goesOn) add(Kind::code, 0, {}, {});
        m_blocks.back().text += std::string(line) + "\n";
    }

    void takeRow(std::string_view line) {
        const bool goesOn = m_isOpen && m_blocks.back().kind == Kind::table;
        if (!goesOn) add(Kind::table, 0, {}, {});
        if (isRule(line)) return;
        std::vector<std::vector<std::string>>& rows = m_blocks.back().rows;
        rows.push_back(cellsOf(line));
        rows.back().resize(rows.front().size());
    }

    std::string_view m_rest;
    std::vector<ManualBlock> m_blocks;
    bool m_isOpen = false;  // the last block may go on
    bool m_inItem = false;  // what is indented belongs to an item
};

}  // namespace

std::string withoutMarks(std::string_view line) {
    std::string shown;
    bool inCode = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '`') inCode = !inCode;
        if (!inCode && line[at] == '*') {
            const std::size_t length = at + 1 < line.size() && line[at + 1] == '*' ? 2 : 1;
            if (marks(line, at, length)) {
                at += length - 1;
                continue;
            }
        }
        const bool isPicture = !inCode && line[at] == '!' && at + 1 < line.size() && line[at + 1] == '[';
        const std::size_t open = isPicture ? at + 1 : at;
        const LinkEnds link = !inCode && line[open] == '[' ? linkAt(line, open) : LinkEnds();
        if (link.behind != std::string_view::npos) {
            shown += withoutMarks(line.substr(open + 1, link.words - open - 1));
            at = link.behind - 1;
            continue;
        }
        shown += line[at];
    }
    return shown;
}

std::vector<std::string_view> codeIn(std::string_view line) {
    std::vector<std::string_view> found;
    for (std::size_t open = line.find('`'); open != std::string_view::npos;) {
        const std::size_t close = line.find('`', open + 1);
        if (close == std::string_view::npos) break;
        found.push_back(line.substr(open + 1, close - open - 1));
        open = line.find('`', close + 1);
    }
    return found;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
    std::vector<std::string> lines{std::string()};
    for (std::size_t at = 0; at < text.size();) {
        if (isBlank(text[at])) {
            ++at;
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(" \t\n", at), text.size());
        const std::string_view word = text.substr(at, end - at);
        std::string& line = lines.back();
        if (line.empty())
            line = word;
        else if (columnsOf(line) + 1 + columnsOf(word) <= width)
            line += " " + std::string(word);
        else
            lines.emplace_back(word);
        at = end;
    }
    return lines;
}

std::vector<ManualBlock> readMarkdown(std::string_view text) {
    return MarkdownReader(text).read();
}

std::string_view sectionNumber(std::string_view heading) {
    constexpr std::string_view sign = "§";
    if (!heading.starts_with(sign)) return {};
    return heading.substr(0, std::min(heading.find(' '), heading.size()));
}

std::vector<ManualBlock> sectionOf(std::span<const ManualBlock> blocks, std::string_view heading) {
    const auto isMeant = [heading](const ManualBlock& block) {
        return block.kind == Kind::heading &&
               (block.text == heading || (!heading.empty() && sectionNumber(block.text) == heading));
    };
    const auto begin = std::ranges::find_if(blocks, isMeant);
    if (begin == blocks.end()) return {};
    const auto end = std::find_if(begin + 1, blocks.end(), [begin](const ManualBlock& block) {
        return block.kind == Kind::heading && block.level <= begin->level;
    });
    return {begin, end};
}

}  // namespace drillwave

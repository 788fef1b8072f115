// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/inline_text.h"

#include <algorithm>

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

// Of "[words](target)" that begins at `at`: where the words end, and behind all of it; `npos` for no link.
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

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/paper_text.h"

namespace drillwave {

namespace {

constexpr std::size_t longestWord = 32;  // [columns], in a cell: the names of keys and files are shorter
constexpr std::size_t nextBreak = 4;  // [columns], within a longer word: its lines fill a column of any width
constexpr std::string_view mayBreak = "\u200b";

/// The character at a place of the text, all its bytes.
std::string_view characterAt(std::string_view text, std::size_t place) {
    const auto first = static_cast<unsigned char>(text[place]);
    return text.substr(place, first < 0xc0 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4);
}

/// Columns that it takes, rather too many than too few: scripts of wide characters begin at U+1100, which has
/// three bytes.
std::size_t widthOf(std::string_view character) {
    constexpr std::size_t mostTab = 16;  // QTextDocument has a stop every 80 px
    return character == "\t" ? mostTab : character.size() > 2 ? 2 : 1;
}

}  // namespace

PaperLines linesOnPaper(std::string_view text, std::size_t lines, std::size_t columns) {
    PaperLines paper;
    std::size_t line = 0, column = 0;
    const auto breakLine = [&] {
        ++line;
        column = 0;
        paper.text += '\n';
    };
    for (std::size_t place = 0; place < text.size();) {
        const std::string_view character = characterAt(text, place);
        place += character.size();
        if (character == "\n") {
            breakLine();
        } else {
            if (column > 0 && column + widthOf(character) > columns) breakLine();
            if (line < lines) paper.text += character;
            column += widthOf(character);
        }
        if (line < lines) continue;
        paper.isWhole = character == "\n" && place >= text.size();
        break;
    }
    return paper;
}

std::string cellOnPaper(std::string_view text, std::size_t columns) {
    std::string cell;
    std::size_t column = 0, word = 0;
    for (std::size_t place = 0; place < text.size();) {
        const std::string_view character = characterAt(text, place);
        place += character.size();
        column += widthOf(character);
        if (column > columns) return cell + "…";
        word = character == " " ? 0 : word + widthOf(character);
        if (word > longestWord) {
            cell += mayBreak;
            word = longestWord - nextBreak + widthOf(character);
        }
        cell += character;
    }
    return cell;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Search of words in the manual: in titles of sections, entries of the glossary, rows of tables and text.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/manual/chapter.h"

namespace drillwave {

/// Hit of a search in the manual: a section, or an entry of the glossary, that contains the searched words.
struct WordPlace {
    /// Part of the section in which the word was found, from the best hit to the weakest: title, glossary
    /// term, first cell of a table row, text. `wholeTitle` means that the title has no other words.
    enum class Rank { wholeTitle, title, term, row, text };
    Rank rank = Rank::text;
    std::string chapter;  ///< name of the chapter, "theory"
    std::string number;   ///< number of the section, "10"; empty for the beginning of a chapter
    /// Text shown for the hit: the title, the entry of the glossary, or the words around the word.
    std::string shown;
    std::size_t count = 0;  ///< number of times that the section contains the word
};

/// Returns how many times a text contains a whole word, in the singular or the plural (unit, units), ignoring
/// capitals.
std::size_t countOfWord(std::string_view text, std::string_view word);

/// Returns whether a text contains each of the words in `words`, which are separated by blanks.
bool hasWords(std::string_view text, std::string_view words);

/// Returns the sections of the manual that contain each of the words in `words`. The best hits are first: in
/// titles, terms of the glossary, first cells of table rows, then in text. At most five hits in text are
/// returned, those with the most words first. A section counts as one hit; in the glossary each entry is a
/// hit, and at most five are returned. Among hits of equal rank, chapters on the window and the evidence come
/// last. The reference pages are not searched, as their sections have no numbers.
std::vector<WordPlace> placesOfWords(std::span<const Chapter> manual, std::string_view words);

}  // namespace drillwave

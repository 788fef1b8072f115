// SPDX-License-Identifier: GPL-3.0-or-later
// Where the manual has a word: titles of sections, entries of the glossary, rows of tables, text.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/manual/chapter.h"

namespace drillwave {

/// A section of the manual that has a word.
struct WordPlace {
    enum class Rank { wholeTitle, title, term, row, text };  ///< where the word is, the best first
    Rank rank = Rank::text;
    std::string chapter;    ///< "theory"
    std::string number;     ///< of the section, "10"; empty for the head of a chapter
    std::string shown;      ///< the title, the entry of the glossary, or the words around the word
    std::size_t count = 0;  ///< how often the section has the word
};

/// Returns how often a text has a whole word, in the singular or the plural (unit, units), capitals or not.
std::size_t countOfWord(std::string_view text, std::string_view word);

/// Returns whether a text has each of these words.
bool hasWords(std::string_view text, std::string_view words);

/// Returns the places of the manual that have each of these words, the best first: titles, terms of the
/// glossary, rows of tables by their first cell, then at most five by their text, those with the most hits
/// first. A section is one place; each entry of the glossary is one, at most five. Within a rank, chapters
/// about the window and the evidence come last. Leaves out the references of parameters and outputs, whose
/// sections have no numbers.
std::vector<WordPlace> placesOfWords(std::span<const Chapter> manual, std::string_view words);

}  // namespace drillwave

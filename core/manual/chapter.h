// SPDX-License-Identifier: GPL-3.0-or-later
// The manual as the program has it: the pages of resources/manual, and the references that are written from
// the tables.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/handy_text.h"

namespace drillwave {

/// A page of the manual.
struct Chapter {
    std::string name;   ///< "theory": its file, and the word that cites it in every language
    std::string title;  ///< its first heading
    std::string text;   ///< whole text, in Markdown
};

/// Returns the names of all chapters, in the order of a list of contents.
std::vector<std::string> chapterNames();

/// Returns all chapters in that order, in the language of a reader; untranslated pages are in English.
std::vector<Chapter> manualChapters(const ReadingStyle& style);

/// The one of that name, or nullptr.
const Chapter* findChapter(std::span<const Chapter> chapters, std::string_view name);

/// Returns a chapter of that text, whose first line is its heading.
Chapter chapterOf(std::string_view name, std::string text);

}  // namespace drillwave

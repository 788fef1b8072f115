// SPDX-License-Identifier: GPL-3.0-or-later
// Manual inside the program: the pages of resources/manual, and the reference pages made from the tables of
// parameters and outputs.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/handy_text.h"

namespace drillwave {

/// Chapter of the manual.
struct Chapter {
    /// Name of the chapter's file without extension, "theory", by which texts cite the chapter in every
    /// language.
    std::string name;
    std::string title;  ///< title of the chapter, which is its first heading
    std::string text;   ///< complete text, in Markdown
};

/// Returns the names of all chapters, in the order of the table of contents.
std::vector<std::string> chapterNames();

/// Returns all chapters in the order of the table of contents, in the language of the reader. Untranslated
/// chapters are in English.
std::vector<Chapter> manualChapters(const ReadingStyle& style);

/// Returns the chapter with this name, such as "theory", or nullptr.
const Chapter* findChapter(std::span<const Chapter> chapters, std::string_view name);

/// Returns a chapter with this name and text; its title is the heading in the first line.
Chapter chapterOf(std::string_view name, std::string text);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/chapter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/manual/manual_texts.h"
#include "core/manual/reference.h"

namespace drillwave {
namespace {

// The references stand behind the pages that tell how files and commands are written.
constexpr std::string_view beforeReferences = "commands";

std::vector<Chapter> allChapters() {
    std::vector<Chapter> chapters;
    for (const ManualText& page : manualTexts) {
        chapters.push_back(chapterOf(page.name, std::string(page.text)));
        if (page.name != beforeReferences) continue;
        chapters.push_back(chapterOf("parameters", parameterReference()));
        chapters.push_back(chapterOf("outputs", outputReference()));
    }
    return chapters;
}

}  // namespace

Chapter chapterOf(std::string_view name, std::string text) {
    constexpr std::string_view mark = "# ";
    const std::string_view head = std::string_view(text).substr(0, text.find('\n'));
    std::string title(head.starts_with(mark) ? head.substr(mark.size()) : name);
    return {std::string(name), std::move(title), std::move(text)};
}

std::span<const Chapter> manualChapters() {
    static const std::vector<Chapter> chapters = allChapters();
    return chapters;
}

const Chapter* findChapter(std::string_view name) {
    const auto chapters = manualChapters();
    const auto found = std::ranges::find(chapters, name, &Chapter::name);
    return found == chapters.end() ? nullptr : &*found;
}

}  // namespace drillwave

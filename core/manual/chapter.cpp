// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/chapter.h"

#include <algorithm>
#include <utility>

#include "core/manual/manual_texts.h"
#include "core/manual/reference.h"

namespace drillwave {
namespace {

// The references stand behind the pages that tell how files and commands are written.
constexpr std::string_view beforeReferences = "commands";
constexpr std::string_view parameterChapter = "parameters", outputChapter = "outputs";

// Returns the text of a page in that language if it is translated ("de/tutorial"), else in English.
std::string_view pageIn(std::string_view language, const ManualText& page) {
    const std::string translated = std::string(language) + "/" + std::string(page.name);
    const auto* const found = std::ranges::find(translatedTexts, translated, &ManualText::name);
    return found == translatedTexts.end() ? page.text : found->text;
}

}  // namespace

Chapter chapterOf(std::string_view name, std::string text) {
    constexpr std::string_view mark = "# ";
    const std::string_view head = std::string_view(text).substr(0, text.find('\n'));
    std::string title(head.starts_with(mark) ? head.substr(mark.size()) : name);
    return {std::string(name), std::move(title), std::move(text)};
}

std::vector<std::string> chapterNames() {
    std::vector<std::string> names;
    for (const ManualText& page : manualTexts) {
        names.emplace_back(page.name);
        if (page.name == beforeReferences)
            names.insert(names.end(), {std::string(parameterChapter), std::string(outputChapter)});
    }
    return names;
}

std::vector<Chapter> manualChapters(const ReadingStyle& style) {
    std::vector<Chapter> chapters;
    for (const std::string& name : chapterNames()) {
        const auto* const page = std::ranges::find(manualTexts, name, &ManualText::name);
        chapters.push_back(chapterOf(name, page != manualTexts.end()
                                               ? std::string(pageIn(style.language(), *page))
                                           : name == parameterChapter ? parameterReference(style)
                                                                      : outputReference(style)));
    }
    return chapters;
}

const Chapter* findChapter(std::span<const Chapter> chapters, std::string_view name) {
    const auto found = std::ranges::find(chapters, name, &Chapter::name);
    return found == chapters.end() ? nullptr : &*found;
}

}  // namespace drillwave

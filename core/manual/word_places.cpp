// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/word_places.h"

#include <algorithm>
#include <sstream>
#include <tuple>

#include "core/manual/markdown.h"
#include "core/text/name_text.h"
#include "core/text/text_layout.h"

namespace drillwave {
namespace {

using Kind = ManualBlock::Kind;
using Rank = WordPlace::Rank;

constexpr std::size_t mostTerms = 5, mostTexts = 5;
constexpr std::size_t mostColumns = 110;   // of what is shown of a place
constexpr std::size_t columnsBefore = 30;  // a word of the text
constexpr std::string_view glossary = "glossary";

bool isAsciiLetter(unsigned char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9');
}

// The first byte of the letters beyond ASCII that the manual has: Latin and Greek ones.
bool beginsLetter(unsigned char byte) {
    return isAsciiLetter(byte) || (byte >= 0xc3 && byte <= 0xcf);
}

bool endsInLetter(std::string_view text) {
    if (text.empty()) return false;
    const auto last = static_cast<unsigned char>(text.back());
    if (last < 0x80) return isAsciiLetter(last);
    return text.size() > 1 && beginsLetter(static_cast<unsigned char>(text[text.size() - 2])) &&
           !isAsciiLetter(static_cast<unsigned char>(text[text.size() - 2]));
}

bool beginsInLetter(std::string_view text) {
    return !text.empty() && beginsLetter(static_cast<unsigned char>(text.front()));
}

// "unit" of "units"; short words and those in "ss" stay.
std::string_view singular(std::string_view word) {
    constexpr std::size_t shortest = 4;
    const bool isPlural = word.size() > shortest && word.ends_with('s') && !word.ends_with("ss");
    return word.substr(0, word.size() - (isPlural ? 1 : 0));
}

// Where a lower-case text has a word in lower case; `npos` where it does not.
std::size_t findWord(std::string_view text, std::string_view word, std::size_t from = 0) {
    const std::string_view stem = singular(word);
    for (std::size_t at = text.find(stem, from); at != std::string_view::npos; at = text.find(stem, at + 1)) {
        if (beginsInLetter(stem) && endsInLetter(text.substr(0, at))) continue;
        std::string_view behind = text.substr(at + stem.size());
        for (const std::string_view wordEnd : {"", "s", "es"})
            if (behind.starts_with(wordEnd) &&
                !(endsInLetter(stem) && beginsInLetter(behind.substr(wordEnd.size()))))
                return at;
    }
    return std::string_view::npos;
}

std::vector<std::string> wordsIn(std::string_view words) {
    std::istringstream stream(lowerCase(std::string(words)));
    std::vector<std::string> found;
    for (std::string word; stream >> word;) found.push_back(word);
    return found;
}

bool hasAll(std::string_view text, const std::vector<std::string>& words) {
    return std::ranges::all_of(words,
                               [text](const std::string& word) { return countOfWord(text, word) > 0; });
}

std::string shortenedText(std::string_view text) {
    const std::size_t end = byteOfColumn(text, mostColumns);
    if (end >= text.size()) return std::string(text);
    return std::string(text.substr(0, std::min(text.rfind(' ', end), end))) + " …";
}

// Some words around the first of those that are sought.
std::string excerptOf(std::string_view text, std::string_view word) {
    const std::size_t at = std::min(findWord(lowerCase(std::string(text)), word), text.size());
    std::size_t begin = at > columnsBefore ? text.rfind(' ', at - columnsBefore) : 0;
    if (begin == std::string_view::npos) begin = 0;
    return (begin > 0 ? "…" : "") + shortenedText(text.substr(begin));
}

// "feed force" of the entry "**feed force**: the force …".
std::string_view termOf(std::string_view item) {
    constexpr std::string_view mark = "**";
    if (!item.starts_with(mark)) return {};
    item.remove_prefix(mark.size());
    const std::size_t end = item.find(mark);
    return end == std::string_view::npos ? std::string_view() : item.substr(0, end);
}

// How far back chapters stand that answer fewer questions of a command line.
int distanceOf(std::string_view chapter) {
    return chapter == "window" || chapter == "keys" ? 1 : chapter == "evidence" ? 2 : 0;
}

/// Goes through the blocks of a chapter and keeps what has the words.
class PlaceFinder {
  public:
    PlaceFinder(std::string_view words, std::vector<WordPlace>& places)
        : m_words(wordsIn(words)), m_places(places) {}

    void read(const Chapter& chapter) {
        m_chapter = chapter.name;
        for (const ManualBlock& block : readMarkdown(chapter.text)) {
            if (block.kind == Kind::heading)
                takeHeading(block.text);
            else if (block.kind == Kind::table)
                for (std::size_t i = 1; i < block.rows.size(); ++i) takeRow(block.rows[i]);
            else
                takeText(block);
        }
        endSection();
    }

  private:
    bool has(std::string_view text) const { return hasAll(text, m_words); }

    void takeHeading(const std::string& heading) {
        endSection();
        const std::string_view number = sectionNumber(heading);
        m_section = {Rank::text, m_chapter, std::string(), withoutMarks(heading), 0};
        if (!number.empty()) {
            m_section.number = number.substr(std::string_view("§").size());
            m_section.shown = withoutMarks(std::string_view(heading).substr(number.size() + 1));
        }
        m_title = m_section.shown;
        if (!has(m_title)) return;
        // Titles of the window name its parts; they do not answer what commands and files ask.
        const bool isWhole = wordsIn(m_title).size() == m_words.size() && m_chapter != "window";
        m_section.rank = isWhole ? Rank::wholeTitle : Rank::title;
    }

    void takeRow(const std::vector<std::string>& row) {
        std::string cells;
        for (const std::string& cell : row)
            cells += (cells.empty() || cell.empty() ? "" : ": ") + withoutMarks(cell);
        m_text += cells + " ";
        if (m_chapter == glossary && row.size() > 1 && has(row[0] + " " + row[1]))
            addEntry(Rank::row, withoutMarks(row[0]) + ": " + withoutMarks(row[1]));
        else if (m_chapter != glossary && m_section.rank == Rank::text && has(row[0])) {
            m_section.rank = Rank::row;
            m_section.shown = shortenedText(cells);
        }
    }

    void takeText(const ManualBlock& block) {
        if (m_chapter == glossary && block.kind == Kind::item && has(block.text))
            addEntry(has(termOf(block.text)) ? Rank::term : Rank::row, withoutMarks(block.text));
        for (const char c : withoutMarks(block.text)) m_text += c == '\n' ? ' ' : c;
        m_text += ' ';
    }

    void addEntry(Rank rank, std::string_view text) {
        m_places.push_back({rank, m_chapter, m_section.number, shortenedText(text), 0});
    }

    // Ends a section. The entries of the glossary are places themselves.
    void endSection() {
        const bool isFound =
            m_section.rank != Rank::text || (m_chapter != glossary && has(m_title + "\n" + m_text));
        if (isFound) {
            for (const std::string& word : m_words) m_section.count += countOfWord(m_text, word);
            if (m_section.rank == Rank::text)
                m_section.shown = shortenedText(m_title + ": " + excerptOf(m_text, m_words.front()));
            m_places.push_back(m_section);
        }
        m_section = {};
        m_title.clear();
        m_text.clear();
    }

    std::vector<std::string> m_words;
    std::vector<WordPlace>& m_places;
    std::string m_chapter;
    WordPlace m_section;
    std::string m_title;
    std::string m_text;  // of the section
};

}  // namespace

std::size_t countOfWord(std::string_view text, std::string_view word) {
    const std::string lower = lowerCase(std::string(text)), sought = lowerCase(std::string(word));
    std::size_t count = 0;
    if (sought.empty()) return count;
    for (std::size_t at = findWord(lower, sought); at != std::string::npos;
         at = findWord(lower, sought, at + sought.size()))
        ++count;
    return count;
}

bool hasWords(std::string_view text, std::string_view words) {
    return hasAll(text, wordsIn(words));
}

std::vector<WordPlace> placesOfWords(std::span<const Chapter> manual, std::string_view words) {
    std::vector<WordPlace> places;
    if (wordsIn(words).empty()) return places;
    PlaceFinder finder(words, places);
    for (const Chapter& chapter : manual)
        if (chapter.name != "parameters" && chapter.name != "outputs") finder.read(chapter);
    std::ranges::stable_sort(places, {}, [](const WordPlace& place) {
        // Many hits only tell in text; elsewhere the order of the manual stays.
        const std::size_t hits = place.rank == Rank::text ? place.count : 0;
        return std::tuple(place.rank, distanceOf(place.chapter), -static_cast<long>(hits));
    });
    std::size_t terms = 0, texts = 0;
    std::erase_if(places, [&](const WordPlace& place) {
        if (place.rank == Rank::text) return ++texts > mostTexts;
        const bool isEntry = place.chapter == glossary && place.rank > Rank::title;
        return isEntry && ++terms > mostTerms;
    });
    return places;
}

}  // namespace drillwave

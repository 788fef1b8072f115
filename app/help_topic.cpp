// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_topic.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/command.h"
#include "app/help_text.h"
#include "core/blow/outputs.h"
#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/manual/plain_text.h"
#include "core/manual/reference.h"
#include "core/manual/word_places.h"
#include "core/model/parameter.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/text_layout.h"

namespace drillwave {
namespace {

using Kind = ManualBlock::Kind;

std::vector<std::string> commandNames() {
    std::vector<std::string> names;
    for (const Command* command : commands()) names.emplace_back(command->name);
    names.insert(names.end(), {"help", "version"});
    return names;
}

std::vector<std::string> resultNames() {
    std::vector<std::string> names;
    for (const auto table : {outputs(), drillOutputs()})
        for (const Output& output : table) names.emplace_back(output.name);
    return names;
}

std::string markdownText(const std::string& markdown, std::size_t width) {
    return plainText(readMarkdown(markdown), width);
}

/// "§3" of "3", "§3" and "3.": a number of a section.
std::string numberOf(std::string_view word) {
    constexpr std::string_view sign = "§";
    if (word.starts_with(sign)) word.remove_prefix(sign.size());
    while (word.ends_with('.')) word.remove_suffix(1);
    const bool isNumber = !word.empty() && word.find_first_not_of("0123456789.") == std::string_view::npos;
    return isNumber ? std::string(sign) + std::string(word) : std::string();
}

/// Returns all of a chapter or a section of it: "theory", "theory 3", "theory §3.1".
std::string chapterText(std::span<const Chapter> manual, std::span<const std::string> words,
                        std::size_t width) {
    const Chapter* chapter = findChapter(manual, words[0]);
    if (!chapter) return {};
    const std::vector<ManualBlock> blocks = readMarkdown(chapter->text);
    if (words.size() == 1) return plainText(blocks, width);
    const std::string number = numberOf(words[1]);
    const std::string text = number.empty() ? std::string() : plainText(sectionOf(blocks, number), width);
    if (!text.empty()) return text;
    std::string there;
    for (const ManualBlock& block : blocks)
        if (block.kind == Kind::heading && block.level == 2 && !sectionNumber(block.text).empty())
            there += (there.empty() ? "" : ", ") + std::string(sectionNumber(block.text));
    if (there.empty())
        throw CommandError(ExitCode::usage, Message(translatable("`%1` is not a section of %2"),
                                                    {shortened(words[1]), chapter->name}));
    throw CommandError(ExitCode::usage, Message(translatable("`%1` is not a section of %2, which has %3"),
                                                {shortened(words[1]), chapter->name, there}));
}

/// Returns the entries of a number, an output or a word, by its name or by its symbol.
std::string referenceText(std::string_view name, std::size_t width, const ReadingStyle& style) {
    std::vector<std::string> entries;
    if (const KeptParameter parameter = findParameter(name))
        entries.push_back(referenceOf(*parameter, style));
    if (const WordParameter* word = findWordParameter(name)) entries.push_back(referenceOf(*word, style));
    if (const Output* output = findOutput(name)) entries.push_back(referenceOf(*output, style));
    if (const SectionField* field = findSectionField(name)) entries.push_back(referenceOf(*field, style));
    for (const Parameter& parameter : parameters())
        if (!parameter.symbol.empty() && parameter.symbol == name)
            entries.push_back(referenceOf(parameter, style));
    std::string text;
    for (const std::string& entry : entries) text += (text.empty() ? "" : "\n") + markdownText(entry, width);
    return text;
}

bool isNamedBy(const std::vector<std::string>& row, std::string_view name) {
    const std::vector<std::string_view> codes = codeIn(row.front());
    if (std::ranges::find(codes, name) != codes.end()) return true;
    const std::string cell = ", " + row.front() + ", ";
    return cell.find(", " + std::string(name) + ", ") != std::string::npos;
}

/// Returns the rows of tables whose first cell names it, each under its heading.
std::string rowText(std::span<const Chapter> manual, std::string_view name, std::size_t width) {
    std::string text;
    for (const Chapter& chapter : manual) {
        std::string heading;
        for (const ManualBlock& block : readMarkdown(chapter.text)) {
            if (block.kind == Kind::heading) heading = block.text;
            if (block.kind != Kind::table) continue;
            ManualBlock found = block;
            std::erase_if(found.rows, [&](const std::vector<std::string>& row) {
                return &row != &found.rows.front() && !isNamedBy(row, name);
            });
            if (found.rows.size() < 2) continue;
            const ManualBlock above{Kind::paragraph, 0, {}, chapter.name + " " + heading};
            text += (text.empty() ? "" : "\n") + plainText(std::vector{above, found}, width);
        }
    }
    return text;
}

/// Words that the manual does not use for what people mean by them.
constexpr auto otherWords = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"rop", "penetration rate"},
    {"wear", "worn"},
    {"getting started", "tutorial"},
    {"quick start", "tutorial"},
    {"introduction", "tutorial"},
});

/// "a, b, c".
std::string listOf(std::span<const std::string> words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// The option of that name, "--shard", "shard" or "-j", of every command that has it, as a table with a row
/// for each meaning; empty where no command has it.
std::string optionText(std::string_view word, std::size_t width, const ReadingStyle& style) {
    std::vector<std::pair<OptionSpec, std::vector<std::string>>> meanings;
    for (const Command* command : commands())
        for (const OptionSpec& option : optionsOf(*command)) {
            if (option.text() != word && (option.name != word || !option.isLong())) continue;
            const auto found = std::ranges::find_if(meanings, [&option](const auto& each) {
                return each.first.help == option.help && each.first.value == option.value;
            });
            if (found != meanings.end())
                found->second.emplace_back(command->name);
            else
                meanings.push_back({option, {std::string(command->name)}});
        }
    if (meanings.empty()) return {};
    ManualBlock table{Kind::table, 0, {}, {}};
    table.rows.push_back({style.said(translatable("option")), style.said(translatable("meaning")),
                          style.said(translatable("commands"))});
    for (const auto& [option, owners] : meanings)
        table.rows.push_back(
            {synopsis(option), style.patternFor(std::string(option.help)),
             owners.size() == commands().size() ? style.said(translatable("all")) : listOf(owners)});
    return plainText(std::span(&table, 1), width);
}

/// Keys of parameters and names of outputs that have the words in their name, or else in what they mean.
std::vector<std::string> namesWith(std::string_view words) {
    constexpr std::size_t mostNames = 8;
    std::vector<std::string> named, meant;
    const auto take = [&](std::string_view name, std::string_view meaning) {
        std::string spoken(name);
        for (char& c : spoken) c = c == '_' || c == '.' ? ' ' : c;
        if (hasWords(spoken, words))
            named.emplace_back(name);
        else if (hasWords(meaning, words))
            meant.emplace_back(name);
    };
    for (const Parameter& parameter : parameters()) take(parameter.key, parameter.meaning);
    for (const WordParameter& parameter : wordParameters()) take(parameter.key, {});
    take(restrikeKey, {});
    for (const auto table : {outputs(), drillOutputs()})
        for (const Output& output : table) take(output.name, output.meaning);
    named.insert(named.end(), meant.begin(), meant.end());
    if (named.size() > mostNames) named.resize(mostNames);
    return named;
}

/// The best places as a table: what prints each, and what is there.
std::string placesText(std::span<const WordPlace> places, std::size_t width, const ReadingStyle& style) {
    ManualBlock table{Kind::table, 0, {}, {}};
    table.rows.push_back({"drillwave help …", style.said(translatable("topics"))});
    for (const WordPlace& place : places)
        table.rows.push_back(
            {place.number.empty() ? place.chapter : place.chapter + " " + place.number, place.shown});
    return plainText(std::span(&table, 1), width);
}

/// Returns all places with these words that have another name: options, a section with that very title or
/// rows of tables, places of the manual, parameters and outputs. Empty if there is none.
std::string searchText(std::span<const Chapter> manual, const std::string& words, std::size_t width,
                       const ReadingStyle& style) {
    constexpr std::size_t mostPlaces = 12;
    constexpr std::size_t longestSymbol = 2;  // columns: e and d0 are in most texts
    const auto other = std::ranges::find(otherWords, lowerCase(words),
                                         &std::pair<std::string_view, std::string_view>::first);
    const std::string meant = other != otherWords.end() ? std::string(other->second) : words;
    std::vector<WordPlace> places = placesOfWords(manual, meant);
    const auto isTitled = [&](WordPlace::Rank rank) {
        return !places.empty() && places.front().rank <= rank;
    };
    std::string text = optionText(words, width, style);
    const auto add = [&text](const std::string& more) {
        text += text.empty() || more.empty() ? more : "\n" + more;
    };
    const auto addSentence = [&](const Message& message) {
        add(plainText(std::vector{ManualBlock{Kind::paragraph, 0, {}, style.said(message)}}, width));
    };
    if (isTitled(WordPlace::Rank::wholeTitle) && !places.front().number.empty()) {
        add(chapterText(manual, std::vector{places.front().chapter, places.front().number}, width));
        places.erase(places.begin());
    } else if (text.empty() && !isTitled(WordPlace::Rank::title)) {
        const std::string rows = rowText(manual, words, width);
        if (!rows.empty() && columnsOf(words) <= longestSymbol) return rows;
        if (!rows.empty())
            std::erase_if(places, [](const WordPlace& place) { return place.rank == WordPlace::Rank::row; });
        add(rows);
    }
    if (places.size() > mostPlaces) places.resize(mostPlaces);
    if (!places.empty()) {
        addSentence({translatable("The manual has `%1` in these places, the best first:"), {meant}});
        add(placesText(places, width, style));
    }
    if (const std::vector<std::string> names = namesWith(meant); !names.empty())
        addSentence({translatable("Parameters and outputs: %1."), {listOf(names)}});
    return text;
}

/// "`bit_rock.gamma`" of "gamma": the parameters whose last part is that name.
std::string keysEndingIn(const std::string& name) {
    std::vector<std::string> keys;
    for (const std::string& key : parameterNames())
        if (key.ends_with("." + name)) keys.push_back("`" + key + "`");
    return listOf(keys);
}

std::string nearest(std::string_view name) {
    std::vector<std::string> found;
    const std::string lastPart = "." + std::string(name);
    for (const auto& names : {commandNames(), chapterNames(), parameterNames(), resultNames()}) {
        const std::vector<std::string_view> views(names.begin(), names.end());
        for (const std::string_view each : views)
            if (each.ends_with(lastPart)) found.push_back("`" + std::string(each) + "`");
        std::string_view near = nearestName(name, views);
        if (near.empty()) near = nameWithWords(name, views);
        if (!near.empty()) found.push_back("`" + std::string(near) + "`");
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    constexpr std::size_t most = 5;
    if (found.size() > most) found.resize(most);
    return listOf(found);
}

}  // namespace

std::vector<std::string> parameterNames() {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters()) names.emplace_back(parameter.key);
    for (const WordParameter& parameter : wordParameters()) names.emplace_back(parameter.key);
    names.emplace_back(restrikeKey);
    return names;
}

std::vector<std::string> topicNames() {
    std::vector<std::string> names;
    for (const auto& some : {commandNames(), chapterNames(), parameterNames(), resultNames()})
        for (const std::string& each : some)
            if (std::ranges::find(names, each) == names.end()) names.push_back(each);
    return names;
}

std::string topicText(std::span<const std::string> words, std::size_t width, const ReadingStyle& style) {
    const std::vector<Chapter> manual = manualChapters(style);
    if (words.size() > 1 && findChapter(manual, words[0])) return chapterText(manual, words, width);
    std::string name;
    for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
    std::string text;
    const auto add = [&text](const std::string& more) {
        text += text.empty() || more.empty() ? more : "\n" + more;
    };
    const Command* command = findCommand(name);
    add(command ? commandHelp(*command, style) : ownHelp(name, style));
    add(chapterText(manual, std::span(&name, 1), width));
    add(referenceText(name, width, style));
    if (text.empty())
        text = searchText(manual, name, width, style);
    else if (const std::string keys = keysEndingIn(name); !keys.empty())
        add(style.said({translatable("See also %1."), {keys}}) + "\n");
    if (!text.empty()) return text;
    const std::string near = nearest(name);
    if (near.empty())
        throw CommandError(
            ExitCode::usage,
            Message(translatable("`%1` is not a command, chapter, parameter or output; see `drillwave help`"),
                    {shortened(name)}));
    throw CommandError(
        ExitCode::usage,
        Message(
            translatable(
                "`%1` is not a command, chapter, parameter or output; did you mean %2? See `drillwave help`"),
            {shortened(name), near}));
}

}  // namespace drillwave

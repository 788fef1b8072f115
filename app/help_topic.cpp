// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_topic.h"

#include <algorithm>

#include "app/command.h"
#include "app/help_text.h"
#include "core/blow/outputs.h"
#include "core/manual/chapter.h"
#include "core/manual/inline_text.h"
#include "core/manual/plain_text.h"
#include "core/manual/reference.h"
#include "core/model/parameter_table.h"
#include "core/text/decimal_text.h"
#include "core/text/nearest_name.h"

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

/// Of a chapter, all of it or a section: "theory", "theory 3", "theory §3.1".
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
        throw CommandError(ExitCode::usage,
                           Message(translatable("drillwave::Message", "`%1` is not a section of %2"),
                                   {shortened(words[1]), chapter->name}));
    throw CommandError(ExitCode::usage, Message(translatable("drillwave::Message",
                                                             "`%1` is not a section of %2, which has %3"),
                                                {shortened(words[1]), chapter->name, there}));
}

/// Of a number, an output or a word, by its name, or by its symbol.
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

/// The rows of tables whose first cell names it, each under the heading it stands below.
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

std::string nearest(std::string_view name) {
    std::vector<std::string> found;
    const std::string lastPart = "." + std::string(name);
    for (const auto& names : {commandNames(), chapterNames(), parameterNames(), resultNames()}) {
        const std::vector<std::string_view> views(names.begin(), names.end());
        for (const std::string_view each : views)
            if (each.ends_with(lastPart)) found.push_back("`" + std::string(each) + "`");
        const std::string_view near = nearestName(name, views);
        if (!near.empty()) found.push_back("`" + std::string(near) + "`");
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    constexpr std::size_t most = 5;
    if (found.size() > most) found.resize(most);
    std::string text;
    for (const std::string& each : found) text += (text.empty() ? "" : ", ") + each;
    return text;
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
    const std::string& name = words.front();
    std::string text;
    const auto add = [&text](const std::string& more) {
        text += text.empty() || more.empty() ? more : "\n" + more;
    };
    if (words.size() == 1)
        if (const Command* command = findCommand(name)) add(commandHelp(*command, style));
    const std::vector<Chapter> manual = manualChapters(style);
    add(chapterText(manual, words, width));
    if (words.size() == 1) add(referenceText(name, width, style));
    if (words.size() == 1 && text.empty()) add(rowText(manual, name, width));
    if (!text.empty()) return text;
    const std::string near = nearest(name);
    if (near.empty())
        throw CommandError(ExitCode::usage,
                           Message(translatable("drillwave::Message",
                                                "`%1` is neither a command nor a chapter, parameter or "
                                                "output; `drillwave help` says what there is"),
                                   {shortened(name)}));
    throw CommandError(ExitCode::usage,
                       Message(translatable("drillwave::Message",
                                            "`%1` is neither a command nor a chapter, parameter or output; "
                                            "near it %2; `drillwave help` says what there is"),
                               {shortened(name), near}));
}

}  // namespace drillwave

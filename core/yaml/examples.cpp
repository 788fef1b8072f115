// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/examples.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/yaml/example_texts.h"

namespace drillwave {

namespace {

/// The comment lines at the top of a file, joined to one paragraph.
std::string leadingComment(std::string_view text) {
    std::string paragraph;
    while (text.starts_with('#')) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(1, end - 1);
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (!paragraph.empty()) paragraph += ' ';
        paragraph += line;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return paragraph;
}

/// The value of the line "title: …". The examples write it unquoted.
std::string titleLine(std::string_view text) {
    constexpr std::string_view key = "\ntitle: ";
    const auto at = text.find(key);
    assert(at != std::string_view::npos);
    const auto begin = at + key.size();
    return std::string(text.substr(begin, text.find('\n', begin) - begin));
}

std::vector<Example> readExamples() {
    std::vector<Example> examples;
    for (const ExampleText& file : exampleTexts)
        examples.push_back({std::string(file.name), titleLine(file.text), leadingComment(file.text),
                            file.text, file.text.find("\ndrillwave: 2\n") != std::string_view::npos});
    return examples;
}

}  // namespace

std::span<const Example> builtInExamples() {
    static const std::vector<Example> examples = readExamples();
    return examples;
}

const Example* findExample(std::string_view name) {
    const auto examples = builtInExamples();
    const auto found = std::ranges::find(examples, name, &Example::name);
    return found == examples.end() ? nullptr : &*found;
}

const Example& defaultExample() {
    const Example* example = findExample("t38_medium_rock");
    assert(example);
    return *example;
}

}  // namespace drillwave

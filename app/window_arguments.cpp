// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_arguments.h"

#include <filesystem>
#include <vector>

#include "app/command.h"
#include "app/language_option.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

[[noreturn]] void refuseWord(const std::string& word) {
    if (word.size() > 1 && word.starts_with('-'))
        throw CommandError(ExitCode::usage, Message(translatable("unknown option `%1`; see drillwave --help"),
                                                    {shortened(word)}));
    std::vector<std::string_view> names;
    for (const Command* command : commands()) names.push_back(command->name);
    for (const Example& example : builtInExamples()) names.push_back(example.name);
    const std::string near(nearestName(word, names));
    if (!near.empty())
        throw CommandError(
            ExitCode::usage,
            Message(translatable("`%1` is not a command, file or example; did you mean `drillwave %2`?"),
                    {shortened(word), near}));
    throw CommandError(ExitCode::unreadableInput,
                       about(word, translatable("No such file or command; see drillwave --help")));
}

}  // namespace

WindowArguments windowArguments(std::span<const std::string> words) {
    WindowArguments arguments;
    std::vector<std::string> rest(words.begin(), words.end());
    arguments.language = takeLanguage(rest);
    for (const std::string& word : rest) {
        if (word == "--reset-ui") {
            arguments.resetsUi = true;
            continue;
        }
        std::error_code ignored;
        const bool isFile = std::filesystem::exists(word, ignored);
        const Example* example = isFile ? nullptr : findExample(word);
        if (!isFile && !example) refuseWord(word);
        if (!arguments.file.empty() || arguments.example)
            throw CommandError(ExitCode::usage,
                               Message(translatable("unexpected argument `%1`; the window opens one file"),
                                       {shortened(word)}));
        if (isFile) arguments.file = word;
        arguments.example = example;
    }
    return arguments;
}

}  // namespace drillwave

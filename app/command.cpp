// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.h"

#include <filesystem>

#include "app/output_file.h"
#include "app/study_command.h"
#include "core/disk/whole_file.h"
#include "core/report/study.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

bool isLinkToFile(const std::string& path) {
    std::error_code ignored;
    return !isStream(path) && std::filesystem::is_symlink(path, ignored) &&
           !std::filesystem::is_directory(path, ignored);
}

std::vector<Command> studyCommands(bool ofFeed) {
    std::vector<Command> made;
    for (const Study* study : studies())
        if (study->isOfFeed == ofFeed) made.push_back(studyCommand(*study));
    return made;
}

}  // namespace

std::span<const Command* const> commands() {
    static const std::vector<Command> ofBlows = studyCommands(false), ofFeed = studyCommands(true);
    static const std::vector<const Command*> all = [] {
        std::vector<const Command*> list{&runCommand(),   &sweepCommand(), &tableCommand(),
                                         &curveCommand(), &mapCommand(),   &joinCommand()};
        for (const Command& command : ofBlows) list.push_back(&command);
        list.push_back(&drillCommand());
        for (const Command& command : ofFeed) list.push_back(&command);
        list.insert(list.end(), {&designCommand(), &identifyCommand(), &signalCommand(), &reportCommand(),
                                 &figuresCommand(), &accuracyCommand(), &stabilityCommand(),
                                 &validateCommand(), &examplesCommand(), &presetsCommand()});
        return list;
    }();
    return all;
}

const Command* findCommand(std::string_view name) {
    for (const Command* command : commands())
        if (command->name == name) return command;
    return nullptr;
}

Arguments parseArguments(const Command& command, std::span<const std::string> words,
                         const Language& language) {
    Arguments arguments = Arguments::parse(words, command.options);
    arguments.speak(language);
    if (arguments.value("o") == std::string())
        throw CommandError(ExitCode::usage,
                           translatable("-o needs a name, this one is empty; - is standard output"));
    // The files that belong to an output are written next to the target of a link.
    if (const std::optional<std::string> path = arguments.value("o"); path && isLinkToFile(*path))
        arguments.replaceValue("o", behindLinks(*path));
    const std::size_t given = arguments.operands().size();
    if (given < command.leastOperands)
        throw CommandError(ExitCode::usage,
                           Message(translatable("needs %1; see drillwave %2 --help"),
                                   {std::string(command.operands), std::string(command.name)}));
    if (given > command.mostOperands) {
        const std::string word = shortened(arguments.operands()[command.mostOperands]), name(command.name);
        if (command.operands.empty())
            throw CommandError(
                ExitCode::usage,
                Message(
                    translatable("unexpected argument `%1`; the command takes none, see drillwave %2 --help"),
                    {word, name}));
        throw CommandError(
            ExitCode::usage,
            Message(translatable("unexpected argument `%1`; the command takes %2, see drillwave %3 --help"),
                    {word, std::string(command.operands), name}));
    }
    return arguments;
}

}  // namespace drillwave

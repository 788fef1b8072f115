// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_text.h"

#include <algorithm>

#include "app/scenario_argument.h"
#include "core/manual/chapter.h"

namespace drillwave {

namespace {

std::string line(const std::string& left, std::string_view right, std::size_t width) {
    return "  " + left + std::string(width - left.size() + 2, ' ') + std::string(right) + "\n";
}

std::string chapterList() {
    std::string list;
    for (const Chapter& chapter : manualChapters()) list += (list.empty() ? "" : ", ") + chapter.name;
    return list;
}

}  // namespace

std::string synopsis(const OptionSpec& option) {
    return option.value.empty() ? option.text() : option.text() + " " + std::string(option.value);
}

std::string programHelp() {
    std::string help =
        "Usage: drillwave [FILE]             open the window (with a scenario, a result or an example)\n"
        "       drillwave COMMAND ARGUMENTS  work without a window\n"
        "\nCommands:\n";
    for (const Command* command : commands()) help += line(std::string(command->name), command->summary, 9);
    help +=
        "\n  drillwave help TOPIC  says more: of a command, as COMMAND --help and -h do; of a parameter\n"
        "  (help bit_rock.gamma), an output (help cor), a symbol; it prints chapters of the manual and\n"
        "  sections of them (help theory 10). drillwave version prints the version.\n"
        "  Chapters: " +
        chapterList() +
        ".\n"
        "  Without a display the window needs `-platform offscreen`.\n"
        "  drillwave --reset-ui  opens the window with its first layout, page, units and choices;\n"
        "  drillwave --language de  in German this once (sv: Swedish, en: English).\n"
        "\nExit codes: ";
    return help + std::string(exitCodesHelp) + ".\n";
}

std::string commandHelp(const Command& command) {
    std::string help = "Usage: drillwave " + std::string(command.name) + " " + std::string(command.operands) +
                       " [OPTION]…\n\n" + std::string(command.summary) + ".\n";
    if (command.operands.starts_with("FILE")) help += "\n" + std::string(scenarioOperandHelp) + "\n";
    std::size_t width = std::string_view("-h, --help").size();
    for (const OptionSpec& option : command.options) width = std::max(width, synopsis(option).size());
    help += "\nOptions:\n";
    for (const OptionSpec& option : command.options) help += line(synopsis(option), option.help, width);
    help += line("-h, --help", "this text", width) + line("--version", "version of the program", width);
    if (!command.details.empty()) help += "\n" + std::string(command.details) + "\n";
    return help;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_text.h"

#include <algorithm>

#include "app/language_option.h"
#include "app/scenario_argument.h"
#include "core/blow/outputs.h"
#include "core/manual/chapter.h"

namespace drillwave {

namespace {

constexpr const char* beforeCommands =
    "Usage: drillwave [FILE]             open the window (with a scenario, a result or an example)\n"
    "       drillwave COMMAND ARGUMENTS  work without a window\n"
    "\nCommands:\n";
constexpr const char* behindCommands =
    "\n  drillwave help TOPIC  prints the help of a command, as COMMAND --help and -h do, of a parameter\n"
    "  (help bit_rock.gamma), an output (help cor) or an option (help --shard), a chapter of the manual\n"
    "  or a section of it (help theory 10), and for any other word (help feed) the places of the\n"
    "  manual that have it. drillwave version prints the version.\n"
    "  Chapters: %1.\n"
    "  Without a display the window needs `-platform offscreen`.\n"
    "  drillwave --reset-ui  opens the window with its first layout, page, units and choices;\n"
    "  drillwave --language de  in German this once (sv: Swedish, en: English).\n"
    "  Commands have --language, too; for all of them set DRILLWAVE_LANGUAGE=de.\n"
    "\nExit codes: %2.\n";
constexpr std::string_view optionsTitle = "Options:";
constexpr std::string_view thisText = "this text";
constexpr std::string_view versionHelp = "version of the program";

std::string line(const std::string& left, std::string_view right, std::size_t width) {
    return "  " + left + std::string(width - left.size() + 2, ' ') + std::string(right) + "\n";
}

std::string chapterList() {
    std::string list;
    for (const std::string& name : chapterNames()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

std::string synopsis(const OptionSpec& option) {
    return option.value.empty() ? option.text() : option.text() + " " + std::string(option.value);
}

std::vector<OptionSpec> optionsOf(const Command& command) {
    std::vector<OptionSpec> options = command.options;
    options.push_back(languageOption);
    return options;
}

std::string detailsOf(const Command& command, const ReadingStyle& style) {
    const std::string details = style.patternFor(std::string(command.details));
    return command.furtherHelp ? details + "\n\n" + command.furtherHelp(style) : details;
}

std::string programHelp(const ReadingStyle& style) {
    std::string help = style.said(beforeCommands);
    for (const Command* command : commands())
        help += line(std::string(command->name), style.patternFor(std::string(command->summary)), 9);
    return help + style.said({behindCommands, {chapterList(), Message::ofTable(exitCodesHelp)}});
}

std::string commandHelp(const Command& command, const ReadingStyle& style) {
    const auto said = [&](std::string_view text) { return style.patternFor(std::string(text)); };
    const std::string operands = command.operands.empty() ? "" : " " + std::string(command.operands);
    std::string help = style.said({translatable("Usage: drillwave %1 [OPTION]…\n"),
                                   {std::string(command.name) + operands}}) +
                       "\n" + said(command.summary) + ".\n";
    if (command.operands.starts_with("FILE")) help += "\n" + said(scenarioOperandHelp) + "\n";
    const std::vector<OptionSpec> options = optionsOf(command);
    std::size_t width = std::string_view("-h, --help").size();
    for (const OptionSpec& option : options) width = std::max(width, synopsis(option).size());
    help += "\n" + said(optionsTitle) + "\n";
    for (const OptionSpec& option : options) help += line(synopsis(option), said(option.help), width);
    help += line("-h, --help", said(thisText), width) + line("--version", said(versionHelp), width);
    if (const std::string details = detailsOf(command, style); !details.empty())
        help += "\n" + details + "\n";
    return help;
}

std::string ownHelp(std::string_view name, const ReadingStyle& style) {
    const auto help = [&](const std::string& usage, std::string_view summary) {
        return style.said({translatable("Usage: drillwave %1\n"), {usage}}) + "\n" +
               style.patternFor(std::string(summary)) + ".\n";
    };
    if (name == "help")
        return help("help [TOPIC]", helpSummary) + "\n" + style.patternFor(std::string(helpDetails)) + "\n";
    return name == "version" ? help("version", versionSummary) : std::string();
}

std::vector<std::string_view> helpTexts() {
    std::vector<std::string_view> texts{beforeCommands, behindCommands, scenarioOperandHelp, exitCodesHelp,
                                        optionsTitle,   thisText,       versionHelp,         helpSummary,
                                        helpDetails,    versionSummary};
    for (const Command* command : commands()) {
        texts.push_back(command->summary);
        if (!command->details.empty()) texts.push_back(command->details);
        for (const OptionSpec& option : optionsOf(*command)) texts.push_back(option.help);
    }
    for (const Output& output : drillOutputs()) texts.push_back(output.meaning);
    return texts;
}

}  // namespace drillwave

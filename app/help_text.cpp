// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_text.h"

#include <algorithm>
#include <cctype>

#include "app/language_option.h"
#include "app/scenario_argument.h"
#include "core/blow/outputs.h"
#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/text/text_layout.h"

namespace drillwave {

namespace {

constexpr const char* usageHeader =
    "Usage: drillwave [FILE]             open the window (scenario, result, example)\n"
    "       drillwave COMMAND ARGUMENTS  work without a window\n"
    "\nCommands:\n";
constexpr const char* usageFooter =
    "\ndrillwave help TOPIC prints the help of a command, as COMMAND --help and -h do. TOPIC can also be\na "
    "parameter (help bit_rock.gamma), an output (help cor) or an option (help --shard). It can be a\nchapter "
    "of the manual, or a section of it (help theory 10). For any other word (help feed) it\nprints the "
    "places of the manual that contain the word. drillwave version prints the version.\n\nChapters: "
    "%1.\n\nWithout a display, the window needs `-platform offscreen`. drillwave --reset-ui opens the "
    "window\nwith its default layout, page, units and choices. drillwave --language de opens it in German, "
    "only\nthis time (sv: Swedish, en: English). Commands also have --language; DRILLWAVE_LANGUAGE=de in "
    "the\nenvironment sets the language for all of them.\n\nExit codes: %2.\n";
constexpr std::string_view optionsTitle = "Options:";
constexpr std::string_view thisText = "print this help";
constexpr std::string_view versionHelp = "print the version of the program";

constexpr std::size_t helpColumns = 80;
constexpr std::size_t widestLeft = 24;  // a longer left part has a line of its own

std::string capitalised(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

/// Two columns, the right one wrapped.
std::string entry(const std::string& left, std::string_view right, std::size_t width) {
    const std::string indent(width + 4, ' ');
    std::string text = "  " + left;
    bool isOpen = columnsOf(left) <= width;
    if (isOpen) text += std::string(width - columnsOf(left) + 2, ' ');
    for (const std::string& line : wrapped(right, helpColumns - indent.size())) {
        text += (isOpen ? "" : "\n" + indent) + line;
        isOpen = false;
    }
    return text + "\n";
}

/// Paragraphs, wrapped. Lines that begin with blanks are entries "  LEFT  RIGHT" or go on with the last one.
std::string wrappedDetails(std::string_view details) {
    struct Part {
        std::string left, right;
        bool isEntry;
    };
    std::vector<Part> parts;
    std::size_t width = 0;
    for (std::size_t at = 0; at <= details.size();) {
        const std::size_t end = std::min(details.find('\n', at), details.size());
        const std::string_view line = details.substr(at, end - at);
        const std::size_t first = line.find_first_not_of(' ');
        at = end + 1;
        if (first == std::string_view::npos) {
            parts.push_back({});
        } else if (first == 0) {
            if (parts.empty() || parts.back().isEntry || parts.back().right.empty())
                parts.push_back({{}, std::string(line), false});
            else
                parts.back().right += "\n" + std::string(line);
        } else if (first > 2 && !parts.empty() && parts.back().isEntry) {
            parts.back().right += " " + std::string(line.substr(first));
        } else {
            const std::size_t gap = std::min(line.find("  ", first), line.size());
            const std::string_view left = line.substr(first, gap - first);
            const std::size_t right = std::min(line.find_first_not_of(' ', gap), line.size());
            parts.push_back({std::string(left), std::string(line.substr(right)), true});
            width = std::max(width, std::min(columnsOf(left), widestLeft));
        }
    }
    std::string text;
    for (const Part& part : parts) {
        if (part.isEntry) {
            text += entry(part.left, part.right, width);
            continue;
        }
        for (const std::string& line : wrapped(part.right, helpColumns)) text += line + "\n";
    }
    return text;
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
    std::string help = style.said(usageHeader);
    constexpr std::size_t nameWidth = 9;
    for (const Command* command : commands())
        help += entry(std::string(command->name), style.patternFor(std::string(command->summary)), nameWidth);
    return help + wrappedDetails(style.said({usageFooter, {chapterList(), Message::ofTable(exitCodesHelp)}}));
}

std::string commandHelp(const Command& command, const ReadingStyle& style) {
    const auto said = [&](std::string_view text) { return style.patternFor(std::string(text)); };
    const std::string operands = command.operands.empty() ? "" : " " + std::string(command.operands);
    std::string help =
        wrappedDetails(capitalised(said(command.summary)) + ".") + "\n" +
        style.said({translatable("Usage: drillwave %1 [OPTION]…\n"), {std::string(command.name) + operands}});
    if (const std::string details = style.patternFor(std::string(command.details)); !details.empty())
        help += "\n" + wrappedDetails(details);
    if (command.operands.starts_with("FILE")) help += "\n" + wrappedDetails(said(scenarioOperandHelp));
    const std::vector<OptionSpec> options = optionsOf(command);
    std::size_t width = std::string_view("-h, --help").size();
    for (const OptionSpec& option : options)
        width = std::max(width, std::min(synopsis(option).size(), widestLeft));
    help += "\n" + said(optionsTitle) + "\n";
    for (const OptionSpec& option : options) help += entry(synopsis(option), said(option.help), width);
    help += entry("-h, --help", said(thisText), width) + entry("--version", said(versionHelp), width);
    if (command.furtherHelp) help += "\n" + wrappedDetails(command.furtherHelp(style));
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
    std::vector<std::string_view> texts{usageHeader,  usageFooter,   scenarioOperandHelp, exitCodesHelp,
                                        optionsTitle, thisText,      versionHelp,         helpSummary,
                                        helpDetails,  versionSummary};
    for (const Command* command : commands()) {
        texts.push_back(command->summary);
        if (!command->details.empty()) texts.push_back(command->details);
        for (const OptionSpec& option : optionsOf(*command)) texts.push_back(option.help);
    }
    for (const Output& output : drillOutputs()) texts.push_back(output.meaning);
    return texts;
}

}  // namespace drillwave

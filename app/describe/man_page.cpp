// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/describe/man_page.h"

#include <algorithm>
#include <vector>

#include "app/command.h"
#include "app/help_text.h"
#include "app/language_option.h"
#include "app/scenario_argument.h"
#include "core/model/version.h"

namespace drillwave {

namespace {

/// The characters that man(7) would take for something else, or set as another one.
std::string_view manCharacter(const char& character) {
    switch (character) {
        case '\\':
            return "\\e";
        case '-':
            return "\\-";
        case '\'':
            return "\\(aq";
        case '^':
            return "\\(ha";
        case '~':
            return "\\(ti";
        default:
            return {&character, 1};
    }
}

/// Returns the text with three dots for each "…", which terminals without UTF-8 do not have.
std::string withDots(std::string_view text) {
    constexpr std::string_view ellipsis = "…";
    std::string shown(text);
    for (std::size_t at = shown.find(ellipsis); at != std::string::npos; at = shown.find(ellipsis, at))
        shown.replace(at, ellipsis.size(), "...");
    return shown;
}

std::string bold(std::string_view text) {
    return "\\fB" + manText(text) + "\\fR";
}

std::string item(const std::string& title, std::string_view meaning) {
    return ".TP\n" + title + "\n" + manText(meaning) + "\n";
}

std::string heading(std::string_view name, std::string_view date) {
    return ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n.TH " + std::string(name) + " 1 " +
           std::string(date) + " \"Drillwave " + versionText + "\" \"User Commands\"\n.nh\n";
}

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::size_t indentOf(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// "word" and "what it means" of "  word   what it means"; no meaning where there are no two blanks.
struct Entry {
    std::string_view word;
    std::string_view meaning;
};

Entry entryOf(std::string_view line) {
    line.remove_prefix(indentOf(line));
    const std::size_t gap = line.find("  ");
    if (gap == std::string_view::npos) return {line, {}};
    const std::string_view behind = line.substr(gap);
    return {line.substr(0, gap), behind.substr(indentOf(behind))};
}

std::string manSection(const Command& command) {
    std::string text = ".SS " + std::string(command.name) + "\n.B drillwave " + std::string(command.name) +
                       "\n" + manText(std::string(command.operands) + " [OPTION]…") + "\n.PP\n" +
                       manText(command.summary) + ".\n";
    for (const OptionSpec& option : command.options)
        text += item(bold(option.text()) + (option.value.empty() ? "" : " " + manText(option.value)),
                     option.help);
    if (const std::string details = detailsOf(command); !details.empty()) text += manDetails(details);
    return text;
}

std::string exitCodes() {
    std::string text;
    std::string_view rest = exitCodesHelp;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        const std::string_view code = rest.substr(indentOf(rest), end - indentOf(rest));
        const std::size_t blank = code.find(' ');
        text += item(bold(code.substr(0, blank)), code.substr(blank + 1));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        while (rest.starts_with('\n')) rest.remove_prefix(1);
    }
    return text;
}

}  // namespace

std::string manText(std::string_view text) {
    std::string shown;
    bool isBold = false;
    bool beginsLine = true;
    const std::string dotted = withDots(text);
    for (const char& character : dotted) {
        // A dot or a quote that begins a line would be a request.
        if (beginsLine && (character == '.' || character == '\'')) shown += "\\&";
        if (character == '`') {
            isBold = !isBold;
            shown += isBold ? "\\fB" : "\\fR";
        } else {
            shown += manCharacter(character);
        }
        beginsLine = character == '\n';
    }
    return shown;
}

std::string manDetails(std::string_view lines) {
    std::string text;
    enum class Before { nothing, paragraph, item, line } before = Before::nothing;
    std::size_t indent = 0;  // of the last item
    for (const std::string_view line : linesOf(lines)) {
        const Entry entry = entryOf(line);
        if (indentOf(line) == 0) {
            // A line that only announces what follows stands alone, and does not end the paragraph before it.
            const bool announces = line.ends_with(':') && line.find(' ') == std::string_view::npos;
            if (before != Before::paragraph || announces) text += ".PP\n";
            text += manText(line) + "\n";
            before = Before::paragraph;
        } else if (before == Before::item && indentOf(line) > indent) {
            text += manText(line.substr(indentOf(line))) + "\n";
        } else if (!entry.meaning.empty()) {
            text += item(bold(entry.word), entry.meaning);
            indent = indentOf(line);
            before = Before::item;
        } else {
            text += (before == Before::line ? ".br\n" : ".PP\n") + manText(entry.word) + "\n";
            before = Before::line;
        }
    }
    return text;
}

std::string manPage(std::string_view date) {
    std::string page = heading("DRILLWAVE", date) +
                       ".SH NAME\ndrillwave \\- simulate percussive top\\-hammer drilling of rock\n"
                       ".SH SYNOPSIS\n.B drillwave\n.RI [ FILE ]\n.br\n.B drillwave\n.I COMMAND\n"
                       ".RI [ ARGUMENT ...]\n.br\n.B drillwave help\n.RI [ TOPIC ]\n"
                       ".SH DESCRIPTION\n";
    page +=
        manText(
            "A hammer blow sends a stress wave through the drill rod, the bit meets the rock, once or "
            "several "
            "times,\nand the rod rebounds. Drillwave says how fast it rebounds, how far the bit penetrates, "
            "where the energy of\nthe blow goes, and what feed force the blows need.\n"
            "Without a command it opens its window, which is in the package of the desktop "
            "(`drillwave-window`); "
            "the\ncommands need neither that nor a display.") +
        "\n.PP\n" + manText(scenarioOperandHelp) + "\n.SH COMMANDS\n";
    for (const Command* command : commands()) page += manSection(*command);
    page += ".SS help\n.B drillwave help\n.RI [ TOPIC ]\n.PP\n" + manText(helpSummary) + ".\n" +
            manText(helpDetails) +
            "\n"
            ".SS version\n.B drillwave version\n.PP\n" +
            manText(versionSummary) +
            ".\n"
            ".SH OPTIONS\nEvery command also has\n" +
            item(bold("-h") + ", " + bold("--help"), "what it takes") +
            item(bold("--version"), "version of the program") +
            item(bold(languageOption.text()) + " " + manText(languageOption.value), languageOption.help) +
            "The window has\n" +
            item(bold("--reset-ui"), "open with the first layout, page, units and choices") +
            item(bold("--language") + " CODE",
                 "use English (en), German (de) or Swedish (sv) for this start, instead of the language "
                 "chosen under View or that of the system") +
            ".SH ENVIRONMENT\n" +
            item(bold(languageVariable),
                 "the language of the commands, as --language; they speak English "
                 "where neither says another") +
            ".SH EXIT STATUS\n" + exitCodes() +
            ".SH EXAMPLES\n.EX\ndrillwave run t38_medium_rock\n"
            "drillwave run t38_medium_rock \\-\\-set rod.length=4.27m gamma=0.2\n"
            "drillwave examples \\-o scenarios\n.EE\n"
            ".SH SEE ALSO\n.BR drillwave\\-window (1)\n.PP\n"
            "The manual, with theory, files, commands and a tutorial, is printed by\n.B drillwave help\n.IR "
            "TOPIC ,\n"
            "and is in the folder\n.I manual\n"
            "of the documentation, beside\n.I examples\nof scenarios.\n";
    return page;
}

std::string windowManPage(std::string_view date) {
    return heading("DRILLWAVE-WINDOW", date) +
           ".SH NAME\ndrillwave\\-window \\- the window of drillwave\n"
           ".SH SYNOPSIS\n.B drillwave\\-window\n.RB [ \\-\\-reset\\-ui ]\n.RB [ \\-\\-language\n.IR CODE "
           "]\n.RI [ FILE ]\n.SH DESCRIPTION\n" +
           manText(
               "The same program as `drillwave`, linked to the library of the desktop: it has the same "
               "commands, opens "
               "the\nwindow and draws pictures. `drillwave` goes on as this one where it needs to; there is "
               "no need "
               "to\ncall it.\nFILE is what a command takes: a scenario, a result that holds one, or the name "
               "of an "
               "example.") +
           "\n.SH SEE ALSO\n.BR drillwave (1)\n";
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.h"
#include "app/describe/completions.h"
#include "app/describe/value_kind.h"
#include "app/help_text.h"
#include "app/language_option.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

/// Quotes a text as one word of fish.
std::string fishWord(std::string_view text) {
    std::string shown = "'";
    for (const char character : text) {
        if (character == '\'' || character == '\\') shown += '\\';
        shown += character;
    }
    return shown + "'";
}

std::string functionName(ValueKind kind) {
    return "__drillwave_" + std::string(name(kind));
}

/// Functions that do not depend on the tables.
constexpr std::string_view fishFunctions = R"fish(
# Whether a command is still to come: options of the program may stand before it.
function __drillwave_use_subcommand
    set -l words (commandline -opc)
    set -e words[1]
    while set -q words[1]
        switch $words[1]
            case --language
                set -e words[1]
                set -q words[1]; or return 0
            case '-*'
            case '*'
                return 1
        end
        set -e words[1]
    end
    return 0
end

# Whether the last option before the cursor is this one.
function __drillwave_follows
    for word in (commandline -opc)[-1..1]
        string match -q -- '-*' $word; or continue
        test $word = $argv[1]
        return
    end
    return 1
end

# Prints words that begin as the current one does, up to their next = : or @.
function __drillwave_stage
    set -l current (commandline -ct)
    set -l length (string length -- "$current")
    set -l last
    for word in $argv
        test (string sub -l $length -- $word) = "$current"; or continue
        set -l rest (string sub -s (math $length + 1) -- $word)
        set -l staged "$current"(string replace -r '([=:@]).*' '$1' -- $rest)
        contains -- "$staged" "$last" "$current"; or printf '%s\n' $staged
        set last $staged
    end
end
)fish";

/// Returns a function that prints the words of a kind, a line each; for lists with the present ones up to the
/// last comma in front, and only new words; for aims and limits the statistics after the "@".
std::string fishFunction(ValueKind kind) {
    const std::vector<std::string> words = wordsOf(kind);
    if (words.empty()) return {};
    std::string list;
    for (const std::string& word : words) list += " " + fishWord(word);
    std::string text = "\nfunction " + functionName(kind) + "\n";
    if (isStaged(kind)) {
        text += "    set -l words" + list + "\n";
        if (kind == ValueKind::aim || kind == ValueKind::limit)
            text +=
                "    if string match -q '*@*' -- (commandline -ct)\n"
                "        set words (string replace -r '@.*' '' -- (commandline -ct))@(" +
                functionName(ValueKind::statistic) + ")" + (kind == ValueKind::limit ? "=" : "") +
                "\n    end\n";
        return text + "    __drillwave_stage $words\nend\n";
    }
    if (isList(kind))
        return text + "    set -l before (string match -r '.*,' -- (commandline -ct))\n    for word in" +
               list +
               "\n        string match -q -- \"*,$word,*\" \",$before\"; or printf '%s%s\\n' \"$before\" "
               "$word\n    end\nend\n";
    return text + "    printf '%s\\n'" + list + "\nend\n";
}

/// Returns the flags for the values of an option, or for the operands.
std::string choice(ValueKind kind) {
    switch (kind) {
        case ValueKind::free:
            return " -x";
        case ValueKind::folder:
            return " -x -a '(__fish_complete_directories)'";
        case ValueKind::file:
            return " -r -F";
        case ValueKind::scenario:
            return " -F -a '(" + functionName(kind) + ")'";
        default:
            return " -x -a '(" + functionName(kind) + ")'";
    }
}

std::string fishLines(const Command& command) {
    const std::string line =
        "complete -c drillwave -n '__fish_seen_subcommand_from " + std::string(command.name) + "'";
    std::string text = "\n";
    for (const OptionSpec& option : optionsOf(command)) {
        text += line + (option.isLong() ? " -l " : " -s ") + std::string(option.name);
        if (!option.value.empty()) text += choice(valueKind(option));
        text += " -d " + fishWord(option.help) + "\n";
        if (option.times == OptionSpec::Times::list && isStaged(valueKind(option)))
            text += "complete -c drillwave -n '__fish_seen_subcommand_from " + std::string(command.name) +
                    "; and __drillwave_follows " + option.text() + "' -a '(" +
                    functionName(valueKind(option)) + ")'\n";
    }
    text += line + " -s h -l help -d 'what it takes'\n";
    if (operandKind(command) != ValueKind::free) text += line + choice(operandKind(command)) + "\n";
    return text;
}

}  // namespace

std::string fishCompletion() {
    std::string text = "# SPDX-License-Identifier: GPL-3.0-or-later\n# Completion of drillwave for fish.\n";
    text += fishFunctions;
    for (const ValueKind kind : allValues<ValueKind>) text += fishFunction(kind);
    text += "\ncomplete -c drillwave -f\n";
    const auto add = [&](std::string_view name, std::string_view summary) {
        text += "complete -c drillwave -n __drillwave_use_subcommand -a " + std::string(name) + " -d " +
                fishWord(summary) + "\n";
    };
    for (const Command* command : commands()) add(command->name, command->summary);
    add("help", helpSummary);
    add("version", versionSummary);
    for (const std::string_view option : programOptions)
        text += "complete -c drillwave -n __drillwave_use_subcommand -l " + std::string(option.substr(2)) +
                (option == languageOption.text() ? choice(ValueKind::language) : "") + "\n";
    text += "complete -c drillwave -n __drillwave_use_subcommand" + choice(ValueKind::scenario) +
            "\ncomplete -c drillwave -n '__fish_seen_subcommand_from help'" + choice(ValueKind::topic) + "\n";
    for (const Command* command : commands()) text += fishLines(*command);
    return text + "\ncomplete -c drillwave-window -w drillwave\n";
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.h"
#include "app/describe/completions.h"
#include "app/describe/value_kind.h"
#include "app/help_text.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

/// As one word of fish.
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

/// Prints the words of a kind, a line each; of lists also what is there already, up to the last comma.
std::string fishFunction(ValueKind kind) {
    const std::vector<std::string> words = wordsOf(kind);
    if (words.empty()) return {};
    std::string list;
    for (const std::string& word : words) list += " " + fishWord(word);
    const bool isList = kind == ValueKind::outputs || kind == ValueKind::formats;
    return "\nfunction " + functionName(kind) + "\n" +
           (isList ? "    set -l before (string match -r '.*,' -- (commandline -ct))\n"
                   : "    set -l before\n") +
           "    for word in" + list + "\n        printf '%s%s\\n' \"$before\" $word\n    end\nend\n";
}

/// What may stand behind an option, or where none is.
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
    }
    text += line + " -s h -l help -d 'what it takes'\n";
    if (operandKind(command) != ValueKind::free) text += line + choice(operandKind(command)) + "\n";
    return text;
}

}  // namespace

std::string fishCompletion() {
    std::string text = "# SPDX-License-Identifier: GPL-3.0-or-later\n# Completion of drillwave for fish.\n";
    for (const ValueKind kind : allValues<ValueKind>) text += fishFunction(kind);
    text += "\ncomplete -c drillwave -f\n";
    const auto add = [&](std::string_view name, std::string_view summary) {
        text += "complete -c drillwave -n __fish_use_subcommand -a " + std::string(name) + " -d " +
                fishWord(summary) + "\n";
    };
    for (const Command* command : commands()) add(command->name, command->summary);
    add("help", helpSummary);
    add("version", versionSummary);
    text += "complete -c drillwave -n __fish_use_subcommand" + choice(ValueKind::scenario) +
            "\ncomplete -c drillwave -n '__fish_seen_subcommand_from help'" + choice(ValueKind::topic) + "\n";
    for (const Command* command : commands()) text += fishLines(*command);
    return text + "\ncomplete -c drillwave-window -w drillwave\n";
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.h"
#include "app/describe/completions.h"
#include "app/describe/value_kind.h"
#include "app/help_text.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

/// Text inside single quotes, in which `special` has a backslash before it.
std::string zshText(std::string_view text, std::string_view special) {
    std::string shown;
    for (const char character : text) {
        if (special.find(character) != std::string_view::npos) shown += '\\';
        shown += character == '\'' ? std::string("'\\''") : std::string(1, character);
    }
    return shown;
}

std::string action(ValueKind kind) {
    switch (kind) {
        case ValueKind::free:
            return " ";
        case ValueKind::folder:
            return "_files -/";
        case ValueKind::file:
            return "_files";
        default:
            return "_drillwave_" + std::string(name(kind));
    }
}

/// "'*--set[change parameters]:KEY=VALUE:_drillwave_parameter'", as _arguments takes it.
std::string specification(const OptionSpec& option) {
    std::string text = option.times == OptionSpec::Times::once ? "'" : "'*";
    text += option.text() + "[" + zshText(option.help, "[]\\") + "]";
    if (!option.value.empty()) text += ":" + zshText(option.value, ":\\") + ":" + action(valueKind(option));
    return text + "'";
}

std::string zshFunction(ValueKind kind) {
    const std::vector<std::string> words = wordsOf(kind);
    if (words.empty()) return {};
    std::string list;
    for (const std::string& word : words) list += " '" + zshText(word, "") + "'";
    std::string text =
        "\n_drillwave_" + std::string(name(kind)) + "() {\n    local -a words=(" + list.substr(1) + ")\n";
    switch (kind) {
        case ValueKind::parameter:
            text += "    compadd -S '' -a words\n";
            break;
        case ValueKind::outputs:
        case ValueKind::formats:
            text += "    _sequence compadd - -a words\n";
            break;
        case ValueKind::scenario:
            text += "    compadd -a words\n    _files\n";
            break;
        default:
            text += "    compadd -a words\n";
    }
    return text + "}\n";
}

std::string operandSpecification(const Command& command) {
    if (command.mostOperands == 0) return {};
    const std::string operand = ":" + zshText(command.operands, ":\\") + ":";
    const ValueKind kind = operandKind(command);
    // A scenario comes first, and other files behind it.
    if (kind == ValueKind::scenario && command.mostOperands < 3)
        return " \\\n            '1" + operand + action(kind) + "' '*" + operand + "_files'";
    return " \\\n            '*" + operand + action(kind) + "'";
}

}  // namespace

std::string zshCompletion() {
    std::string text =
        "#compdef drillwave drillwave-window\n# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of drillwave for zsh.\n";
    for (const ValueKind kind : allValues<ValueKind>) text += zshFunction(kind);
    text += "\n_drillwave_command() {\n    local -a commands=(\n";
    for (const Command* command : commands())
        text += "        '" + std::string(command->name) + ":" + zshText(command->summary, ":\\") + "'\n";
    text += "        'help:" + zshText(helpSummary, ":\\") +
            "'\n        'version:" + std::string(versionSummary) +
            "'\n    )\n"
            "    _describe command commands\n}\n"
            "\n_drillwave() {\n"
            "    if ((CURRENT == 2)); then\n        _drillwave_command\n        _drillwave_scenario\n        "
            "return\n"
            "    fi\n    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command in\n"
            "        help) ((CURRENT > 2)) || _drillwave_topic ;;\n";
    for (const Command* command : commands()) {
        text += "        " + std::string(command->name) + ")\n            _arguments -S";
        for (const OptionSpec& option : optionsOf(*command))
            text += " \\\n            " + specification(option);
        text += " \\\n            '(- *)'{-h,--help}'[what it takes]'" + operandSpecification(*command) +
                "\n            ;;\n";
    }
    return text + "    esac\n}\n\n_drillwave \"$@\"\n";
}

}  // namespace drillwave

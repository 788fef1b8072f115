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

/// "'*--set[change parameters]:*-*:KEY=VALUE:_drillwave_parameter'", as _arguments takes it: of a list all
/// words up to the next option.
std::string specification(const OptionSpec& option) {
    std::string text = option.times == OptionSpec::Times::once ? "'" : "'*";
    text += option.text() + "[" + zshText(option.help, "[]\\") + "]";
    const bool isList = option.times == OptionSpec::Times::list && isStaged(valueKind(option));
    if (!option.value.empty())
        text += (isList ? ":*-*:" : ":") + zshText(option.value, ":\\") + ":" + action(valueKind(option));
    return text + "'";
}

/// Offers its arguments up to their next = : or @; does not depend on the tables.
constexpr std::string_view zshStage = R"zsh(
_drillwave_stage() {
    local word rest head before=${PREFIX%"${PREFIX##*[=:@]}"}
    local -aU open whole
    for word; do
        [[ $word == "$PREFIX"* && $word != "$PREFIX" ]] || continue
        rest=${word#"$before"} head=${rest%%[=:@]*}
        if [[ $head == $rest ]]; then whole+=("$rest"); else open+=("$head${rest[$#head+1]}"); fi
    done
    compset -P '*[=:@]'
    compadd -S '' -a open
    compadd -a whole
}
)zsh";

/// The words of an aim or a limit once an "@" has been typed: "…@{mean,q05}=".
std::string statisticsBehind(ValueKind kind) {
    std::string list;
    for (const std::string& word : wordsOf(ValueKind::statistic)) list += (list.empty() ? "" : ",") + word;
    return "    [[ $PREFIX != *@* ]] || words=(\"${PREFIX%%@*}@\"{" + list + "}" +
           (kind == ValueKind::limit ? "=" : "") + ")\n";
}

std::string zshFunction(ValueKind kind) {
    const std::vector<std::string> words = wordsOf(kind);
    if (words.empty()) return {};
    std::string list;
    for (const std::string& word : words) list += " '" + zshText(word, "") + "'";
    const bool isOfKeys = kind == ValueKind::parameter || kind == ValueKind::choice;
    std::string text = "\n_drillwave_" + std::string(name(kind)) + "() {\n" +
                       (isOfKeys ? "    local previous=$words[CURRENT-1]\n" : "") + "    local -a words=(" +
                       list.substr(1) + ")\n";
    switch (kind) {
        case ValueKind::aim:
        case ValueKind::limit:
            text += statisticsBehind(kind) + "    _drillwave_stage $words\n";
            break;
        case ValueKind::parameter:
        case ValueKind::choice:
            // After the first one of a list FILE may follow as well.
            text += "    [[ $previous == -* ]] || _drillwave_scenario\n    _drillwave_stage $words\n";
            break;
        case ValueKind::outputs:
        case ValueKind::formats:
        case ValueKind::reportStudies:
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
    // A scenario comes first, and other files after it.
    if (kind == ValueKind::scenario && command.mostOperands < 3)
        return " \\\n            '1" + operand + action(kind) + "' '*" + operand + "_files'";
    return " \\\n            '*" + operand + action(kind) + "'";
}

}  // namespace

std::string zshCompletion() {
    std::string text =
        "#compdef drillwave drillwave-window\n# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of drillwave for zsh.\n";
    text += zshStage;
    for (const ValueKind kind : allValues<ValueKind>) text += zshFunction(kind);
    std::string options;
    for (const std::string_view option : programOptions) options += std::string(option) + " ";
    text += "\n_drillwave_command() {\n    local -a commands=(\n";
    for (const Command* command : commands())
        text += "        '" + std::string(command->name) + ":" + zshText(command->summary, ":\\") + "'\n";
    text += "        'help:" + zshText(helpSummary, ":\\") +
            "'\n        'version:" + std::string(versionSummary) +
            "'\n    )\n"
            "    _describe command commands\n}\n"
            "\n_drillwave() {\n"
            "    while ((CURRENT > 2)) && [[ $words[2] == (--language(|=*)|--reset-ui) ]]; do\n"
            "        if [[ $words[2] == --language ]]; then\n"
            "            ((CURRENT > 3)) || { _drillwave_language; return }\n"
            "            words[2]=()\n            ((CURRENT--))\n        fi\n"
            "        words[2]=()\n        ((CURRENT--))\n    done\n"
            "    if ((CURRENT == 2)); then\n"
            "        if [[ $PREFIX == -* ]]; then\n            compadd -- " +
            options +
            "\n            return\n        fi\n"
            "        _drillwave_command\n        _drillwave_scenario\n        "
            "return\n"
            "    fi\n    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command in\n"
            "        help | --help | -h) ((CURRENT > 2)) || _drillwave_topic ;;\n";
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

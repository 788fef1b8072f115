// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "app/command.h"
#include "app/describe/completions.h"
#include "app/describe/value_kind.h"
#include "app/help_text.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

/// What does not depend on the tables. Words are sought by their beginning, lists behind their last comma;
/// names with blanks in them are quoted. Behind an option that takes many KEY=… words further ones are
/// sought, too.
constexpr std::string_view functions = R"bash(
_drillwave_offer() {
    local word before=
    [[ $2 != list ]] || { [[ $current != *,* ]] || before=${current%,*},; }
    while IFS= read -r word; do
        [[ -z $word || $before$word != "$current"* ]] || COMPREPLY+=("$before$(printf %q "$word")")
    done < <(_drillwave_words "$1")
}

_drillwave_files() {
    compopt -o filenames 2>/dev/null
    local path
    while IFS= read -r path; do COMPREPLY+=("$path"); done < <(compgen "$1" -- "$current")
}

_drillwave_kind() {
    case $1 in
        free) ;;
        folder) _drillwave_files -d ;;
        file) _drillwave_files -f ;;
        scenario) _drillwave_offer scenario && _drillwave_files -f ;;
        parameter) compopt -o nospace 2>/dev/null && _drillwave_offer parameter ;;
        outputs | formats) compopt -o nospace 2>/dev/null && _drillwave_offer "$1" list ;;
        *) _drillwave_offer "$1" ;;
    esac
}

_drillwave() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} kind word i
    COMPREPLY=()
    # The shell splits at "=": what stands behind a key is a value of the user's own.
    [[ $current != = && $previous != = ]] || return 0
    current=${current//\\/}
    if [[ $COMP_CWORD -eq 1 ]]; then
        while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -W "$_drillwave_commands" -- "$current")
        _drillwave_kind scenario
        return 0
    fi
    if [[ $command == help ]]; then
        _drillwave_kind topic
        return 0
    fi
    kind=$(_drillwave_value "$command" "$previous")
    if [[ -n $kind ]]; then
        _drillwave_kind "$kind"
        return 0
    fi
    if [[ $current == -* ]]; then
        while IFS= read -r word; do COMPREPLY+=("$word"); done \
            < <(compgen -W "$(_drillwave_options "$command")" -- "$current")
        return 0
    fi
    for ((i = COMP_CWORD - 1; i > 1; --i)); do
        [[ ${COMP_WORDS[i]} == -* ]] || continue
        [[ " $_drillwave_lists " != *" ${COMP_WORDS[i]} "* ]] || _drillwave_offer parameter
        break
    done
    _drillwave_kind "$(_drillwave_operand "$command")"
}

complete -F _drillwave drillwave
complete -F _drillwave drillwave-window
)bash";

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : std::string(between)) + word;
    return text;
}

/// A function that prints by its words: `case "$*" in PATTERN|PATTERN) echo 'TEXT' ;;`, patterns of one text
/// in one line.
std::string caseFunction(std::string_view title,
                         const std::map<std::string, std::vector<std::string>>& patterns) {
    std::string text = "\n" + std::string(title) + "() {\n    case $* in\n";
    for (const auto& [shown, words] : patterns)
        text += "        " + joined(words, " | ") + ") echo '" + shown + "' ;;\n";
    return text + "    esac\n}\n";
}

std::string bashWord(std::string_view text) {
    return "'" + std::string(text) + "'";
}

}  // namespace

std::string bashCompletion() {
    std::vector<std::string> names;
    std::vector<std::string> lists;
    std::map<std::string, std::vector<std::string>> options;
    std::map<std::string, std::vector<std::string>> values;
    std::map<std::string, std::vector<std::string>> operands;
    for (const Command* command : commands()) {
        names.emplace_back(command->name);
        std::vector<std::string> own;
        for (const OptionSpec& option : optionsOf(*command)) {
            own.push_back(option.text());
            if (!option.value.empty())
                values[std::string(name(valueKind(option)))].push_back(
                    bashWord(std::string(command->name) + " " + option.text()));
            if (option.times == OptionSpec::Times::list && valueKind(option) == ValueKind::parameter &&
                std::ranges::find(lists, option.text()) == lists.end())
                lists.push_back(option.text());
        }
        options[joined(own, " ") + (own.empty() ? "" : " ") + "--help"].emplace_back(command->name);
        operands[std::string(name(operandKind(*command)))].emplace_back(command->name);
    }
    std::string text =
        "# SPDX-License-Identifier: GPL-3.0-or-later\n# Completion of drillwave for bash.\n"
        "_drillwave_commands='" +
        joined(names, " ") + " help version'\n_drillwave_lists='" + joined(lists, " ") + "'\n";
    text += caseFunction("_drillwave_options", options);
    text += caseFunction("_drillwave_value", values);
    text += caseFunction("_drillwave_operand", operands);
    std::map<std::string, std::vector<std::string>> words;
    for (const ValueKind kind : allValues<ValueKind>)
        if (const std::vector<std::string> list = wordsOf(kind); !list.empty())
            words[joined(list, "\n")].emplace_back(name(kind));
    return text + caseFunction("_drillwave_words", words) + std::string(functions);
}

}  // namespace drillwave

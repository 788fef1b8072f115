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

/// The part that does not depend on the tables. Words are sought by their beginning, lists after their last
/// comma; names with blanks in them are quoted. After an option that takes many KEY=… words further ones are
/// also sought.
constexpr std::string_view bashFunctions = R"bash(
# Bash splits words at = : and @ as COMP_WORDBREAKS says. This joins them again, and sets `before` to the part
# of the last word that stays as it is.
_drillwave_join() {
    local word breaks= joins= i
    for word in = : @; do [[ ${COMP_WORDBREAKS-=:@} != *"$word"* ]] || breaks+=$word; done
    for ((i = 0; i <= COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        if [[ $i -gt 0 && (-n $joins || $word == ["$breaks"]*) ]]; then words[-1]+=$word; else words+=("$word"); fi
        if [[ $word == *["$breaks"] ]]; then joins=1; else joins=; fi
    done
    current=${words[-1]//\\/}
    before=${current%"${current##*["$breaks"]}"}
}

_drillwave_offer() {
    local word list=
    [[ $2 != list ]] || { [[ $current != *,* ]] || list=${current%,*},; }
    while IFS= read -r word; do
        [[ -z $word || $list$word != "$current"* || ,$list == *",$word,"* ]] || COMPREPLY+=("$list$(printf %q "$word")")
    done < <(_drillwave_words "$1")
}

# Offers words up to their next = : or @; behind @ the statistics.
_drillwave_stage() {
    local word rest head last= behind=
    staged=1
    [[ $1 != limit ]] || behind==
    while IFS= read -r word; do
        [[ -n $word && $word == "$current"* && $word != "$current" ]] || continue
        rest=${word#"$current"} head=${rest%%[=:@]*}
        word=$current$head${rest:${#head}:1}
        [[ $word == "$last" ]] || COMPREPLY+=("$(printf %q "${word#"$before"}")")
        last=$word
    done < <(
        if [[ $1 != parameter && $1 != choice && $current == *@* ]]; then
            while IFS= read -r word; do echo "${current%%@*}@$word$behind"; done < <(_drillwave_words statistic)
        else
            _drillwave_words "$1"
        fi
    )
    [[ ${#COMPREPLY[@]} -eq 0 || ${COMPREPLY[0]} != *[=:@] ]] || compopt -o nospace 2>/dev/null
}

# Names of files are not told so where keys are offered, too: "=" would be quoted in them.
_drillwave_files() {
    [[ -n $staged ]] || compopt -o filenames 2>/dev/null
    local path
    while IFS= read -r path; do COMPREPLY+=("$path"); done < <(compgen "$1" -- "$current")
}

_drillwave_kind() {
    case $1 in
        free) ;;
        folder) _drillwave_files -d ;;
        file) _drillwave_files -f ;;
        scenario) _drillwave_offer scenario && _drillwave_files -f ;;
        parameter | choice | aim | limit) _drillwave_stage "$1" ;;
        outputs | formats | report_studies) compopt -o nospace 2>/dev/null && _drillwave_offer "$1" list ;;
        *) _drillwave_offer "$1" ;;
    esac
}

_drillwave_offer_from() {
    local word
    while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -W "$1" -- "$current")
}

_drillwave() {
    local words=() current before staged= command kind i
    COMPREPLY=()
    _drillwave_join
    while [[ ${words[1]} == --language && ${#words[@]} -gt 3 || ${words[1]} == --language=* || ${words[1]} == --reset-ui ]]; do
        [[ ${#words[@]} -gt 2 ]] || break
        if [[ ${words[1]} == --language ]]; then i=3; else i=2; fi
        words=("${words[0]}" "${words[@]:i}")
    done
    command=${words[1]}
    if [[ ${#words[@]} -eq 2 ]]; then
        if [[ $current == -* ]]; then
            _drillwave_offer_from "$_drillwave_program_options"
        else
            _drillwave_offer_from "$_drillwave_commands"
            _drillwave_kind scenario
        fi
        return 0
    fi
    case $command in
        help | --help | -h) _drillwave_kind topic && return 0 ;;
        --language) _drillwave_kind language && return 0 ;;
    esac
    kind=$(_drillwave_value "$command" "${words[-2]}")
    if [[ -n $kind ]]; then
        _drillwave_kind "$kind"
        return 0
    fi
    if [[ $current == -* ]]; then
        _drillwave_offer_from "$(_drillwave_options "$command")"
        return 0
    fi
    for ((i = ${#words[@]} - 2; i > 1; --i)); do
        [[ ${words[i]} == -* ]] || continue
        [[ " $_drillwave_lists " != *" ${words[i]} "* ]] || _drillwave_kind "$(_drillwave_value "$command" "${words[i]}")"
        break
    done
    [[ ${#COMPREPLY[@]} -gt 0 && -n $current ]] || _drillwave_kind "$(_drillwave_operand "$command")"
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
            if (option.times == OptionSpec::Times::list && isStaged(valueKind(option)) &&
                std::ranges::find(lists, option.text()) == lists.end())
                lists.push_back(option.text());
        }
        options[joined(own, " ") + (own.empty() ? "" : " ") + "--help"].emplace_back(command->name);
        operands[std::string(name(operandKind(*command)))].emplace_back(command->name);
    }
    std::string text =
        "# SPDX-License-Identifier: GPL-3.0-or-later\n# Completion of drillwave for bash.\n"
        "_drillwave_commands='" +
        joined(names, " ") + " help version'\n_drillwave_program_options='" +
        joined({std::begin(programOptions), std::end(programOptions)}, " ") + "'\n_drillwave_lists='" +
        joined(lists, " ") + "'\n";
    text += caseFunction("_drillwave_options", options);
    text += caseFunction("_drillwave_value", values);
    text += caseFunction("_drillwave_operand", operands);
    std::map<std::string, std::vector<std::string>> words;
    for (const ValueKind kind : allValues<ValueKind>)
        if (const std::vector<std::string> list = wordsOf(kind); !list.empty())
            words[joined(list, "\n")].emplace_back(name(kind));
    return text + caseFunction("_drillwave_words", words) + std::string(bashFunctions);
}

}  // namespace drillwave

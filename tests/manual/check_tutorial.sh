#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every command of the tutorial, from top to bottom in a copy of resources/examples/identify: check_tutorial.sh ROOT PROGRAM
# Each must end with 0; where a goal has no answer with 6. The other languages must have the same commands. `drillwave stability`
# is left out, which takes long, writes nothing and has tests of its own.
set -u
export LC_ALL=C DRILLWAVE_LANGUAGE=en
root=$(readlink -f "${1:?check_tutorial.sh ROOT PROGRAM}")
program=$(readlink -f "${2:?check_tutorial.sh ROOT PROGRAM}")
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
PATH=$(dirname "$program"):$PATH

# Prints what is to be typed, one command a line: lines of blocks, and code between backquotes that begins with a
# command and its arguments. A block of YAML is written into the file that is named before it.
commands() {
    awk '
        function flush(    n, part, i) {
            n = split(text, part, "`")
            for (i = 2; i <= n; i += 2) {
                if (part[i] ~ /^drillwave [a-z]+ /) print part[i]
                if (part[i] ~ /\.yaml$/) file = part[i]
            }
            text = ""
        }
        /^ *```/ { flush(); kind = kind ? "" : $0; sub(/^ *```/, "", kind); if (!kind && !inside) kind = "sh"; inside = !inside
                   if (inside && kind == "yaml") printf "printf \"%%s\\n\" "
                   if (!inside) { if (yaml) print ">" file; yaml = 0; kind = "" }
                   next }
        inside && kind == "yaml" { yaml = 1; sub(/^   /, ""); printf "\047%s\047 ", $0 }
        inside && kind == "sh" { sub(/^ +/, ""); sub(/ +# .*/, ""); if (sub(/ *\\$/, " ")) printf "%s", $0; else print }
        !inside { text = text " " $0 }
        END { flush() }' "$1"
}

commands "$root/resources/manual/tutorial.md" >"$work/en"
[ "$(grep -c '^drillwave' "$work/en")" -gt 40 ] || { echo "the tutorial has hardly any commands" && exit 1; }
for language in de sv; do
    commands "$root/resources/manual/$language/tutorial.md" >"$work/$language"
    diff "$work/en" "$work/$language" || echo "$language/tutorial.md: other commands than tutorial.md"
done >"$work/wrong"
# The tutorial asks the reader to copy this folder.
cp -R "$root/resources/examples/identify" "$work/folder" && cd "$work/folder" || exit 2
while IFS= read -r line; do
    code=0
    sh -c "$line" </dev/null >"$work/printed" 2>&1 || code=$?
    case "$code $line" in
        0\ * | 6\ *--goal*) ;;
        *) echo "$line: exit code $code: $(tail -1 "$work/printed")" ;;
    esac
done <"$work/en" >>"$work/wrong"
cat "$work/wrong"
[ ! -s "$work/wrong" ] || exit 1
echo "$(wc -l <"$work/en") commands of the tutorial run in one folder"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Holds the manual to the program: check_names.sh ROOT PROGRAM
# Every parameter, number of a section, output, alert and shape of a blow must stand in files.md, and every command and option in commands.md,
# as `name`. Outputs, shapes, commands and options are those that the program says it has; parameters, numbers of sections and
# alerts, which it lists nowhere, those of the tables in the sources.
set -u
export LC_ALL=C
root=${1:?check_names.sh ROOT PROGRAM}
program=${2:?check_names.sh ROOT PROGRAM}
cd "$root" || exit 2
missing=$(mktemp) || exit 2  # what is missing, said in the subshells of pipes
trap 'rm -f "$missing"' EXIT

# expect PAGE KIND LEAST: each name on standard input must stand in the page, and there must be so many.
expect() {
    names=$(sort -u)
    found=0
    for name in $names; do
        found=$((found + 1))
        grep -qF -e "\`$name\`" -e "\`$name " -e " $name\`" -e " $name " "resources/manual/$1" && continue
        echo "resources/manual/$1: does not have the $2 $name" >>"$missing"
    done
    if [ "$found" -lt "$3" ]; then
        echo "only $found of kind $2 found; the pattern here no longer fits" >>"$missing"
    fi
}

sed -n 's/^ *Parameter{"\([^"]*\)",.*/\1/p' core/model/parameter_table.cpp | expect files.md parameter 25
sed -n 's/^ *SectionField{"\([^"]*\)",.*/\1/p' core/model/section_field.cpp | expect files.md section 11
# "choose from all, cor, …": what a wrong one is answered with, whole and on one line.
"$program" sweep paper_fig4a --vary beta=1:2:2 --outputs none_such -o - 2>&1 | sed -n 's/.*; choose from all, //p' | tr -d ',' |
    tr ' ' '\n' | expect files.md output 36
sed -n '/alertNames{/,/};/p' core/model/alerts.cpp | grep -o '"[a-z_]*"' | tr -d '"' | expect files.md alert 13
"$program" run paper_fig4a --set pulse.shape=none_such 2>&1 | sed -n 's/.*must be one of \([a-z_, ]*\).*/\1/p' | tr -d ',' |
    tr ' ' '\n' | expect files.md shape 8
commands=$("$program" help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\)  .*/\1/p')
echo "$commands" | expect commands.md command 15
for command in $commands; do
    "$program" help "$command"
done | sed -n 's/^  \(--*[a-z-]*\) .*/\1/p' | expect commands.md option 25
cat "$missing"
[ ! -s "$missing" ] || exit 1
echo "all names stand in the manual"

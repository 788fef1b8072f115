#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Holds the manual to the program: check_names.sh ROOT
# Every parameter, number of a section, output, alert and shape of a blow must stand in files.md, and every command and option in commands.md,
# as `name`; found in the tables of the sources that define them.
set -u
export LC_ALL=C
root=${1:?check_names.sh ROOT}
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
        echo "only $found of kind $2 found in the sources; the pattern here no longer fits" >>"$missing"
    fi
}

sed -n 's/^ *Parameter{"\([^"]*\)",.*/\1/p' core/model/parameter.cpp | expect files.md parameter 25
sed -n 's/^ *SectionField{"\([^"]*\)",.*/\1/p' core/model/section_field.cpp | expect files.md section 11
sed -n 's/^ *{"\([a-z_]*\)", "[^"]*",* *\(Measure::.*\)*$/\1/p' core/blow/outputs.cpp | expect files.md output 21
sed -n '/alertNames{/,/};/p' core/model/alerts.cpp | grep -o '"[a-z_]*"' | tr -d '"' | expect files.md alert 13
sed -n '/shapeNames{/,/};/p' core/model/scenario.cpp | grep -o '"[a-z_]*"' | tr -d '"' | expect files.md shape 8
sed -n 's/^ *\.name = "\([a-z]*\)",.*/\1/p' app/*_command.cpp | expect commands.md command 10
# {"segments", "N", "of the …"} is --segments; -o and -j have one letter.
grep -ho '{"[a-z-]*", "[^"]*", "[^" ]* ' app/*.cpp app/*.h | sed 's/{"\([a-z-]*\)".*/\1/' |
    sed 's/^[xy]$/--&/; s/^.$/-&/; s/^[a-z][a-z-].*/--&/' | expect commands.md option 12
cat "$missing"
[ ! -s "$missing" ] || exit 1
echo "all names stand in the manual"

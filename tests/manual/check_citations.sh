#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Holds citations to the manual: check_citations.sh ROOT
#   theory §3, files §1.1, commands §4   a section must be a heading of resources/manual/<word>.md
#   [paper (14)]                         an equation of the paper must stand in theory.md with that number
#   (T14), (S2), (D1)                    an equation must stand in theory.md, in strings.md, in drilling.md
# in sources, tests and the manual itself. Other ways to cite these are refused: they would go unchecked.
set -u
export LC_ALL=C
root=${1:?check_citations.sh ROOT}
cd "$root" || exit 2
manual=resources/manual
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

pages="theory strings drilling files commands window glossary tutorial evidence"
for page in $pages; do
    if [ ! -s "$manual/$page.md" ]; then
        echo "$manual/$page.md: is missing"
        exit 1
    fi
done
for page in $pages; do
    # "§3.1" of "### §3.1 Everything else"
    sed -n "s/^##* \(§[0-9.]*\) .*/$page \1/p" "$manual/$page.md"
done | sed 's/\.$//' >"$work/there"
# Lines of equations end in their number, behind the paper's own where it has one.
sed -n '/  (T[0-9][0-9]*)$/p' "$manual/theory.md" >"$work/equations"
sed -n '/  (S[0-9][0-9]*)$/p' "$manual/strings.md" >>"$work/equations"
sed -n '/  (D[0-9][0-9]*)$/p' "$manual/drilling.md" >>"$work/equations"
grep -o '\[paper ([0-9]*)\]' "$work/equations" >>"$work/there"
sed 's/.*  \(([TSD][0-9]*)\)$/\1/' "$work/equations" >"$work/numbers"
cat "$work/numbers" >>"$work/there"
twice=$(sort "$work/numbers" | uniq -d)
if [ -n "$twice" ]; then
    echo "$manual: numbers two equations" $twice
    exit 1
fi

find core ui app tests resources/manual CONTRIBUTING.md -type f \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.in' -o -name '*.md' \) | sort >"$work/files"

# Prints "file:line: citation" for each citation that a pattern finds.
citations() {
    tr '\n' '\0' <"$work/files" | xargs -0 grep -Hno "$1" /dev/null
}
{
    citations '\(theory\|strings\|drilling\|files\|commands\|window\|glossary\|tutorial\|evidence\) §[0-9][0-9.]*' | sed 's/\.$//'
    citations '\[paper ([0-9]*)\]'
    citations '([TSD][0-9][0-9]*)'
} >"$work/cited"

awk -F: -v list="$work/there" '
    BEGIN { while ((getline line < list) > 0) there[line] = 1 }
    !($3 in there) { print $1 ":" $2 ": cites " $3 ", which does not stand in resources/manual"; wrong = 1 }
    END { exit wrong }' "$work/cited"
unknown=$?

other='contract §\|[Tt]heory, section\|[Pp]aper, eqs*\.* *(\|\[paper, \|eqs (\|eq\. ('
citations "$other" | grep -v '^tests/manual/' |
    sed 's/$/ …: cite as in `theory §3`, `files §1`, `commands §4`, `[paper (14)]`/' >"$work/other"
cat "$work/other"

count=$(wc -l <"$work/cited")
if [ "$count" -lt 100 ]; then
    echo "only $count citations found; are these the sources?"
    exit 1
fi
[ "$unknown" = 0 ] && [ ! -s "$work/other" ] || exit 1
echo "$count citations stand in the manual"

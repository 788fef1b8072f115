#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Commands and files in README, CONTRIBUTING and the manual must be there: check_commands.sh ROOT
#   drillwave COMMAND         a command of app/*_command.cpp or core/report/*_answer.cpp, or an option, or a file
#   tst_…, bench_…            a test program or benchmark
#   packaging/…, resources/…, tests/…, core/…, ui/…, app/…   a file or folder of the sources
#   build/release/…           what the build makes of a source of that name
set -u
export LC_ALL=C
root=${1:?check_commands.sh ROOT}
cd "$root" || exit 2
pages="README.md CONTRIBUTING.md $(echo resources/manual/*.md)"
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

sed -n 's/^ *\.name = "\([a-z]*\)",.*/\1/p' app/*_command.cpp core/report/*_answer.cpp | sort -u >"$work/commands"
printf 'help\nversion\n' >>"$work/commands"
find tests -name 'tst_*.cpp' -o -name 'bench_*.cpp' -o -name screenshots.cpp | sed 's:.*/::; s:\.cpp$::' | sort -u >"$work/programs"

# Code alone: blocks and what stands between backquotes, "page: code".
for page in $pages; do
    awk -v page="$page" '
        /^```/ { block = !block; next }
        block || /^    / { print page ": " $0; next }
        { n = split($0, part, "`"); for (i = 2; i <= n; i += 2) print page ": " part[i] }' "$page"
done >"$work/code"

missing() { echo "$1: names $2, which is not there"; }
{
    # The word behind `drillwave` where it begins a command: `drillwave run`, `$ drillwave run`, `.../drillwave run`.
    sed -n 's/^\([^:]*\):\(.*[ /$]\)*drillwave \([a-z][a-z]*\).*/\1 \3/p' "$work/code" | grep -v '^[^ ]* -' |
        while read -r page command; do grep -qx "$command" "$work/commands" || missing "$page" "drillwave $command"; done
    grep -o '^[^:]*:\|\(tst\|bench\)_[a-z_0-9]*' "$work/code" >"$work/words"
    awk '/:$/ { page = substr($0, 1, length($0) - 1); next } { print page, $0 }' "$work/words" | sort -u |
        while read -r page program; do
            grep -qx "$program" "$work/programs" || [ "$program" = tst_ ] || missing "$page" "$program"
        done
    grep -o '^[^:]*:\|\(^\|[^a-z/._~-]\)\(packaging\|resources\|tests\|core\|ui\|app\)/[A-Za-z0-9_./-]*' "$work/code" |
        awk '/:$/ && !/[^a-zA-Z.\/_:]/ { page = substr($0, 1, length($0) - 1); next } { sub(/^[^a-z]/, ""); print page, $0 }' | sort -u |
        while read -r page path; do
            path=${path%.}
            [ -e "$path" ] || [ -e "$path.h" ] || [ -e "$path.cpp" ] || case $path in *NAME* | */X*) ;; *) missing "$page" "$path" ;; esac
        done
} >"$work/missing"
cat "$work/missing"
[ ! -s "$work/missing" ] || exit 1
echo "what people are told to type is there: $(wc -l <"$work/code") pieces of code"

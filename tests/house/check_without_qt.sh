#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks what a build does where Qt is absent: check_without_qt.sh SOURCE_FOLDER [PROGRAM]
# - with its window it ends, and names the option that does without;
# - without, it is configured; with PROGRAM it is built too, runs, and gives the same bytes as PROGRAM.
set -euo pipefail
source_folder=$(readlink -f "$1")
program=${2:+$(readlink -f "$2")}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export QT_QPA_PLATFORM=offscreen

without_qt() {
    cmake -S "$source_folder" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_QCustomPlotQt6=ON "$@"
}
fail() { echo "$1" && exit 1; }

if without_qt >"$work/window.txt" 2>&1; then fail "a window was configured without Qt"; fi
grep -q 'DRILLWAVE_GUI=OFF' "$work/window.txt" || fail "the option is not named: $(cat "$work/window.txt")"
without_qt -DDRILLWAVE_GUI=OFF >"$work/commands.txt" 2>&1 || fail "$(cat "$work/commands.txt")"
[ -n "$program" ] || exit 0

cmake --build "$work/build" --target drillwave >"$work/built.txt" || fail "$(tail -n 40 "$work/built.txt")"
bare=$work/build/app/drillwave
! ldd "$bare" | grep -i qt || fail "Qt is linked"

same() {
    "$program" "$@" | sed -E 's/("run_time":) [^,]*/\1/' >"$work/with.txt"
    "$bare" "$@" | sed -E 's/("run_time":) [^,]*/\1/' >"$work/without.txt"
    diff "$work/with.txt" "$work/without.txt" || fail "other bytes without Qt: $*"
}
for name in $("$bare" examples | awk '{ print $1 }'); do same run "$name" --json; done
same sweep reference_case --vary gamma=0.05:1:8 --outputs all
same help
same report reference_case --no-plots -o -
code=0
said=$("$bare" run reference_case -o "$work/out" --plots png 2>&1) || code=$?
[ "$code" = 2 ] && [[ $said == *DRILLWAVE_GUI* ]] || fail "pictures without Qt: exit $code, $said"
[ ! -e "$work/out" ] || fail "a folder without its pictures was left behind"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tries what can go wrong around the program: faults.sh [OPTION]… [ROW[=COUNT]]…
#   --program FILE   the program that is tried (default: build/release/app/drillwave)
#   --by-hand        every row as often as by hand, which takes some hours
#   --seed N         other cases and times
#   --case "CASE"    one case again, as printed where it does not hold
#   --list           the rows, how often each is done here and by hand, and what must hold
# All rows without one. Works in a folder of its own, which goes at the end. Needs no rights; where namespaces of users are
# permitted it mounts small disks of its own, elsewhere what needs them is left out, and said so. Exit code 1 where something
# does not hold, each such thing in a line.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

# name, cases in ctest, cases by hand, what must hold
rows=(
    "disk     12  1000 a full disk, device or limit of a file: exit code 4 and a line, nothing half written, old files as they were"
    "places    8  1000 no right to write, no home, no folder for what is temporary, no fonts: the same files, or exit code 4 and a line"
    "limits    8  2000 too few threads or too little memory: the same files or a line, nothing half written"
    "clock     1    40 the clock jumps forwards and back: the same rows, a sensible bar, recovery as ever"
    "signals  16 10000 SIGINT, SIGTERM, SIGHUP, SIGKILL at random times: 130, and nothing left behind; all is done by the next run"
    "opening   4   200 SIGINT while the library that draws has a folder among what is temporary: 130, and nothing left behind"
    "kills     8  1000 SIGKILL while files are put in place: the old ones or the new ones, which the next run completes"
    "company   8  1000 two runs to one name, readers that leave early: one set whole, no noise"
    "names    20  1000 closed streams, odd names, folders, pipes, links in a circle: a line, or done as asked"
)

program=$root/build/release/app/drillwave
by_hand=0
seed=1
only=
chosen=()
refuse() { echo "faults.sh: $1" >&2 && exit 2; }
while [ $# -gt 0 ]; do
    case $1 in
        --program) program=${2:?--program FILE} && shift ;;
        --seed) seed=${2:?--seed N} && shift ;;
        --case) only=${2:?--case "CASE"} && shift ;;
        --by-hand) by_hand=1 ;;
        --list) printf '%s\n' "${rows[@]}" && exit 0 ;;
        --help) sed -n '3,/^set/{/^set/d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" && exit 0 ;;
        -*) refuse "no option $1; see --help" ;;
        *) chosen+=("$1") ;;
    esac
    shift
done
program=$(readlink -f "$program")
[ -x "$program" ] || refuse "$program is no program; build it or name one by --program"

# Once more in a namespace of its own, in which small disks can be mounted and which they vanish with.
if [ -z "${FAULTS_INSIDE:-}" ] && unshare -rm true 2>/dev/null; then
    options=(--program "$program" --seed "$seed" ${only:+--case "$only"})
    [ $by_hand = 0 ] || options+=(--by-hand)
    FAULTS_INSIDE=1 exec unshare -rm "${BASH_SOURCE[0]}" "${options[@]}" "${chosen[@]}"
fi

. "$here/commands.sh"
. "$here/disk_rows.sh"
. "$here/process_rows.sh"
. "$here/name_rows.sh"

# The fields of a row, or nothing.
row_of() {
    local row
    for row in "${rows[@]}"; do [ "${row%% *}" != "$1" ] || echo "$row"; done
}
[ ${#chosen[@]} -gt 0 ] || chosen=("${rows[@]%% *}")
for word in "${chosen[@]}"; do [ -n "$(row_of "${word%%=*}")" ] || refuse "no row ${word%%=*}; see --list"; done

# take_cases N: so many of those that the row lists, all of them before any a second time.
take_cases() {
    local cases=() i at
    mapfile -t all_cases < <("list_$row")
    for ((i = 0; i < $1; ++i)); do
        [ ${#cases[@]} -gt 0 ] || cases=("${all_cases[@]}")
        at=$((RANDOM % ${#cases[@]}))
        case=${cases[at]}
        cases=("${cases[@]:0:at}" "${cases[@]:at+1}")
        # shellcheck disable=SC2086
        try_$case
    done
}

make_references
if [ -n "$only" ]; then
    row=only case=$only
    # shellcheck disable=SC2086
    try_$only
    exit $((faults > 0))
fi
for word in "${chosen[@]}"; do
    read -r row here_count hand_count _ <<<"$(row_of "${word%%=*}")"
    count=$here_count
    [ $by_hand = 0 ] || count=$hand_count
    [ "$word" = "$row" ] || count=${word#*=}
    began=$(milliseconds) faults_before=$faults tried=0
    take_cases "$count"
    sort -u "$work/left_out" 2>/dev/null && rm -f "$work/left_out"
    printf '%-8s %6d cases, the program run %d times in %d s: %d do not hold\n' \
        "$row" "$count" $tried $((($(milliseconds) - began) / 1000)) $((faults - faults_before))
done
[ $faults = 0 ]

# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of faults.sh: full disks, places that cannot be written to or are not there, the clock.

# leave_out WHAT: printed once at the end of the row.
leave_out() { echo "$row: left out: $1" >>"$work/left_out"; }
can_mount() {
    [ -n "${FAULTS_INSIDE:-}" ] || { leave_out "what needs a disk of its own: no namespaces of users here" && false; }
}
mount_disk() {
    mkdir -p "$work/disk"
    mount -t tmpfs -o "size=$1" faults "$work/disk"
    place=$work/disk/place
}
unmount_disk() {
    umount "$work/disk"
    place=$work/place
}

list_disk() {
    local command before room
    for command in "${quick[@]}" report run_drawn; do
        for before in none old; do
            echo "no_bytes $command $before"
            for room in 0 4 8 16; do echo "full_disk $command $before $room"; done
        done
    done
    for command in sweep curve map table join gap thrust scan; do echo "full_device $command"; done
    for ((i = 0; i < ${#printing[@]}; ++i)); do echo "full_output $i"; done
}

limited_to_no_bytes() { (ulimit -f 0 && exec "$@"); }
try_no_bytes() {
    begin "$1" "$2"
    words_of "$1" new "$place" && words+=(--force)
    to=/dev/null attempt limited_to_no_bytes
    expect_all_or_nothing "$1" "$2" 4
    expect "is done on a full disk" ended_with 4
}

# COMMAND none|old KILOBYTES: on a disk with so much left.
try_full_disk() {
    can_mount || return
    mount_disk 8m
    begin "$1" "$2"
    head -c 16m /dev/zero >"$work/disk/filler" 2>/dev/null
    truncate -s "-$(($3 * 1024))" "$work/disk/filler"
    words_of "$1" new "$place" && words+=(--force)
    attempt
    expect_all_or_nothing "$1" "$2" 4
    [ "$3" != 0 ] || expect "is done on a full disk" ended_with 4
    unmount_disk
}

try_full_device() {
    words_of "$1" new "$place"
    write_to /dev/full
    attempt
    expect "is done" ended_with 4 && expect "does not say why in a line" says_a_line
}

# The number of a line of `printing`.
try_full_output() {
    words_in "${printing[$1]}"
    to=/dev/full attempt
    expect "is done" ended_with 4 && expect "does not say why in a line" says_a_line
}

# Surroundings of a program in a session that are missing: nothing that commands need.
surroundings=(
    "env -u HOME" "env HOME=/nonexistent" "env HOME=/proc" "env TMPDIR=/nonexistent" "env TMPDIR=/proc"
    "env XDG_RUNTIME_DIR=/nonexistent" "env XDG_CONFIG_HOME=/proc/x XDG_DATA_HOME=/proc/x XDG_CACHE_HOME=/proc/x XDG_STATE_HOME=/proc/x"
    "env FONTCONFIG_FILE=$inputs/no_fonts.conf FONTCONFIG_PATH=/nonexistent" "env -i QT_QPA_PLATFORM=offscreen SOURCE_DATE_EPOCH=1700000000"
    "env LC_ALL=xx_YY" "env LANG=de_DE.UTF-8 LC_ALL="
)

list_places() {
    local command before i
    for command in "${quick[@]}" report; do
        for before in none old; do echo "no_right $command $before" && echo "locked_disk $command $before"; done
    done
    for ((i = 0; i < ${#surroundings[@]}; ++i)); do
        for command in run map_drawn report; do echo "surroundings $command $i"; done
        echo "window $i"
    done
}

# Without the rights that root has over files of all.
without_rights() { setpriv --bounding-set=-all --inh-caps=-all -- "$@"; }
try_no_right() {
    begin "$1" "$2"
    chmod -R a-w "$place"
    words_of "$1" new "$place" && words+=(--force)
    attempt without_rights
    expect_all_or_nothing "$1" "$2" 4
    expect "is done" ended_with 4
}

try_locked_disk() {
    can_mount || return
    mount_disk 32m
    begin "$1" "$2"
    mount -o remount,ro "$work/disk"
    words_of "$1" new "$place" && words+=(--force)
    attempt
    expect_all_or_nothing "$1" "$2" 4
    expect "is done" ended_with 4
    expect "does not name the disk" grep -q "Read-only file system" "$work/err"
    unmount_disk
}

try_surroundings() {
    local around=${surroundings[$2]}
    begin "$1" none
    words_of "$1" new "$place"
    # shellcheck disable=SC2086
    attempt $around
    if [[ $around == *FONTCONFIG* && $1 != run ]]; then
        expect "is done without fonts" ended_with 4 && expect "does not say why in a line" says_a_line
        return
    fi
    expect "is not done with $around" ended_with 0
    expect "is done with words on stderr with $around" says_nothing
    expect "is done, but other files are there with $around" is_set "$1" new
}

# The window stays until it is ended.
try_window() {
    [ -x "${program}-window" ] || { leave_out "the window: there is no drillwave-window beside the program" && return; }
    words=("$inputs/new.yaml")
    # shellcheck disable=SC2086
    attempt timeout -s KILL 2 ${surroundings[$1]}
    expect "does not stay with ${surroundings[$1]}" ended_with 137
}

list_clock() { printf '%s\n' "jump -3600d" "jump +3600d" "recovery -365d" "recovery +365d"; }

# A time that is looked up again at each look at the clock; clocks for durations go on as they do.
faketime=$(echo /usr/lib/*/faketime/libfaketimeMT.so.1)
with_clock() { env FAKETIME_TIMESTAMP_FILE="$work/time" FAKETIME_NO_CACHE=1 FAKETIME_DONT_FAKE_MONOTONIC=1 LD_PRELOAD="$faketime" "$@"; }
can_set_clock() { [ -e "$faketime" ] || { leave_out "there is no libfaketime (package faketime)" && false; }; }

# A sweep with its bar, which a terminal gets.
try_jump() {
    can_set_clock || return
    local pid
    begin sweep none
    words=(sweep "$inputs/new.yaml" --vary beta=0.5:1:200 --vary delta=0:2:40 -j 1)
    [ -e "$work/rows" ] || "$program" "${words[@]}" -o - >"$work/rows"
    echo +0 >"$work/time"
    with_clock script -qec "$(printf '%q ' "$program" "${words[@]}" -o "$place/out.csv")" "$work/err" >/dev/null </dev/null &
    pid=$!
    wait_milliseconds $((300 + RANDOM % 700))
    echo "$1" >"$work/time"
    wait $pid
    code=$? tried=$((tried + 1))
    expect "is not done" ended_with 0
    expect "is done, but other rows are there" cmp -s "$work/rows" "$place/out.csv"
    expect "shows a bar that makes no sense" shows_no_nonsense
}
shows_no_nonsense() { ! sed '1d;$d' "$work/err" | grep -aqE -- '-[0-9]|[0-9]{5,} (s|min|h)|nan|inf'; }

# Runs the tests of recovery with a clock that is a year behind all files, or before them.
try_recovery() {
    can_set_clock || return
    local test
    test=$(dirname "$(dirname "$program")")/tests/ui/tst_recovery
    [ -x "$test" ] || { leave_out "recovery: $test is not built" && return; }
    words=()
    echo "$1" >"$work/time"
    with_clock "$test" >"$work/err" 2>&1
    code=$? tried=$((tried + 1))
    expect "fails" ended_with 0
}

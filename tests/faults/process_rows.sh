# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of faults.sh: threads and memory that there are not enough of, signals, runs beside each other.

few_processes() { prlimit --nproc=1 "$@"; }
with_memory() { (ulimit -v "$kilobytes" && exec "$@"); }

list_limits() {
    local command
    for command in "${quick[@]}" map_drawn report; do echo "no_threads $command" && echo "memory $command"; done
}

try_no_threads() {
    [ "$(awk '{ print $2 }' /proc/self/uid_map)" != 0 ] || { leave_out "no_threads: nobody counts the threads of root" && return; }
    begin "$1" none
    words_of "$1" new "$place"
    attempt few_processes
    expect_all_or_nothing "$1" none 1
}

try_memory() {
    local least=12000 most=100000
    words=(version) kilobytes=2000000
    attempt with_memory
    [ "$code" = 0 ] || { leave_out "memory: this build needs more addresses than can be limited" && return; }
    case $1 in map_drawn | report) least=60000 most=500000 ;; esac
    kilobytes=$((least + (RANDOM * 32768 + RANDOM) % (most - least)))
    begin "$1" old
    words_of "$1" new "$place" && words+=(--force)
    attempt with_memory
    # The loader of the system ends with 127 where not even the program finds room.
    case="$case, $kilobytes kB" expect_all_or_nothing "$1" old 1 127
}

# in_background: runs the program with `words`; its `pid`.
in_background() {
    "$program" "${words[@]}" >/dev/null 2>"$work/err" &
    pid=$!
    tried=$((tried + 1))
}
reap() {
    wait "$pid" 2>/dev/null
    code=$?
}

# Files that are seen belong to one set, though perhaps not all are there.
is_one_set() {
    local set
    [ -e "$place/notes.txt" ] || return 1
    for set in old new; do
        diff -rq -I '"run_time"' -x '.drillwave*' "$work/reference/$1.$set" "$place" 2>&1 |
            grep -qv "^Only in $work/reference" || return 0
    done
    return 1
}

list_signals() {
    local command signal before
    for command in "${quick[@]}" "${drawing[@]}"; do
        for signal in INT TERM HUP KILL; do
            for before in none old; do echo "signal $command $before $signal"; done
        done
    done
}

# Whether the program has begun to listen to that signal: before it is loaded the shell does.
listens_to() {
    local caught
    [[ $(readlink "/proc/$pid/exe") == "$program"* ]] || return
    caught=$(awk '/^SigCgt/ { print $2 }' "/proc/$pid/status" 2>/dev/null)
    [ -n "$caught" ] && ((16#$caught & 1 << $(kill -l "$1") - 1))
}

try_signal() {
    local command=$1 before=$2 signal=$3 case=$case listens=no
    delay=$((RANDOM % (lasts[$command] + 10)))
    case="$case after $delay ms"
    begin "$command" "$before"
    words_of "$command" new "$place" && words+=(--force)
    in_background
    wait_milliseconds $delay
    ! listens_to "$signal" || listens=yes
    kill -"$signal" $pid 2>/dev/null
    reap
    if [ "$signal" = KILL ]; then
        expect "files of two runs are there" is_one_set "$command"
        rm -rf "${TMPDIR:?}"/*
        attempt
        expect "the next run is not done" ended_with 0
        expect "the next run leaves something else" is_set "$command" new
    elif ended_with 129 130 143 && says_nothing; then
        # Hardly more than loaded, nothing of the program was there yet to hear it: on a busy machine for long.
        expect "does not hear a signal" test $listens = no -a $delay -lt $((20 + lasts[$command] * 3 / 4))
        expect "is not done, but files have changed" is_set "$command" "$before"
    else
        expect_all_or_nothing "$command" "$before" 130
    fi
}

list_opening() { printf 'opening %s\n' "${drawing[@]}"; }

try_opening() {
    local command=$1
    begin "$command" none
    words_of "$command" new "$place"
    in_background
    until compgen -G "$TMPDIR/runtime-*" >/dev/null; do kill -0 $pid 2>/dev/null || break; done
    compgen -G "$TMPDIR/runtime-*" >/dev/null || leave_out "opening: the library that draws makes no folder here"
    kill -INT $pid 2>/dev/null
    reap
    expect_all_or_nothing "$command" none 130
}

list_kills() { printf '%s\n' "kill run any" "kill run amid" "kill sweep any" "kill sweep amid"; }

# COMMAND any|amid: at any time, or when files are about to be put in place.
try_kill() {
    local command=$1 set=old other=new pause
    begin "$command" old
    [ $((RANDOM % 2)) = 0 ] || set=new other=old
    words_of "$command" "$set" "$place" && words+=(--force)
    in_background
    if [ "$2" = any ]; then
        wait_milliseconds $((RANDOM % (lasts[$command] + 10)))
    else
        until is_writing; do kill -0 $pid 2>/dev/null || break; done
        for ((pause = RANDOM % 400; pause > 0; --pause)); do :; done
    fi
    kill -KILL $pid 2>/dev/null
    reap
    ! is_writing || amid=$((amid + 1))
    expect "files of two runs are there" is_one_set "$command"
    words_of "$command" "$other" "$place"
    attempt
    expect "the next run does not refuse what is there" ended_with 4
    expect "the next run brings back no whole set" is_either "$command"
}
amid=0
is_writing() { compgen -G "$place/.drillwave-*" >/dev/null || compgen -G "$place/out/.drillwave-*" >/dev/null; }
is_either() { is_set "$1" old >/dev/null || is_set "$1" new; }

list_company() {
    local command force i
    for command in "${quick[@]}" report; do echo "two_runs $command" && echo "two_runs $command --force"; done
    for ((i = 0; i < ${#printing[@]}; ++i)); do echo "reader $i" && echo "reader_told $i"; done
}

try_two_runs() {
    local codes
    begin "$1" none
    words_of "$1" old "$place" && words+=("${@:2}")
    in_background
    words_of "$1" new "$place" && words+=("${@:2}")
    attempt
    codes=$code
    reap
    codes=$(printf '%s\n' "$codes" $code | sort | tr -d '\n')
    if [ $# -gt 1 ]; then
        expect "not both are done ($codes)" test "$codes" = 00
    else
        expect "not one is done and one refused ($codes)" test "$codes" = 04
    fi
    expect "other files are there than those of one" is_either "$1"
}

# Whoever reads what is printed leaves early.
try_reader() {
    words_in "${printing[$1]}"
    env --default-signal=PIPE "$program" "${words[@]}" 2>"$work/err" | head -c 1 >/dev/null
    code=${PIPESTATUS[0]} tried=$((tried + 1))
    expect "ends otherwise than by it" ended_with 0 141 && expect "makes noise" says_nothing
}

# Where that ends nobody, it is reported as any other output that cannot be written.
try_reader_told() {
    words_in "${printing[$1]}"
    env --ignore-signal=PIPE "$program" "${words[@]}" 2>"$work/err" | true
    code=${PIPESTATUS[0]} tried=$((tried + 1))
    [ "$code" = 0 ] || { expect "ends otherwise" ended_with 4 && expect "does not say why in a line" says_a_line; }
}

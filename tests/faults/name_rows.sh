# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Row of faults.sh: closed streams, and names of files that are odd, or none of files.

without_input() { "$@" <&-; }
without_output() { "$@" >&-; }
without_words() { "$@" 2>&-; }
without_streams() { "$@" <&- >&- 2>&-; }

long=$(printf 'x%.0s' {1..240})
odd_names=("two words" $'two\nlines' "ü" $'\xff\xfe' '*?[' "it's" '"' '\' $'\e[31m' "a:b" "a=b,c" ".hidden" "$long" "$long$long"
    "$(printf "$long/%.0s" {1..30})x" "%s%n" "~" '$HOME' "#" "")

# Names of no file, or of none that can be read.
no_files=(folder loop dangling dangling_deep pipe empty noise empty/x /dev/null /proc/self/mem nameless .)
make_no_files() {
    mkdir "$place/folder"
    ln -s loop2 "$place/loop" && ln -s loop "$place/loop2"
    ln -s missing "$place/dangling"
    ln -s missing/deep "$place/dangling_deep"
    mkfifo "$place/pipe"
    : >"$place/empty"
    head -c 100000 /dev/urandom >"$place/noise"
}
no_file_named() {
    case $1 in /*) echo "$1" ;; nameless) ;; *) echo "$place/$1" ;; esac
}
readings=("run FILE" "validate FILE" "presets FILE" "run SCENARIO --presets FILE --rock x" "table SCENARIO FILE" "join FILE PART1 -o -"
    "design SCENARIO --draws FILE --samples 64" "sweep FILE --vary delta=0:2:5")

list_names() {
    local command closed name i
    for ((i = 0; i < ${#printing[@]}; ++i)); do
        for closed in input output streams; do echo "printing_without $i $closed"; done
    done
    for command in "${quick[@]}"; do
        for closed in input words streams; do echo "writing_without $command $closed"; done
        for name in folder loop dangling dangling_deep empty empty/x /dev/null nameless .; do echo "no_output $command $name"; done
    done
    for ((i = 0; i < ${#odd_names[@]}; ++i)); do echo "odd_output $i" && echo "odd_input $i"; done
    for name in "${no_files[@]}"; do
        for ((i = 0; i < ${#readings[@]}; ++i)); do echo "no_input $i $name"; done
    done
    echo dash
}

try_printing_without() {
    words_in "${printing[$1]}"
    attempt "without_$2"
    case $2 in
        input) expect "is not done" ended_with 0 ;;
        output) expect "is done" ended_with 4 && expect "does not say why in a line" says_a_line ;;
        streams) expect "is done" ended_with 4 ;;
    esac
}

try_writing_without() {
    begin "$1" none
    words_of "$1" new "$place"
    attempt "without_$2"
    if [ "$code" = 0 ]; then
        expect "is done, but other files are there" is_set "$1" new
    else
        expect "ends otherwise" ended_with 4 && expect "leaves something" is_set "$1" none
    fi
}

try_odd_output() {
    local name=$place/${odd_names[$1]}.csv
    [ -n "${odd_names[$1]}" ] || name=
    begin sweep none
    words_of sweep new "$place"
    write_to "$name"
    attempt
    if [ "$code" = 0 ]; then
        expect "writes other rows" cmp -s "$name" "$work/reference/sweep.new/out.csv"
    else
        expect "ends otherwise" ended_with 2 4 && expect "does not say why in a line" says_a_line
        expect "leaves something" is_set sweep none
    fi
}

try_odd_input() {
    local name=$place/${odd_names[$1]}.yaml
    [ -n "${odd_names[$1]}" ] || name=
    begin sweep none
    cp "$inputs/new.yaml" "$name" 2>/dev/null
    words=(run "$name" --json)
    attempt
    if [ "$code" = 0 ]; then
        expect "says something else" says_nothing
    else
        expect "refuses a file that is there" test ! -e "$name"
        expect "ends otherwise" ended_with 2 3 && expect "does not say why in a line" says_a_line
    fi
}

try_dash() {
    begin run none
    cp "$inputs/new.yaml" "$place/-new.yaml"
    words=(run -o ./-out -- -new.yaml)
    attempt env -C "$place"
    expect "is not done" ended_with 0
    expect "has not written" test -e "$place/-out/summary.json"
}

try_no_input() {
    local file
    begin sweep none
    make_no_files
    file=$(no_file_named "$2")
    words_in "${readings[$1]}"
    words=("${words[@]/#FILE/$file}")
    # Somebody who opens the pipe and writes nothing.
    [ "$2" != pipe ] || { : >"$place/pipe" & }
    to=/dev/null attempt timeout 20
    expect "ends otherwise" ended_with 2 3 5 && expect "does not say why" says_lines
    [ "$2" != pipe ] || { kill $! && wait $!; } 2>/dev/null
}

try_no_output() {
    begin "$1" none
    make_no_files
    rm "$place/noise"
    find "$place" | sort >"$work/listed"
    words_of "$1" new "$place"
    write_to "$(no_file_named "$2")"
    attempt
    expect "ends otherwise" ended_with 0 2 4
    [ "$code" = 0 ] || { expect "does not say why in a line" says_a_line && expect "leaves something" is_listed; }
}
is_listed() { find "$place" | sort | cmp -s "$work/listed"; }

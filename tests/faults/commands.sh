# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The commands that faults.sh tries, what they write when all goes well, and what is held against that. Each command writes two
# sets of files, `old` and `new`, so that a test can see which one is there.

quick=(run sweep curve map table join gap thrust drill scan design examples)
drawing=(run_drawn map_drawn report figures)
printing=("run SCENARIO" "sweep SCENARIO --vary gamma=0.05:1:200 -o -" "curve SCENARIO --along gamma=0.05:1" "gap SCENARIO -o -"
    "map SCENARIO --x gamma=0.05:1:9 --y delta=0:2:9 -o -" "table SCENARIO CASES" "thrust SCENARIO" "examples"
    "examples r32_hard_rock -o -" "presets" "accuracy SCENARIO --segments 100 -o -" "help theory" "help run" "version" "--help"
    "design SCENARIO --uncertain bit_rock.gamma=0.05:0.3 --samples 64" "join PART1 PART2 -o -" "report SCENARIO -o -"
    "drill SCENARIO --blows 30 --settle 10 --cells 10 -o -" "figures -o -")

work=$(mktemp -d) || exit 2
trap 'chmod -R u+w "$work" 2>/dev/null; umount -l "$work"/disk 2>/dev/null; rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
inputs=$work/inputs
place=$work/place
faults=0
tried=0
RANDOM=$seed
export QT_QPA_PLATFORM=offscreen SOURCE_DATE_EPOCH=1700000000 TMPDIR=$work/tmp LC_ALL=C.UTF-8 HOME=$work/home
unset XDG_RUNTIME_DIR XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME
mkdir "$inputs" "$TMPDIR" "$HOME"
echo '<fontconfig/>' >"$inputs/no_fonts.conf"
mkfifo "$work/never" && exec {never}<>"$work/never"

milliseconds() { local now=$EPOCHREALTIME && echo $((${now/[.,]/} / 1000)); }
wait_milliseconds() { IFS= read -rt "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))" -u "$never" _; }

# words_of COMMAND SET FOLDER: the words by which it writes that set there, into `words`.
words_of() {
    local from=$inputs/$2.yaml to=$3
    local -A formats=([old]=svg [new]=png)
    local marched=(--blows 30 --settle 10 --cells 10)
    case $1 in
        run) words=(run "$from" -o "$to/out") ;;
        run_drawn) words=(run "$from" --plots "${formats[$2]},pdf" -o "$to/out") ;;
        sweep) words=(sweep "$from" --vary delta=0:2:5 --outputs all -o "$to/out.csv") ;;
        curve) words=(curve "$from" --along beta=0.5:1 -o "$to/out.csv") ;;
        map) words=(map "$from" --x beta=0.5:2:4 --y delta=0:2:4 --level 0 -o "$to/out.csv") ;;
        map_drawn) words=(map "$from" --x beta=0.5:2:4 --y delta=0:2:4 --level 0 --plots "${formats[$2]}" -o "$to/out.csv") ;;
        table) words=(table "$from" "$inputs/cases.csv" -o "$to/out.csv") ;;
        join) words=(join "$inputs/$2.1.csv" "$inputs/$2.2.csv" -o "$to/out.csv") ;;
        gap) words=(gap "$from" -o "$to/out.csv") ;;
        thrust) words=(thrust "$from" --along beta=0.5:2:4 -o "$to/out.csv") ;;
        drill) words=(drill "$from" "${marched[@]}" -o "$to/out") ;;
        scan) words=(drill "$from" "${marched[@]}" --scan drill.thrust=3kN,6kN -o "$to/out.csv" --gaps "$to/gaps.csv") ;;
        design) words=(design "$from" --uncertain bit_rock.gap=0mm:1mm --choose pulse.duration=120us,160us --samples 64 -o "$to/out") ;;
        report) words=(report "$from" -o "$to/out/") ;;
        examples) words=(examples -o "$to/out") ;;
        figures) words=(figures --plots "${formats[$2]}" -o "$to/out") ;;
    esac
}

# words_in LINE: a line of `printing` as `words`.
words_in() {
    read -ra words <<<"$1"
    local i
    for i in "${!words[@]}"; do
        case ${words[i]} in
            SCENARIO) words[i]=$inputs/new.yaml ;;
            CASES) words[i]=$inputs/cases.csv ;;
            PART?) words[i]=$inputs/new.${words[i]#PART}.csv ;;
        esac
    done
}

# write_to FILE: what `words` name as their output, alone: nothing stands beside a device.
write_to() {
    local given=("${words[@]}")
    words=()
    while [ ${#given[@]} -gt 0 ]; do
        case ${given[0]} in
            -o) words+=(-o "$1") && given=("${given[@]:2}") ;;
            --gaps | --level) given=("${given[@]:2}") ;;
            *) words+=("${given[0]}") && given=("${given[@]:1}") ;;
        esac
    done
}

# attempt [WRAPPER…]: runs the program with `words`, by the wrapper where there is one; `code`, and its messages in the file
# err, by a pipe that no limit of files touches. The output goes to `to`.
to=$work/out
attempt() {
    "$@" "$program" "${words[@]}" 2>&1 >"$to" | cat >"$work/err"
    code=${PIPESTATUS[0]}
    tried=$((tried + 1))
}

# expect WHAT TEST…: tells, where the test fails, of `case`.
expect() {
    local what=$1 && shift
    "$@" && return
    faults=$((faults + 1))
    echo "$row: $case: $what (exit code $code)"
    printf '  %s\n' "${words[*]}"
    head -c 600 "$work/err" | head -n 4 | sed 's/^/  | /'
    return 1
}

# Does not count the progress that long work on a busy machine prints every 15 seconds, as in the log of a job.
words_said() { grep -v '^[0-9]* % done ' "$work/err"; }
says_a_line() { [ "$(words_said | wc -l)" -eq 1 ]; }
says_lines() { [ -n "$(words_said)" ]; }
says_nothing() { [ -z "$(words_said)" ]; }
ended_with() { [[ " $* " == *" $code "* ]]; }
# Times are what no two runs share; hidden files count.
same() { diff -rq -I '"run_time"' "$1" "$2" >"$work/difference" 2>&1 || { sed 's/^/  > /' "$work/difference" | head -n 3 && false; }; }
is_set() { same "$work/reference/$1.$2" "$place"; }
leaves_no_temporary() { [ -z "$(ls -A "$TMPDIR")" ]; }

# begin COMMAND none|old: the place before it, with a file of somebody else.
begin() {
    [ ! -d "$place" ] || chmod -R u+w "$place"
    rm -rf "$place" "${TMPDIR:?}"/*
    cp -a "$work/reference/$1.$2" "$place"
}

# Done as when nothing is wrong, or ended with one of the codes, in a line, with the place as it was.
expect_all_or_nothing() {
    local command=$1 before=$2 && shift 2
    if [ "$code" = 0 ]; then
        expect "is done, but other files are there" is_set "$command" new
        expect "is done with words on stderr" says_nothing
    else
        expect "is not done, but files have changed" is_set "$command" "$before"
        expect "ends with another code than $*" ended_with "$@" && expect "does not say why in a line" says_a_line
    fi
    expect "leaves something in the folder for what is temporary" leaves_no_temporary || rm -rf "${TMPDIR:?}"/*
}

make_references() {
    local command set part row=references
    for set in old new; do
        "$program" examples r32_hard_rock -o - | sed "s/^title: .*/title: $set/" >"$inputs/$set.yaml"
        [ $set = old ] || sed -i 's/gamma: 0.3/gamma: 0.6/' "$inputs/$set.yaml"
        for part in 1 2; do
            "$program" sweep "$inputs/$set.yaml" --vary delta=0:2:6 --shard $part/2 -o "$inputs/$set.$part.csv" || exit 2
        done
    done
    printf 'beta,delta\n0.5,0\n1,1\n2,0\n' >"$inputs/cases.csv"
    for command in "${quick[@]}" "${drawing[@]}"; do
        mkdir -p "$work/reference/$command.none"
        echo mine >"$work/reference/$command.none/notes.txt"
        for set in old new; do
            cp -a "$work/reference/$command.none" "$work/reference/$command.$set"
            words_of "$command" $set "$work/reference/$command.$set"
            began=$(milliseconds)
            case=$command
            attempt
            expect "is not done when nothing is wrong" ended_with 0 || exit 1
            lasts[$command]=$(($(milliseconds) - began))
        done
    done
}
declare -A lasts  # milliseconds of a command

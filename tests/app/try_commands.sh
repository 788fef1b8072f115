#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every command on a rod and a string, in each language, and some that are refused: try_commands.sh PROGRAM
# Each ends in the code that it should, in a program that watches itself, as sanitizers make it, too.
set -uo pipefail
program=$(readlink -f "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
tried=0
failed=0

# expect CODE WORD…: the command ends in that exit code.
expect() {
    local wanted=$1 code=0
    shift
    tried=$((tried + 1))
    "$program" "$@" >out.txt 2>err.txt </dev/null || code=$?
    [ "$code" != "$wanted" ] || return 0
    failed=$((failed + 1))
    echo "exit $code, not $wanted: drillwave $*"
    tail -n 30 err.txt
}

marched=(--blows 20 --settle 5 --cells 10)
for language in en de sv; do
    export DRILLWAVE_LANGUAGE=$language
    rod=t38_medium_rock
    expect 0 run $rod
    expect 0 run $rod --method lattice --segments 500
    expect 0 thrust $rod --along beta=0.5:1:3
    expect 0 gap $rod
    expect 0 curve $rod --along gamma=0.2:1 --goal 0.7
    expect 0 map $rod --x gamma=0.1:1:4 --y delta=0:1:4 --level 0.5
    expect 0 drill r32_hard_rock "${marched[@]}"
    expect 0 drill r32_hard_rock "${marched[@]}" --scan drill.thrust=3kN,6kN
    expect 0 design $rod --uncertain gamma=0.1:0.3 --choose rod.length=3m,4m --samples 64
    expect 0 accuracy $rod --segments 100
    expect 0 presets --search T38
    expect 0 help
    for command in run sweep table curve map join gap drill thrust design report figures accuracy stability validate examples presets; do
        expect 0 "$command" --help
    done
    expect 2 run $rod --colour
    expect 2 sweep $rod
    expect 5 design $rod --uncertain gamma=1:0.1
    expect 2 help rok
    expect 3 run nowhere.yaml
    expect 4 run $rod -o /dev/null/x
    expect 5 run $rod --set gamma=2 rod.length=-1m
done
unset DRILLWAVE_LANGUAGE
expect 0 run r32_hard_rock --set bit_rock.law=power bit_rock.exponent=1.5 --json
for shape in rectangular triangular half_sine trapezoid exponential; do expect 0 run r32_hard_rock --set pulse.shape=$shape --json; done
expect 0 run r32_hard_rock -o blow
expect 0 run blow/histories.csv
expect 0 sweep r32_hard_rock --vary delta=0:2:20 --outputs all -o rows.csv
for part in 1 2; do expect 0 sweep r32_hard_rock --vary delta=0:2:20 --shard $part/2 -o part$part.csv; done
expect 0 join part1.csv part2.csv -o joined.csv
printf 'gamma,delta\n0.1,0.2\n0.3,0.4\n' >cases.csv
expect 0 table r32_hard_rock cases.csv
expect 0 examples -o scenarios
expect 0 validate scenarios/*.yaml
expect 0 run r32_string --json
expect 0 thrust r32_string
expect 0 drill r32_string "${marched[@]}"
expect 0 sweep r32_string --vary string.coupling.diameter=45mm:55mm:3 --outputs efficiency
expect 0 help theory
echo "$tried commands, $failed failed"
[ "$failed" = 0 ]

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compares what two builds of the program write, byte by byte: compare_outputs.sh OLD_PROGRAM NEW_PROGRAM [NEW_OUTPUTS]
# For every built-in scenario: the texts, JSON, CSV and pictures of run, and sweep, curve, map, thrust, accuracy and the report; of
# rods gap and the lattice too; also the table of reference cases, the figures and the presets. Times, which no two runs share, are left out. For changes that must not
# show. Exit code 1 and the differences when there are any. NEW_OUTPUTS, as in peak_tension,peak_compression, are left out of
# JSON where only the new program has them; of sweeps both write what the old one has.
set -euo pipefail
old=$(readlink -f "$1")
new=$(readlink -f "$2")
added=${3:-}
outputs=$("$old" help sweep | sed -n '/^Outputs/,$s/^  \([a-z_]*\)  .*/\1/p' | grep -vxE 'all|thrust' | paste -sd,)
[ -n "$outputs" ] || { echo "the help of the old program names no outputs" && exit 2; }
cases=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../cases")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export QT_QPA_PLATFORM=offscreen SOURCE_DATE_EPOCH=1700000000

# Blanks out what was measured: run_time in JSON and YAML, times in the columns and lines of accuracy.
without_times() {
    find "$1" -type f \( -name '*.json' -o -name '*.yaml' -o -name '*.csv' -o -name '*.txt' \) -print0 |
        xargs -0 sed -i -E 's/("?run_time[a-z_]*"?[:=] ?)[-+.0-9e]+/\1TIME/g
            s/[0-9.]+ (ns|µs|us|ms|s)\b/TIME/g'
    [ -z "$added" ] || find "$1" -name '*.json' -print0 | xargs -0 sed -i -E "/^ *\"(${added//,/|})\": /d"
}

# Everything the program writes goes into the current folder; standard output and error too.
write_all() {
    local program=$1 name
    say() { local to=$1 && shift && "$program" "$@" >"$to.txt" 2>"$to.err.txt" || echo "exit $?" >>"$to.txt"; }
    for name in $("$program" examples | awk '{ print $1 }'); do
        say "$name.run" run "$name"
        "$program" run "$name" --json >"$name.run.json"
        say "$name.folder" run "$name" -o "$name.blow" --plots png,svg,pdf
        say "$name.thrust" thrust "$name" --set drill.blow_frequency=45Hz
        say "$name.report" report "$name" -o "$name.html"
        say "$name.curve" curve "$name" --along gamma=0.05:1 --outputs rock_work,peak_force
        if [[ $name == *_string ]]; then
            say "$name.sweep" sweep "$name" --vary gamma=0.05:1:5 --vary bit_rock.gap=0mm:3mm:7 --outputs "$outputs"
            say "$name.map" map "$name" --x gamma=0.05:1:6 --y string.coupling.diameter=40mm:60mm:5 --output rock_work --level 0.5
            continue
        fi
        say "$name.sweep" sweep "$name" --vary gamma=0.05:1:8 --vary delta=0:3:40 --outputs "$outputs"
        say "$name.map" map "$name" --x gamma=0.05:1:9 --y delta=0:2:9 --output cor --level 0
        say "$name.lattice" run "$name" --method lattice --segments 2000
        say "$name.gap" gap "$name"
        say "$name.gap_json" gap "$name" --json
        say "$name.gap_csv" gap "$name" -o "$name.gap"
        # Methods and errors only: the other columns are times and what follows from them.
        "$program" accuracy "$name" --segments 100,1000 -o - | grep -v '^#' | cut -d, -f1-15 >"$name.accuracy.csv"
    done
    say table table r32_hard_rock "$cases/reference.csv"
    say figures figures -o figures
    say presets presets
    say help help
    for name in run sweep table curve map gap thrust report join figures accuracy stability validate examples presets; do
        say "help.$name" help "$name"
    done
}

for side in old new; do
    mkdir "$work/$side"
    (cd "$work/$side" && write_all "${!side}" && without_times .)
done
if diff -rq "$work/old" "$work/new"; then
    echo "the same bytes in $(find "$work/new" -type f | wc -l) files"
else
    diff -r "$work/old" "$work/new" | grep -a -v '^Binary' | head -n 60 || true
    exit 1
fi

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes what every command gives, for compare_outputs.sh: write_outputs.sh PROGRAM FOLDER OLD_PROGRAM
# PROGRAM works in FOLDER, in folders of its own for English, German and Swedish. Studies are small. English has every
# format; the other languages have texts, and SVG as the only pictures. The help of OLD_PROGRAM says which options,
# parameters and outputs are tried, so that both sides try the same.
# Each command leaves its standard output in NAME.txt, .json, .csv or .html, its standard error in NAME.err.txt, its
# exit code in NAME.exit, and the files that it writes.
set -uo pipefail
program=$(readlink -f "$1")
old=$(readlink -f "$3")
cases=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../cases")
mkdir -p "$2" && cd "$2" || exit 2
export QT_QPA_PLATFORM=offscreen SOURCE_DATE_EPOCH=1700000000 TZ=UTC LC_ALL=C.UTF-8
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export HOME=$home XDG_CONFIG_HOME=$home XDG_DATA_HOME=$home XDG_CACHE_HOME=$home XDG_RUNTIME_DIR=$home
unset DRILLWAVE_LANGUAGE

commands='run sweep table curve map join gap drill thrust design report figures accuracy stability'
commands+=' validate examples presets'
chapters='tutorial window keys files commands parameters outputs glossary theory strings drilling evidence upgrading'
marched=(--blows 30 --settle 10 --cells 10)
defined() { "$old" help "$1" | sed -nE 's/^`([a-z_.0-9]+)`: .*/\1/p'; }
parameters=$(defined parameters)
every_output=$(defined outputs)
drill_outputs=$(grep '^drill_' <<<"$every_output" | paste -sd,)
examples=$("$old" examples | awk '{ print $1 }')
[ -n "$parameters" ] && [ -n "$drill_outputs" ] && [ -n "$examples" ] ||
    { echo "the old program names no parameters, outputs or examples" >&2 && exit 2; }

# say NAME.ENDING WORD…: runs the command with these words.
say() {
    local to=$1 code=0
    shift
    "$program" "$@" >"$to" 2>"${to%.*}.err.txt" </dev/null || code=$?
    echo "$code" >"${to%.*}.exit"
}

# Sets what studies of an example go along: $second, and $output with $level for maps; $chosen for designs,
# $deviation of the gap, $segments of lattices, and $si where there are units.
set_axes() {
    second=delta=0:2:9 output=cor level=0 chosen=bit_rock.gap=0mm,1mm deviation=0.5mm segments=(--segments '100,1000')
    si=(--si)
    case $1 in
        paper_* | reference_case) chosen=delta=0,1 deviation=0.5 si=() ;;
        *_string) second=string.coupling.diameter=40mm:60mm:4 output=rock_work level=0.5 segments=() ;;
    esac
}

# Texts of every command for an example.
write_words() {
    local name=$1 second output level chosen deviation segments si
    set_axes "$name"
    say "$name.run.txt" run "$name"
    say "$name.thrust.txt" thrust "$name"
    say "$name.thrust_45.txt" thrust "$name" --set drill.blow_frequency=45Hz --along gamma=0.1:1:3
    say "$name.curve.txt" curve "$name" --along gamma=0.05:1 --outputs rock_work,peak_force --level 0.5
    say "$name.goal.txt" curve "$name" --along gamma=0.05:1 --outputs "$output" --goal 0.55
    say "$name.map.txt" map "$name" --x gamma=0.05:1:6 --y "$second" --output "$output" --level "$level"
    say "$name.gap.txt" gap "$name"
    say "$name.gap_scatter.txt" gap "$name" --gap-deviation "$deviation"
    say "$name.accuracy.txt" accuracy "$name" "${segments[@]}"
    say "$name.drill.txt" drill "$name" "${marched[@]}"
    say "$name.scan.txt" drill "$name" "${marched[@]}" --scan drill.thrust=3kN,9kN
    say "$name.design.txt" design "$name" --uncertain gamma=0.1:0.3 --choose "$chosen" --samples 64
}

# The files of every study of an example, with pictures in the formats $plots.
write_files() {
    local name=$1 second output level chosen deviation segments si
    set_axes "$name"
    say "$name.folder.txt" run "$name" -o "$name.blow" --plots "$plots"
    say "$name.report.txt" report "$name" -o "$name.report/"
    say "$name.sweep.txt" sweep "$name" --vary gamma=0.05:1:4 --vary "$second" -o "$name.sweep_files.csv" \
        --plots "$plots"
    say "$name.curve_files.txt" curve "$name" --along gamma=0.05:1 --family delta=0,1 --outputs "$output" --goal 0.55 \
        -o "$name.curve_files.csv" --plots "$plots"
    say "$name.map_files.txt" map "$name" --x gamma=0.05:1:6 --y "$second" --output "$output" --level "$level" \
        -o "$name.map_files.csv" --plots "$plots"
    say "$name.gap_files.txt" gap "$name" --gap-deviation "$deviation" -o "$name.gap_files.csv" --plots "$plots"
    say "$name.thrust_files.txt" thrust "$name" --frequency 30Hz:60Hz:7 -o "$name.thrust_files.csv" --plots "$plots"
    say "$name.drill_files.txt" drill "$name" "${marched[@]}" -o "$name.drill" --histories 2:3 --plots "$plots"
    say "$name.drill_rows.txt" drill "$name" "${marched[@]}" -o "$name.drill_rows.csv" --plots "$plots"
    say "$name.scan_files.txt" drill "$name" "${marched[@]}" --scan drill.thrust=3kN:9kN:3 -o "$name.scan_files.csv" \
        --gaps "$name.scan_gaps.csv" --plots "$plots"
    say "$name.design_files.txt" design "$name" --uncertain gamma=0.1:0.3 --choose "$chosen" \
        --at-least efficiency@q05=0.3 --samples 64 -o "$name.design" --plots "$plots"
    say "$name.accuracy_files.txt" accuracy "$name" "${segments[@]}" -o "$name.accuracy" --plots "$plots"
}

# The pictures of a blow and its report, of the examples whose studies are not drawn.
write_pictures() {
    say "$1.folder.txt" run "$1" -o "$1.blow" --plots svg
    say "$1.report.txt" report "$1" -o "$1.report/"
}

# Numbers of an example, which are the same in all languages.
write_numbers() {
    local name=$1 second output level chosen deviation segments si
    set_axes "$name"
    # The new side may have more of them.
    local columns
    columns=$("$old" sweep "$name" --vary gamma=0.5 --outputs all | sed -n '1{s/^gamma,//; s/ \[[^]]*\]//g; p; }')
    say "$name.run.json" run "$name" --json
    say "$name.run_si.txt" run "$name" --si -o "$name.blow_si"
    say "$name.run_groups.txt" run "$name" --dimensionless -o "$name.blow_groups"
    say "$name.rows.csv" sweep "$name" --vary gamma=0.05:1:6 --vary "$second" --outputs "$columns"
    say "$name.rows_si.csv" sweep "$name" --vary gamma=0.05:1:6 --outputs "$columns" "${si[@]}"
    say "$name.rows_drill.csv" sweep "$name" --vary drill.thrust=3kN:9kN:2 --outputs "$drill_outputs"
    say "$name.points.csv" curve "$name" --along gamma=0.05:1 --outputs rock_work,peak_force "${si[@]}" -o -
    say "$name.curve.json" curve "$name" --along gamma=0.05:1 --outputs rock_work,peak_force --level 0.5 --json
    say "$name.goal.json" curve "$name" --along gamma=0.05:1 --outputs "$output" --goal 0.55 --json
    say "$name.map.json" map "$name" --x gamma=0.05:1:6 --y "$second" --output "$output" --level "$level" --json
    say "$name.map_si.csv" map "$name" --x gamma=0.05:1:6 --y "$second" --output peak_force "${si[@]}" -o -
    say "$name.gap.json" gap "$name" --gap-deviation "$deviation" --json
    say "$name.gap_si.csv" gap "$name" "${si[@]}" -o -
    say "$name.thrust.json" thrust "$name" --json
    say "$name.thrust_along.json" thrust "$name" --along gamma=0.1:1:4 --json
    say "$name.report.html" report "$name" -o - --project "A project" --author "An author" --customer C --date 2026
    say "$name.accuracy.json" accuracy "$name" "${segments[@]}" --json
    say "$name.accuracy_rows.csv" accuracy "$name" "${segments[@]}" -o -
    say "$name.drill.json" drill "$name" "${marched[@]}" --json
    say "$name.drill_groups.json" drill "$name" "${marched[@]}" --dimensionless --json
    say "$name.drill_si.csv" drill "$name" "${marched[@]}" --si -o -
    say "$name.scan.json" drill "$name" "${marched[@]}" --scan drill.thrust=3kN:9kN:3 --json
    say "$name.scan_rows.csv" drill "$name" "${marched[@]}" --scan drill.thrust=3kN:9kN:3 --dimensionless -o -
    say "$name.design.json" design "$name" --uncertain gamma=0.1:0.3 --choose "$chosen" --samples 64 --json
    say "$name.lattice.json" run "$name" --method lattice --segments 2000 --json
    say "$name.closed_form.json" run "$name" --method closed_form --json
    say "$name.closed_form.txt" run "$name" --method closed_form
}

# Shapes of the blow, laws of the rock and values that bring out warnings and refusals: a line of words for --set each.
variants='pulse.shape=rectangular
pulse.shape=triangular
pulse.shape=half_sine
pulse.shape=trapezoid
pulse.shape=exponential
bit_rock.law=power bit_rock.exponent=1.5
bit_rock.gap=1.3mm
bit_rock.gamma=0.01
bit_rock.gamma=1
bit_rock.stiffness=1MN/m
bit_rock.stiffness=5GN/m
rod.length=0.2m
rod.length=300m
rod.yield_strength=100MPa
pulse.duration=10us
pulse.duration=5ms
pulse.impulse=1Ns
pulse.impulse=5000Ns
drill.thrust=1kN
drill.thrust=4kN
drill.thrust=100kN
drill.thrust=4kN drill.machine_mass=200kg drill.damper_damping=6.3kNs/m drill.wave_loss=10%
drill.blow_frequency=5Hz
drill.blow_frequency=300Hz
drill.inclination=90deg drill.machine_mass=200kg
hammer.velocity=1m/s
hammer.velocity=60m/s
hammer.restrike=true
string.rod.length=0.3m
string.5.diameter=200mm
title=Another'

write_variants() {
    local name=$1 number=0 change
    while read -ra change; do
        number=$((number + 1))
        say "$name.variant_$number.txt" run "$name" --set "${change[@]}"
        say "$name.variant_$number.drill.txt" drill "$name" --blows 12 --settle 4 --cells 10 --set "${change[@]}"
        [[ $language == en && $name != *_string ]] || continue
        say "$name.variant_$number.json" run "$name" --json --set "${change[@]}"
        say "$name.variant_$number.report.html" report "$name" --set "${change[@]}" -o -
    done <<<"$variants"
}

write_help() {
    local name
    say help.txt help
    for name in $commands; do say "help_$name.txt" "$name" --help; done
    for name in $chapters $parameters $every_output version β γ e; do say "topic_$name.txt" help "$name"; done
    for name in 1 2 4.3 99; do say "section_$name.txt" help theory "$name"; done
    say presets.txt presets
    say presets_search.txt presets --search T38
    say examples.txt examples
    say examples_one.txt examples r32_string -o -
}

# Commands that are refused: what an option or a parameter cannot be, and files that are none.
write_refused() {
    local name option key
    for name in $commands; do
        for option in $("$old" "$name" --help | sed -nE 's/^  (--[a-z-]+) [A-Za-z].*/\1/p'); do
            say "refused_${name}_$option.txt" "$name" t38_medium_rock "$option"
            say "refused_${name}_${option}_word.txt" "$name" t38_medium_rock "$option" nonsense
        done
        say "refused_${name}_unknown.txt" "$name" t38_medium_rock --colour
        say "refused_${name}_alone.txt" "$name" nowhere.yaml
        say "refused_${name}_plots.txt" "$name" t38_medium_rock --plots bmp
    done
    for key in $parameters; do
        for name in t38_medium_rock t38_string; do
            say "refused_set_${name}_$key.txt" run "$name" --set "$key=-1e9"
            say "refused_set_${name}_${key}_unit.txt" run "$name" --set "$key=1e99 furlongs"
        done
    done
    say refused_help.txt help rok
    say refused_language.txt run t38_medium_rock --language fr
    say refused_output.txt run t38_medium_rock -o /dev/null/x
    say refused_existing.txt run r32_hard_rock -o r32_hard_rock.blow
    say refused_design.txt design t38_medium_rock --uncertain gamma=1:0.1
    say refused_goal.txt curve t38_medium_rock --along gamma=0.2:1 --goal 7
    say refused_table.txt table t38_medium_rock bad.csv
    say refused_presets.txt presets bad_1.yaml
    say refused_found.txt presets --search nonsense
    for name in bad_*.yaml; do say "refused_$name.txt" validate "$name"; done
    say refused_all.txt validate t38_medium_rock bad_*.yaml nowhere.yaml
}

# Files that are no scenarios, each in another way.
make_bad_files() {
    local number=0 text
    for text in '' 'a: [' 'drillwave: 1' 'drillwave: 99' $'drillwave: 1\nrod: {length: 3 kg}' 'drillwave: one' \
        $'drillwave: 1\ntitle: a\ntitle: b' $'drillwave: 1\nrood: {length: 3 m}' $'drillwave: 2\nstring: []' \
        $'drillwave: 1\ngroups: {beta: -1, gamma: 2, tau: x, delta: 0}' '- 1' \
        $'drillwave: 2\nhammer: 3\nstring: {a: 1}'; do
        number=$((number + 1))
        printf '%s\n' "$text" >"bad_$number.yaml"
    done
    printf 'gamma,Beta\n0.1,0.2\n7\n' >bad.csv
    printf 'gamma,delta\n0.1,0.2\n0.3,0.4\n' >cases.csv
}

# Commands without a scenario, and those that take files of others.
write_others() {
    local part
    say table.csv table r32_hard_rock "$cases/reference.csv"
    say table_cases.txt table r32_hard_rock cases.csv --outputs cor,peak_force --si -o table_cases_files.csv
    for part in 1 2; do
        say part_$part.txt sweep r32_hard_rock --vary delta=0:2:20 --shard $part/2 -o part$part.csv
    done
    say join.txt join part1.csv part2.csv -o joined.csv
    say join_missing.txt join part1.csv -o joined_missing.csv
    for part in r32_hard_rock.{blow/histories.csv,blow/summary.json,blow/scenario.yaml,report/report.html} \
        joined.csv.yaml; do
        say "again_${part##*/}.txt" run "$part"
    done
    say examples_files.txt examples -o scenarios
    say validate.txt validate scenarios/*.yaml
    say figures.txt figures -o figures --plots "$plots"
    say figures.csv figures -o -
}

for language in en de sv; do
    mkdir -p "$language"
    (
        cd "$language" || exit 2
        plots=svg
        [ $language = en ] && plots=png,svg,pdf || export DRILLWAVE_LANGUAGE=$language
        make_bad_files
        for name in $examples; do
            [[ $language != en && $name == @(paper_fig4b|paper_fig8_minimum|t38_string|t51_string) ]] || write_words "$name"
        done
        for name in r32_hard_rock r32_string paper_fig4a; do write_files "$name"; done
        for name in piston_for_unknown_rock r32_string; do write_variants "$name"; done
        write_help
        write_others
        write_refused
        # One form in each language: it takes long.
        case $language in
            en) say stability.txt stability -o stability --plots "$plots" ;;
            de) say stability.txt stability ;;
            sv) say stability.json stability --json ;;
        esac
        [ $language = en ] || exit 0
        for name in $examples; do
            write_numbers "$name"
            [[ $name == @(r32_hard_rock|r32_string|paper_fig4a) ]] || write_pictures "$name"
        done
        say version.txt version
    )
done

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compares what two builds of the program write: compare_outputs.sh [OPTION]… OLD NEW [NEW_KEYS]
# OLD and NEW are folders of builds (build/release), or the programs in them (build/release/app/drillwave). NEW_KEYS, as
# in peak_tension,gap, may be in the JSON of the new side only.
#   --commands     compares the commands only, not the window
#   --keep FOLDER  leaves the outputs in FOLDER/old and FOLDER/new
#
# It covers every command with every format, pictures, help and refused commands, in English, German and Swedish
# (write_outputs.sh); manual pages and completions; and every page of the window for a rod and a drill string: its CSV,
# picture, copied command line and texts, menus and panels (tests/ui/page_outputs.cpp).
#
# Keys, codes, exit codes, numbers, file names and pictures must be equal. Words for people may differ, and each changed
# text is listed, old -> new. The rules are at the head of compare_outputs.py. Versions and run times are not compared.
#
# The tool for the window is compiled from this checkout against the sources and libraries of each side, so that an old
# checkout need not have it; both sides must be built. It is not compared where a side is built without the window.
#
# Exit code: 0 nothing differs, 3 only texts differ, 1 something that must be equal differs, 2 the sides could not be
# compared. It takes 15 minutes of processor time, that is 8 minutes on two free processors: both sides run at the same
# time.
set -euo pipefail
house=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
window=yes
keep=
while [[ ${1:-} == --* ]]; do
    case $1 in
        --commands) window= ;;
        --keep) keep=$2 && shift ;;
        *) echo "unknown option $1" >&2 && exit 2 ;;
    esac
    shift
done
[ $# -ge 2 ] || { echo "usage: compare_outputs.sh [--commands] [--keep FOLDER] OLD NEW [NEW_KEYS]" >&2 && exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
outputs=${keep:-$work}
mkdir -p "$outputs"
outputs=$(readlink -f "$outputs")
[ ! -e "$outputs/old" ] && [ ! -e "$outputs/new" ] || { echo "$outputs has outputs already" >&2 && exit 2; }

# The program of a folder of a build, or the folder of a program.
program_of() { if [ -d "$1" ]; then readlink -f "$1/app/drillwave"; else readlink -f "$1"; fi; }
build_of() { dirname "$(dirname "$(program_of "$1")")"; }
has_window() { [ -e "$(build_of "$1")/CMakeCache.txt" ] && [ -e "$(build_of "$1")/app/drillwave-window" ]; }

# build_tool BUILD TOOL: compiles and links the tool for the window as the build does tests/ui/screenshots.
build_tool() {
    local build=$1 tool=$2 sources object=tests/ui/CMakeFiles/screenshots.dir/screenshots.cpp.o
    sources=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
    ninja -C "$build" -t commands tests/ui/screenshots | grep -F " $object" |
        sed "s|$sources/tests/ui/screenshots.cpp|$house/../ui/page_outputs.cpp|g; s|$object|$tool.o|g
             s|-o tests/ui/screenshots |-o $tool |; s| -Werror | |" >"$tool.commands"
    (cd "$build" && bash -e "$tool.commands") >"$tool.log" 2>&1 && [ -x "$tool" ]
}

# write_pages TOOL FOLDER
write_pages() {
    local language example home
    home=$(mktemp -d "$work/home.XXX")
    export QT_QPA_PLATFORM=offscreen SOURCE_DATE_EPOCH=1700000000 TZ=UTC LC_ALL=C.UTF-8 HOME=$home XDG_CONFIG_HOME=$home
    export XDG_DATA_HOME=$home XDG_CACHE_HOME=$home XDG_RUNTIME_DIR=$home
    for example in t38_medium_rock r32_string; do
        "$1" "$2/$example" "$example" 2>"$1.log" || { cat "$1.log" >&2 && return 1; }
        for language in de sv; do
            "$1" --language $language --without-studies "$2/${example}_$language" "$example" 2>"$1.log" ||
                { cat "$1.log" >&2 && return 1; }
        done
    done
}

# write_side NAME OLD_OR_NEW
write_side() {
    local program build file
    program=$(program_of "$2")
    build=$(build_of "$2")
    bash "$house/write_outputs.sh" "$program" "$outputs/$1" "$(program_of "$old")" || return 1
    for file in "$build"/app/describe/{drillwave.1,drillwave-window.1,drillwave.bash,drillwave.fish,_drillwave}; do
        [ ! -e "$file" ] || cp "$file" "$outputs/$1"
    done
    [ -z "$window" ] || write_pages "$work/pages_$1" "$outputs/$1/window"
}

old=$1
new=$2
SECONDS=0
for side in "$old" "$new"; do
    [ -x "$(program_of "$side")" ] || { echo "$side: no program" >&2 && exit 2; }
    [ -z "$window" ] || has_window "$side" || { echo "$side is built without the window: only commands" && window=; }
done
if [ -n "$window" ]; then
    build_tool "$(build_of "$old")" "$work/pages_old" &
    build_tool "$(build_of "$new")" "$work/pages_new" && wait $! ||
        { cat "$work"/pages_*.log && echo "the tool for the window cannot be compiled; use --commands" && exit 2; } >&2
fi
write_side old "$old" &
first=$!
write_side new "$new" && wait $first || { echo "not everything could be written" >&2 && exit 2; }
result=0
python3 -B "$house/compare_outputs.py" "$outputs/old" "$outputs/new" ${3:+"$3"} || result=$?
echo "compared in $((SECONDS / 60)) min $((SECONDS % 60)) s; processor time: $(times | sed -n '2s/ / and /p')"
exit $result

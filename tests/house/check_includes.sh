#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks what the include lines say about the house: check_includes.sh SOURCE_FOLDER [ROOMS]
# - every file of core, ui and app is in a room of rooms.txt and includes only from its own room or one above it there, not
#   from one beside it;
# - includes are root-relative;
# - core includes no Qt, and of yaml-cpp only in core/yaml;
# - a source of core or ui begins with its own header, of the same name, or with that of its noun where several sources
#   share one: design_text.cpp with design_report.h of the same folder.
set -euo pipefail
source_folder=$1
rooms=$(readlink -f "${2:-$(dirname "${BASH_SOURCE[0]}")/rooms.txt}")
cd "$source_folder"

find core ui app -name '*.h' -o -name '*.cpp' | sort | xargs awk -v rooms="$rooms" '
    function room(path) { sub(/\/[^\/]*$/, "", path); return path }
    function complain(text) { print FILENAME ":" FNR ": " text; wrong = 1 }
    function mayReach(there) { return there == own || height[there] < height[own] }
    BEGIN {
        while ((getline line < rooms) > 0) {
            if (line ~ /^#/) continue
            ++count
            for (i = split(line, beside, " "); i > 0; --i) height[beside[i]] = count
        }
    }
    # Folder and first word of the name.
    function noun(path) { sub(/[_.][a-z_.]*$/, "", path); return path }
    FNR == 1 {
        own = room(FILENAME)
        included = 0
        if (!(own in height)) complain("the folder " own " is no room of rooms.txt")
    }
    /^#include "/ {
        split($0, part, "\"")
        header = part[2]
        if (header !~ /^(core|ui|app)\//) complain("\"" header "\" is not root-relative")
        else if (!(room(header) in height)) complain("no room holds " header)
        else if (!mayReach(room(header))) complain(own " must not include from " room(header) ": " header)
        if (FILENAME ~ /^(core|ui)\/.*\.cpp$/ && ++included == 1) {
            mine = FILENAME
            sub(/cpp$/, "h", mine)
            if (header != mine && noun(header) != noun(mine)) complain("must begin with its own header " mine)
        }
    }
    /^#include <Q/ && own ~ /^core/ { complain("core knows no Qt") }
    /^#include <yaml-cpp/ && own != "core/yaml" { complain("only core/yaml includes yaml-cpp") }
    END { if (NR == 0) { print "no sources found"; wrong = 1 } exit wrong }'

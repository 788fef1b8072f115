#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that a name of a class stands for one class: check_names.sh SOURCE_FOLDER
# Two headers that define classes of one name in one namespace can both be right as long as no source includes both; linked
# together the program calls the functions of one with the other. Forward declarations define nothing; what a source keeps in
# an unnamed namespace is its own.
set -euo pipefail
cd "$1"

find core ui app -name '*.h' | sort | xargs awk '
    /^namespace / { space = $2 }
    /^(struct|class|enum class|union) [A-Za-z_]+/ && !/;[ \t]*$/ {
        name = $1 == "enum" ? $3 : $2
        sub(/[^A-Za-z_0-9].*/, "", name)
        place = FILENAME ":" FNR
        whole = space "::" name
        if (whole in first) { print place ": " whole " is another class in " first[whole] ": rename one"; wrong = 1 }
        else first[whole] = place
        ++count
    }
    END { if (count == 0) { print "no classes found"; wrong = 1 } exit wrong }'

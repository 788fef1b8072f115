#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The check of the includes must be able to fail: check_finds_wrong.sh SOURCE_FOLDER
# Each file below holds one include line that breaks a rule of the house.
set -euo pipefail
checks=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
(cd "$1" && cp -R core ui app "$copy")
failed=0

while IFS='|' read -r file line expected; do
    mkdir -p "$(dirname "$copy/$file")"
    printf '#include %s\n' "$line" >"$copy/$file"
    if said=$("$checks/check_includes.sh" "$copy" 2>&1) || [[ $said != *"$file:1: $expected"* ]]; then
        echo "check_includes.sh does not complain \"$expected\" of $file; it said ${said:-nothing}"
        failed=1
    fi
    rm "$copy/$file"
done <<'END'
core/text/wrong.h|"core/numeric/brent.h"|core/text must not include from core/numeric
core/wave/lattice/wrong.h|"core/wave/exact/exact_solver.h"|core/wave/lattice must not include from core/wave/exact
core/wave/exact/wrong.h|"core/wave/closed/closed_form.h"|core/wave/exact must not include from core/wave/closed
core/yaml/wrong.h|"core/archive/row_record.h"|core/yaml must not include from core/archive
core/nowhere/wrong.h|"core/text/units.h"|the folder core/nowhere is no room
core/text/wrong.h|"units.h"|"units.h" is not root-relative
core/text/wrong.cpp|"core/text/units.h"|must begin with its own header core/text/wrong.h
core/text/wrong.h|<QString>|core knows no Qt
core/archive/wrong.h|<yaml-cpp/yaml.h>|only core/yaml includes yaml-cpp
END

[ "$failed" = 0 ] && echo "the check of the includes finds what is wrong"
exit "$failed"

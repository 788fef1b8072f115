#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Output of commands quoted in README and the manual must be right: check_printed.sh ROOT PROGRAM
# Each line of a block that begins with "```text drillwave …" must be printed by that command; but for errors of rounding, which
# differ from machine to machine.
set -u
export LC_ALL=C
root=$(readlink -f "${1:?check_printed.sh ROOT PROGRAM}")
program=$(readlink -f "${2:?check_printed.sh ROOT PROGRAM}")
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
unrounded='s/(error below [^)]*)//; s/balance errors.*/balance errors/; s/ *$//'
for page in "$root/README.md" "$root"/resources/manual/*.md; do
    awk -v page="$(basename "$page")" '
        /^```text drillwave / { sub(/^```text drillwave /, ""); words = $0; inside = 1; next }
        /^```/ { inside = 0 }
        inside && NF { print page "\t" words "\t" $0 }' "$page"
done >"$work/told"
cd "$root/resources/examples/identify" || exit 2  # the records that commands name
[ -s "$work/told" ] || { echo "no page has a block that begins with \`\`\`text drillwave" && exit 1; }
cut -f2 "$work/told" | sort -u | while IFS= read -r words; do
    # Words of the manual, without quotes in them.
    # shellcheck disable=SC2086
    DRILLWAVE_LANGUAGE=en "$program" $words </dev/null 2>&1 | sed "$unrounded" >"$work/printed"
    awk -F'\t' -v words="$words" '$2 == words { print $1 "\t" $3 }' "$work/told" | sed "$unrounded" |
        while IFS='	' read -r page line; do
            grep -qxF -e "$line" "$work/printed" || printf '%s: drillwave %s does not print "%s"\n' "$page" "$words" "$line"
        done
done >"$work/wrong"
cat "$work/wrong"
[ ! -s "$work/wrong" ]

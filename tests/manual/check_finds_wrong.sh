#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The checks of the manual must be able to fail: check_finds_wrong.sh ROOT PROGRAM
# Each line below is put into a copy of the sources as a comment, or a passage is taken out of its manual.
set -u
root=${1:?check_finds_wrong.sh ROOT PROGRAM}
program=${2:?check_finds_wrong.sh ROOT PROGRAM}
checks=$(cd "$(dirname "$0")" && pwd)
copy=$(mktemp -d) || exit 2
trap 'rm -rf "$copy"' EXIT
(cd "$root" && cp -R core ui app tests packaging resources README.md CONTRIBUTING.md "$copy") || exit 2
failed=0

# refuses CHECK EXPECTED: the check must fail on the copy and say so.
refuses() {
    said=$("$checks/$1" "$copy" "$program" 2>&1) && said="nothing: $said"
    case $said in
        nothing*) ;;
        *"$2"*) return ;;
    esac
    echo "$1 does not complain \"$2\"; it said $said"
    failed=1
}

while IFS='|' read -r comment expected; do
    printf '// %s\n' "$comment" >"$copy/core/wrong.h"
    refuses check_citations.sh "$expected"
done <<'END'
see theory §99|core/wrong.h:1: cites theory §99
see theory §8.9.|core/wrong.h:1: cites theory §8.9
see files §77|core/wrong.h:1: cites files §77
see commands §4.40|core/wrong.h:1: cites commands §4.40
F3 [paper (16)]|core/wrong.h:1: cites [paper (16)]
e (T999)|core/wrong.h:1: cites (T999)
see strings §99|core/wrong.h:1: cites strings §99
e (S99)|core/wrong.h:1: cites (S99)
F3 [paper, eq. (13)]|core/wrong.h:1:
one number of contract §4|core/wrong.h:1:
Theory, section 7|core/wrong.h:1:
END
rm "$copy/core/wrong.h"

cp "$copy/README.md" "$copy/readme"
while IFS='|' read -r code expected; do
    printf '\nType `%s`.\n' "$code" | cat "$copy/readme" - >"$copy/README.md"
    refuses check_commands.sh "$expected"
done <<'END'
drillwave solve t38_medium_rock|README.md: names drillwave solve
ctest -R tst_nothing|README.md: names tst_nothing
packaging/nothing --all|README.md: names packaging/nothing
END
mv "$copy/readme" "$copy/README.md"

edit() {
    sed "$2" "$copy/$1" >"$copy/edited" && mv "$copy/edited" "$copy/$1"
}
mv "$copy/resources/manual/files.md" "$copy/files"
refuses check_citations.sh "files.md: is missing"
mv "$copy/files" "$copy/resources/manual/files.md"
edit resources/manual/theory.md '/\[paper (14)\]   *(T/d'
refuses check_citations.sh "cites [paper (14)]"
edit resources/manual/files.md 's/`bit_rock.stiffness`//; s/peak_force//; s/string_momentum//; s/half_sine//'
refuses check_names.sh "parameter bit_rock.stiffness"
refuses check_names.sh "output peak_force"
refuses check_names.sh "output string_momentum"
refuses check_names.sh "shape half_sine"
edit resources/manual/commands.md 's/--segments//'
refuses check_names.sh "option --segments"
edit resources/manual/tutorial.md 's/0\.936617 F0/0.936618 F0/'
refuses check_printed.sh "tutorial.md: drillwave run t38_medium_rock does not print \"  peak force            0.936618 F0"
edit resources/manual/tutorial.md 's/rebound\.csv/map.csv/'
refuses check_tutorial.sh "-o map.csv: exit code 4: drillwave map: map.csv: exists already"

[ "$failed" = 0 ] && echo "the checks of the manual find what is wrong"
exit "$failed"

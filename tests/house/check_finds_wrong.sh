#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The checks of includes and of words must be able to fail: check_finds_wrong.sh SOURCE_FOLDER
set -euo pipefail
checks=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
(cd "$1" && cp -R core ui app tests packaging resources README.md CHANGELOG.md "$copy")
failed=0

# Each file below holds one include line that breaks a rule of the house.
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

# expect_complaints TEXT…: the check of the words must fail on the copy and say each of them.
expect_complaints() {
    local said
    said=$("$checks/check_words.sh" "$copy" 2>&1) && said="nothing: $said"
    for expected; do
        if [[ $said == nothing:* || $said != *"$expected"* ]]; then
            echo "check_words.sh does not complain \"$expected\"; it said $said"
            failed=1
        fi
    done
}
lists=$copy/tests/house
cat >"$copy/ui/wrong.cpp" <<'END'
const auto label = tr("A share that the page takes "
                      "in place of the mean");
/// Returns the same.
int count();  ///< Of a string, a count.
// What is it? A sentence goes on in
// the next line, and is told there.
END
printf '\nA paragraph of the manual that throws\nback a wave. Those are wrong.\n' >>"$copy/resources/manual/theory.md"
lines=$(wc -l <"$copy/resources/manual/theory.md")
expect_complaints 'ui/wrong.cpp:2: ' 'not "in place of"; instead: instead of' 'ui/wrong.cpp:4: ' 'not "Of …" at the beginning' \
    'ui/wrong.cpp:6: ' 'not "told"' "theory.md:$((lines - 1)): " "theory.md:$lines: back a wave. Those"
"$checks/check_words.sh" "$copy" --shrink
if ! cmp -s "$1/tests/house/word_exceptions.txt" "$lists/word_exceptions.txt"; then
    echo "check_words.sh --shrink changes a list that has nothing to be lowered"
    failed=1
fi
rm "$copy/ui/wrong.cpp"
cp "$1/resources/manual/theory.md" "$copy/resources/manual/theory.md"

# The list has counts that no text has any more, and of a file that was renamed.
printf 'core/gone.h | told | 1\ncore/CMakeLists.txt | told | 7\nREADME.md | tolt | 1\n' >>"$lists/word_exceptions.txt"
expect_complaints 'core/gone.h is not there' 'core/CMakeLists.txt | told is down to 0 from 7' 'is not FILE | PHRASE | COUNT'
cp "$1/tests/house/word_exceptions.txt" "$lists/word_exceptions.txt"

# The list has grown with the text since the last commit.
if command -v git >/dev/null; then
    commit() {
        git -C "$copy" add -A
        git -C "$copy" -c user.name=check -c user.email=check -c commit.gpgsign=false -c core.hooksPath=/dev/null \
            commit -q -m "$1"
    }
    unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
    git -C "$copy" init -q
    commit first
    printf '// It is told.\n' >"$copy/ui/wrong.cpp"
    printf 'ui/wrong.cpp | told | 1\n' >>"$lists/word_exceptions.txt"
    expect_complaints 'it may only shrink'
    commit second
    expect_complaints 'it may only shrink'
fi

[ "$failed" = 0 ] && echo "the checks of includes and words find what is wrong"
exit "$failed"

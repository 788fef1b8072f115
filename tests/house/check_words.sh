#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that texts use no phrase of forbidden_phrases.txt: check_words.sh ROOT [--shrink | --list]
# Reads the string literals of core, ui and app, the comments of core, ui, app, tests and packaging, the English manual, README,
# CHANGELOG, and the comments of examples and presets. Code between backquotes is not read.
# word_exceptions.txt lists how many hits each file may still have: FILE | PHRASE | COUNT. More hits fail, and so do fewer.
#   --shrink  lowers its counts to the hits that there are and removes what is 0; adds nothing
#   --list    prints the lines of today's hits: to start the counts of a new phrase
# The total of a phrase may not grow either. It is compared with the versions of the list in the history of git, back to the
# last change of this script; without a history the comparison is skipped.
set -euo pipefail
export LC_ALL=C
unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
root=${1:?check_words.sh ROOT [--shrink | --list]}
mode=${2:-}
cd "$root"
own=tests/house/check_words.sh
phrases=tests/house/forbidden_phrases.txt
list=tests/house/word_exceptions.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Reads files; prints "FILE | PHRASE | LINE | TEXT" for each hit.
find_hits() {
    awk -v phrases="$phrases" '
        BEGIN {
            while ((getline line < phrases) > 0) {
                if (line ~ /^#/ || split(line, part, / \| /) < 2) continue
                phrase[++count] = part[1]
                atStart[count] = part[1] ~ /^\^/
                words = part[1]
                sub(/^\^/, "", words)
                ending = sub(/\[\.,;\)\]$/, "", words) ? "([.,;)]|$)" : "([^a-z0-9_]|$)"
                # Sentences begin where the text does, after a full stop, and in a new cell or line.
                pattern[count] = (atStart[count] ? "(^|[.!?][)]? |[|] *)" : "(^|[^a-z0-9_])") words ending
                if (atStart[count]) starts = starts (starts ? "|" : "") words
                else all = all (all ? "|" : "") words
            }
            close(phrases)
            any = "(" all ")"
            anyStart = "(^|[.!?][)]? |[|] *)(" starts ")"
        }

        # Gathers a text from pieces of lines and searches it as a whole. Each hit has the line where it begins.
        function add(piece) {
            pieceAt[++pieces] = length(text) + 1
            pieceLine[pieces] = FNR
            pieceText[pieces] = $0
            text = text piece
        }
        function begin(piece) { search(); add(piece) }
        function search(    i, lower) {
            if (text != "") {
                lower = tolower(text)
                if (lower ~ any)
                    for (i = 1; i <= count; ++i) if (!atStart[i]) searchFor(i, lower)
                if (text ~ anyStart)
                    for (i = 1; i <= count; ++i) if (atStart[i]) searchFor(i, text)
            }
            text = ""
            pieces = 0
        }
        function searchFor(i, rest,    at, end, first, n, shown) {
            for (at = 0; match(rest, pattern[i]); at += end) {
                end = RSTART + RLENGTH - 2  # the border after it may be the one before the next
                first = atStart[i] ? end : RSTART + (substr(rest, RSTART, 1) !~ /[a-z0-9]/)
                for (n = pieces; n > 1 && pieceAt[n] > at + first; ) --n
                rest = substr(rest, end + 1)
                if (atStart[i] && isQuestion(rest)) continue
                shown = pieceText[n]
                sub(/^[ \t]*/, "", shown)
                print file " | " phrase[i] " | " pieceLine[n] " | " substr(shown, 1, 120)
            }
        }
        function isQuestion(rest) { return match(rest, /[.!?|]( |$)/) && substr(rest, RSTART, 1) == "?" }
        function withoutCode(words) { gsub(/`[^`]*`/, "`", words); return words }

        # Adds a line of a comment to the one above it at the same column, or begins a text.
        function comment(words, mark, column) {
            words = withoutCode(words)
            sub(/^</, "", words)
            sub(/^ +/, "", words)
            if (words == "" || words ~ /^SPDX-/) { search(); commentLine = 0; return }
            if (commentLine == FNR - 1 && commentMark == mark && commentColumn == column && words !~ /^- /) add(" " words)
            else { sub(/^- /, "", words); begin(words) }
            commentLine = FNR
            commentMark = mark
            commentColumn = column
        }

        # Literals that are separated by blanks only are one text.
        function source(line,    at, between, mark, piece) {
            if (rawEnd != "") {
                if (index(line, rawEnd)) rawEnd = ""
                return
            }
            if (line ~ /^#include/) return
            at = 0
            while (match(line, /"([^"\\]|\\.)*"|\/\/+|\047([^\047\\]|\\.)\047|R"[a-z]*\(/)) {
                between = substr(line, 1, RSTART - 1)
                piece = substr(line, RSTART, RLENGTH)
                at += RSTART + RLENGTH - 1
                line = substr(line, RSTART + RLENGTH)
                if (between !~ /^[ \t]*$/) afterLiteral = 0
                if (piece ~ /^\//) {
                    afterLiteral = 0
                    comment(line, length(piece) > 2 ? "///" : "//", at - RLENGTH)
                    return
                }
                if (piece ~ /^R/) {
                    rawEnd = ")" substr(piece, 3, length(piece) - 3) "\""
                    if (!index(line, rawEnd)) return
                    line = substr(line, index(line, rawEnd) + length(rawEnd))
                    rawEnd = ""
                    afterLiteral = 0
                    continue
                }
                if (piece !~ /^"/) { afterLiteral = 0; continue }
                if (!readsLiterals) continue
                piece = withoutCode(substr(piece, 2, length(piece) - 2))
                gsub(/\\n/, " | ", piece)
                gsub(/\\"/, "\"", piece)
                if (afterLiteral) add(piece)
                else begin(piece)
                afterLiteral = 1
                commentLine = 0
            }
            if (line !~ /^[ \t]*$/) afterLiteral = 0
        }

        function script(line,    words) {
            if (match(line, /^[ \t]*#+/) || match(line, /[ \t]#+[ \t]/)) {
                words = substr(line, RSTART + RLENGTH)
                if (FNR == 1 && words ~ /^!/) return
                comment(words, "#", RSTART + RLENGTH)
            }
        }

        # Markdown: paragraphs, headings, items and cells; neither code nor formulas.
        function manual(line) {
            if (line ~ /^ *```/) { search(); fenced = !fenced; return }
            if (fenced) return
            if (line ~ /^ *$/) { search(); return }
            line = withoutCode(line)
            gsub(/\]\([^)]*\)/, "]", line)
            gsub(/[*[\]]/, "", line)
            if (line ~ /^#/) { inList = 0; sub(/^#+ (§[0-9.]* )?/, "", line); begin(line); search(); return }
            if (line ~ /^ *\|/) { begin(line); search(); return }
            if (line ~ /^ *(-|[0-9]+\.) /) { sub(/^ *(-|[0-9]+\.) /, "", line); begin(line); inList = 1; return }
            if (text != "") { sub(/^ */, "", line); add(" " line); return }
            if (line !~ /^ /) inList = 0
            if (line ~ /^    / && !inList) return
            sub(/^ */, "", line)
            begin(line)
        }

        FNR == 1 {
            search()
            file = FILENAME
            kind = file ~ /\.md$/ ? "manual" : file ~ /\.(h|cpp|h\.in)$/ ? "source" : "script"
            readsLiterals = file ~ /^(core|ui|app)\//
            rawEnd = ""
            fenced = afterLiteral = inList = commentLine = 0
        }
        kind == "source" { source($0) }
        kind == "script" { script($0) }
        kind == "manual" { manual($0) }
        END { search() }' "$@"
}

{
    find core ui app -name '*.h' -o -name '*.cpp' -o -name '*.h.in' -o -name '*.cmake' -o -name CMakeLists.txt
    find tests packaging -name '*.h' -o -name '*.cpp' -o -name '*.cmake' -o -name CMakeLists.txt -o -name '*.sh' \
        -o -name '*.sbatch' -o -type f ! -name '*.*'
    find resources/examples resources/presets -name '*.yaml'
    find resources/manual -maxdepth 1 -name '*.md'
    echo README.md
    echo CHANGELOG.md
} | sort >"$work/files"
(find_hits $(cat "$work/files")) >"$work/hits"
[ -f "$phrases" ] && [ -f "$list" ] || { echo "$phrases or $list is missing" && exit 1; }

# FILE | PHRASE | COUNT of the hits
awk -F ' [|] ' '{ ++count[$1 " | " $2] } END { for (each in count) print each " | " count[each] }' "$work/hits" | sort >"$work/found"
if [ "$mode" = --list ]; then
    cat "$work/found"
    exit
fi
if [ "$mode" = --shrink ]; then
    awk -F ' [|] ' 'NR == FNR { found[$1 " | " $2] = $3; next }
        /^#/ || NF != 3 { print; next }
        { now = found[$1 " | " $2] + 0; least = now < $3 ? now : $3; if (least > 0) print $1 " | " $2 " | " least }' \
        "$work/found" "$list" >"$work/shrunk"
    cat "$work/shrunk" >"$list"
    exit
fi

awk -F ' [|] ' -v list="$list" '
    function named(phrase) {
        if (sub(/^\^/, "", phrase)) return "\"" phrase " …\" at the beginning of a sentence"
        return sub(/\[.*/, "", phrase) ? "\"" phrase "\" at the end of a phrase" : "\"" phrase "\""
    }
    FILENAME ~ /forbidden_phrases/ { if ($0 !~ /^#/ && NF > 1) instead[$1] = $2; next }
    FILENAME == list {
        if (/^#/) next
        if (NF != 3 || !($2 in instead) || $3 !~ /^[1-9][0-9]*$/) { print list ":" FNR ": is not FILE | PHRASE | COUNT"; wrong = 1; next }
        if (($1 " | " $2) in listed) { print list ":" FNR ": lists it twice"; wrong = 1 }
        listed[$1 " | " $2] = $3
        next
    }
    FILENAME ~ /files$/ { there[$1] = 1; next }
    FILENAME ~ /found$/ { found[$1 " | " $2] = $3; total += $3; next }
    # hits
    found[$1 " | " $2] > listed[$1 " | " $2] + 0 {
        print $1 ":" $3 ": " $4
        print "    not " named($2) "; instead: " instead[$2]
        over[$1 " | " $2] = 1
        wrong = 1
    }
    END {
        for (each in over)
            if (listed[each]) { print each ": " found[each] " hits, " listed[each] " are listed; at least one of those above is new" }
        for (each in listed) {
            split(each, part, / \| /)
            if (!(part[1] in there)) {
                print list ": " part[1] " is not there; where it was renamed, write its new name into its lines; else run " \
                      "tests/house/check_words.sh ROOT --shrink"
                wrong = 1
            } else if (found[each] + 0 < listed[each]) {
                print list ": " each " is down to " found[each] + 0 " from " listed[each] "; run tests/house/check_words.sh ROOT --shrink"
                wrong = 1
            }
        }
        if (!wrong) print total + 0 " hits, all of them listed"
        exit wrong
    }' "$phrases" "$list" "$work/files" "$work/found" "$work/hits" || failed=1

# "PHRASE | TOTAL" of a list; 0 of every phrase that it has none of.
totals() {
    awk -F ' [|] ' '/^#/ { next } FILENAME == ARGV[1] { if (NF > 1) total[$1] += 0; next } NF == 3 { total[$2] += $3 }
        END { for (each in total) print each " | " total[each] }' "$1" "$2"
}
old_totals() {
    command -v git >/dev/null && [ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ] || return 0
    since=$(git log -1 --format=%H -- "$own") && [ -n "$since" ] && git diff --quiet HEAD -- "$own" || return 0
    for version in $since $(git log -20 --format=%H "$since.." -- "$list"); do
        git show "$version:$list" >"$work/old_list" 2>/dev/null || continue
        git show "$version:$phrases" >"$work/old_phrases" 2>/dev/null || continue
        totals "$work/old_phrases" "$work/old_list" | sed "s/$/ | $(echo "$version" | cut -c1-8)/"
    done
}
totals "$phrases" "$list" >"$work/totals"
old_totals >"$work/old_totals" 2>/dev/null || true
awk -F ' [|] ' -v list="$list" 'NR == FNR { now[$1] = $2; next }
    now[$1] > $2 && !seen[$1]++ { print list ": lists " now[$1] " of \"" $1 "\", but in " $3 " only " $2 ": it may only shrink"; wrong = 1 }
    END { exit wrong }' "$work/totals" "$work/old_totals" || failed=1
exit "${failed:-0}"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks the program's files for a desktop, by its own tools where they are there: check_desktop.sh SOURCE_FOLDER BUILD_FOLDER
# - the entry in the menu and what catalogues of programs show are valid;
# - scenarios are recognised by their ending or their key, and other YAML is not taken for one.
set -euo pipefail
desktop=$(readlink -f "$1/packaging/desktop")
build=$(readlink -f "$2/packaging")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
checked=0
there() { command -v "$1" >/dev/null && checked=1; }
fail() { echo "$1" && exit 1; }

if there desktop-file-validate; then desktop-file-validate "$desktop/drillwave.desktop"; fi
if there appstreamcli; then
    appstreamcli validate --no-net "$build"/*.metainfo.xml >"$work/said.txt" || fail "$(cat "$work/said.txt")"
fi
# Both read the same names: the type of the files, and that of the icon.
type=$(sed -n 's/.*mime-type type="\([^"]*\)".*/\1/p' "$desktop/mime.xml")
grep -q "^MimeType=$type;" "$desktop/drillwave.desktop" || fail "the entry in the menu does not open $type"
grep -q "<mediatype>$type</mediatype>" "$build"/*.metainfo.xml || fail "catalogues are not told of $type"

shared=/usr/share/mime/packages/freedesktop.org.xml
if [ -e "$shared" ] && there update-mime-database && there gio; then
    mkdir -p "$work/share/mime/packages"
    cp "$shared" "$desktop/mime.xml" "$work/share/mime/packages"
    update-mime-database "$work/share/mime" 2>/dev/null
    while IFS='|' read -r name text expected; do
        printf "$text" >"$work/$name"
        given=$(XDG_DATA_HOME="$work" XDG_DATA_DIRS="$work/share" gio info -a standard::content-type "$work/$name" |
            sed -n 's/.*standard::content-type: //p')
        [ "$given" = "$expected" ] || fail "$name with \"$text\" is $given, not $expected"
    done <<END
a.yaml|drillwave: 1\nrod: 2\n|$type
b.yaml|# Looks at\n# the rod.\n\ndrillwave: 2\n|$type
c.yml|title: x\ndrillwave: 1\n|$type
new.drillwave.yaml|title: none yet\n|$type
other.yaml|a: 1\nb: 2\n|application/x-yaml
mentions.yaml|program: drillwave\nnot drillwave: 1\n|application/x-yaml
presets.yaml|drillwave_presets: 1\n|application/x-yaml
END
    for example in "$1"/resources/examples/*.yaml; do
        given=$(XDG_DATA_HOME="$work" XDG_DATA_DIRS="$work/share" gio info -a standard::content-type "$example")
        [[ $given == *"standard::content-type: $type"* ]] || fail "$example is not $type: $given"
    done
fi
[ $checked = 1 ] || exit 77

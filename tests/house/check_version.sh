#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The version and its day must be the same wherever they stand: check_version.sh SOURCE_FOLDER
set -euo pipefail
cd "$1"
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
day=$(sed -n 's/^set(DRILLWAVE_RELEASED \([0-9-]*\)).*/\1/p' CMakeLists.txt)
wrong=0
# FILE LINE: the line must be there.
holds() { grep -qxF -- "$2" "$1" || { echo "$1: no line \"$2\", as CMakeLists.txt has it" && wrong=1; }; }
holds CITATION.cff "version: $version"
holds CITATION.cff "date-released: $day"
holds CHANGELOG.md "## [$version] – $day"
grep -qF "version $version, ${day%%-*}" README.md || { echo "README.md: does not cite version $version, ${day%%-*}" && wrong=1; }
[ -n "$version" ] && [ -n "$day" ] || { echo "CMakeLists.txt: has no version or no day" && wrong=1; }
exit "$wrong"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that every source is laid out as clang-format 14 does it by .clang-format: check_format.sh SOURCE_FOLDER
set -euo pipefail
cd "$1"
sources=$(find core ui app tests -name '*.h' -o -name '*.cpp')
[ -n "$sources" ] || { echo "no sources found" && exit 1; }
clang-format-14 --dry-run --Werror $sources

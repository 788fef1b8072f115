#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Brings catalogues up to date with the texts of the sources: extract.sh LUPDATE LIST_CORE_TEXTS FOLDER CATALOGUE.ts…
# The texts are those of ui, the messages of core and app, the tables of both, and what Qt itself shows in the window. What is new is left
# to be translated, and what is no longer there goes. FOLDER is for what is written on the way.
set -eu
lupdate=$1
list=$2
work=$3
shift 3
cd "$(dirname "$0")/../.."
"$list" >"$work/core_texts.cpp"
"$lupdate" -locations none -no-obsolete -tr-function-alias QT_TRANSLATE_NOOP+=translatable -I . \
    ui core app resources/languages/qt_texts.h "$work/core_texts.cpp" -ts "$@"

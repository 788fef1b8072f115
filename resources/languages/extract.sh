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
# A text outside of a class has no context of its own: copies of the sources name it.
rm -rf "$work/sources"
mkdir "$work/sources"
cp -r core app ui "$work/sources"
find "$work/sources" -name '*.cpp' -o -name '*.h' |
    xargs sed -i -E 's/\btranslatable\(("|$)/translatable("drillwave::Message", \1/g'
"$lupdate" -locations none -no-obsolete -tr-function-alias QT_TRANSLATE_NOOP+=translatable -I "$work/sources" \
    "$work/sources" resources/languages/qt_texts.h "$work/core_texts.cpp" -ts "$@"

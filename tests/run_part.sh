#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs one of N parts of the slots of a test, the one that DRILLWAVE_SEED chooses: run_part.sh N TEST. Each slot runs once within N
# consecutive commits.
set -eu
parts=$1
test=$2
slots=$("$test" -functions | sed -n 's/^\(.*\)()$/\1/p' |
    awk -v parts="$parts" -v seed="${DRILLWAVE_SEED:-0}" '(NR + seed) % parts == 0')
# shellcheck disable=SC2086
[ -z "$slots" ] || exec "$test" $slots

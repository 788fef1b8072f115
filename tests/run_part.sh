#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs one of N parts of the slots of a test, the one that DRILLWAVE_SEED chooses: run_part.sh N TEST. Each slot runs once within N
# consecutive commits. The test itself gets the seed divided by N, so that a slot meets another part of its rows each time it runs.
set -eu
parts=$1
test=$2
seed=${DRILLWAVE_SEED:-0}
functions=$("$test" -functions)
slots=$(echo "$functions" | sed -n 's/^\(.*\)()$/\1/p' | awk -v parts="$parts" -v seed="$seed" '(NR + seed) % parts == 0')
[ -n "$slots" ] || exit 0
# shellcheck disable=SC2086
DRILLWAVE_SEED=$((seed / parts)) exec "$test" $slots

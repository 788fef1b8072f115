#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the tests of a room as one source, which the compiler reads in a third of the time: unite.sh OUT TEST.cpp…
# Each test lies in a namespace of its name, so that none sees the names and the main() of another; what they include comes
# before. The program runs the test by whose name it is called.
set -eu
out=$1
shift
{
    echo "// Written by tests/unite.sh."
    grep -h '^#include' "$@" | grep -v '\.moc"' | sort -u
    echo '#include "tests/support/called_by_name.h"'
    for test in "$@"; do
        printf 'namespace %s {\n#include "%s"\n}\n' "$(basename "$test" .cpp)" "$test"
    done
    echo "int main(int argc, char** argv) {"
    echo "    return drillwave::test::runCalled(argc, argv, {"
    for test in "$@"; do
        name=$(basename "$test" .cpp)
        echo "        {\"$name\", &$name::main},"
    done
    echo "    });"
    echo "}"
} >"$out.new"
mv "$out.new" "$out"

// SPDX-License-Identifier: GPL-3.0-or-later
// Several test programs in one file, which runs the program under whose name it is called.
#pragma once

#include <cstdio>
#include <string_view>
#include <vector>

namespace drillwave::test {

struct NamedProgram {
    std::string_view name;
    int (*main)(int, char**);
};

/// Runs the program whose name is the last part of argv[0] and returns its exit code. If there is none,
/// prints the known names on stderr and returns 2.
inline int runCalled(int argc, char** argv, const std::vector<NamedProgram>& programs) {
    const std::string_view path = argc > 0 ? argv[0] : "";
    const std::string_view called = path.substr(path.rfind('/') + 1);
    for (const NamedProgram& program : programs)
        if (program.name == called) return program.main(argc, argv);
    std::fputs("Call one of the links to this program, which run its tests:\n", stderr);
    for (const NamedProgram& program : programs)
        std::fprintf(stderr, "  %.*s\n", static_cast<int>(program.name.size()), program.name.data());
    return 2;
}

}  // namespace drillwave::test

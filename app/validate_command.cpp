// drillwave validate FILE…
#include <cstdio>

#include "app/command.h"
#include "app/scenario_argument.h"

namespace drillwave {

namespace {

/// The worse of two results: a file that cannot be read at all counts above an invalid one.
ExitCode worse(ExitCode a, ExitCode b) {
    if (a == ExitCode::unreadableInput || b == ExitCode::unreadableInput) return ExitCode::unreadableInput;
    return a == ExitCode::done ? b : a;
}

ExitCode validateFiles(const Arguments& arguments) {
    ExitCode result = ExitCode::done;
    for (const std::string& path : arguments.operands()) {
        try {
            loadScenarioFile(path);
        } catch (const CommandError& error) {
            for (const std::string& line : error.lines()) std::fprintf(stderr, "%s\n", line.c_str());
            result = worse(result, error.code());
        }
    }
    return result;
}

}  // namespace

const Command& validateCommand() {
    static const Command command{
        .name = "validate",
        .operands = "FILE…",
        .summary = "list the problems of scenario files, one a line",
        .details = "Says nothing about a file without problems.",
        .options = {},
        .leastOperands = 1,
        .mostOperands = SIZE_MAX,
        .draws = [](const Arguments&) { return false; },
        .run = validateFiles,
    };
    return command;
}

}  // namespace drillwave

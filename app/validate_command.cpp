// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave validate FILE…
#include <string_view>

#include "app/command.h"
#include "app/preset_options.h"
#include "app/scenario_argument.h"
#include "core/yaml/preset_file.h"

namespace drillwave {

namespace {

/// The worse of two results: a file that cannot be read at all counts above an invalid one.
ExitCode worse(ExitCode a, ExitCode b) {
    if (a == ExitCode::unreadableInput || b == ExitCode::unreadableInput) return ExitCode::unreadableInput;
    return a == ExitCode::done ? b : a;
}

bool holdsPresets(std::string_view text) {
    constexpr std::size_t beginning = 1 << 16;
    text = text.substr(0, beginning);
    return text.starts_with(presetKey) || text.find("\n" + std::string(presetKey)) != std::string_view::npos;
}

/// Presets are checked as presets.
void check(const std::string& path, const ReadingStyle& style) {
    const std::string text = inputBytes(path, style);
    if (holdsPresets(text))
        parsedPresets(text, path);
    else
        parsedInput(text, path);
}

ExitCode validateFiles(const Arguments& arguments, const Drawing*) {
    ExitCode result = ExitCode::done;
    for (const std::string& path : arguments.operands()) {
        try {
            check(path, arguments.style());
        } catch (const CommandError& error) {
            for (const Message& line : error.messages()) printRemark(line, arguments.style());
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
        .summary = "list the errors of scenario files, one per line",
        .details =
            "Checks scenario files and preset files. Prints one line for each error, and nothing for a file "
            "without errors.",
        .options = {},
        .leastOperands = 1,
        .mostOperands = SIZE_MAX,
        .draws = [](const Arguments&) { return false; },
        .run = validateFiles,
    };
    return command;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave presets [FILE.yaml]
#include "app/command.h"
#include "app/output_file.h"
#include "app/preset_options.h"

namespace drillwave {

namespace {

/// The lines of a description, each behind four blanks.
std::string indented(const std::string& lines) {
    std::string text = "    ";
    for (const char c : lines) text += c == '\n' ? std::string("\n    ") : std::string(1, c);
    return text + "\n";
}

ExitCode runPresets(const Arguments& arguments, const Drawing*) {
    const std::string path = arguments.operands().empty() ? std::string() : arguments.operands().front();
    std::string text;
    std::string_view heading;
    for (const Preset& preset : presetsOf(path)) {
        if (name(preset.kind) != heading) {
            heading = name(preset.kind);
            text +=
                (text.empty() ? "" : "\n") + std::string(heading) + "s, for --" + std::string(heading) + "\n";
        }
        text += "  " + preset.name + "\n" + indented(description(preset));
    }
    writeFile("-", text, Overwrite::allowed);
    return ExitCode::done;
}

}  // namespace

const Command& presetsCommand() {
    static const Command command{
        .name = "presets",
        .operands = "[FILE.yaml]",
        .summary = "list rods, hammers and rocks, with the source of every value",
        .details =
            "Those that are built in, or those of a file in the same format. A command takes them with "
            "--rod\n"
            "NAME, --hammer NAME and --rock NAME; the beginning of a name will do where only one has it.",
        .options = {},
        .leastOperands = 0,
        .mostOperands = 1,
        .draws = [](const Arguments&) { return false; },
        .run = runPresets,
    };
    return command;
}

}  // namespace drillwave

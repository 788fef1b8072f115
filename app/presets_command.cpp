// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave presets [FILE.yaml]
#include <optional>

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

/// A list under its heading.
class Listing {
  public:
    void add(std::string_view kind, std::string_view use, const std::string& name,
             const std::string& description) {
        if (kind != m_kind)
            m_text += (m_text.empty() ? "" : "\n") + std::string(kind) + "s, for " + std::string(use) + "\n";
        m_kind = kind;
        m_text += "  " + name + "\n" + indented(description);
    }
    const std::string& text() const { return m_text; }

  private:
    std::string m_text;
    std::string_view m_kind;
};

ExitCode runPresets(const Arguments& arguments, const Drawing*) {
    std::optional<std::string> path;
    if (!arguments.operands().empty()) path = arguments.operands().front();
    const PresetFile file = presetsOf(path);
    Listing listing;
    for (const Preset& preset : file.presets)
        listing.add(name(preset.kind), "--" + std::string(name(preset.kind)), preset.name,
                    description(preset));
    for (const SectionPreset& preset : file.sectionPresets)
        listing.add(name(preset.kind), "drill strings (length × diameter / bore)", preset.name,
                    description(preset));
    printText(listing.text());
    return ExitCode::done;
}

}  // namespace

const Command& presetsCommand() {
    static const Command command{
        .name = "presets",
        .operands = "[FILE.yaml]",
        .summary = "list rods, hammers, rocks and pieces of drill strings, with their sources",
        .details =
            "Those that are built in, or those of a file in the same format. A command takes them with "
            "--rod\n"
            "NAME, --hammer NAME and --rock NAME; the beginning of a name will do where only one has it. "
            "Pistons,\n"
            "adapters, couplings and bits are pieces of drill strings, to be put in on the page String of "
            "the window.",
        .options = {},
        .leastOperands = 0,
        .mostOperands = 1,
        .draws = [](const Arguments&) { return false; },
        .run = runPresets,
    };
    return command;
}

}  // namespace drillwave

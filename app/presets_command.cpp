// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave presets [FILE.yaml]
#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "app/command.h"
#include "app/output_file.h"
#include "app/preset_options.h"
#include "core/text/name_text.h"
#include "core/text/text_layout.h"

namespace drillwave {

namespace {

/// Returns the use of the presets of a kind; %1 is the option that takes them.
const char* usePattern(PresetKind kind) {
    switch (kind) {
        case PresetKind::rod:
            return translatable("rods, for %1");
        case PresetKind::hammer:
            return translatable("hammers, for %1");
        case PresetKind::rock:
            return translatable("rocks, for %1");
    }
    return "";
}

const char* usePattern(SectionPresetKind kind) {
    switch (kind) {
        case SectionPresetKind::piston:
            return translatable("pistons, for drill strings (length × diameter / bore)");
        case SectionPresetKind::adapter:
            return translatable("adapters, for drill strings (length × diameter / bore)");
        case SectionPresetKind::coupling:
            return translatable("couplings, for drill strings (length × diameter / bore)");
        case SectionPresetKind::bit:
            return translatable("bits, for drill strings (length × diameter / bore)");
    }
    return "";
}

/// Returns the kind of presets that an operand names, "rock" for "rock" and "rocks"; otherwise an empty text.
std::string kindOf(std::string_view operand) {
    const auto isKind = [&](std::string_view kind) {
        return operand == kind || operand == std::string(kind) + "s";
    };
    for (const PresetKind kind : allValues<PresetKind>)
        if (isKind(name(kind))) return std::string(name(kind));
    for (const SectionPresetKind kind : allValues<SectionPresetKind>)
        if (isKind(name(kind))) return std::string(name(kind));
    return {};
}

/// Lists, each under its heading, of what has every word looked for in its kind, name or description,
/// capitals or not.
class Listing {
  public:
    /// `only` is the kind to list; empty for all.
    Listing(std::string only, const std::string& search, const ReadingStyle& style)
        : m_style(style), m_only(std::move(only)) {
        std::istringstream words(lowerCase(search));
        for (std::string word; words >> word;) m_words.push_back(word);
    }

    void add(std::string_view kind, const Message& use, const std::string& name,
             const std::string& description) {
        if (!m_only.empty() && kind != m_only) return;
        const std::string title = nameFor(name, m_style);
        const std::string all = lowerCase(std::string(kind) + "s\n" + title + "\n" + description);
        const auto isThere = [&](const std::string& word) { return all.find(word) != std::string::npos; };
        if (!std::ranges::all_of(m_words, isThere)) return;
        if (kind != m_kind) m_text += (m_text.empty() ? "" : "\n") + m_style.said(use) + "\n";
        m_kind = kind;
        m_text += "  " + title + "\n" + indented(description, 4);
    }
    const std::string& text() const { return m_text; }

  private:
    const ReadingStyle& m_style;
    std::string m_only;
    std::vector<std::string> m_words;
    std::string m_text;
    std::string_view m_kind;
};

ExitCode runPresets(const Arguments& arguments, const Drawing*) {
    std::optional<std::string> path;
    std::string kind;
    for (const std::string& operand : arguments.operands()) {
        const std::string named = kindOf(operand);
        if (named.empty() ? path.has_value() : !kind.empty())
            throw CommandError(ExitCode::usage,
                               Message(translatable("unexpected argument `%1`; the command takes %2, see "
                                                    "drillwave %3 --help"),
                                       {operand, "[KIND] [FILE.yaml]", "presets"}));
        if (named.empty())
            path = operand;
        else
            kind = named;
    }
    const PresetFile file = presetsOf(path, arguments.style());
    const std::string search = arguments.value("search").value_or("");
    Listing listing(kind, search, arguments.style());
    for (const Preset& preset : file.presets)
        listing.add(name(preset.kind), {usePattern(preset.kind), {"--" + std::string(name(preset.kind))}},
                    preset.name, description(preset, arguments.style()));
    for (const SectionPreset& preset : file.sectionPresets)
        listing.add(name(preset.kind), usePattern(preset.kind), preset.name,
                    description(preset, arguments.style()));
    if (listing.text().empty() && !search.empty())
        throw CommandError(ExitCode::unsolvedOrFailed,
                           Message(translatable("no preset has all of \"%1\""), {search}));
    printText(listing.text());
    return ExitCode::done;
}

}  // namespace

const Command& presetsCommand() {
    static const Command command{
        .name = "presets",
        .operands = "[KIND] [FILE.yaml]",
        .summary = "list rods, hammers, rocks and sections of drill strings, with their sources",
        .details =
            "Lists the built-in presets, or those of FILE.yaml. KIND restricts the list to rod, hammer, "
            "rock,\n"
            "piston, adapter, coupling or bit. Other commands use a preset with --rod NAME, --hammer NAME "
            "or\n"
            "--rock NAME; the beginning of the name suffices if only one preset has it. Pistons, adapters,\n"
            "couplings and bits are sections of drill strings: insert them on the page String of the window.",
        .options = {{"search", "WORDS",
                     "list only presets with all of these words in kind, name, numbers or source, such as "
                     "\"T38 bit\""}},
        .leastOperands = 0,
        .mostOperands = 2,
        .draws = [](const Arguments&) { return false; },
        .run = runPresets,
    };
    return command;
}

}  // namespace drillwave

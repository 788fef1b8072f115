// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts the words of a command line into options ("--set x=1") and operands (words that are not options).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/languages.h"

namespace drillwave {

/// Description of one option of a command, for parsing and help, such as "--set KEY=VALUE" or "-j N".
struct OptionSpec {
    std::string_view name;  ///< name without dashes: "set", or a single letter
    /// Placeholder of the option's value in the help, "KEY=VALUE"; empty for a switch.
    std::string_view value;
    std::string_view help;  ///< description in the help, one line
    /// Number of times that the option may appear. A `list` option also takes all following words that have
    /// an equals sign.
    enum class Times { once, repeated, list } times = Times::once;
    /// Scenario key that the option sets: "drill.blows" for --blows; empty if it sets none.
    std::string_view sets = {};

    /// Returns true if the option is written with two dashes, "--set" or "--x", and false if with one, "-j".
    bool isLong() const;
    /// Returns the option with its dashes: "--set" or "-j".
    std::string text() const;
};

/// Options and operands of one command, parsed from its words.
class Arguments {
  public:
    /// Parses the words of a command; `options` describes the options it accepts. Accepts "--name value",
    /// "--name=value", "-j 4" and "-j4"; the word "--" ends the options. Throws CommandError (usage) with one
    /// line that names the wrong word and the most similar option.
    static Arguments parse(std::span<const std::string> words, std::span<const OptionSpec> options);

    bool has(std::string_view option) const;
    std::optional<std::string> value(std::string_view option) const;
    std::vector<std::string> values(std::string_view option) const;
    /// Returns the given options that set a scenario key, as pairs of key and option name, in the order
    /// given.
    const std::vector<std::pair<std::string_view, std::string_view>>& shorts() const { return m_shorts; }
    /// Returns the language in which the command writes its output.
    const Language& language() const { return *m_language; }
    const ReadingStyle& style() const { return styleOf(*m_language); }
    void speak(const Language& language) { m_language = &language; }
    /// Replaces the value of an option that may be given only once.
    void replaceValue(std::string_view option, std::string value);
    const std::vector<std::string>& operands() const { return m_operands; }

    /// Returns the words of an option whose value is a list separated by commas, each word once; empty
    /// without the option. Throws CommandError (usage) for a word that is not in `known`. `pattern` is the
    /// text of this error, with placeholders for the list, the wrong word and the known words.
    std::vector<std::string> listed(std::string_view option, std::span<const std::string_view> known,
                                    const char* pattern) const;

    /// Throws CommandError (usage) if both --json and "-o -" are given, because both print to standard
    /// output.
    void checkOnePrinted() const;

    /// Returns the command line as a shell accepts it, quoted where necessary, operands first. Leaves out the
    /// options named in `without`.
    std::string shellText(std::span<const std::string_view> without) const;
    /// Returns only the options as a shell accepts them, leaving out the options named in `without`.
    std::string optionsText(std::span<const std::string_view> without) const;

    /// Returns the whole number given to an option, or `fallback` without the option. Throws CommandError
    /// (usage) if the value is not a whole number from `low` to `high`.
    long number(std::string_view option, long fallback, long low, long high) const;

  private:
    // Pairs of option name (OptionSpec::name) and value, in the order given.
    std::vector<std::pair<std::string_view, std::string>> m_options;
    std::vector<std::string_view> m_switches;  // names of the given options that take no value
    std::vector<std::pair<std::string_view, std::string_view>> m_shorts;
    std::vector<std::string> m_operands;
    const Language* m_language = &languages[0];
};

/// Splits a line into words as a shell does; the inverse of Arguments::shellText().
std::vector<std::string> shellWords(std::string_view line);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line sorted into options and operands.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/languages.h"

namespace drillwave {

/// One option of a command, "--set KEY=VALUE" or "-j N".
struct OptionSpec {
    std::string_view name;   ///< "set", or a single letter
    std::string_view value;  ///< what it takes, for the help; empty for a switch
    std::string_view help;   ///< one line
    enum class Times { once, repeated, list } times = Times::once;  ///< list: takes all KEY=… words after it
    std::string_view sets = {};  ///< the key of a scenario that it is short for: "drill.blows" of --blows

    /// Whether it has two dashes: words, and the axes x and y.
    bool isLong() const;
    /// "--set" or "-j".
    std::string text() const;
};

/// The parsed words of one command.
class Arguments {
  public:
    /// Reads "--name value", "--name=value", "-j 4", "-j4"; "--" ends the options. Throws CommandError
    /// (usage) with one line that names the offending word and the nearest option.
    static Arguments parse(std::span<const std::string> words, std::span<const OptionSpec> options);

    bool has(std::string_view option) const;
    std::optional<std::string> value(std::string_view option) const;
    std::vector<std::string> values(std::string_view option) const;
    /// The options that are short for a key: the key and the option, in the order given.
    const std::vector<std::pair<std::string_view, std::string_view>>& shorts() const { return m_shorts; }
    /// The language of the command's output.
    const Language& language() const { return *m_language; }
    const ReadingStyle& style() const { return styleOf(*m_language); }
    void speak(const Language& language) { m_language = &language; }
    /// Replaces the value of an option that is given once.
    void replaceValue(std::string_view option, std::string value);
    const std::vector<std::string>& operands() const { return m_operands; }

    /// Returns the words of an option that takes a list with commas, each once; none without the option. For
    /// a word that is not known, throws CommandError (usage) with `pattern` about list, word and known words.
    std::vector<std::string> listed(std::string_view option, std::span<const std::string_view> known,
                                    const char* pattern) const;

    /// Throws CommandError (usage) where --json and -o - would both print to standard output.
    void checkOnePrinted() const;

    /// The words again as a shell takes them, operands first, without the options named.
    std::string shellText(std::span<const std::string_view> without) const;
    /// Returns the text of only the options.
    std::string optionsText(std::span<const std::string_view> without) const;

    /// Returns the whole number given to an option, or `fallback`. Throws CommandError (usage) when it is
    /// none or out of range.
    long number(std::string_view option, long fallback, long low, long high) const;

  private:
    std::vector<std::pair<std::string_view, std::string>> m_options;  // names of specs, in the order given
    std::vector<std::string_view> m_switches;                         // of these, the ones without a value
    std::vector<std::pair<std::string_view, std::string_view>> m_shorts;
    std::vector<std::string> m_operands;
    const Language* m_language = &languages[0];
};

/// The words of a line as a shell would split it: what Arguments::shellText() put together.
std::vector<std::string> shellWords(std::string_view line);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Exception that ends a command early: an exit code and the lines with the reasons.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

/// Exit codes of the program, listed in §6 of the manual's chapter on commands.
enum class ExitCode : int {
    done = 0,
    internalError = 1,
    usage = 2,
    unreadableInput = 3,
    unwritableOutput = 4,
    invalidScenario = 5,
    unsolvedOrFailed = 6,
    interrupted = 130,
};

/// Exception thrown by commands; main() catches it, prints its lines to stderr and exits with its code.
class CommandError : public std::runtime_error {
  public:
    /// Makes an error with one line, which is printed after the name of the command.
    CommandError(ExitCode code, const Message& line)
        : std::runtime_error(line.text()), m_code(code), m_messages{line}, m_isLocated(false) {}
    /// Beginning of each line of an error with several lines.
    enum class Begin {
        withPlace,   ///< a position, "file:line:column: …"; lines are printed unchanged
        withOption,  ///< an option, "--set x: …"; lines are printed after the name of the command
    };
    CommandError(ExitCode code, std::vector<Message> problems, Begin begin = Begin::withPlace)
        : std::runtime_error("problems in the input"),
          m_code(code),
          m_messages(std::move(problems)),
          m_isLocated(begin == Begin::withPlace) {}

    ExitCode code() const { return m_code; }
    const std::vector<Message>& messages() const { return m_messages; }
    /// Returns the lines of the error in English.
    std::vector<std::string> lines() const {
        std::vector<std::string> lines;
        for (const Message& message : m_messages) lines.push_back(message.text());
        return lines;
    }
    bool isLocated() const { return m_isLocated; }

  private:
    ExitCode m_code;
    std::vector<Message> m_messages;
    bool m_isLocated;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// How a command ends early: an exit code and the lines that say why.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace drillwave {

/// Exit codes of the program (commands §6).
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

/// Thrown by commands, caught in main(), which prints it to stderr.
class CommandError : public std::runtime_error {
  public:
    /// One line, printed behind the name of the command.
    CommandError(ExitCode code, const std::string& line)
        : std::runtime_error(line), m_code(code), m_lines{line}, m_isLocated(false) {}
    /// Where the lines of a report begin.
    enum class Begin {
        withPlace,   ///< "file:line:column: …", printed as they are
        withOption,  ///< "--set x: …", printed behind the name of the command
    };
    CommandError(ExitCode code, std::vector<std::string> problems, Begin begin = Begin::withPlace)
        : std::runtime_error("problems in the input"),
          m_code(code),
          m_lines(std::move(problems)),
          m_isLocated(begin == Begin::withPlace) {}

    ExitCode code() const { return m_code; }
    const std::vector<std::string>& lines() const { return m_lines; }
    bool isLocated() const { return m_isLocated; }

  private:
    ExitCode m_code;
    std::vector<std::string> m_lines;
    bool m_isLocated;
};

}  // namespace drillwave

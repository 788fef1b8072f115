// How a command ends early: an exit code and the lines that say why.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace drillwave {

/// Exit codes of the program (README, "Exit codes").
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

/// Thrown by commands, caught in main(): each line goes to stderr.
class CommandError : public std::runtime_error {
  public:
    CommandError(ExitCode code, std::vector<std::string> lines)
        : std::runtime_error(lines.empty() ? std::string() : lines.front()),
          m_code(code),
          m_lines(std::move(lines)) {}
    CommandError(ExitCode code, const std::string& line)
        : CommandError(code, std::vector<std::string>{line}) {}

    ExitCode code() const { return m_code; }
    const std::vector<std::string>& lines() const { return m_lines; }

  private:
    ExitCode m_code;
    std::vector<std::string> m_lines;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Options of the command `design`, converted to a design study.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/arguments.h"
#include "app/command_error.h"
#include "core/model/design_setup.h"
#include "core/model/scenario.h"
#include "core/study/design/design_study.h"

namespace drillwave {

/// Collector of errors in the options of the command `design`, so that all of them are reported together.
class DesignFaults {
  public:
    void add(ExitCode code, const Message& line) { m_faults.emplace_back(code, line); }
    /// Throws CommandError with all errors that were added, and with the smallest of their exit codes; does
    /// nothing without errors.
    void check() const;

  private:
    std::vector<std::pair<ExitCode, Message>> m_faults;
};

/// Returns true if a word is an objective such as "min:thrust@q95", and therefore a further value of --aim
/// instead of a file name.
bool isAimWord(const std::string& word);

/// Returns the design study given by the options. For options that are not given, the settings of the
/// scenario file (`setup`) are used. With --draws, the uncertain inputs of `setup` are not used. `base` is
/// the scenario. Errors are added to `faults`.
DesignStudy designStudyOf(const Arguments& arguments, const Scenario& base, const DesignSetup& setup,
                          DesignFaults& faults);

}  // namespace drillwave

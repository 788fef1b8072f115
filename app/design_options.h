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

/// Collector of errors in the options of `design`, so that they are reported together.
class DesignFaults {
  public:
    void add(ExitCode code, const Message& line) { m_faults.emplace_back(code, line); }
    /// Throws CommandError with all errors that were added; does nothing without errors. The exit code is the
    /// smallest of theirs.
    void check() const;

  private:
    std::vector<std::pair<ExitCode, Message>> m_faults;
};

/// Returns true if an operand is another word of --aim, such as "min:thrust@q95", rather than a file name.
bool isAimWord(const std::string& word);

/// Returns the design study given by the options. `base` is the scenario, and `setup` (from the scenario
/// file) replaces each option that is not given, except that --draws also replaces its uncertain inputs. Adds
/// errors to `faults`.
DesignStudy designStudyOf(const Arguments& arguments, const Scenario& base, const DesignSetup& setup,
                          DesignFaults& faults);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Options of `design`, read from their words.
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

/// Lines on what is wrong, of all options together.
class DesignFaults {
  public:
    void add(ExitCode code, const Message& line) { m_faults.emplace_back(code, line); }
    /// Throws CommandError with all of them, where there are any; the code is that of the least number.
    void check() const;

  private:
    std::vector<std::pair<ExitCode, Message>> m_faults;
};

/// Whether an operand is a further word of --aim, and not FILE: "min:thrust@q95".
bool isAimWord(const std::string& word);

/// Reads all options on top of a scenario. The set-up of the file stands for each option that is not given;
/// --draws also replaces its uncertain inputs. Adds errors to the faults.
DesignStudy designStudyOf(const Arguments& arguments, const Scenario& base, const DesignSetup& setup,
                          DesignFaults& faults);

}  // namespace drillwave

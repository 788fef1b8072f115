// SPDX-License-Identifier: GPL-3.0-or-later
// Option --with of the command `report`: studies to include, checked before the computation starts.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/interruption.h"
#include "core/report/report_studies.h"
#include "core/study/design/design_study.h"
#include "core/study/drilling/drilling_study.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the description of the option --with, which adds studies to a report.
OptionSpec reportStudiesSpec();

/// Studies to include in the report on a scenario, with the settings of the scenario file.
class ReportStudyPlan {
  public:
    /// Reads and checks the studies of --with; `path` names the scenario in messages. Throws CommandError
    /// (usage) for an unknown study. Throws CommandError (invalid scenario) if the file's settings are
    /// missing or wrong for a study. Throws CommandError (unsolved) if many blows would take too much work.
    ReportStudyPlan(const Arguments& arguments, const ScenarioDocument& document, std::string path);

    /// Computes the studies requested with --with and returns their results. Throws CommandError: unsolved,
    /// if a study has no result; interrupted.
    ReportStudies run(const Interruption& interruption) const;

  private:
    std::shared_ptr<const DrillingResult> drilling(const Interruption& interruption) const;
    std::shared_ptr<const DesignReport> design(const Interruption& interruption) const;

    Scenario m_scenario;
    std::string m_path;  // name of the scenario in messages
    const ReadingStyle& m_style;
    int m_jobs;
    std::optional<DrillingSettings> m_drilling;  // settings of continuous drilling; empty if not requested
    std::optional<DesignStudy> m_design;         // design study; empty if not requested
};

}  // namespace drillwave

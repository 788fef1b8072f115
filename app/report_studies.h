// SPDX-License-Identifier: GPL-3.0-or-later
// `report --with`: the studies that the report contains, checked before anything is computed.
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

/// --with, for the table of options.
OptionSpec reportStudiesSpec();

/// Studies of a scenario with the settings of its file.
class ReportStudyPlan {
  public:
    /// Throws CommandError: usage for an unknown study; invalid scenario if the file has no settings for a
    /// study or the study refuses them; unsolved if many blows would take too much work.
    ReportStudyPlan(const Arguments& arguments, const ScenarioDocument& document, std::string path);

    /// Computes the studies. Throws CommandError: unsolved; interrupted.
    ReportStudies run(const Interruption& interruption) const;

  private:
    std::shared_ptr<const DrillingResult> drilling(const Interruption& interruption) const;
    std::shared_ptr<const DesignReport> design(const Interruption& interruption) const;

    Scenario m_scenario;
    std::string m_path;  // name of the scenario in messages
    const ReadingStyle& m_style;
    int m_jobs;
    std::optional<DrillingSettings> m_drilling;  // settings, if continuous drilling is requested
    std::optional<DesignStudy> m_design;         // if it is wanted
};

}  // namespace drillwave

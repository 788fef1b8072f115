// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_studies.h"

#include "app/command_error.h"
#include "app/design_options.h"
#include "app/design_run.h"
#include "app/drill_options.h"
#include "app/input_text.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "core/report/design_report.h"
#include "core/study/drilling/quick_march.h"

namespace drillwave {

namespace {

/// Returns the settings of many blows. Throws CommandError.
DrillingSettings drillingOf(const Scenario& scenario, const std::string& path, const ReadingStyle& style) {
    const DrillingSettings settings = drillingSettingsOf(scenario);
    refuseDrill(drillingRefusals(scenario, settings), path);
    const double work = drillingWork(scenario, settings, {});
    if (work <= mostDrillingWork) return settings;
    throw CommandError(
        ExitCode::unsolvedOrFailed,
        Message(translatable("--with drill: %1 blows take about %2, more than a report may; set fewer blows "
                             "(drill.blows), or use `drillwave drill --work-limit`"),
                {std::to_string(settings.blows), style.quantity(work / workOfSecond, Quantity::time, 2)}));
}

/// Returns the study of the block `design`. Throws CommandError.
DesignStudy designOf(const Arguments& arguments, const ScenarioDocument& document, const std::string& path) {
    if (document.design.uncertain.empty())
        throw CommandError(
            ExitCode::invalidScenario,
            about(inputName(path), translatable("--with design needs a block `design` with its list "
                                                "`uncertain`; see `drillwave help files`")));
    DesignFaults faults;
    DesignStudy study = designStudyOf(arguments, document.scenario, document.design, faults);
    faults.check();
    return study;
}

}  // namespace

OptionSpec reportStudiesSpec() {
    return {"with", "drill,design",
            "add studies to the report: drill (consecutive blows), design (best design, from the block "
            "`design` of FILE)"};
}

ReportStudyPlan::ReportStudyPlan(const Arguments& arguments, const ScenarioDocument& document,
                                 std::string path)
    : m_scenario(document.scenario),
      m_path(std::move(path)),
      m_style(arguments.style()),
      m_jobs(jobsOf(arguments)) {
    for (const std::string& study :
         arguments.listed("with", reportStudyNames,
                          translatable("--with %1: `%2` is not a study of reports; choose from %3"))) {
        if (study == drillStudyName) m_drilling = drillingOf(m_scenario, m_path, m_style);
        if (study == designStudyName) m_design = designOf(arguments, document, m_path);
    }
}

ReportStudies ReportStudyPlan::run(const Interruption& interruption) const {
    ReportStudies studies;
    if (m_drilling) studies.drilling = drilling(interruption);
    if (m_design) studies.design = design(interruption);
    return studies;
}

std::shared_ptr<const DrillingResult> ReportStudyPlan::drilling(const Interruption& interruption) const {
    const DrillingRequest wants{.jobs = m_jobs};
    ProgressBar bar(static_cast<std::uint64_t>(foreseenBlows(*m_drilling, wants)), translatable("blows"),
                    m_style);
    std::uint64_t done = 0;
    auto result = std::make_shared<DrillingResult>(
        studyDrilling(m_scenario, *m_drilling, wants, interruption.token(),
                      [&](long more) { bar.show(done += static_cast<std::uint64_t>(more)); }));
    interruption.check();
    if (result->outcome == DrillingOutcome::notSolved)
        throw CommandError(ExitCode::unsolvedOrFailed, couldNotBeSolved(m_path, result->reason));
    return result;
}

std::shared_ptr<const DesignReport> ReportStudyPlan::design(const Interruption& interruption) const {
    auto report = std::make_shared<DesignReport>();
    report->study = *m_design;
    report->findings = findDesigns(report->study, {m_jobs, m_path, m_style}, interruption);
    return report;
}

}  // namespace drillwave

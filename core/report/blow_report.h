// SPDX-License-Identifier: GPL-3.0-or-later
// Contents of a report on one blow.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/blow.h"
#include "core/report/gap_report.h"
#include "core/report/report_numbers.h"
#include "core/report/report_studies.h"
#include "core/report/thrust_report.h"
#include "core/signal/alignment.h"

namespace drillwave {

/// Input listed in a report: a value given in the scenario, with its source.
struct ReportInput {
    std::string key;                        ///< key in scenario files, such as "rod.length"
    Message label;                          ///< label for people, such as "length L"
    std::string value;                      ///< value as in the file, such as "3.66 m"
    std::optional<double> si;               ///< value in SI units; empty if it is not a number
    Message source;                         ///< source of the value, never empty, such as "assumed typical"
    std::optional<Quantity> quantity = {};  ///< quantity of the value in the form that the scenario uses
    /// Name of the pulse shape or rock law, as shown to people. Empty if the input is a number.
    Message word = {};
    bool operator==(const ReportInput&) const = default;
};

/// Section of the hammer or the string. A section that occurs several times, such as a rod, is listed once.
struct ReportSection {
    std::string key;   ///< key of the section's first occurrence, such as "hammer.1" or "string.2"
    Message place;     ///< position for people, such as "hammer 1" or "2"
    std::string name;  ///< name of the section; may be empty
    int times = 1;     ///< number of times that the section occurs
    std::vector<ReportInput> values;  ///< values given in the file, with the keys of their SectionField
    Message source;                   ///< source of the values, never empty
    bool operator==(const ReportSection&) const = default;
};

/// Lines below the title of a report, as entered by the user; empty ones are omitted.
struct ReportHead {
    std::string project, author, customer;
    std::string date;  ///< date in the format in which it is printed

    bool isEmpty() const { return project.empty() && author.empty() && customer.empty() && date.empty(); }
    bool operator==(const ReportHead&) const = default;
};

/// Table that compares the blow of the report with other blows or with measurements, one row per quantity.
struct ReportComparison {
    /// Headings of the value columns. If the blow of the report has a column, it is the first.
    std::vector<std::string> titles;
    std::vector<ReportRow> rows;
};

/// Contents of a report. Apart from head, other blows and measured signals, they depend only on the scenario,
/// not on when, where or how fast the report was made.
struct BlowReport {
    Blow blow;             ///< blow, solved exactly with histories, stresses and the margin of the feed force
    ReportHead head = {};  ///< lines below the title, as requested
    ReportComparison others = {};  ///< comparison with the other blows in the report; empty without any
    /// Measured signals that the pictures of the report show with the computed curves; only for a scenario
    /// with units.
    std::vector<MeasuredSignal> measured = {};
    ReportComparison misfits = {};  ///< differences between each measured signal and the computed one
    std::string scenarioText;       ///< scenario file that reproduces the scenario
    std::vector<Message> recordRemarks = {};  ///< warnings about the quality of a measured blow
    std::vector<ReportInput> inputs;          ///< values of the scenario, in the order of a scenario file
    std::vector<ReportSection> sections;      ///< sections of hammer and string; empty for a uniform rod
    /// Study of all gaps; empty if e does not depend on the gap or is not known for all gaps.
    std::optional<GapStudy> gap;
    /// Reason, as a sentence, why the report has no study of all gaps (`gap`). Empty if it has one, and for a
    /// drill string.
    Message gapProblem;
    /// Report of the required feed force, with its curve over a parameter; empty if the scenario has no blow
    /// frequency.
    std::optional<ThrustReport> thrust;
    Message thrustProblem;  ///< reason why there is no study of the feed force; empty if there is one
    /// Studies added on request, such as a sequence of blows or a design study.
    ReportStudies studies = {};
};

/// Returns the report of a valid scenario, without scenarioText, inputs and sections. Solves the blow, and
/// studies all gaps and the required feed force at several blow frequencies. A study that needs more than
/// mostPiecesInPassing wave pieces (the solver's unit of work) is omitted; a drill string has no study of the
/// gaps. If the blow is not solved within `limits`, the report has no studies. After a stop request the blow
/// is unsolved or the studies are missing.
BlowReport studyReport(const Scenario& scenario, const std::stop_token& stop = {},
                       const GapProgress& progress = {}, const WorkLimits& limits = {});

}  // namespace drillwave

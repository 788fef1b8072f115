// SPDX-License-Identifier: GPL-3.0-or-later
// Data of a report on one blow.
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

/// One value that the scenario gives.
struct ReportInput {
    std::string key;                        ///< "rod.length"
    Message label;                          ///< "length L"
    std::string value;                      ///< as the file has it: "3.66 m"
    std::optional<double> si;               ///< of a number
    Message source;                         ///< where the value is from, never empty: "assumed typical"
    std::optional<Quantity> quantity = {};  ///< of the value, in the form of the scenario
    Message word = {};                      ///< for people, of the name of a shape or a law; empty otherwise
    bool operator==(const ReportInput&) const = default;
};

/// A section of a hammer or a string as the file has it, once.
struct ReportSection {
    std::string key;                  ///< "hammer.1", "string.2": its first place
    Message place;                    ///< "hammer 1", "2"
    std::string name;                 ///< may be empty
    int times = 1;                    ///< how often it comes
    std::vector<ReportInput> values;  ///< that it gives, by the key of their SectionField
    Message source;                   ///< where they are from, never empty
    bool operator==(const ReportSection&) const = default;
};

/// Lines below the title of a report; empty ones are left out.
struct ReportHead {
    std::string project, author, customer;
    std::string date;  ///< as it is to be read

    bool isEmpty() const { return project.empty() && author.empty() && customer.empty() && date.empty(); }
    bool operator==(const ReportHead&) const = default;
};

/// The blow of the report beside others, quantity by quantity, or beside what was measured.
struct ReportComparison {
    std::vector<std::string> titles;  ///< of the cells of a row: where it has one, that of its own blow first
    std::vector<ReportRow> rows;
};

/// Content of a report. Except for head, other blows and measured signals it does not depend on when, where
/// and how fast it was made.
struct BlowReport {
    Blow blow;                     ///< solved exactly with histories, stresses and margin of the thrust
    ReportHead head = {};          ///< as asked for
    ReportComparison others = {};  ///< other blows of the report; empty without others
    std::vector<MeasuredSignal> measured = {};  ///< signals over the curves of a scenario with units
    ReportComparison misfits = {};              ///< how far each of them is from what is computed
    std::string scenarioText;                   ///< gives its scenario again
    std::vector<Message> recordRemarks = {};    ///< on the quality of a measured blow
    std::vector<ReportInput> inputs;            ///< in the order of a file
    std::vector<ReportSection> sections;        ///< of hammer and string; none for a uniform rod
    std::optional<GapStudy> gap;                ///< where e depends on the gap and is known at all gaps
    Message gapProblem;                         ///< why not, in a sentence, else empty; empty of a string
    std::optional<ThrustReport> thrust;         ///< with study and curve, where blows have a frequency
    Message thrustProblem;                      ///< why there is no study of the feed
    ReportStudies studies = {};                 ///< as asked for
};

/// Solves a valid scenario and, unless that takes more than mostPiecesInPassing, follows it over the gap and
/// the blow frequency: all but scenarioText, inputs and sections. A string has no curve over the gap. Where
/// the blow is not solved, within `limits`, there is nothing else. A stop leaves it unsolved, or without
/// studies.
BlowReport studyReport(const Scenario& scenario, const std::stop_token& stop = {},
                       const GapProgress& progress = {}, const WorkLimits& limits = {});

}  // namespace drillwave

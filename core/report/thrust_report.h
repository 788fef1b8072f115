// SPDX-License-Identifier: GPL-3.0-or-later
// Report of the required feed force as text, JSON and CSV.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/report/report_text.h"
#include "core/report/study.h"
#include "core/study/rows/sweep_axis.h"
#include "core/study/thrust/thrust_curve.h"
#include "core/study/thrust/thrust_study.h"
#include "core/text/message.h"

namespace drillwave {

/// Parameter with its values, and the required feed force at each of them.
struct ThrustAlong {
    SweepAxis axis;
    ThrustCurve curve;
};

/// Contents of the report of the required feed force.
struct ThrustReport {
    Scenario scenario;
    ThrustStudy study = {};
    std::optional<ThrustAlong> along = {};
    double runTime = 0;  ///< computing time [s]
};

/// Returns the study behind `drillwave thrust` and the page Feed: the required feed force compared with the
/// installed one (theory §10).
const Study& thrustStudy();

/// Returns the figure of a report that has a curve along a parameter. For each case, a strip runs from the
/// required feed force to the one that returns the rod in time. Shaded layers show the ratings of the feed
/// force, such as "not enough". A line shows the effective feed force.
StudyFigure thrustFigure(const ThrustReport& report);

/// Returns a table of the required feed force: headings, then one line for each case of ThrustCase that is
/// known, such as this blow or rigid rock. Requires a study with a result.
TextGrid needsGrid(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// Returns sentences on the required feed force: the estimate, the benefit of more force, the margin, and the
/// share of gaps for which the force is enough. `shareCovered` is that share (ThrustStudy::shareFull); empty
/// if it is not known.
std::vector<Message> thrustSentences(const Scenario& scenario, const FeedEstimate& feed,
                                     const std::optional<double>& shareCovered,
                                     const ReadingStyle& style = plainStyle());

/// Returns the report as text for people, with sentences and tables.
std::string thrustText(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// Returns the report as one JSON object in SI units. It contains `scenarioText`, the text of a scenario
/// file, from which the report can be reproduced.
std::string thrustJson(const ThrustReport& report, const std::string& scenarioText);

/// Default number of values of a range over which the required feed force is computed.
inline constexpr std::uint64_t customaryThrustPoints = 101;

/// Returns all values of an axis in SI units.
std::vector<double> valuesOf(const SweepAxis& axis);

/// Returns one CSV row for each point. First comes the parameter in the unit of its axis. The required feed
/// forces f I0 (1 + e) [N] of the four cases (ThrustCase) follow. Next, with the suffix `_undamped`, are the
/// forces that return an undamped rod in time, f I0 (1 + 2e) [N]. The effective feed force [N], its margin
/// over the largest required one, and the gap at the blow [m], computed from the e of this blow, follow. The
/// last columns are n_b (round trips of a wave between blows) and the verdict. Unknown values are empty
/// cells.
std::string thrustCsv(const ThrustAlong& along);

}  // namespace drillwave

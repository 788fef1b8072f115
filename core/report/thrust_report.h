// SPDX-License-Identifier: GPL-3.0-or-later
// Required feed force with all that is reported about it: text, JSON and CSV.
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

/// A parameter, its values, and the needs at each.
struct ThrustAlong {
    SweepAxis axis;
    ThrustCurve curve;
};

/// All that is reported.
struct ThrustReport {
    Scenario scenario;
    ThrustStudy study = {};
    std::optional<ThrustAlong> along = {};
    double runTime = 0;  ///< [s]
};

/// `drillwave thrust` and the page Feed: the required feed force, and how the installed one compares (theory
/// §10).
const Study& thrustStudy();

/// Returns the required forces along a parameter as strips, the states of the feed as layers, and the feed,
/// of a report that has them.
StudyFigure thrustFigure(const ThrustReport& report);

/// Returns the required feed of the four cases as text: a line of titles, then a line for each case. Requires
/// a study.
TextGrid needsGrid(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// The estimate in words, then what the cases say of it. `shareCovered` is ThrustStudy::shareFull, where
/// known.
std::vector<Message> thrustSentences(const Scenario& scenario, const FeedEstimate& feed,
                                     const std::optional<double>& shareCovered,
                                     const ReadingStyle& style = plainStyle());

/// Sentences and tables for people.
std::string thrustText(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// One JSON object, SI; the text gives the scenario again.
std::string thrustJson(const ThrustReport& report, const std::string& scenarioText);

/// Points of a range for which no number was given.
inline constexpr std::uint64_t customaryThrustPoints = 101;

/// All values of the axis, SI.
std::vector<double> valuesOf(const SweepAxis& axis);

/// One row for each point: the parameter in the unit of its axis; of each case f I0 (1+e) and, `_undamped`,
/// f I0 (1+2e) [N]; then the effective force, the margin over the largest need, the gap at the blow by the e
/// of the blow [m], n_b and the verdict. Where something is not known, its cell is empty.
std::string thrustCsv(const ThrustAlong& along);

}  // namespace drillwave

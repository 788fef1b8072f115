// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_study.h"

#include <cassert>
#include <cmath>

#include "core/blow/feed_estimate.h"

namespace drillwave {
namespace {

// A scenario may be large, and each look at the study is a copy of it.
constexpr std::size_t pointsAtATime = 8;

}  // namespace

std::string axisText(const StudyRange& range) {
    return range.text() + range.tail();
}

SweepAxis axisOf(const StudyRange& range) {
    const ParsedAxis parsed = parseAxis(axisText(range), customaryThrustPoints);
    assert(parsed.problem.isEmpty());
    return parsed.axis;
}

ThrustAnswer ThrustStudent::answer(const ThrustQuestion& question, const StudyFeed<ThrustAnswer>& feed) {
    ThrustAnswer found{
        .scenario = question.scenario, .along = {}, .here = {}, .problem = thrustProblem(question.scenario)};
    if (!found.problem.isEmpty()) return found;
    found.along.axis = axisOf(question.range);
    const Parameter& parameter = *question.range.parameter;
    const double value = parameter.value(question.scenario).value_or(std::nan(""));
    found.here = thrustPoint(question.scenario, value, m_finder, feed.stop);
    const std::size_t wanted = found.along.axis.count;
    found.along.curve = thrustAlong(question.scenario, parameter, valuesOf(found.along.axis), m_finder,
                                    feed.stop, [&](const ThrustCurve& soFar) {
                                        feed.tell({soFar.points.size(), wanted});
                                        if (soFar.points.size() % pointsAtATime != 0) return;
                                        found.along.curve = soFar;
                                        feed.show(found);
                                    });
    return found;
}

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_question.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/numeric/available_threads.h"
#include "core/study/rows/axis_scenario.h"

namespace drillwave {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// A map that is expected to take no longer is drawn once, complete.
constexpr milliseconds quick{120};
/// The first picture of another one comes so early, further ones now and then: what is handed over of a
/// million points takes some milliseconds.
constexpr milliseconds firstPicture{60}, betweenPictures{150};
constexpr int restAfterCopy = 5;  // in the time that it took
/// While values are dragged the picture of one value may take so long before it makes room for the next.
constexpr milliseconds patience{80};

bool isSameAxis(const SweepAxis& a, const SweepAxis& b) {
    return a.parameter == b.parameter && a.unit == b.unit && a.kind == b.kind && a.start == b.start &&
           a.stop == b.stop && a.count == b.count;
}

/// Returns the scenario without the values that the map sets. A map over the duration keeps all values: with
/// a given mean force, the impulse follows from them.
Scenario background(const MapStudy& study) {
    const std::array axes{study.x, study.y};
    const auto isDuration = [](const SweepAxis& axis) { return axis.key() == "pulse.duration"; };
    Scenario scenario = study.base;
    if (std::ranges::none_of(axes, isDuration))
        scenario = AxisScenario(study.base, axes).set(std::array{study.x.start, study.y.start});
    scenario.title.clear();
    return scenario;
}

/// Shows a map while it grows, and ends it when another one waits.
class Growth {
  public:
    Growth(const MapQuestion& question, const StudyFeed<MapReport>& feed, MapReport& report)
        : m_question(question), m_feed(feed), m_report(report) {}

    /// False to end.
    bool follow(const MapGrid& soFar) {
        const Clock::time_point now = Clock::now();
        if (now - m_reported > milliseconds(20)) {
            m_feed.tell({soFar.done(), soFar.size()});
            m_reported = now;
        }
        const double share = double(soFar.done()) / double(soFar.size());
        const bool isQuick = now - m_start < quick * share;
        if (soFar.stride() == 0 || soFar.isComplete() || isQuick) return true;
        if (now >= m_nextPicture) {
            m_report.grid = soFar;
            m_feed.show(m_report);
            const Clock::time_point shown = Clock::now();
            m_nextPicture = shown + std::max<Clock::duration>(betweenPictures, restAfterCopy * (shown - now));
        }
        const bool isWaitedFor = m_question.newest && *m_question.newest != m_question.number;
        return !(isWaitedFor && now - m_start > patience);
    }

  private:
    const MapQuestion& m_question;
    const StudyFeed<MapReport>& m_feed;
    MapReport& m_report;
    Clock::time_point m_start = Clock::now();
    Clock::time_point m_reported = m_start;
    Clock::time_point m_nextPicture = m_start + firstPicture;
};

}  // namespace

bool MapQuestion::operator==(const MapQuestion& other) const {
    return isSameAxis(study.x, other.study.x) && isSameAxis(study.y, other.study.y) &&
           study.output.output == other.study.output.output &&
           study.output.units == other.study.output.units && levels == other.levels &&
           background(study) == background(other.study);
}

MapReport answerMap(const MapQuestion& question, const StudyFeed<MapReport>& feed) {
    const int jobs = availableThreads();
    MapReport report{.study = question.study, .grid = {}, .contours = {}, .runTime = 0, .scenarioText = {}};
    std::stop_source ending;
    const std::stop_callback relay(feed.stop, [&ending] { ending.request_stop(); });
    Growth growth(question, feed, report);
    MapGrid grid = solveMap(question.study, jobs, ending.get_token(), [&](const MapGrid& soFar) {
        if (!growth.follow(soFar)) ending.request_stop();
    });
    report.grid = std::move(grid);
    if (!report.grid.isComplete()) return report;
    feed.tell({report.grid.size(), report.grid.size()});
    for (const double level : question.levels)
        report.contours.push_back(contourOf(question.study, report.grid, level, jobs, ending.get_token()));
    return report;
}

}  // namespace drillwave

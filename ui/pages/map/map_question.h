// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the page Map: its question, and the answer while it grows.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/report/map_report.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// A map to be computed.
struct MapQuestion {
    MapStudy study;
    std::vector<double> levels;  ///< in the units of the map
    int number = 0;              ///< of the page's questions
    /// The number of the page's newest question: who sees that it is another one makes room for it.
    std::shared_ptr<const std::atomic<int>> newest;

    /// Whether the answer is the same. The two parameters that vary may have any value, so that dragging a
    /// crosshair makes no new question; the title does not matter.
    bool operator==(const MapQuestion& other) const;
};

/// Throws nothing; a stopped map keeps its points. Feeds a first part within about 100 ms even if blows are
/// slow, and further parts now and then.
MapReport answerMap(const MapQuestion& question, const StudyFeed<MapReport>& feed);

}  // namespace drillwave

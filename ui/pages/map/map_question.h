// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the page Map: its question, and its answer, which is shown while it is computed.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/report/map_report.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// Input of a map: the study of a result over two parameters, with the values of its contours.
struct MapQuestion {
    MapStudy study;
    std::vector<double> levels;  ///< values of the contours, in the units of the map
    int number = 0;              ///< number of this question on its page
    /// Number of the latest question that the page has asked. The study of an earlier question reads it and
    /// ends early. nullptr if the study never ends early.
    std::shared_ptr<const std::atomic<int>> newest;

    /// Returns whether both questions have the same answer. Title and present values of the two varied
    /// parameters may differ, so that dragging them starts no new study.
    bool operator==(const MapQuestion& other) const;
};

/// Returns the map of a question. It shows a first part within about 100 ms even if blows are slow, and
/// further parts later. After a stop it returns the points computed so far. Throws nothing.
MapReport answerMap(const MapQuestion& question, const StudyFeed<MapReport>& feed);

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// A pinned result: the scenario with its bytes, and its blow.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/archive/kept_runs.h"
#include "ui/job/solved_blow.h"

namespace drillwave {

struct Run {
    int number = 0;              ///< 0 … mostRuns − 1: its letter, colour and dash
    QString name;                ///< what changed, in words
    ScenarioDocument contents;   ///< what reverting brings back
    SolvedBlowPtr blow;          ///< nullptr until it is solved; its `problem` says why it could not be
    bool isShown = true;         ///< laid over the plots
    std::optional<double> kept;  ///< the e that its file has, where it is from one
    std::string version = {};    ///< of the program that had solved that

    /// "A".
    QString letter() const { return QString::fromStdString(runLetter(number)); }
    /// "A  k 300 MN/m".
    QString title() const { return letter() + QStringLiteral("  ") + name; }
    bool isSolved() const { return blow && blow->fault.isEmpty(); }
};

/// In the order in which they were pinned; never changed once made, so that other threads may look at it.
using RunList = std::vector<Run>;
using RunListPtr = std::shared_ptr<const RunList>;

}  // namespace drillwave

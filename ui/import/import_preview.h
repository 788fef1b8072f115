// SPDX-License-Identifier: GPL-3.0-or-later
// What an import would give, computed away from the window's thread.
#pragma once

#include <QPolygonF>
#include <QString>
#include <memory>
#include <optional>

#include "core/blow/thinned_blow.h"
#include "core/signal/samples.h"
#include "core/signal/signal_quality.h"
#include "core/signal/signal_recipe.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// All that the result depends on.
struct ImportQuestion {
    QString path;
    SampleSource source;
    SignalRecipe recipe;
    Scenario scenario = {};  ///< that a blow is for: of which e is told
    bool isThinned = false;  ///< to thinningError, where the user has chosen no number of points
    bool operator==(const ImportQuestion&) const = default;
};

/// Its answer: the signal, and the whole record to be drawn behind it.
struct ImportPreview {
    QString problem;      ///< why the file could not be read; then there is nothing else
    ShapedSignal signal;  ///< may have a problem of its own
    std::optional<ThinningEffect> effect = {};  ///< of a blow
    QPolygonF record;         ///< time [s], force [N], zero line off: all of it, thinned to what can be seen
    std::size_t samples = 0;  ///< of the record
    std::size_t skipped = 0;  ///< rows
    std::size_t firstSkipped = 0;          ///< line
    double skippedTime = 0;                ///< longest pause that skipped rows leave [s]
    bool hasNulTail = false;               ///< NUL bytes ended the table
    RecordSpan time;                       ///< from the first to the last sample [s]
    std::optional<RecordSpan> aroundPeak;  ///< spanAroundPeak()
    double signOfPeak = 1;                 ///< of the record, as in the table
    std::vector<SignalRemark> remarks;     ///< on the quality of the record
    std::optional<double> estimatedRate;   ///< of times that are too coarse [Hz]
    bool hasBothSigns = false;             ///< some of it lies beyond the zero line, seen from the peak
};

/// Remembers the samples of the last source, so that each file is read once for all that is made of it.
class ImportStudy {
  public:
    /// On the job's thread, one call at a time.
    ImportPreview operator()(const ImportQuestion& question, const StudyFeed<ImportPreview>& feed);

  private:
    struct Kept {
        QString path;
        SampleSource source;
        Samples samples;
    };
    std::shared_ptr<Kept> m_kept = std::make_shared<Kept>();
};

}  // namespace drillwave

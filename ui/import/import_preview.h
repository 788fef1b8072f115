// SPDX-License-Identifier: GPL-3.0-or-later
// Result of an import, computed away from the window's thread.
#pragma once

#include <QPlainTextEdit>
#include <QPolygonF>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/blow/thinned_blow.h"
#include "core/signal/samples.h"
#include "core/signal/signal_quality.h"
#include "core/signal/signal_recipe.h"
#include "ui/job/study_job.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class PlotWidget;
class UnitChoice;

/// All that the result depends on.
struct ImportQuestion {
    QString path;
    SampleSource source;
    SignalRecipe recipe;
    Scenario scenario = {};  ///< of the blow, for its e
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

// The first lines of a file that is imported, with their numbers.

/// To be read only; a few lines high.
class FileLines : public QPlainTextEdit {
    Q_OBJECT

  public:
    explicit FileLines(QWidget* parent = nullptr);

    /// Goes to the first sample, whose line counts from 1, and marks it.
    void present(const std::vector<std::string>& lines, std::size_t firstSample);
};

// The preview of an import: the whole record faintly, and what is taken of it over it.

/// Lives as a child of the plot.
class ImportPlot : public StudyFrame {
    Q_OBJECT

  public:
    /// The units must outlive it.
    ImportPlot(PlotWidget* plot, const UnitChoice& units);

    /// `shift` is the time of the record at which the signal's own time begins [s].
    void present(const ImportPreview& preview, double shift, const QString& axis);
    /// Between which times of the record one looks [s].
    RecordSpan visibleTimes() const;

  protected:
    void clear() override;
    void restyle() override;
    void setRanges() override;

  private:
    const UnitChoice& m_units;
    QCPGraph* m_record;
    QCPGraph* m_taken;
    double m_timeFactor = 1e6;
    const Unit* m_forceUnit = nullptr;
};

// Sentences about an import.

/// Samples, impulse, peak, points and how far they are from the samples; what was skipped and clipped.
/// Requires a preview without problems.
QString importSummary(const ImportPreview& preview, const UnitChoice& units);

/// How to import, for F1.
QString importHelp();

}  // namespace drillwave

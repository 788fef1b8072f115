// SPDX-License-Identifier: GPL-3.0-or-later
// Preview of an import, computed outside the window's thread.
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

/// All choices in the import dialog that affect the imported signal.
struct ImportQuestion {
    QString path;
    SampleSource source;
    SignalRecipe recipe;
    Scenario scenario = {};  ///< scenario of the imported blow, for computing its e
    /// Whether to leave out as many samples as the permitted error thinningError allows. True if the user has
    /// not chosen a number of points.
    bool isThinned = false;
    bool operator==(const ImportQuestion&) const = default;
};

/// Preview of an import, computed for an ImportQuestion: the imported signal, and the whole record, which is
/// drawn in a faint colour.
struct ImportPreview {
    QString problem;      ///< why the file cannot be read, then all else is empty; empty on success
    ShapedSignal signal;  ///< imported signal; has a `problem` of its own
    /// Effect of leaving out samples on the blow; only for hammer blows.
    std::optional<ThinningEffect> effect = {};
    /// Points of the whole record for the plot: time [s] and force [N] relative to the zero line. They are
    /// reduced to what the plot can show.
    QPolygonF record;
    std::size_t samples = 0;               ///< number of samples in the record
    std::size_t skipped = 0;               ///< number of skipped rows
    std::size_t firstSkipped = 0;          ///< line number of the first skipped row
    double skippedTime = 0;                ///< longest gap left by skipped rows [s]
    bool hasNulTail = false;               ///< the table was ended by NUL bytes
    RecordSpan time;                       ///< times of the first and the last sample [s]
    std::optional<RecordSpan> aroundPeak;  ///< times around the peak, spanAroundPeak() [s]
    double signOfPeak = 1;                 ///< sign of the peak in the table: 1 or −1
    std::vector<SignalRemark> remarks;     ///< remarks on the quality of the record
    std::optional<double> estimatedRate;   ///< sample rate estimated from times that are too coarse [Hz]
    /// True if some samples lie on the other side of the zero line than the peak.
    bool hasBothSigns = false;
};

/// Function object that computes import previews. It keeps the samples of the last file, so that each file is
/// read only once.
class ImportStudy {
  public:
    /// Computes the preview for the present choices of the import dialog. Called in the job's thread, one
    /// call at a time.
    ImportPreview operator()(const ImportQuestion& question, const StudyFeed<ImportPreview>& feed);

  private:
    struct Kept {
        QString path;
        SampleSource source;
        Samples samples;
    };
    std::shared_ptr<Kept> m_kept = std::make_shared<Kept>();
};

// View of the first lines of an imported file, with line numbers.

/// Read-only view of the first lines of an imported file, a few lines high.
class FileLines : public QPlainTextEdit {
    Q_OBJECT

  public:
    explicit FileLines(QWidget* parent = nullptr);

    /// Shows lines of a file, scrolls to the first sample and marks it. `firstSample` is the number of its
    /// line, counted from 1.
    void present(const std::vector<std::string>& lines, std::size_t firstSample);
};

// Plot of an import: the whole record in faint colour, and the imported part over it.

/// Plot of the record in the import dialog, with the part to be imported. It is a child object of the plot
/// widget.
class ImportPlot : public StudyFrame {
    Q_OBJECT

  public:
    /// Makes an empty plot for the preview of an import. `units` must outlive it.
    ImportPlot(PlotWidget* plot, const UnitChoice& units);

    /// Shows the preview of an import. `shift` is the time in the record at which the imported signal starts
    /// [s]; `axis` is the label of the force axis.
    void present(const ImportPreview& preview, double shift, const QString& axis);
    /// Returns the first and the last time of the record that are visible in the plot [s].
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

// Sentences that describe an import.

/// Returns a summary: impulse, peak, numbers of samples and points, deviation from the samples, skipped and
/// clipped samples. Requires a preview without problems.
QString importSummary(const ImportPreview& preview, const UnitChoice& units);

/// Returns the help text on importing, shown by F1.
QString importHelp();

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The preview of an import: the whole record faintly, and what is taken of it over it.
#pragma once

#include "ui/import/import_preview.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class PlotWidget;
class UnitChoice;

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

}  // namespace drillwave

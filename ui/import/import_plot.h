// SPDX-License-Identifier: GPL-3.0-or-later
// The preview of an import: the whole record faintly, and what is taken of it over it.
#pragma once

#include <QObject>

#include "ui/import/import_preview.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

class QCPGraph;

namespace drillwave {

class PlotWidget;
class UnitChoice;

/// Lives as a child of the plot.
class ImportPlot : public QObject {
    Q_OBJECT

  public:
    /// The units must outlive it.
    ImportPlot(PlotWidget* plot, const UnitChoice& units);

    /// `shift` is the time of the record at which the signal's own time begins [s].
    void present(const ImportPreview& preview, double shift, const QString& axis);
    void showNothing(const QString& message);
    void fit();
    /// Between which times of the record one looks [s].
    RecordSpan visibleTimes() const;

  private:
    void setStyle(const PlotStyle& style);

    PlotWidget* m_plot;
    const UnitChoice& m_units;
    QCPGraph* m_record;
    QCPGraph* m_taken;
    PlotMessage* m_message;
    FittedView* m_view;
    double m_timeFactor = 1e6;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of all legends of a plot, which hide and show their curves.
#pragma once

#include <qcustomplot.h>

#include <QList>
#include <QPointF>

namespace drillwave {

/// Returns the curves that have an entry in a legend of the plot, in the order in which they were added. Only
/// these can be read and hidden.
QList<QCPAbstractPlottable*> namedCurves(const QCustomPlot& plot);

/// Returns the curves with a legend entry that are visible and have at least one point.
QList<QCPAbstractPlottable*> visibleCurves(const QCustomPlot& plot);

/// Returns the curve whose legend entry is at a point of the plot [px]; nullptr if there is none.
QCPAbstractPlottable* legendEntryAt(const QCustomPlot& plot, QPointF point);

/// Arranges the entries of a legend in as many columns as fit into `width` [px], at least 1 and at most
/// `mostColumns`. Each column is as wide as its widest entry.
void wrapLegend(QCPLegend& legend, double width, int mostColumns);

/// Fades and strikes out the legend entries of hidden curves, so that a click can show these curves again.
/// Restores the entries of visible curves.
void markHiddenCurves(QCustomPlot& plot);

/// Guard that hides the legend entries of hidden curves while it exists. Used for drawing a plot to a file,
/// in which nobody can show these curves again.
class WithoutHiddenEntries {
  public:
    explicit WithoutHiddenEntries(QCustomPlot& plot);
    ~WithoutHiddenEntries();
    WithoutHiddenEntries(const WithoutHiddenEntries&) = delete;
    WithoutHiddenEntries& operator=(const WithoutHiddenEntries&) = delete;

  private:
    QList<QCPPlottableLegendItem*> m_entries;
};

}  // namespace drillwave

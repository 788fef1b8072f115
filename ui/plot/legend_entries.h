// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of all legends of a plot, which hide and show their curves.
#pragma once

#include <qcustomplot.h>

#include <QList>
#include <QPointF>

namespace drillwave {

/// Returns the curves in a legend, in the order in which they were added: those that users can name.
QList<QCPAbstractPlottable*> namedCurves(const QCustomPlot& plot);

/// Returns the named curves that are shown now and have a point.
QList<QCPAbstractPlottable*> visibleCurves(const QCustomPlot& plot);

/// The curve whose legend entry is at a point of the plot, or nullptr.
QCPAbstractPlottable* legendEntryAt(const QCustomPlot& plot, QPointF point);

/// Arranges as many entries side by side as have room in a width [px], at most so many: in columns, each as
/// wide as the widest of its entries.
void wrapLegend(QCPLegend& legend, double width, int mostColumns);

/// Fades and strikes out the entries of hidden curves. Changes nothing where nothing has changed.
void markHiddenCurves(QCustomPlot& plot);

/// While it lives, the entries of hidden curves are not drawn: on paper nobody can show them again.
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

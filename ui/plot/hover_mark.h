// SPDX-License-Identifier: GPL-3.0-or-later
// A mark on the curve point nearest to the mouse pointer, with a label.
#pragma once

#include <qcustomplot.h>

#include <QLocale>
#include <QPointer>
#include <QString>
#include <optional>

#include "ui/plot/curve_meaning.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Point on a visible curve: x and y in the units of the axes, and its pixel position on the plot.
struct CurvePoint {
    QCPAbstractPlottable* curve = nullptr;
    double x = 0;
    double y = 0;
    QPointF pixel;
};

/// Returns the point nearest to `pixel` on the visible curves that have a legend entry; nothing if none is
/// within `tolerance` [px]. Only the points of a graph near the pointer are searched, so that long curves
/// cost no more than short ones.
std::optional<CurvePoint> nearestCurvePoint(const QCustomPlot& plot, QPointF pixel, double tolerance);
/// Returns whether a visible curve or point is within `reach` [px] of a pixel. Includes curves that are in no
/// legend.
bool isOnCurve(const QCustomPlot& plot, QPointF pixel, double reach);

/// Returns a text with the curve's name and the x and y of the point, with their names and units, in three
/// lines.
QString pointText(const CurvePoint& point, const CurveMeaning& meaning, const QLocale& locale);

/// Ring with a label on the layer "overlay". The caller redraws that layer after a change.
class HoverMark {
  public:
    explicit HoverMark(QCustomPlot& plot) : m_plot(plot) {}

    /// Shows the ring at a point of an axis rect [px of the plot], with a label unless `text` is empty. The
    /// caller then redraws the overlay.
    void show(QCPAxisRect& rect, QPointF pixel, const QString& text);
    /// Hides the mark. Returns whether it was shown, so that the overlay must be redrawn.
    bool hide();
    void setStyle(const PlotStyle& style);
    /// Returns the label of the mark; empty while no label is shown.
    QString text() const;

  private:
    void addItems();

    QCustomPlot& m_plot;
    QPointer<QCPItemTracer> m_ring;
    QPointer<QCPItemText> m_label;
    PlotStyle m_style = PlotStyle::forPaper();
};

}  // namespace drillwave

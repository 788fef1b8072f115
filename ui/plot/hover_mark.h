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
/// Returns whether a visible curve or one of its points is within `reach` [px] of a pixel. Curves without a
/// legend entry are included.
bool isOnCurve(const QCustomPlot& plot, QPointF pixel, double reach);

/// Returns the label of a point of a curve in three lines: the name of the curve, and x and y with their
/// names and units.
QString pointText(const CurvePoint& point, const CurveMeaning& meaning, const QLocale& locale);

/// Ring with a label that marks a point of a plot, such as the curve point at the mouse pointer. It is on the
/// layer "overlay", which the caller redraws after a change.
class HoverMark {
  public:
    explicit HoverMark(QCustomPlot& plot) : m_plot(plot) {}

    /// Shows the ring at the point `pixel` [px of the plot] in the axis rect `rect`, with the label `text`
    /// unless this is empty. The caller then redraws the layer "overlay".
    void show(QCPAxisRect& rect, QPointF pixel, const QString& text);
    /// Hides the mark. Returns true if it was visible; the caller must then redraw the overlay.
    bool hide();
    void setStyle(const PlotStyle& style);
    /// Returns the label beside the ring; empty while no label is shown.
    QString text() const;

  private:
    void addItems();

    QCustomPlot& m_plot;
    QPointer<QCPItemTracer> m_ring;
    QPointer<QCPItemText> m_label;
    PlotStyle m_style = PlotStyle::forPaper();
};

}  // namespace drillwave

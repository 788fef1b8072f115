// SPDX-License-Identifier: GPL-3.0-or-later
// The point of a curve next to the pointer, marked and read in words.
#pragma once

#include <qcustomplot.h>

#include <QLocale>
#include <QPointer>
#include <QString>
#include <optional>

#include "ui/plot/curve_meaning.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// A point on a visible curve.
struct CurvePoint {
    QCPAbstractPlottable* curve = nullptr;
    double x = 0;
    double y = 0;
    QPointF pixel;
};

/// Returns the point of a visible named curve nearest to a point of the plot, within `tolerance` pixels.
/// Searches only the points of graphs near the pointer, so long curves cost no more than short ones.
std::optional<CurvePoint> nearestCurvePoint(const QCustomPlot& plot, QPointF pixel, double tolerance);
/// Whether a curve or a point that is drawn, with a name or without, is within so many pixels.
bool isOnCurve(const QCustomPlot& plot, QPointF pixel, double reach);

/// Describes its curve and its numbers in words.
QString pointText(const CurvePoint& point, const CurveMeaning& meaning, const QLocale& locale);

/// A ring and a label on the layer "overlay".
class HoverMark {
  public:
    explicit HoverMark(QCustomPlot& plot) : m_plot(plot) {}

    /// Marks a point [px] of an axis rect, and reads it where there are words. The overlay has to be drawn
    /// again then.
    void show(QCPAxisRect& rect, QPointF pixel, const QString& text);
    /// Returns whether the overlay has to be drawn again.
    bool hide();
    void setStyle(const PlotStyle& style);
    /// The label, empty while there is no mark.
    QString text() const;

  private:
    void addItems();

    QCustomPlot& m_plot;
    QPointer<QCPItemTracer> m_ring;
    QPointer<QCPItemText> m_label;
    PlotStyle m_style = PlotStyle::forPaper();
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// One look for every plot: colours, pens and fonts, on screen (light or dark) and in exported files.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QPen>

class QCPAxisRect;
class QCPLayer;
class QCPLegend;
class QCPTextElement;
class QCustomPlot;

namespace drillwave {

struct PlotStyle {
    static constexpr int lineKinds = 4;

    QColor background;
    QColor text;
    QColor frame;
    QColor grid;
    QColor zeroLine;
    QColor lines[lineKinds];  ///< colours of the curves, with a contrast of at least 4.5 to the background
    QFont font;  ///< font of all texts; its size is in pixels, so that files look the same at any resolution
    double lineWidth = 1.6;  ///< width of curves [px]
    int legendGap = 4;       ///< space between the line and the name of a legend entry [px]

    /// Returns the style for a widget on screen, light or dark according to its palette.
    static PlotStyle forScreen(const QPalette& palette, const QFont& font);
    /// Returns the style for files, black on white.
    static PlotStyle forPaper();

    /// Returns the pen of curve `index` (from 0) of a plot. The first four pens differ in both colour and
    /// dash pattern, the first sixteen in at least one of them.
    QPen linePen(int index) const;
    /// Returns the pen of curve `index` of an earlier result, which is shown faintly: thin, translucent and
    /// dashed.
    QPen ghostPen(int index) const;
    /// Returns the brush for the area under curve `index`: its colour, translucent.
    QBrush areaBrush(int index) const;

    /// Returns the brush for the background of words that are placed on curves. It is translucent, so that
    /// the curves remain faintly visible.
    QBrush behindWords() const;

    void applyTo(QCPAxisRect& rect) const;
    void applyTo(QCPLegend& legend) const;
    void applyTo(QCPTextElement& title) const;
};

/// Returns the layer for curves of other results, such as an earlier result or pinned runs. It lies below the
/// layer of the usual curves, and is created if the plot does not have it yet.
QCPLayer* ghostLayer(QCustomPlot& plot);

}  // namespace drillwave

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
    QColor lines[lineKinds];  ///< contrast of at least 4.5 with the background
    QFont font;               ///< size in pixels, so that files look the same at any resolution
    double lineWidth = 1.6;   ///< [px]
    int legendGap = 4;        ///< between line and name [px]

    /// Light or dark after the palette of a widget.
    static PlotStyle forScreen(const QPalette& palette, const QFont& font);
    /// Black on white, for files.
    static PlotStyle forPaper();

    /// Returns the pen of the index-th curve of a plot: the first lineKinds differ both in colour and in dash
    /// pattern (never only in colour), sixteen of them in one of the two.
    QPen linePen(int index) const;
    /// Returns the pen of an earlier result, which stays faintly: thin, translucent and dotted.
    QPen ghostPen(int index) const;
    /// A translucent version of a line's colour, for areas.
    QBrush areaBrush(int index) const;

    /// Returns the background of words on curves: what they hide is faintly visible.
    QBrush behindWords() const;

    void applyTo(QCPAxisRect& rect) const;
    void applyTo(QCPLegend& legend) const;
    void applyTo(QCPTextElement& title) const;
};

/// The layer below the curves, for those of an earlier result; made when there is none.
QCPLayer* ghostLayer(QCustomPlot& plot);

}  // namespace drillwave

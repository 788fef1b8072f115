// SPDX-License-Identifier: GPL-3.0-or-later
// The cursors of a plot, and the strip below the plot with the readings of a curve at the cursors.
#pragma once

#include <QObject>
#include <QPointer>
#include <optional>

#include "ui/plot/curve_reading.h"
#include "ui/plot/plot_csv.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/reading_cells.h"

namespace drillwave {

class CursorBar;

/// Key of a user setting. If it is on, the strip of readings is shown below every plot, even if no cursor is
/// placed.
inline const QString tableShownKey = QStringLiteral("plots/table");

/// Reader of one curve of a plot. Updates the strip of readings below the plot whenever the plot is drawn or
/// a cursor moves. All x and y are in the units of the axes.
class CurveReader : public QObject {
    Q_OBJECT

  public:
    /// Creates a reader for `plot`. `meanings` gives units and exact functions of its curves; it must outlive
    /// the reader, as must the plot.
    CurveReader(QCustomPlot& plot, const CurveMeanings& meanings);

    /// Places cursor A, B or time at x (unit of the axis), or removes it if x is empty. Emits changed() for A
    /// and B, and no other signal.
    void place(PlotCursor cursor, std::optional<double> x);
    /// Returns the x of a cursor in the unit of the axis; nothing if it is not placed.
    std::optional<double> position(PlotCursor cursor) const { return m_cursors.position(cursor); }
    /// Removes the cursors A and B from the plot.
    void clear();
    const PlotCursors& cursors() const { return m_cursors; }
    void setStyle(const PlotStyle& style) { m_cursors.setStyle(style); }

    /// Returns the graph that is read: the one last chosen, else the default of setUsual(), else the first
    /// visible one. Hidden graphs are skipped; nullptr if no graph is visible.
    QCPGraph* graph() const;
    /// Sets the graph that is read until the user chooses another one. If it is nullptr, the first visible
    /// graph is read.
    void setUsual(QCPGraph* graph) { m_usual = graph; }
    /// Chooses the graph that is read at the cursors. If it is nullptr, the default of setUsual() is read.
    void setGraph(QCPGraph* graph);
    /// Chooses the curve that the table below the plot reads: the curve within 40 px of a point of the plot.
    /// If none is that close, the present curve stays if it is on the axes there, else the first curve on
    /// them is chosen. While cursor A or B is placed, a present curve on these axes always stays.
    void aim(QPointF pixel);
    /// Returns the readings of graph() at cursors A and B; nothing unless both cursors are placed.
    std::optional<CursorReading> reading() const;
    /// Returns the text of the strip of readings below the plot; empty while the strip is hidden.
    QString text() const;
    /// Copies the readings in the strip to the clipboard, as tab-separated text.
    void copy() const;
    /// Sets whether the curves belong to the present input. Readings of outdated curves cannot be copied.
    void setCurrent(bool current);
    /// Sets whether the strip of readings below the plot is also shown if neither cursor A nor B is placed.
    /// It then shows extremes, mean and integral of the part of the curve in view.
    void setTableShown(bool shown);
    /// Computes the readings of the curve at the cursors and shows them in the strip below the plot. Every
    /// replot does this too. Call it only after changing the data without a replot.
    void read();
    /// Shows or hides the strip of readings at the bottom of the plot. When it is shown, the area for the
    /// curves becomes smaller by its height.
    void placeBar();

  signals:
    /// Reports that the readings of the curve at the cursors are new, because a cursor, the curve or its data
    /// may have changed. See reading().
    void changed();
    /// Reports that the user has removed the cursors A and B by the button of the strip.
    void closed();

  private:
    bool isBarShown() const;
    CurveMeaning meaning() const;
    ReadingCells cellsAtCursors() const;
    ReadingCells cellsInView() const;

    QCustomPlot& m_plot;
    const CurveMeanings& m_meanings;
    PlotCursors m_cursors;
    CursorBar* m_bar;
    QPointer<QCPGraph> m_graph;
    QPointer<QCPGraph> m_usual;
    bool m_tableShown;
};

}  // namespace drillwave

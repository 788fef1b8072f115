// SPDX-License-Identifier: GPL-3.0-or-later
// The cursors of a plot and the strip below it that reads a curve at them.
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

/// Key of the setting that shows the strips below the plots even without cursors.
inline const QString tableShownKey = QStringLiteral("plots/table");

/// Reads the chosen curve of a plot whenever it is drawn or a cursor moves. Every x and y is in the units of
/// the axes.
class CurveReader : public QObject {
    Q_OBJECT

  public:
    /// Lives in the plot, as do the meanings of its curves, which decide how they are read.
    CurveReader(QCustomPlot& plot, const CurveMeanings& meanings);

    /// Puts cursor A, B or the time to x, or takes it away; emits nothing but changed().
    void place(PlotCursor cursor, std::optional<double> x);
    std::optional<double> position(PlotCursor cursor) const { return m_cursors.position(cursor); }
    /// Takes A and B away.
    void clear();
    const PlotCursors& cursors() const { return m_cursors; }
    void setStyle(const PlotStyle& style) { m_cursors.setStyle(style); }

    /// The graph read at A and B: as chosen, else the usual one, else the first that is visible; nullptr
    /// without any.
    QCPGraph* graph() const;
    /// The one that is read until another is chosen; or none.
    void setUsual(QCPGraph* graph) { m_usual = graph; }
    void setGraph(QCPGraph* graph);
    /// The curve below a point of the plot is read from now on, or one of the axes there. While there are
    /// cursors, a curve between the same axes stays.
    void aim(QPointF pixel);
    /// Returns the reading of graph() at cursors A and B; nothing unless both are placed.
    std::optional<CursorReading> reading() const;
    /// The strip below the plot, in words; empty while there is none.
    QString text() const;
    /// Copies the text of the strip to the clipboard, as a table.
    void copy() const;
    /// Whether what the strip reads may be copied: the curves answer the present input.
    void setCurrent(bool current);
    /// Whether the strip has its place also while neither A nor B is there: what is in view is read then.
    void setTableShown(bool shown);
    /// The curve has data of its own: reads it again. Replots do that by themselves.
    void read();
    /// The strip takes its height from the plot.
    void placeBar();

  signals:
    /// Cursor A or B, the curve or its data have changed; see reading().
    void changed();
    /// The user has taken A and B away by the strip.
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

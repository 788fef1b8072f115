// SPDX-License-Identifier: GPL-3.0-or-later
// Common part of the plots of pages: message, view, style, legend and caption, pinned runs and the mark of
// the present scenario.
#pragma once

#include <qcustomplot.h>

#include <QPointer>
#include <optional>

#include "ui/plot/axis_rect.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/here_mark.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/run_graphs.h"
#include "ui/plot/run_marks.h"

namespace drillwave {

/// Base class for the plots of pages, on screen and in files. It draws what all plots have: legend, caption,
/// messages, pinned runs and the mark of the present scenario. A derived class adds its own items, styles and
/// clears them, and sets the ranges that show all of them. The plot owns the object.
class StudyFrame : public QObject {
    Q_OBJECT

  public:
    /// Removes all curves and other results from the plot, and shows `message` instead, which says why there
    /// are none.
    void showNothing(const QString& message);
    /// Moves the mark of the present scenario (the current input) to x and y, in the units of the axes. With
    /// no y the mark is only a vertical line; with no x it is hidden.
    void setHere(std::optional<double> x, std::optional<double> y) { m_here->setPlace(x, y); }
    /// Shows the pinned runs (results kept for comparison) as marks. Plots of curves also show the `curves`
    /// of the runs. All coordinates are in the units of the axes.
    void setRuns(const QVector<RunMark>& marks, const QVector<RunCurve>& curves = {});
    const QVector<RunMark>& runMarks() const {
        static const QVector<RunMark> none;  // before the plot has runs
        return m_runMarks ? m_runMarks->marks() : none;
    }
    const QVector<QCPGraph*>& runCurves() const {
        static const QVector<QCPGraph*> none;  // before the plot has runs
        return m_runCurves ? m_runCurves->graphs() : none;
    }
    void setStyle(const PlotStyle& style);
    /// Sets the ranges of the axes so that everything in the plot is in view.
    void fit();
    /// Brings everything into view, unless the user has zoomed or panned.
    void fitUnlessZoomed();
    /// Returns the places that the keyboard point can reach in this plot. By default there are none (no axis
    /// rect), so that the keys do nothing.
    virtual KeyPlaces keyPlaces() const { return {}; }
    /// Returns a description of the plot in words, for screen readers and for the line above the plot.
    QString textSummary() const { return m_summary; }

  protected:
    explicit StudyFrame(QCustomPlot* plot);

    /// Removes what the derived class has drawn; called when a message is shown instead of results. The base
    /// class has already removed the pinned runs, the caption and the mark of the present scenario.
    virtual void clear() = 0;
    /// Applies the style m_style to all items that the derived class has added; called after every change of
    /// the style. The base class has already applied it to its own items.
    virtual void restyle() = 0;
    /// Sets the ranges of all axes so that everything drawn is in view. Called by fit().
    virtual void setRanges() = 0;

    /// Removes QCustomPlot's own axes and legend, so that the derived class can build its own layout. New
    /// curves are not added to a legend automatically.
    void layOutAnew();
    /// Makes `rect` the axis rect whose ranges fit() sets. From now on, zooming or panning by the user in
    /// this rect is noticed.
    void view(QCPAxisRect* rect);
    /// Returns the horizontal axis of the axis rect passed to view().
    QCPAxis* x() const { return m_rect->axis(QCPAxis::atBottom); }
    /// Returns the vertical axis of the axis rect passed to view().
    QCPAxis* y() const { return m_rect->axis(QCPAxis::atLeft); }
    /// Returns the position of a point in pixels of the plot; `at` is given in the units of the axes.
    QPointF pixelOf(QPointF at) const { return {x()->coordToPixel(at.x()), y()->coordToPixel(at.y())}; }
    /// Adds an element, such as a legend, to the layout of the plot. It gets a new row at the top, which is
    /// only as high as the element needs.
    void insertAbove(QCPLayoutElement* element);
    /// Makes the plot's legend visible and uses it. If the layout has deleted it, uses a new legend.
    /// `margins` are in pixels.
    void useLegend(const QMargins& margins);
    /// Adds a row above the axes, where it cannot hide a curve, with the legend and an empty caption.
    /// `spaceBelow` is the space below the caption [px]. Returns the layout of that row.
    QCPLayoutGrid* addHeader(int spaceBelow);
    /// Adds the mark at the values of the present scenario to the axis rect passed to view(). The mark is
    /// `mark`, or a new HereMark if it is nullptr.
    void addHere(HereMark* mark = nullptr);
    const HereMark& here() const { return *m_here; }
    /// Prepares the plot for showing marks of pinned runs, see setRuns(). Call this after view().
    void addRunMarks();
    /// Prepares the plot for showing the curves of pinned runs, see setRuns(). `width` is a factor of the
    /// line width.
    void addRunCurves(double width = 1);
    /// Moves the legend entries of the pinned runs (results kept for comparison) to the end of the legend.
    void standRunsLast() { m_runCurves->standLast(); }
    /// Adds a text to an axis rect, in font and colour of the style. `padding` is in pixels. Returns the
    /// text, which the plot owns.
    QCPItemText* addText(QCPAxisRect* rect, const QMargins& padding, Qt::Alignment alignment);
    /// Hides the message of showNothing(). Brings everything into view, unless the user has zoomed and the
    /// axes are the same as before. Call this after showing new results.
    void finish(bool hasOtherAxes);

    QCustomPlot* m_plot;
    QCPAxisRect* m_rect = nullptr;
    QCPLegend* m_legend = nullptr;
    QCPTextElement* m_caption = nullptr;
    FittedView* m_view;
    PlotStyle m_style;
    QString m_summary;

  private:
    PlotMessage* m_message;
    HereMark* m_here = nullptr;
    RunMarks* m_runMarks = nullptr;
    RunGraphs* m_runCurves = nullptr;
    QVector<QPointer<QCPItemText>> m_texts;
};

}  // namespace drillwave

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

/// Base of the plots of pages, for screen and files. A derived class adds its items, and defines how to style
/// them, how to clear them and which ranges show all of them. The plot owns the object.
class StudyFrame : public QObject {
    Q_OBJECT

  public:
    /// Removes all curves and shows `message` instead, which says why there are none.
    void showNothing(const QString& message);
    /// Places the mark of the present scenario at x and y, in the units of the axes. Without y it is a
    /// vertical line, without x it is hidden.
    void setHere(std::optional<double> x, std::optional<double> y) { m_here->setPlace(x, y); }
    /// Shows pinned runs (results kept for comparison) as marks and, in plots of curves, as curves. All are
    /// in the units of the axes.
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
    /// Sets the ranges of the axes so that everything is in view, unless the user has zoomed or panned.
    void fitUnlessZoomed();
    /// Returns the places that the keys can reach in this plot. The default has no axis rect, so that the
    /// keys do nothing.
    virtual KeyPlaces keyPlaces() const { return {}; }
    /// Returns a description of the plot in words, for assistive tools and for the line above the plot.
    QString textSummary() const { return m_summary; }

  protected:
    explicit StudyFrame(QCustomPlot* plot);

    /// Removes what the derived class has drawn. The base class has already removed runs, caption and the
    /// mark of the scenario.
    virtual void clear() = 0;
    /// Applies m_style to the items of the derived class; the base class has already applied it to its own
    /// items.
    virtual void restyle() = 0;
    /// Sets the axis ranges that bring everything into view.
    virtual void setRanges() = 0;

    /// Removes QCustomPlot's own axes and legend from the plot. New curves are not added to a legend
    /// automatically.
    void layOutAnew();
    /// Makes `rect` the axis rect whose ranges are fitted and zoomed.
    void view(QCPAxisRect* rect);
    /// Returns the horizontal axis of the fitted axis rect.
    QCPAxis* x() const { return m_rect->axis(QCPAxis::atBottom); }
    /// Returns the vertical axis of the fitted axis rect.
    QCPAxis* y() const { return m_rect->axis(QCPAxis::atLeft); }
    /// Returns the position in pixels of a point given in the units of the axes.
    QPointF pixelOf(QPointF at) const { return {x()->coordToPixel(at.x()), y()->coordToPixel(at.y())}; }
    /// Adds an element in a new row above all others, only as high as the element needs.
    void insertAbove(QCPLayoutElement* element);
    /// Makes the plot's legend visible and uses it, or a new legend if the layout has deleted the old one.
    /// `margins` are in pixels.
    void useLegend(const QMargins& margins);
    /// Adds a row with legend and (still empty) caption above the axes, where they cannot hide a curve, with
    /// `spaceBelow` [px]. Returns the layout of that row.
    QCPLayoutGrid* addHeader(int spaceBelow);
    /// Adds the mark of the present scenario over the axes of the fitted rect: `mark`, or a new one for
    /// nullptr.
    void addHere(HereMark* mark = nullptr);
    const HereMark& here() const { return *m_here; }
    /// Adds the marks of pinned runs, which need the axes of the fitted rect.
    void addRunMarks();
    /// Adds the curves of pinned runs. `width` is a factor of the line width.
    void addRunCurves(double width = 1);
    /// Moves the pinned runs to the end of the legend.
    void standRunsLast() { m_runCurves->standLast(); }
    /// Adds a text to an axis rect, in font and colour of the style. `padding` is in pixels. Returns the
    /// text, which the plot owns.
    QCPItemText* addText(QCPAxisRect* rect, const QMargins& padding, Qt::Alignment alignment);
    /// Hides the message of showNothing(). Fits the view if it was fitted before or if the axes are
    /// different. Call this after showing new results.
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

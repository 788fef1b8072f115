// SPDX-License-Identifier: GPL-3.0-or-later
// Common part of the plots of pages: messages, view, style, header, runs and the mark of the scenario.
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

/// Draws on screen and in files alike. A plot of a page adds what it draws, says how that looks and goes
/// away, and which ranges have all of it in view. Lives as a child of the plot.
class StudyFrame : public QObject {
    Q_OBJECT

  public:
    /// No curves, and `message` in their place (why there are none).
    void showNothing(const QString& message);
    /// Places the mark of the scenario, in units of the axes: without y a line, without x nothing.
    void setHere(std::optional<double> x, std::optional<double> y) { m_here->setPlace(x, y); }
    /// Where pinned runs are and, of a plot that has them, their curves; in units of the axes.
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
    /// Everything in view.
    void fit();
    /// The same, unless the user has chosen another view.
    void fitUnlessZoomed();
    /// Where keys may go; no rect where they do nothing.
    virtual KeyPlaces keyPlaces() const { return {}; }
    /// Returns a description of the plot in words, for assistive tools and the line above it.
    QString textSummary() const { return m_summary; }

  protected:
    explicit StudyFrame(QCustomPlot* plot);

    /// Away with what is drawn; message, runs and "you are here" have gone already.
    virtual void clear() = 0;
    /// Applies m_style to the items of the derived frame; the base class has applied it to its own.
    virtual void restyle() = 0;
    /// That have everything in view.
    virtual void setRanges() = 0;

    /// The plot without its own axes and legend; none of its curves comes into a legend by itself.
    void layOutAnew();
    /// Takes a rect for the one that is fitted and zoomed.
    void view(QCPAxisRect* rect);
    QCPAxis* x() const { return m_rect->axis(QCPAxis::atBottom); }
    QCPAxis* y() const { return m_rect->axis(QCPAxis::atLeft); }
    QPointF pixelOf(QPointF at) const { return {x()->coordToPixel(at.x()), y()->coordToPixel(at.y())}; }
    /// A row of its own above all others, as high as it has to be.
    void insertAbove(QCPLayoutElement* element);
    /// Legend of the plot, or another one if that has gone with the layout.
    void useLegend(const QMargins& margins);
    /// Legend and caption (of no words yet) above the axes, where they can hide no part of a curve, and
    /// `spaceBelow` them [px]. Returns what holds them.
    QCPLayoutGrid* addHeader(int spaceBelow);
    /// These are over the axes that are in view.
    void addHere();
    const HereMark& here() const { return *m_here; }
    void addRunMarks();
    void addRunCurves(double width = 1);
    /// Behind what has come into the legend since.
    void standRunsLast() { m_runCurves->standLast(); }
    /// Words of a rect, in font and colour of the style.
    QCPItemText* addText(QCPAxisRect* rect, const QMargins& padding, Qt::Alignment alignment);
    /// At the end of what shows something: fitted where it was, or where the axes are others than before.
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

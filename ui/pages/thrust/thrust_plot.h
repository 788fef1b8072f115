// SPDX-License-Identifier: GPL-3.0-or-later
// The needs of the thrust along a parameter as brackets, the regimes of the feed as bands, and the feed
// (theory §10).
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <array>
#include <optional>

#include "ui/pages/study/run_marks.h"
#include "ui/pages/thrust/thrust_picture.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/here_mark.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

class RegimeBands;

/// Draws the picture of a study of the thrust, on screen and in files alike. Lives as a child of the plot.
class ThrustPlot : public QObject {
    Q_OBJECT

  public:
    explicit ThrustPlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted, or parameter or units changed.
    void present(const ThrustPicture& picture);
    /// No curves, and `message` in their place (why there are none).
    void showNothing(const QString& message);
    /// Where the present scenario is: its value of the parameter and its effective force, in shown units.
    void setHere(std::optional<double> along, std::optional<double> force);
    /// What blows of pinned runs need for full penetration, in shown units.
    void setRuns(const QVector<RunMark>& marks);
    const QVector<RunMark>& runs() const { return m_runs->marks(); }
    void setStyle(const PlotStyle& style);
    /// All along the parameter, from no thrust to the largest.
    void fit();

    /// The line of a need's lower end, which is that of the legend.
    QCPGraph* need(ThrustCase which) const { return m_lower[static_cast<std::size_t>(which)]; }
    QCPGraph* feed() const { return m_feed; }
    /// How far above (negative: below) the line of the feed a pixel is [px]; nothing where there is no line
    /// there.
    std::optional<double> heightAboveFeed(QPointF pixel) const;
    /// Where keys may go: along the needs and the feed.
    KeyPlaces keyPlaces() const;
    /// What the plot shows, in words, for assistive tools.
    QString textSummary() const { return m_summary; }

  private:
    void listKnown();
    void followLegend();
    void nameFeed();

    QCustomPlot* m_plot;
    RegimeBands* m_bands;
    std::array<QCPGraph*, thrustCaseCount> m_lower{};
    std::array<QCPGraph*, thrustCaseCount> m_upper{};
    QCPGraph* m_feed;
    QCPTextElement* m_caption = nullptr;  // what the brackets are
    QCPItemText* m_feedName;
    HereMark* m_here;
    RunMarks* m_runs;
    PlotMessage* m_message;
    ThrustPicture m_picture;
    FittedView* m_view;
    QString m_summary;
};

}  // namespace drillwave

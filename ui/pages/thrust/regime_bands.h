// SPDX-License-Identifier: GPL-3.0-or-later
// States of the feed, as bands of a plot of required forces.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <array>

#include "ui/pages/thrust/thrust_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// The states of FeedEstimate from pushed back to return in time, each between its thresholds and with its
/// name. Behind the curves; cut at the axes in every format. Lives as a child of the plot.
class RegimeBands : public QObject {
    Q_OBJECT

  public:
    explicit RegimeBands(QCustomPlot* plot);

    void present(const ThrustPicture& picture);
    void clear() { present({}); }
    void setStyle(const PlotStyle& style);

  private:
    static constexpr std::size_t bandCount = 5;

    void place();
    void placeName(std::size_t band, const QVector<QPointF>& floor, const QVector<QPointF>& ceiling);
    bool hasRoom(const QCPItemText& name, QPointF floor, QPointF ceiling) const;

    QCustomPlot* m_plot;
    std::array<QCPCurve*, bandCount> m_bands{};
    std::array<QCPItemText*, bandCount> m_names{};
    std::array<QVector<QPointF>, bandCount - 1> m_thresholds;  // between them, from below
    QVector<QPointF> m_feed;                                   // which names make way for
};

}  // namespace drillwave

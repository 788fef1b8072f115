// SPDX-License-Identifier: GPL-3.0-or-later
// What the feed does between the blows, as bands of a plot of thrusts.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <array>

#include "ui/pages/thrust/thrust_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// The regimes of theory §10 from pushed back to at rest, each between its thresholds by the e of the
/// blow, and with its name. Behind the curves; cut at the axes in every format. Lives as a child of the plot.
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

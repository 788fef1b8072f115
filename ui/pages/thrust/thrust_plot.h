// SPDX-License-Identifier: GPL-3.0-or-later
// The needs of the thrust along a parameter as brackets, the regimes of the feed as bands, and the feed
// (theory §10).
#pragma once

#include <array>
#include <optional>

#include "ui/pages/thrust/thrust_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class RegimeBands;

/// Draws the picture of a study of the thrust: fitted, all along the parameter is in view, from no thrust to
/// the largest. One is at the value of the parameter and the effective force, runs at what they need for full
/// penetration.
class ThrustPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit ThrustPlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted, or parameter or units changed.
    void present(const ThrustPicture& picture);

    /// The line of a need's lower end, which is that of the legend.
    QCPGraph* need(ThrustCase which) const { return m_lower[static_cast<std::size_t>(which)]; }
    QCPGraph* feed() const { return m_feed; }
    /// How far above (negative: below) the line of the feed a pixel is [px]; nothing where there is no line
    /// there.
    std::optional<double> heightAboveFeed(QPointF pixel) const;
    /// Along the needs and the feed.
    KeyPlaces keyPlaces() const override;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void listKnown();
    void followLegend();
    void nameFeed();

    RegimeBands* m_bands;
    std::array<QCPGraph*, thrustCaseCount> m_lower{};
    std::array<QCPGraph*, thrustCaseCount> m_upper{};
    QCPGraph* m_feed;
    QCPItemText* m_feedName;
    ThrustPicture m_picture;
};

}  // namespace drillwave

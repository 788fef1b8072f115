// SPDX-License-Identifier: GPL-3.0-or-later
// Force or velocity along the rod at one instant, of the blow and of pinned runs.
#pragma once

#include <QPointF>
#include <QVector>
#include <QWidget>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// The field along the time cursor's line as curves, because curves can be laid over each other and
/// colours cannot. There for a drill string, and while runs are laid over the page; in line with the
/// rod below. Place and time are those of the blow on show: a longer rod ends outside, a shorter one
/// inside.
class RodProfile : public QWidget {
    Q_OBJECT

  public:
    /// One curve, as shown.
    struct Line {
        int number = -1;  ///< of the run; -1 for the blow itself
        QString title;
        QVector<QPointF> points;  ///< place in the rod, value; as far as both rods go
    };

    explicit RodProfile(QWidget* parent = nullptr);

    /// A blow with a picture, or nullptr for none.
    void setBlow(const SolvedBlowPtr& blow);
    /// Global time t/t0 of the blow.
    void setTime(double t);
    /// Sets the ends of the rod [px from the left].
    void setRodEnds(int left, int right);

    /// The blow, and the runs that are laid over it; none without runs.
    const QVector<Line>& lines() const { return m_lines; }
    /// The values of all lines at a place in the rod x/L, by name; of those that go that far.
    QString readout(double xi) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {300, sizeHint().height()}; }

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    const WavePicture& picture() const { return *m_blow->page<WavePicture>(); }
    const ShownUnit& unit() const { return picture().units.of(picture().raster.quantity); }
    QRectF area() const;
    double pixelOf(double xi) const;
    void compute();
    Line lineOf(const SolvedBlow& blow, const PictureUnits& units, double time) const;
    void paintAxes(QPainter& painter, const PlotStyle& style) const;
    void paintNames(QPainter& painter, const PlotStyle& style) const;
    QPen penOf(const Line& line, const PlotStyle& style) const;

    SolvedBlowPtr m_blow;
    double m_time = 0;
    int m_left = 64, m_right = -1;
    double m_limit = 1;  // of all lines at all times, as shown
    QVector<Line> m_lines;
};

}  // namespace drillwave

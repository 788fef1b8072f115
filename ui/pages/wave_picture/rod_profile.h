// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of force or velocity along the rod at one instant, for the blow and for pinned runs.
#pragma once

#include <QPointF>
#include <QVector>
#include <QWidget>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Widget with curves of force or velocity along the rod at the time cursor; unlike colours, curves can be
/// drawn over each other. It is visible for a drill string, and if pinned runs are shown. It is aligned with
/// the drawing of the rod below. Positions and times have the scales of the present blow. So the curve of a
/// longer rod is cut off at the end of the present rod.
class RodProfile : public QWidget {
    Q_OBJECT

  public:
    /// Curve of one blow, in the units shown.
    struct Line {
        int number = -1;  ///< number of the pinned run; −1 for the present blow
        QString title;
        QVector<QPointF> points;  ///< value over position, within both rods
    };

    explicit RodProfile(QWidget* parent = nullptr);

    /// Shows a blow, which must have a wave picture; nullptr for none.
    void setBlow(const SolvedBlowPtr& blow);
    /// Sets the time of the curves [t0], counted from the start of the present blow.
    void setTime(double t);
    /// Sets the ends of the rod [px from the left], to align the curves with the drawing of the rod.
    void setRodEnds(int left, int right);

    /// Returns the curves of the present blow and of the pinned runs (results kept for comparison); empty
    /// while the widget is hidden.
    const QVector<Line>& lines() const { return m_lines; }
    /// Returns a text with the value of each curve at the position x/L and the name of its run. Curves that
    /// do not reach x/L are left out.
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
    double m_limit = 1;  // largest magnitude of all curves at all times, in the unit shown
    QVector<Line> m_lines;
};

}  // namespace drillwave

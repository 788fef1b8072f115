// SPDX-License-Identifier: GPL-3.0-or-later
// The rod itself at one instant, coloured by its stress.
#pragma once

#include <QWidget>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"
#include "ui/plot/colour_scale.h"

namespace drillwave {

/// Hammer, rod, bit and rock from left to right, the rod in the colours of the picture above, and the state
/// of the bit in words. A drill string has all its sections, their heights as their diameters; where the
/// picture shows forces each has the colour of its stress, of which the largest one of the blow has the
/// colour of the end of the scale. Redrawn for every step of a playing blow: a fraction of a millisecond.
class RodStrip : public QWidget {
    Q_OBJECT

  public:
    explicit RodStrip(QWidget* parent = nullptr);

    /// A blow with a picture, or nullptr for an empty strip.
    void setBlow(const SolvedBlowPtr& blow);
    /// Global time t/t0.
    void setTime(double t);
    double time() const { return m_time; }
    /// Sets the ends of the rod [px from the left], to be in line with a picture above.
    void setRodEnds(int left, int right);
    /// "t = 0.52 ms: contact, penetration 0.8 mm, force 120 kN; stress −45 … 12 MPa", or the
    /// velocity where the picture shows that.
    QString stateText() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {300, sizeHint().height()}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    const WavePicture& picture() const { return *m_blow->page<WavePicture>(); }
    const ColourScale& colours() const;
    void nameColours();
    void compute();
    QRect rodRect() const;
    bool isStress() const { return !m_blow || picture().raster.quantity == WaveQuantity::force; }
    bool hammerTouches() const;
    void toStress(const RasterGrid& grid);
    void paintRod(QPainter& painter, const QRect& rod) const;
    void paintSections(QPainter& painter, const QRect& rod) const;
    QImage colouredLine() const;
    void paintHammer(QPainter& painter, const QRect& rod) const;
    void paintRock(QPainter& painter, const QRect& rod) const;

    SolvedBlowPtr m_blow;
    double m_time = 0;
    int m_left = 64, m_right = -1;
    std::vector<float>
        m_values;  // of the field of the picture, in a string of the stress, at the pixels of the rod
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of the rod at one instant, coloured by its stress.
#pragma once

#include <QWidget>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"
#include "ui/plot/colour_scale.h"

namespace drillwave {

/// Drawing of hammer, rod, bit and rock at one instant, with the colours of the wave picture above it. The
/// state of the bit is shown in words. A drill string shows all its sections, with heights proportional to
/// their diameters. If the picture shows forces, the sections have the colours of their stresses. The largest
/// stress of the blow has the end colour of the scale. Redrawing takes a fraction of a millisecond, because
/// it happens at every step of playing.
class RodStrip : public QWidget {
    Q_OBJECT

  public:
    explicit RodStrip(QWidget* parent = nullptr);

    /// Shows a blow, which must have a wave picture; nullptr for an empty strip.
    void setBlow(const SolvedBlowPtr& blow);
    /// Sets the time that the drawing shows [t0], counted from the start of the blow.
    void setTime(double t);
    double time() const { return m_time; }
    /// Sets the ends of the rod [px from the left], to align it with the picture above.
    void setRodEnds(int left, int right);
    /// Returns the state of bit and rod at the time of setTime() in words. An example is "t = 0.52 ms:
    /// contact, penetration 0.8 mm, force 120 kN; stress −45 … 12 MPa". It ends with the velocity instead if
    /// the picture shows velocities.
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
    std::vector<float> valuesAt(int columns) const;
    void toStress(const RasterGrid& grid, std::vector<float>& values) const;
    void paintRod(QPainter& painter, const QRect& rod) const;
    void paintSections(QPainter& painter, const QRect& rod) const;
    QImage colouredLine() const;
    void paintHammer(QPainter& painter, const QRect& rod) const;
    void paintRock(QPainter& painter, const QRect& rod) const;

    SolvedBlowPtr m_blow;
    double m_time = 0;
    int m_left = 64, m_right = -1;
    std::vector<float>
        m_values;  // values at the pixels of the rod: the field of the picture, or the stress in a string
    float m_least = 0, m_most = 0;  // extremes of the same quantity along the rod, or 0
};

}  // namespace drillwave

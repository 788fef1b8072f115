// SPDX-License-Identifier: GPL-3.0-or-later
// Joints and names of the sections of a drill string in the x–t picture of its waves.
#pragma once

#include <QRectF>
#include <QVector>

#include "ui/pages/wave_picture/wave_picture_items.h"

namespace drillwave {

/// Lines and names in the x–t picture of a drill string. Every joint has a thin line. The line between hammer
/// and string is stronger, and thick while they touch. Names are above the picture; names of short sections
/// are upright within it, if there is space.
class JointMarksItem : public WavePictureItem {
    Q_OBJECT

  public:
    /// Name of a section as drawn, centred in the visible part of its section.
    struct Name {
        QString text;
        QRectF box;
        bool upright = false;
    };

    explicit JointMarksItem(QCustomPlot* plot) : WavePictureItem(plot) { setClipToAxisRect(false); }

    void setBlow(const SolvedBlowPtr& blow) override;
    void setStyle(const PlotStyle& style) override;
    /// Returns the section names in view for which there is space, the longest section first.
    QVector<Name> names() const;
    /// Returns the positions of the lines at the joints in view [px from the left].
    QVector<double> lines() const;

  protected:
    void draw(QCPPainter* painter) override;

  private:
    /// Stretch of hammer or string that has one name in the picture. Its ends are in x/L.
    struct Named {
        QString text;
        double rear, front;
    };
    QVector<Named> namedStretches() const;
    void reserveRoom();
    void drawFace(QCPPainter& painter) const;
    void drawNames(QCPPainter& painter) const;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Joints of the sections of a drill string in its picture, and the names of the sections.
#pragma once

#include <QRectF>
#include <QVector>

#include "ui/pages/wave_picture/wave_picture_items.h"

namespace drillwave {

/// A thin line at every joint, a stronger one between hammer and string, thick while they touch. The names of
/// sections are above the picture, those of short ones upright inside of it, if there is room.
class JointMarksItem : public WavePictureItem {
    Q_OBJECT

  public:
    /// A name as drawn, centred in the visible part of its section.
    struct Name {
        QString text;
        QRectF box;
        bool upright = false;
    };

    explicit JointMarksItem(QCustomPlot* plot) : WavePictureItem(plot) { setClipToAxisRect(false); }

    void setBlow(const SolvedBlowPtr& blow) override;
    void setStyle(const PlotStyle& style) override;
    /// The names in view that have room, the longest section first.
    QVector<Name> names() const;
    /// Places of the lines in view [px from the left].
    QVector<double> lines() const;

  protected:
    void draw(QCPPainter* painter) override;

  private:
    /// A stretch with one name, in x/L.
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

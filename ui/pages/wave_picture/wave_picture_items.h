// SPDX-License-Identifier: GPL-3.0-or-later
// Items of an x–t picture of waves: the coloured field, the wave fronts, the times of contact.
#pragma once

#include <qcustomplot.h>

#include <QImage>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"
#include "ui/plot/colour_scale.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Item of a wave picture, with position to the right and time upwards. It clips itself to the axes, because
/// some file formats do not clip.
class WavePictureItem : public QCPAbstractItem {
    Q_OBJECT

  public:
    explicit WavePictureItem(QCustomPlot* plot) : QCPAbstractItem(plot) { setSelectable(false); }

    /// Sets the blow that the item draws, which must have a wave picture; nullptr for none.
    virtual void setBlow(const SolvedBlowPtr& blow) { m_blow = blow; }
    virtual void setStyle(const PlotStyle& style) { m_style = style; }
    double selectTest(const QPointF&, bool, QVariant* = nullptr) const override { return -1; }

  protected:
    const WavePicture& picture() const { return *m_blow->page<WavePicture>(); }
    /// Returns the ranges of the axes in x/L and t/t0, with the size of the axis rect in pixels as numbers of
    /// columns and rows.
    RasterGrid view() const;
    /// Returns the pixel of a point given by x/L and t/t0.
    QPointF pixel(double xi, double t) const;

    SolvedBlowPtr m_blow;
    PlotStyle m_style;
};

/// Force or velocity of a wave picture, drawn as colours. For a file it is computed again with the resolution
/// of the file.
class WaveFieldItem : public WavePictureItem {
    Q_OBJECT

  public:
    using WavePictureItem::WavePictureItem;
    void setBlow(const SolvedBlowPtr& blow) override;
    void setStyle(const PlotStyle& style) override;

  protected:
    void draw(QCPPainter* painter) override;

  private:
    QImage imageOf(const WaveRaster& raster) const;
    void drawForFile(QCPPainter& painter) const;

    ColourScale m_colours = ColourScale::onLight();
    QImage m_image;
};

/// Lines of the wave fronts, x = ±ct + …, that start at every start, jump and end of the hammer force. They
/// are followed to and fro between the ends, but not after reflections at joints. For a uniform rod the first
/// waves are named as in the paper's Fig. 2.
class WaveFrontsItem : public WavePictureItem {
    Q_OBJECT

  public:
    using WavePictureItem::WavePictureItem;

  protected:
    void draw(QCPPainter* painter) override;

  private:
    void drawFamily(QCPPainter& painter, double start, bool named) const;
    void drawLine(QCPPainter& painter, const FrontRun& run) const;
    void drawName(QCPPainter& painter, const FrontRun& run) const;
};

/// Bars at the bit's end of a wave picture that show when bit and rock touch. Ticks show when the rock starts
/// to unload, returns to its loading curve, or passes a corner of it.
class ContactBarsItem : public WavePictureItem {
    Q_OBJECT

  public:
    static constexpr int width = 46;  ///< width of the space for the bars beside the axes [px]

    explicit ContactBarsItem(QCustomPlot* plot) : WavePictureItem(plot) { setClipToAxisRect(false); }

  protected:
    void draw(QCPPainter* painter) override;

  private:
    void drawEvents(QCPPainter& painter, const RasterGrid& range) const;
    void drawTitle(QCPPainter& painter) const;
};

}  // namespace drillwave

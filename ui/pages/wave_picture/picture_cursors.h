// SPDX-License-Identifier: GPL-3.0-or-later
// The draggable lines of section and time in an x–t picture of the waves.
#pragma once

#include <qcustomplot.h>

#include <QLocale>
#include <QObject>
#include <optional>

#include "ui/pages/wave_picture/wave_picture_plot.h"

namespace drillwave {

/// Vertical line at the observed section x/L and horizontal line at the time cursor. They are on a layer that
/// is redrawn without the picture. The user drags them, or moves them by Ctrl with the arrow keys while the
/// plot has the focus.
class PictureCursors : public QObject {
    Q_OBJECT

  public:
    /// Creates a vertical line (observed section) and a horizontal line (time cursor). Plot and picture must
    /// outlive them.
    PictureCursors(QCustomPlot* plot, WavePicturePlot* picture);

    /// Moves the vertical line, which marks the observed section, to x/L.
    void setSection(double xi);
    /// Moves the horizontal line, which is the time cursor, to the time t/t0, counted from the start of the
    /// blow.
    void setTime(double t);
    void setStyle(const PlotStyle& style);
    /// Returns the position of the vertical line, which marks the observed section [px from the left].
    double sectionPixel() const;
    /// Returns the position of the horizontal line, which is the time cursor [px from the top].
    double timePixel() const;

  signals:
    /// Reports that the user has moved the vertical line, which marks the observed section, to x/L.
    void sectionMoved(double xi);
    /// Reports that the user has moved the horizontal line, which is the time cursor, to t (in units of the
    /// time scale t0).
    void timeMoved(double t);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Line { none, section, time };
    struct DrawnLine {
        QCPItemLine* halo = nullptr;
        QCPItemLine* line = nullptr;
        QCPItemText* label = nullptr;
    };
    DrawnLine addLine();
    void place();
    void redraw();
    QString sectionText(const QLocale& locale) const;
    Line lineAt(const QPointF& pixel) const;
    void moveTo(const QPointF& pixel);
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool step(const QKeyEvent& event);

    QCustomPlot* m_plot;
    WavePicturePlot* m_picture;
    DrawnLine m_sectionLine, m_timeLine;
    double m_section = 0.5;
    double m_time = 0;
    Line m_dragged = Line::none;
    bool m_ownsCursor = false;  // whether the pointer has the shape for dragging
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of section and time in an x–t picture, to be dragged.
#pragma once

#include <qcustomplot.h>

#include <QLocale>
#include <QObject>
#include <optional>

#include "ui/pages/wave_picture/wave_picture_plot.h"

namespace drillwave {

/// A vertical line at the section x/L and a horizontal one at the time cursor, on the layer that is redrawn
/// without the picture. The mouse drags them; Ctrl with the arrow keys moves them while the plot has focus.
class PictureCursors : public QObject {
    Q_OBJECT

  public:
    /// Both must outlive the cursors.
    PictureCursors(QCustomPlot* plot, WavePicturePlot* picture);

    void setSection(double xi);
    /// Global time t/t0.
    void setTime(double t);
    void setStyle(const PlotStyle& style);
    /// Places of the lines [px].
    double sectionPixel() const;
    double timePixel() const;

  signals:
    void sectionMoved(double xi);
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
    bool m_ownsCursor = false;  // the mouse pointer shows that a line can be dragged
};

}  // namespace drillwave

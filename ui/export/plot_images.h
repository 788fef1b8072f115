// SPDX-License-Identifier: GPL-3.0-or-later
// Plots inside a text document that is laid out for paper.
#pragma once

#include <QObject>
#include <QRectF>
#include <QTextObjectInterface>
#include <vector>

#include "ui/export/report_plots.h"

namespace drillwave {

/// Text object handler that draws plots as vectors where a text has images of the same names. The text must
/// be drawn by a QCPPainter.
class PlotImages : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

  public:
    /// Takes the plots, which must outlive this object. `unit` is the resolution of the text's layout [1/in].
    PlotImages(const std::vector<ReportPlot>& plots, int unit) : m_plots(plots), m_unit(unit) {}

    /// Scales the heights of plots by `share`, 0 … 1. Plots above 60 mm are not made lower than 60 mm; the
    /// heights of lower plots and all widths do not change. The caller must then lay out the text again.
    void setHeight(double share) { m_height = share; }
    /// Sets the page that is drawn, in coordinates of the text. Plots on other pages are left out, because a
    /// plot ignores clipping.
    void setPage(const QRectF& page) { m_page = page; }

    QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
    void drawObject(QPainter* painter, const QRectF& place, QTextDocument* document, int position,
                    const QTextFormat& format) override;

  private:
    const ReportPlot* find(const QTextFormat& format) const;
    Millimetres sizeOf(const ReportPlot& plot) const;

    const std::vector<ReportPlot>& m_plots;
    int m_unit;
    double m_height = 1;
    QRectF m_page;
};

}  // namespace drillwave

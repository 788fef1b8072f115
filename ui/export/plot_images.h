// SPDX-License-Identifier: GPL-3.0-or-later
// Plots inside a text document that is laid out for paper.
#pragma once

#include <QObject>
#include <QRectF>
#include <QTextObjectInterface>
#include <vector>

#include "ui/export/report_plots.h"

namespace drillwave {

/// Handler of text objects that replaces images in a text by the plots of the same names, drawn as vectors.
/// The text must be drawn by a QCPPainter.
class PlotImages : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

  public:
    /// Stores a reference to the plots, which must outlive this object. `unit` is the resolution of the text
    /// layout [dots per inch].
    PlotImages(const std::vector<ReportPlot>& plots, int unit) : m_plots(plots), m_unit(unit) {}

    /// Scales the heights of all plots by `share`, 0 … 1, to save a page. Heights above 60 mm do not get
    /// below 60 mm; smaller heights and all widths stay. The caller must then lay out the text again.
    void setHeight(double share) { m_height = share; }
    /// Sets the page to draw, as a rectangle in coordinates of the text. Plots on other pages are left out,
    /// because a plot ignores clipping.
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

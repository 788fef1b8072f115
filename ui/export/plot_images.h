// SPDX-License-Identifier: GPL-3.0-or-later
// Plots in a text that is laid out for paper.
#pragma once

#include <QObject>
#include <QRectF>
#include <QTextObjectInterface>
#include <vector>

#include "ui/export/report_plots.h"

namespace drillwave {

/// Draws the plots as vectors where a text has images of their names. The text must be drawn by a
/// QCPPainter.
class PlotImages : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

  public:
    /// `unit` is that of the layout of the text [1/in]. The plots must outlive the images.
    PlotImages(const std::vector<ReportPlot>& plots, int unit) : m_plots(plots), m_unit(unit) {}

    /// Scales the height of high plots by `share` and keeps their width. The caller lays out texts that have
    /// them again.
    void setHeight(double share) { m_height = share; }
    /// The page that is drawn: plots of other pages are left out, as a plot does not heed clips.
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

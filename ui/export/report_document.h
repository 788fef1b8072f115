// SPDX-License-Identifier: GPL-3.0-or-later
// Layout of the report on a blow, its words and plots, on pages.
#pragma once

#include <QTextDocument>
#include <vector>

#include "ui/export/plot_images.h"

class QPaintDevice;

namespace drillwave {

/// Layout of a report on pages: the text of reportHtml() with its plots. Headings stay with the text below
/// them and captions with their plots. Tables repeat their header on each page. Plots are made lower if that
/// saves a nearly empty last page.
class ReportDocument {
  public:
    /// Lays out the report on pages of size `page`, in units of the device. Plots and device must outlive the
    /// document.
    ReportDocument(const BlowReport& report, const std::vector<ReportPlot>& plots, const ReadingStyle& style,
                   QPaintDevice& device, const QSizeF& page);

    const QTextDocument& text() const { return m_text; }
    const QFont& font() const { return m_font; }
    /// Draws one page, counted from 0, with its upper left corner at the origin.
    void draw(QPainter& painter, int page);

  private:
    /// Position of the last part of a report (its final heading and text): directly after the text before it,
    /// or on a new page.
    enum class Ending { inFlow, ownPage };

    void layOut(double plotHeight, Ending place);
    /// Returns the heading of the last part of the report.
    QTextBlock ending() const;
    void breakBefore(const QTextBlock& heading);
    void keepTogether();
    void saveLastPage();
    double shareOfLastPage() const;

    QFont m_font;
    PlotImages m_images;
    QTextDocument m_text;
    std::vector<int> m_broken;  // text positions of headings with a page break before them
};

}  // namespace drillwave

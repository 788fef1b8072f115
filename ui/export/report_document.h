// SPDX-License-Identifier: GPL-3.0-or-later
// The words and plots of the report on a blow, laid out on pages.
#pragma once

#include <QTextDocument>
#include <vector>

#include "ui/export/plot_images.h"

class QPaintDevice;

namespace drillwave {

/// The text of reportHtml() for paper with the plots in it. Headings stay with their text and captions with
/// their plots, the head of a table is on each of its pages, and plots are lower where that saves a last page
/// of a few lines.
class ReportDocument {
  public:
    /// For pages of that size in the units of the device. Plots and device must outlive the document.
    ReportDocument(const BlowReport& report, const std::vector<ReportPlot>& plots, const ReadingStyle& style,
                   QPaintDevice& device, const QSizeF& page);

    const QTextDocument& text() const { return m_text; }
    const QFont& font() const { return m_font; }
    /// Draws a page with its corner at the origin.
    void draw(QPainter& painter, int page);

  private:
    /// Where the part after pictures, scenario and errors of the solution goes: where it fits, or on a page
    /// of its own.
    enum class Ending { inFlow, ownPage };

    void layOut(double plotHeight, Ending place);
    /// The heading that begins it.
    QTextBlock ending() const;
    void breakBefore(const QTextBlock& heading);
    void keepTogether();
    void saveLastPage();
    double shareOfLastPage() const;

    QFont m_font;
    PlotImages m_images;
    QTextDocument m_text;
    std::vector<int> m_broken;  // positions of headings that begin a page
};

}  // namespace drillwave

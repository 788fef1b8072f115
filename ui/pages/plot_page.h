// SPDX-License-Identifier: GPL-3.0-or-later
// A page with one plot, which it exports.
#pragma once

#include "ui/pages/page.h"

class QPushButton;

namespace drillwave {

class PlotWidget;
class StudyFrame;

class PlotPage : public Page {
    Q_OBJECT

  public:
    using Page::Page;

    void fit() override;
    QList<PageExport> exports() const override;
    void setCurrent(bool current) override;
    PlotWidget* plot() const { return m_plot; }

  protected:
    /// Returns a new button *Fit*, which can shrink to the width of its text. `tip` is its tooltip.
    QPushButton* newFitButton(const QString& tip);
    /// Creates the plot of the page and returns it. Call it once, when its turn in the tab order of the
    /// page's widgets comes.
    PlotWidget* makePlot();
    /// Sets the frame, which draws the contents of the plot. Connects it with the colours of the window, zoom
    /// to fit and the keyboard. `accessibleName` is what screen readers speak.
    void useFrame(StudyFrame& frame, const QString& accessibleName);
    /// Redraws the plot and updates its description for assistive tools.
    void redraw();
    StudyFrame& frame() const { return *m_frame; }
    /// Sets the minimum height of the plot in lines of text. In a small window the widgets above and below
    /// shrink first, then the page is scrolled.
    void setLeastLines(int lines);

  private:
    PlotWidget* m_plot = nullptr;
    StudyFrame* m_frame = nullptr;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// A page around one plot, which is what it exports.
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
    /// Makes the button *Fit*, which may become as narrow as its word.
    QPushButton* newFitButton(const QString& tip);
    /// The page's plot, made by the page once, where it comes in the order of its widgets.
    PlotWidget* makePlot();
    /// Connects a frame that draws in the plot with the window's style, fitting and keyboard.
    void useFrame(StudyFrame& frame, const QString& accessibleName);
    /// Shows what the frame has drawn since, in words as well.
    void redraw();
    StudyFrame& frame() const { return *m_frame; }
    /// Sets the least height of the plot in lines of text; parts above and below it shrink first, then the
    /// page is scrolled.
    void setLeastLines(int lines);

  private:
    PlotWidget* m_plot = nullptr;
    StudyFrame* m_frame = nullptr;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/plot_page.h"

#include <QPushButton>
#include <cassert>

#include "ui/plot/plot_widget.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

QPushButton* PlotPage::newFitButton(const QString& tip) {
    constexpr int padding = 16;  // left and right of the word together [px]
    QPushButton* button = newButton({}, tr("Fit"), tip);
    button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) + padding);
    connect(button, &QPushButton::clicked, this, &PlotPage::fit);
    return button;
}

PlotWidget* PlotPage::makePlot() {
    assert(!m_plot);
    m_plot = new PlotWidget(this);
    connect(m_plot, &PlotWidget::saveDataRequested, this,
            [this] { emit exportRequested(exports().first()); });
    connect(m_plot, &PlotWidget::savePictureRequested, this,
            [this] { emit exportRequested(exports().last()); });
    return m_plot;
}

void PlotPage::useFrame(StudyFrame& frame, const QString& accessibleName) {
    m_frame = &frame;
    m_plot->setAccessibleName(accessibleName);
    m_plot->followPalette([&frame](const PlotStyle& style) { frame.setStyle(style); });
    connect(m_plot, &PlotWidget::fitRequested, &frame, &StudyFrame::fit);
    m_plot->keyPoint().offer(frame.keyPlaces());
}

void PlotPage::redraw() {
    m_plot->setAccessibleDescription(m_frame->textSummary());
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotPage::setLeastLines(int lines) {
    m_plot->setMinimumHeight(lines * fontMetrics().height());
}

void PlotPage::fit() {
    m_plot->fit();
}

void PlotPage::setCurrent(bool current) {
    m_plot->setCurrent(current);
}

// The numbers first, then the picture.
QList<PageExport> PlotPage::exports() const {
    PageExport numbers;
    numbers.title = tr("&Data of this plot…");
    numbers.toolTip = tr("The curves of the plot, as CSV");
    numbers.fileStem = QStringLiteral("_plot");
    numbers.csv = [plot = m_plot] { return plot->csv(); };
    PageExport picture;
    picture.title = tr("&Picture of this plot…");
    picture.toolTip = tr("The present view, as PNG, SVG or PDF");
    picture.picture = {[plot = m_plot](const PictureChoice& choice, const QString& title) {
                           return plot->drawing(choice.format, choice.size, choice.dpi, title);
                       },
                       [plot = m_plot] { return double(plot->width()) / plot->height(); },
                       [plot = m_plot] { plot->copyPicture(); }};
    return {numbers, picture};
}

}  // namespace drillwave

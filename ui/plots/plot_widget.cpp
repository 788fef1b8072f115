#include "ui/plots/plot_widget.h"

#include <QEvent>
#include <QWheelEvent>
#include <QWindow>

namespace drillwave {

PlotWidget::PlotWidget(QWidget* parent) : QCustomPlot(parent) {
    // Antialiased lines of two pixels are drawn an order of magnitude faster this way.
    setPlottingHint(QCP::phFastPolylines, true);
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    setFocusPolicy(Qt::ClickFocus);
    connect(this, &QCustomPlot::mouseWheel, this, &PlotWidget::chooseZoomAxes);
    connect(this, &QCustomPlot::mouseDoubleClick, this, &PlotWidget::fitRequested);
}

void PlotWidget::followPalette(Restyle restyle) {
    m_restyle = std::move(restyle);
    m_restyle(PlotStyle::forScreen(palette(), font()));
}

void PlotWidget::restyle() {
    if (!m_restyle) return;
    m_restyle(PlotStyle::forScreen(palette(), font()));
    replot(rpQueuedReplot);
}

void PlotWidget::changeEvent(QEvent* event) {
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
}

// QCustomPlot does not notice by itself that its window has moved to a screen of another density.
void PlotWidget::showEvent(QShowEvent* event) {
    QCustomPlot::showEvent(event);
    if (QWindow* window = this->window()->windowHandle())
        connect(window, &QWindow::screenChanged, this, &PlotWidget::followScreen, Qt::UniqueConnection);
    followScreen();
}

void PlotWidget::followScreen() {
    if (bufferDevicePixelRatio() == devicePixelRatioF()) return;
    setBufferDevicePixelRatio(devicePixelRatioF());
    replot(rpQueuedReplot);
}

void PlotWidget::chooseZoomAxes(QWheelEvent* event) {
    for (QCPAxisRect* rect : axisRects()) {
        QList<QCPAxis*> hit;
        for (QCPAxis* axis : {rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)})
            if (axis->selectTest(event->position(), false) >= 0) hit.append(axis);
        rect->setRangeZoomAxes(
            hit.isEmpty() ? QList<QCPAxis*>{rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)}
                          : hit);
    }
}

}  // namespace drillwave

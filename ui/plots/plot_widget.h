// A plot on screen: zooms, pans and fits alike on every page, and follows palette, font and screen.
#pragma once

#include <qcustomplot.h>

#include <functional>

#include "ui/plots/plot_style.h"

namespace drillwave {

/// The wheel zooms at the pointer (over an axis only that axis), dragging pans, a double-click asks to fit.
class PlotWidget : public QCustomPlot {
    Q_OBJECT

  public:
    using Restyle = std::function<void(const PlotStyle&)>;

    explicit PlotWidget(QWidget* parent = nullptr);

    /// Applies the style of the present palette now, and again whenever palette or font change.
    void followPalette(Restyle restyle);

    QSize minimumSizeHint() const override { return {400, 300}; }

  signals:
    void fitRequested();

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void restyle();
    void followScreen();
    void chooseZoomAxes(QWheelEvent* event);

    Restyle m_restyle;
};

}  // namespace drillwave

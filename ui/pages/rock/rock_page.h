// SPDX-License-Identifier: GPL-3.0-or-later
// The rock under the blow: force against penetration (paper, Fig. 1).
#pragma once

#include "ui/job/observation.h"
#include "ui/pages/page.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/plot/plot_widget.h"

class QLabel;

namespace drillwave {

class RockPage : public Page {
    Q_OBJECT

  public:
    /// The observation must outlive the page.
    explicit RockPage(Observation& observation, QWidget* parent = nullptr);

    QString title() const override { return tr("Rock"); }
    PreparePage prepare() const override;
    void setResult(const SolvedBlowPtr& blow) override;
    void setGhost(const SolvedBlowPtr& before) override;
    void fit() override;

    PlotWidget* plot() const override { return m_plot; }
    RockPlot* rockPlot() const { return m_rock; }

  private:
    void showTime();

    Observation& m_observation;
    QLabel* m_instant;
    PlotWidget* m_plot;
    RockPlot* m_rock;
    SolvedBlowPtr m_blow;
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The page Rock: impact force against penetration during the blow (paper, Fig. 1).
#pragma once

#include "ui/job/observation.h"
#include "ui/pages/plot_page.h"

class QLabel;

namespace drillwave {

class RockPlot;

class RockPage : public PlotPage {
    Q_OBJECT

  public:
    /// Creates the page. `observation` (observed section and time of all pages) must outlive it.
    explicit RockPage(Observation& observation, QWidget* parent = nullptr);

    QString title() const override { return tr("Rock"); }
    PreparePage prepare() const override;
    void setResult(const SolvedBlowPtr& blow) override;
    bool showsMarched() const override { return true; }
    void setGhost(const SolvedBlowPtr& before) override;
    void setRuns(const RunListPtr& runs) override;

    RockPlot* rockPlot() const { return m_rock; }

  private:
    void showTime();

    Observation& m_observation;
    QLabel* m_instant;
    PlotWidget* m_plot;
    RockPlot* m_rock;
    SolvedBlowPtr m_blow;
    RunListPtr m_runs = std::make_shared<const RunList>();
};

}  // namespace drillwave

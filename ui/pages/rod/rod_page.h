// SPDX-License-Identifier: GPL-3.0-or-later
// The page Rod: the largest stresses at every section of rod or string, with place and time.
#pragma once

#include <vector>

#include "core/blow/string_blow.h"
#include "ui/job/observation.h"
#include "ui/pages/plot_page.h"

class QLabel;

namespace drillwave {

class RodPlot;
struct RodCurves;

class RodPage : public PlotPage {
    Q_OBJECT

  public:
    /// Creates the page. `observation` (observed section and time of all pages) must outlive it.
    explicit RodPage(Observation& observation, QWidget* parent = nullptr);

    QString title() const override { return tr("Rod"); }
    PreparePage prepare() const override;
    void setResult(const SolvedBlowPtr& blow) override;
    void setGhost(const SolvedBlowPtr& before) override;
    void setRuns(const RunListPtr& runs) override;

    RodPlot* rodPlot() const { return m_rod; }

  private:
    void showHere();
    void showReadout();
    std::vector<SectionStress> stresses() const;
    QString strengthText(std::size_t section) const;
    QString answer() const;
    std::optional<double> stressAt(double section, double time) const;
    void goTo(QPointF coordinates);
    const RodCurves* curves() const;

    Observation& m_observation;
    QLabel* m_readout;
    PlotWidget* m_plot;
    RodPlot* m_rod;
    SolvedBlowPtr m_blow;
    RunListPtr m_runs = std::make_shared<const RunList>();
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// The blow over time: waves at a section, impact force, impulse and momentum (paper, Figs. 3–5).
#pragma once

#include "ui/job/observation.h"
#include "ui/pages/plot_page.h"

class QHBoxLayout;
class QLabel;

namespace drillwave {

class BlowPlots;
struct ComputedForce;
class MeasuredBar;
class MeasuredCurves;
class MeasuredList;
struct MeasuredSignal;
class UnitChoice;
class PlaceField;

class BlowPage : public PlotPage {
    Q_OBJECT

  public:
    /// Creates the page. `observation` (observed section and time of all pages) must outlive it.
    explicit BlowPage(Observation& observation, QWidget* parent = nullptr);

    QString title() const override { return tr("Blow"); }
    PreparePage prepare() const override;
    void setResult(const SolvedBlowPtr& blow) override;
    bool showsMarched() const override { return true; }
    void setGhost(const SolvedBlowPtr& before) override;
    void setRuns(const RunListPtr& runs) override;

    /// Shows the measured signals of a list over the curves. Call it once; list and units must outlive the
    /// page.
    void follow(MeasuredList& measured, const UnitChoice& units);

    BlowPlots* plots() const { return m_plots; }
    const MeasuredCurves* measuredCurves() const { return m_measuredCurves; }

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QHBoxLayout* makeBar();
    void showSection();
    void showPlace();
    void reserveInstant();
    void showInstant();
    void setMeanings();
    void carryCursors();
    void goToPlace(double x);
    /// Returns the computed force to compare with a signal, over the time span of the plots. Nothing if the
    /// blow has no physical units, no histories or no curves.
    std::optional<ComputedForce> computedFor(const MeasuredSignal& signal) const;
    void align(std::size_t index);
    void showMisfit();
    void showMeasured();

    Observation& m_observation;
    QLabel* m_hint;
    PlaceField* m_section;
    QLabel* m_place;
    QLabel* m_instant;
    PlotWidget* m_plot;
    BlowPlots* m_plots;
    MeasuredList* m_measured = nullptr;
    MeasuredCurves* m_measuredCurves;
    MeasuredBar* m_measuredBar = nullptr;
    SolvedBlowPtr m_blow;
    RunListPtr m_runs = std::make_shared<const RunList>();
    ShownUnit m_cursorUnit;  // time unit of the positions of cursors A and B
};

}  // namespace drillwave

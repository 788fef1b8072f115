// SPDX-License-Identifier: GPL-3.0-or-later
// The page Wave picture: waves over position and time, and the rod or drill string at a moving instant
// (paper, Fig. 2).
#pragma once

#include <optional>

#include "ui/job/observation.h"
#include "ui/pages/plot_page.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;

namespace drillwave {

class PictureCursors;
class PlayBar;
class RodProfile;
class RodStrip;
class PlaceField;
class WavePicturePlot;

class WavePicturePage : public PlotPage {
    Q_OBJECT

  public:
    /// Creates the page. `observation` (observed section and time of all pages) must outlive it.
    explicit WavePicturePage(Observation& observation, QWidget* parent = nullptr);

    QString title() const override { return tr("Wave picture"); }
    PreparePage prepare() const override;
    void setResult(const SolvedBlowPtr& blow) override;
    bool showsMarched() const override { return true; }
    void setRuns(const RunListPtr& runs) override;

    WavePicturePlot* picture() const { return m_picture; }
    PictureCursors* cursors() const { return m_cursors; }
    RodProfile* rodProfile() const { return m_profile; }
    RodStrip* rodStrip() const { return m_strip; }
    PlayBar* playBar() const { return m_playBar; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QHBoxLayout* makeBar();
    void restoreChoices();
    void wire();
    void showTime();
    void showSpan();
    void alignStrip();
    void showReadout();
    double timeShown() const;

    Observation& m_observation;
    QComboBox* m_field;
    QCheckBox* m_fronts;
    PlaceField* m_section;
    QLabel* m_readout;
    PlotWidget* m_plot;
    WavePicturePlot* m_picture;
    PictureCursors* m_cursors;
    RodProfile* m_profile;
    RodStrip* m_strip;
    PlayBar* m_playBar;
    RunListPtr m_runs = std::make_shared<const RunList>();
    std::optional<QPointF> m_pointer;  // position of the mouse pointer over the plot
};

}  // namespace drillwave

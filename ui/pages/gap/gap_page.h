// SPDX-License-Identifier: GPL-3.0-or-later
// The page COR–gap: what a gap that nobody controls does to a result (paper, Fig. 8).
#pragma once

#include "core/model/blow_traits.h"
#include "ui/job/asked_study.h"
#include "ui/pages/gap/gap_picture.h"
#include "ui/pages/gap/gap_study.h"
#include "ui/pages/gap/run_gaps.h"
#include "ui/pages/study/study_page.h"
#include "ui/plot/curve_meaning.h"

namespace drillwave {

class ChoiceBox;
class GapPlot;
class ScatterFields;

class GapPage : public StudyPage {
    Q_OBJECT

  public:
    explicit GapPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("COR–gap"); }
    bool shows(const Scenario& scenario) const override { return gapHasPeriod(scenario); }
    QString elsewhere() const override;
    bool leadsElsewhere() const override { return true; }
    /// How many studies were started.
    int studies() const { return m_study.started(); }

    /// How many studies of runs were started.
    int runStudies() const { return m_runGaps.started(); }
    GapPlot* gapPlot() const { return m_plot; }

  protected:
    void ask() override;
    void present() override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    struct Shown {
        std::shared_ptr<const GapAnswer> answer;
        GapOutput output = GapOutput::cor;
        ShownUnits units;
        bool operator==(const Shown&) const = default;
    };
    ChoiceBox* outputBox();
    GapOutput output() const;
    Shown wanted() const;
    CurveMeaning meaning() const;
    void draw();
    void placeHere();
    void askRuns();
    void showRuns();
    void takeGap(double shownGap, Qt::KeyboardModifiers modifiers);
    QString sentence() const;

    ChoiceBox* m_output;
    ScatterFields* m_scatter;
    GapPlot* m_plot = nullptr;
    Shown m_shown;
    GapPicture m_picture;
    std::shared_ptr<const RunGaps::Answers> m_shownGaps;  // of runs, as they are drawn
    RunListPtr m_shownRuns;
    AskedStudy<GapQuestion, GapAnswer> m_study;  // goes first: its thread works
    RunGaps m_runGaps;                           // likewise
};

}  // namespace drillwave

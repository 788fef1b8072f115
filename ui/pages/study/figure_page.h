// SPDX-License-Identifier: GPL-3.0-or-later
// A page for any study that is described by a Study value.
#pragma once

#include "core/report/study.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/run_studies.h"
#include "ui/pages/study/study_page.h"
#include "ui/plot/figure_frame.h"

namespace drillwave {

class AnswerTable;
class ChoiceBox;
class MissingFields;
class OptionFields;

/// Page of a study: controls for its options, its sentences and its figure, with the results of pinned runs
/// (kept for comparison) drawn over it. A click on the figure can set a parameter. The object name of the
/// page is that of the study.
class FigurePage : public StudyPage {
    Q_OBJECT

  public:
    /// Creates the page. Study and document must outlive it.
    FigurePage(const Study& study, Document& document, QWidget* parent = nullptr);

    QString title() const override;
    bool shows(const Scenario& scenario) const override { return m_study.whyNot(scenario).isEmpty(); }
    QString elsewhere() const override;
    bool leadsElsewhere() const override { return m_study.isElsewhereOverGap; }
    /// Returns how many studies the page has started for the present scenario, for tests.
    int studies() const { return m_asked.started(); }
    /// Returns how many studies the page has started for pinned runs (results kept for comparison), for
    /// tests.
    int runStudies() const { return m_ofRuns.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    /// Returns the answer that is shown; nullptr before the first one.
    StudyAnswerPtr answer() const { return m_shown.answer; }

  protected:
    void ask() override;
    void present() override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    struct Shown {
        StudyAnswerPtr answer;
        std::size_t view = 0;
        ShownUnits units;
        bool operator==(const Shown&) const = default;
    };
    using RunAnswers = RunStudies<StudyQuestion, StudyAnswerPtr>;

    Shown wanted() const;
    void draw();
    void placeHere();
    void askRuns();
    void showRuns();
    void markRuns();
    bool isCompared(const Run& run) const;
    StudyQuestion questionOf(const Run& run) const;
    Message lacking() const;
    void refuse(const QString& why);
    void takePlace(const QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers);
    void hold(double y);
    void moveHeld(double y);

    const Study& m_study;
    ChoiceBox* m_view = nullptr;  // nullptr if the study has a single view
    OptionFields* m_options;
    FigureFrame* m_frame = nullptr;
    MissingFields* m_missing = nullptr;  // nullptr if the study needs no further values
    AnswerTable* m_table = nullptr;      // nullptr if the study has no table
    // Line that the user drags: the value that it sets, and y where the drag began.
    struct Held {
        int gesture = 0;
        double value = 0;
        double y = 0;
    };
    Held m_held;
    Shown m_shown;
    std::shared_ptr<const RunAnswers::Answers> m_shownAnswers;  // answers of pinned runs as drawn
    RunListPtr m_shownRuns;
    // Destroyed first, because their threads use other members.
    StudyRunner<StudyQuestion, StudyAnswerPtr> m_asked;
    RunAnswers m_ofRuns;  // answers for pinned runs
};

}  // namespace drillwave

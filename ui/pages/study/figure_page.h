// SPDX-License-Identifier: GPL-3.0-or-later
// The page of any study that is a value.
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

/// Controls of the study's options, its sentences and its figure, with the answers for pinned runs laid
/// over it. A click takes over a value of an axis with a target. Its object name is that of the study.
class FigurePage : public StudyPage {
    Q_OBJECT

  public:
    /// Study and document must outlive it.
    FigurePage(const Study& study, Document& document, QWidget* parent = nullptr);

    QString title() const override;
    bool shows(const Scenario& scenario) const override { return m_study.whyNot(scenario).isEmpty(); }
    QString elsewhere() const override;
    bool leadsElsewhere() const override { return m_study.isElsewhereOverGap; }
    /// How many studies were started, and how many of runs.
    int studies() const { return m_asked.started(); }
    int runStudies() const { return m_ofRuns.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    /// The answer that is shown; nullptr before the first.
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
    ChoiceBox* m_view = nullptr;  // none where there is one thing to see
    OptionFields* m_options;
    FigureFrame* m_frame = nullptr;
    MissingFields* m_missing = nullptr;  // none where nothing is asked for
    AnswerTable* m_table = nullptr;      // none where the study has no table
    // A line that is dragged: the value that it sets, and y where it was taken hold of.
    struct Held {
        int gesture = 0;
        double value = 0;
        double y = 0;
    };
    Held m_held;
    Shown m_shown;
    std::shared_ptr<const RunAnswers::Answers> m_shownAnswers;  // of runs, as they are drawn
    RunListPtr m_shownRuns;
    StudyRunner<StudyQuestion, StudyAnswerPtr> m_asked;  // goes first: its thread works
    RunAnswers m_ofRuns;                                 // the same
};

}  // namespace drillwave

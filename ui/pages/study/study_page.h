// SPDX-License-Identifier: GPL-3.0-or-later
// Common part of the pages of studies: when they compute, their sentences, and what they export.
#pragma once

#include <QBoxLayout>
#include <QTimer>
#include <optional>

#include "ui/document/document.h"
#include "ui/job/study_job.h"
#include "ui/pages/plot_page.h"

namespace drillwave {

class ScrolledLabel;
class SectionBox;
class StaleVeil;
struct FigureUnits;
struct ShownUnits;

/// A page around one plot of a study of the scenario that is being edited. The answer comes first, in bold,
/// then further sentences, the controls in a box that folds, the plot and its details. A study that may have
/// changed is asked for while the page can be seen, or as soon as it can; a page that goes out of sight stops
/// its study. Sentence, plot and what stands beside and below them are veiled where they are of an earlier
/// input for more than a moment, and hidden where they are of another scenario.
///
/// A page implements ask() (hand its question to its job, whose question is compared with the last),
/// present(), csv() and commandWords(), and calls arrange() and watch() as it is made.
class StudyPage : public PlotPage {
    Q_OBJECT

  public:
    /// The document must outlive the page.
    explicit StudyPage(Document& document, QWidget* parent = nullptr);

    /// A study is no part of the blow.
    PreparePage prepare() const override { return {}; }
    void setResult(const SolvedBlowPtr& blow) override;
    void setRuns(const RunListPtr& runs) override;
    void setCurrent(bool current) override;
    QList<PageExport> exports() const override;
    StudyActivity* activity() const override { return m_activity; }

    /// The command that writes the same CSV as exports(), see commandText(). Empty where there is none now.
    virtual QString command() const;

  public slots:
    virtual void copyCommand();

  protected:
    /// Asks the page's job for what the controls say of the scenario. Called only while it can be seen.
    virtual void ask() = 0;
    /// Shows what the job has, in the units of blow(), and where the present scenario is. Called whenever one
    /// of them has changed; blow() is nullptr before the first, and may be unsolved.
    virtual void present() = 0;
    /// Returns why the shown study cannot be exported now; empty if it can.
    virtual QString obstacle() const;
    /// The file that the command of command() writes, of the finished study.
    virtual QByteArray csv() const = 0;
    /// Name and words of the command, in front of "-o": {"gap", "--gap-mean", "1 mm"}. Empty where there is
    /// none.
    virtual QStringList commandWords() const = 0;

    QString answerText() const override;

    /// Builds the page: answer, controls in a row that wraps, plot with `beside` at its right. Returns the
    /// plot. Call it once.
    PlotWidget* arrange(const QList<QWidget*>& controls, QWidget* beside = nullptr);
    /// On a page narrower than `width` [px], `beside` is above the plot; otherwise it has a third of the
    /// width.
    void stackBelow(int width);
    enum class PartOf { question, answer };
    /// Adds a widget between the sentences and the controls, in view even while the controls are folded.
    void addAbove(QWidget* widget, PartOf part);
    /// Adds a widget below the plot as a part of the answer.
    void addBelow(QWidget* table);
    /// Box of the controls.
    SectionBox& settingsBox() const { return *m_settings; }
    /// The page's job. Once.
    void watch(StudyActivity& activity);
    /// Jobs beside it: present() is called when one has news, and out of sight they are stopped, to
    /// be asked again by present().
    void watchBeside(StudyActivity& activity);
    /// The question may be another one: ask() now, or as soon as the page can be seen.
    void requestUpdate();
    /// Shows the answer in bold and further sentences below it. A problem of the study replaces both.
    void say(const QString& answer, const QString& more = {});
    /// The same with the first sentence as the answer.
    void say(const QStringList& sentences);
    /// Shows the reason instead of the curves, and as the answer.
    void showNothing(const QString& why);
    /// The same where nothing is asked any more: no answer is on its way.
    void showNothingAsked(const QString& why);
    /// Takes over values of parameters as one undo step, as a click in the plot does; says why not.
    void load(const std::vector<ParameterValue>& values);
    /// Pins the scenario with those values, which stays as it is; says why not.
    void pin(const std::vector<ParameterValue>& values);
    /// The same with a whole scenario; `step` names the step.
    void load(const Scenario& scenario, const QString& step);
    /// The same with its text, byte for byte.
    void load(const ScenarioDocument& contents, const QString& step);
    void pin(const Scenario& scenario);
    /// The one or the other, by Shift.
    void take(const std::vector<ParameterValue>& values, Qt::KeyboardModifiers modifiers);

    /// Units of figures: those of the form for parameters, `units` for all else.
    FigureUnits figureUnits(const ShownUnits& units) const;
    Document& document() const { return m_document; }
    const Scenario& scenario() const { return m_document.scenario(); }
    const SolvedBlowPtr& blow() const { return m_blow; }
    /// The pinned runs; those that are solved and shown are laid over the plot.
    const RunList& runs() const { return *m_runs; }
    const RunListPtr& runList() const { return m_runs; }

    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void takeIntoAnswer(QWidget* widget);
    template <class Take>
    void takeStep(const Take& take, const QString& step);
    void askNow();
    void follow();
    void forget();
    void setStale(bool isStale);
    void showWords();

    Document& m_document;
    SolvedBlowPtr m_blow;
    RunListPtr m_runs = std::make_shared<const RunList>();
    StudyActivity* m_activity = nullptr;
    QVector<StudyActivity*> m_beside;
    bool m_due = true;           // something has changed while the page could not be seen
    bool m_inputCurrent = true;  // the blow on show answers the present input
    ScrolledLabel* m_words = nullptr;
    SectionBox* m_settings = nullptr;
    QBoxLayout* m_center = nullptr;  // the plot and what stands beside it
    int m_stackBelow = 0;            // width [px]
    QString m_sentence;
    QString m_more;
    QString m_refusal;         // why a value could not be taken over
    QList<QWidget*> m_answer;  // what stands beside and below the plot
    StaleVeil* m_veil = nullptr;
    bool m_isForeign = false;  // the answer is of another scenario
    QTimer m_late;
    std::uint64_t m_answers = 0;  // of the job, when it was looked at last
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
// Common part of the pages of studies: when they compute, their sentences, and their exports.
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

/// Page around the plot of a study of the present scenario.
///
/// From the top it has the answer in bold, further sentences, the controls in a box that folds, the plot and
/// details. While the page is visible, a study is requested whenever its input may have changed; hiding the
/// page stops it. Outdated sentences, plot and details are greyed out after a moment. They are hidden if they
/// belong to another document.
///
/// A derived class implements ask(), present(), csv() and commandWords(), and calls arrange() and watch() in
/// its constructor. ask() passes the present question to the page's StudyRunner. It does nothing for a
/// question whose study is already running or finished.
class StudyPage : public PlotPage {
    Q_OBJECT

  public:
    /// Creates the page. The document must outlive it.
    explicit StudyPage(Document& document, QWidget* parent = nullptr);

    /// Returns no function, because the study is computed separately from the blow.
    PreparePage prepare() const override { return {}; }
    void setResult(const SolvedBlowPtr& blow) override;
    void setRuns(const RunListPtr& runs) override;
    void setCurrent(bool current) override;
    QList<PageExport> exports() const override;
    StudyActivity* activity() const override { return m_activity; }

    /// Returns the command line that prints the same CSV as exports() save, see commandText(). Empty if there
    /// is none now.
    virtual QString command() const;

  public slots:
    virtual void copyCommand();

  protected:
    /// Starts the study that the controls describe, unless it is already running or finished. Called only
    /// while the page is visible.
    virtual void ask() = 0;
    /// Shows the latest results of the study in the units of blow(), and marks the present scenario in the
    /// plot. Called after any of them has changed. blow() is nullptr before the first blow, and may be
    /// unsolved.
    virtual void present() = 0;
    /// Returns why the shown study cannot be exported now; empty if it can.
    virtual QString obstacle() const;
    /// Returns the finished study as CSV, as the command line of commandWords() prints it.
    virtual QByteArray csv() const = 0;
    /// Returns name and arguments of the command that runs this study, without its option "-o" for the output
    /// file. An example is {"gap", "--gap-mean", "1 mm"}. Empty if there is none.
    virtual QStringList commandWords() const = 0;

    QString answerText() const override;

    /// Builds the page: answer, controls in a row that wraps, and the plot with `beside` at its right.
    /// Returns the plot. Call it once.
    PlotWidget* arrange(const QList<QWidget*>& controls, QWidget* beside = nullptr);
    /// Sets the page width [px] below which the widget beside the plot moves above the plot. On a wider page
    /// this widget has a third of the width.
    void stackBelow(int width);
    /// Group that a widget belongs to: `question` for controls, `answer` for results. Widgets of the answer
    /// are greyed out while the answer is out of date.
    enum class PartOf { question, answer };
    /// Adds a widget between the sentences and the controls, visible even while the controls are folded.
    void addAbove(QWidget* widget, PartOf part);
    /// Adds a widget, such as a table of results, below the plot. It is greyed out together with the plot
    /// while the results are out of date.
    void addBelow(QWidget* table);
    /// Returns the box that contains the controls and can be folded.
    SectionBox& settingsBox() const { return *m_settings; }
    /// Returns whether the page may fold its controls now if the window is too low to show controls and plot.
    virtual bool canFoldSettings() const { return true; }
    /// Sets the study that gives the page's answer. Call it once.
    void watch(StudyActivity& activity);
    /// Adds a study that runs beside the main study of the page. Each update of this study calls present().
    /// Hiding the page stops it until present() starts it again.
    void watchBeside(StudyActivity& activity);
    /// Updates the study to the present input: calls ask() now, or as soon as the page is visible.
    void requestUpdate();
    /// Shows the answer in bold and further sentences below it. An error of the study replaces both.
    void say(const QString& answer, const QString& more = {});
    /// Shows the first sentence in bold as the answer of the page, and the others below it.
    void say(const QStringList& sentences);
    /// Shows the reason why there is no result, instead of the curves and as the answer.
    void showNothing(const QString& why);
    /// Shows the reason why no study is requested, instead of the curves and as the answer. Removes the grey
    /// that marks outdated results.
    void showNothingAsked(const QString& why);
    /// Sets parameters of the scenario as one undo step, like a click in the plot. Shows the reason if this
    /// is impossible.
    void load(const std::vector<ParameterValue>& values);
    /// Requests a pinned run (a result kept for comparison) for the scenario with these values; the scenario
    /// itself is unchanged. Shows the reason if this is impossible.
    void pin(const std::vector<ParameterValue>& values);
    /// Replaces the scenario as one undo step with the name `step`. Shows the reason if this is impossible.
    void load(const Scenario& scenario, const QString& step);
    /// Replaces the scenario and its text, byte for byte, as one undo step with the name `step`. Shows the
    /// reason if this is impossible.
    void load(const ScenarioDocument& contents, const QString& step);
    /// Requests a pinned run (a result kept for comparison) for a scenario. Shows the reason if this is
    /// impossible.
    void pin(const Scenario& scenario);
    /// Sets these parameters of the scenario as one undo step. If `modifiers` contains Shift, it leaves the
    /// scenario unchanged and pins a run with these values (a result kept for comparison).
    void take(const std::vector<ParameterValue>& values, Qt::KeyboardModifiers modifiers);

    /// Returns the units in which values of a scenario are shown: those chosen in the window, with the scales
    /// of this scenario. Without a blow they are SI units, and for a dimensionless scenario dimensionless
    /// ones.
    ShownUnits unitsFor(const Scenario& scenario) const;
    /// Returns the units of figures: parameters have those of their input fields, all other quantities those
    /// in `units`.
    FigureUnits figureUnits(const ShownUnits& units) const;
    Document& document() const { return m_document; }
    const Scenario& scenario() const { return m_document.scenario(); }
    const SolvedBlowPtr& blow() const { return m_blow; }
    /// Returns the pinned runs (results kept for comparison). Solved runs that are shown are drawn over the
    /// plot.
    const RunList& runs() const { return *m_runs; }
    const RunListPtr& runList() const { return m_runs; }

    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void takeIntoAnswer(QWidget* widget);
    void foldSettings();
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
    bool m_due = true;           // whether the input has changed while the page was hidden
    bool m_inputCurrent = true;  // whether the blow shown belongs to the present input
    ScrolledLabel* m_words = nullptr;
    SectionBox* m_settings = nullptr;
    bool m_isLow = false;            // whether the window is too low for open settings
    bool m_hasFolded = false;        // whether the settings are folded because of m_isLow
    QBoxLayout* m_center = nullptr;  // the plot and the widget beside it
    int m_stackBelow = 0;            // width below which they are stacked [px]
    QString m_sentence;
    QString m_more;
    QString m_refusal;         // reason why a value could not be taken into the scenario
    QList<QWidget*> m_answer;  // widgets beside and below the plot
    StaleVeil* m_veil = nullptr;
    bool m_isForeign = false;  // whether the answer belongs to another document
    QTimer m_late;
    std::uint64_t m_answers = 0;  // number of answers of the study when last checked
};

}  // namespace drillwave

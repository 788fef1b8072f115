// SPDX-License-Identifier: GPL-3.0-or-later
// Main window, which creates the parts of the program and connects them.
#pragma once

#include <QMainWindow>
#include <memory>

#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/document/measured_list.h"
#include "ui/job/observation.h"
#include "ui/job/solve_job.h"
#include "ui/questions/questions.h"

class QSessionManager;

namespace drillwave {

class AlertLink;
class CurvePage;
class ExampleNote;
class ExportMenu;
class FileNotice;
class FormNotice;
class FileMenu;
class Importer;
class MarchedNotice;
class WavesNotice;
class PageTabs;
class PinnedRuns;
class Recovery;
class ReportWriter;
class ResultPanel;
class IdentifyPage;
class RodPage;
class ScenarioPanel;
class SolveStatus;
class StringPage;
class StudyStatus;
class TakenNotice;
class UnitsChoice;
class WindowLayout;
struct Example;

/// Main window of the program. At first it shows the default example, already solved.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    /// Creates a window for tests: `solve` solves the blows, and `questions` answers what the window would
    /// ask the user.
    MainWindow(std::unique_ptr<Questions> questions, SolveJob::Solve solve, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a scenario file. Returns true on success, else shows the reason.
    bool openFile(const QString& path);
    void openExample(const Example& example);
    /// Stores unsaved changes in this folder from now on. Offers to restore the unsaved changes of instances
    /// that crashed.
    void startRecovery(const QString& folder);

    /// Returns true if the window was closed so that a new window opens at once with the same contents.
    bool wantsRestart() const { return m_wantsRestart; }

    Document& document() { return m_document; }
    /// Returns the blow whose results are displayed; it may belong to an earlier input. nullptr before the
    /// first one is solved.
    const SolvedBlowPtr& shown() const { return m_shown; }

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    MainWindow(std::unique_ptr<Questions> questions, std::unique_ptr<SolveJob> job, QWidget* parent);
    void addTabs();
    void addCenter();
    void addDocks();
    void addMenus();
    void addStatusBar();
    void showLead();
    void wire();
    void wireSolving();
    void wireImport();
    void takeDropped(const QStringList& paths);
    void followPage();
    void goToPlace(double section, double time);
    void goToParameter(const QString& key);
    void seekGoal(const QString& key);
    bool mayClose();
    void restart();
    void saveChoices() const;
    void endSession(QSessionManager& session);
    void inform(const QString& message);

    SolveRequest request();
    void solve();
    void present(const SolvedBlowPtr& blow);
    void presentState();
    void markResult(bool outOfDate);

    Document m_document;
    FileWatch m_watch{m_document, this};
    Observation m_observation{this};
    MeasuredList m_measured{m_document.undoStack(), this};
    std::unique_ptr<Questions> m_questions;
    std::unique_ptr<SolveJob> m_job;
    SolvedBlowPtr m_shown;
    bool m_wantsRestart = false;
    std::uint64_t m_asked = 0;  // number of the last request to the solver

    FileMenu* m_fileMenu = nullptr;
    ExportMenu* m_exportMenu = nullptr;
    ExampleNote* m_exampleNote = nullptr;
    FileNotice* m_fileNotice = nullptr;
    FormNotice* m_formNotice = nullptr;
    MarchedNotice* m_marchedNotice = nullptr;
    TakenNotice* m_takenNotice = nullptr;
    WavesNotice* m_wavesNotice = nullptr;
    Recovery* m_recovery = nullptr;
    PinnedRuns* m_runs = nullptr;
    ResultPanel* m_resultPanel = nullptr;
    QWidget* m_resultSide = nullptr;  // panel with the result, and the pinned runs below it
    bool m_isResultShown = false;
    UnitsChoice* m_units;
    ReportWriter* m_report;
    PageTabs* m_pages;
    CurvePage* m_curvePage = nullptr;
    IdentifyPage* m_identifyPage = nullptr;
    RodPage* m_rodPage = nullptr;
    StringPage* m_stringPage = nullptr;
    SolveStatus* m_solveStatus;
    AlertLink* m_alertLink = nullptr;
    StudyStatus* m_studyStatus;
    WindowLayout* m_layout;
    // Declared last, because its destructor delivers the last edits and needs the members above.
    std::unique_ptr<ScenarioPanel> m_scenarioPanel;
    std::unique_ptr<Importer> m_importer;
};

}  // namespace drillwave

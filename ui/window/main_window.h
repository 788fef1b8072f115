// SPDX-License-Identifier: GPL-3.0-or-later
// The window: puts the parts together and wires them, and does nothing else.
#pragma once

#include <QMainWindow>
#include <memory>

#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/job/observation.h"
#include "ui/job/solve_job.h"
#include "ui/questions/questions.h"

class QDockWidget;
class QRadioButton;
class QSessionManager;
class QTabWidget;

namespace drillwave {

class BlowPage;
class ExampleNote;
class ExportMenu;
class FileNotice;
class FileMenu;
class Page;
class Recovery;
class ResultPanel;
class ScenarioPanel;
class SolveStatus;
class StaleVeil;

/// Opens with the default example, solved.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    /// With another solver and other answers to its questions.
    MainWindow(std::unique_ptr<Questions> questions, SolveJob::Solve solve, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a scenario file, or tells why it cannot. True when opened.
    bool openFile(const QString& path);
    /// Keeps unsaved changes in a folder from now on, and offers those of instances that died.
    void startRecovery(const QString& folder);

    Document& document() { return m_document; }
    SolveJob& job() { return *m_job; }
    FileMenu& fileMenu() { return *m_fileMenu; }
    ExportMenu& exportMenu() { return *m_exportMenu; }
    ExampleNote& exampleNote() { return *m_exampleNote; }
    FileNotice& fileNotice() { return *m_fileNotice; }
    FileWatch& fileWatch() { return m_watch; }
    ScenarioPanel& scenarioPanel() { return *m_scenarioPanel; }
    ResultPanel& resultPanel() { return *m_resultPanel; }
    BlowPage& blowPage() { return *m_blowPage; }
    Observation& observation() { return m_observation; }
    SolveStatus& solveStatus() { return *m_solveStatus; }
    /// What is on show.
    const SolvedBlowPtr& shown() const { return m_shown; }
    /// Dimensionless or SI; a dimensionless scenario has no SI.
    void setUnits(UnitSystem units);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    MainWindow(std::unique_ptr<Questions> questions, std::unique_ptr<SolveJob> job, QWidget* parent);
    void addNotices();
    void addDocks();
    void addPage(Page* page);
    void setGhost(const SolvedBlowPtr& before);
    void addMenus();
    void addViewMenu();
    void addStatusBar();
    void wire();
    void restoreChoices();
    void restoreLayout();
    void resetLayout();
    void stackDocks();
    void saveChoices() const;
    void endSession(QSessionManager& session);

    Page& currentPage() const;
    SolveRequest request();
    void solve();
    void present(const SolvedBlowPtr& blow);
    void presentState();
    void presentUnits();
    void markResult(bool outOfDate);

    Document m_document;
    FileWatch m_watch{m_document};
    Observation m_observation;
    std::unique_ptr<Questions> m_questions;
    std::unique_ptr<SolveJob> m_job;
    SolvedBlowPtr m_shown;
    std::uint64_t m_asked = 0;  // the number of the last request
    UnitSystem m_units = UnitSystem::si;

    FileMenu* m_fileMenu = nullptr;
    ExportMenu* m_exportMenu = nullptr;
    ExampleNote* m_exampleNote = nullptr;
    FileNotice* m_fileNotice = nullptr;
    Recovery* m_recovery = nullptr;
    ScenarioPanel* m_scenarioPanel = nullptr;
    ResultPanel* m_resultPanel = nullptr;
    QTabWidget* m_pages = nullptr;
    BlowPage* m_blowPage = nullptr;
    SolveStatus* m_solveStatus = nullptr;
    StaleVeil* m_pageVeil = nullptr;
    QRadioButton* m_dimensionless = nullptr;
    QRadioButton* m_si = nullptr;
    QAction* m_dimensionlessAction = nullptr;
    QAction* m_siAction = nullptr;
    QList<QDockWidget*> m_docks;
    // What a preset leaves of the case before it.
    enum class GhostStay { no, overThisChange, untilTheNextChange };
    GhostStay m_ghostStays = GhostStay::no;
    bool m_restored = false;
    QSize m_firstSize;       // where there is none of the last run
    bool m_stacked = false;  // the panels share a side for want of room
};

}  // namespace drillwave

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QRadioButton>
#include <QScreen>
#include <QSessionManager>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>

#include "core/file/examples.h"
#include "ui/document/recovery.h"
#include "ui/export/export_menu.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/solve_status.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/rock/rock_page.h"
#include "ui/pages/wave_picture/wave_picture_page.h"
#include "ui/result/result_panel.h"
#include "ui/result/stale_veil.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/window/example_note.h"
#include "ui/window/file_drop.h"
#include "ui/window/file_menu.h"
#include "ui/window/file_notice.h"
#include "ui/window/help_menu.h"
#include "ui/window/on_screen.h"
#include "ui/window/recovery_offer.h"

namespace drillwave {
namespace {

// Raised when docks or toolbars change so that an old layout no longer fits.
constexpr int layoutVersion = 1;
const QString geometryKey = QStringLiteral("window/geometry");
const QString layoutKey = QStringLiteral("window/layout");
const QString stackedKey = QStringLiteral("window/stacked");
const QString pageKey = QStringLiteral("window/page");
const QString unitsKey = QStringLiteral("window/units");
const QString siName = QStringLiteral("si");
const QString dimensionlessName = QStringLiteral("dimensionless");
constexpr int messageMilliseconds = 8000;

QString statusText(const SolvedBlow& blow) {
    if (!blow.problem.isEmpty()) return MainWindow::tr("exact · not solved");
    const QLocale locale;
    const int contacts = blow.impact.contacts;
    return MainWindow::tr("exact · %1 · %2 · e = %3")
        .arg(contacts == 1 ? MainWindow::tr("1 contact") : MainWindow::tr("%1 contacts").arg(contacts),
             runTimeText(blow.runTime, locale), numberText(blow.summary.cor, 4, locale));
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : MainWindow(std::make_unique<DialogQuestions>(), std::make_unique<SolveJob>(), parent) {}

MainWindow::MainWindow(std::unique_ptr<Questions> questions, SolveJob::Solve solve, QWidget* parent)
    : MainWindow(std::move(questions), std::make_unique<SolveJob>(std::move(solve)), parent) {}

MainWindow::MainWindow(std::unique_ptr<Questions> questions, std::unique_ptr<SolveJob> job, QWidget* parent)
    : QMainWindow(parent), m_questions(std::move(questions)), m_job(std::move(job)) {
    const Example& example = defaultExample();
    m_document.startFrom(example.text, QString::fromStdString(example.name));
    m_pages = new QTabWidget(this);
    m_pages->setDocumentMode(true);
    m_pages->setTabBarAutoHide(true);
    m_pageVeil = new StaleVeil(m_pages->findChild<QStackedWidget*>());
    m_solveStatus = new SolveStatus(this);
    addNotices();
    addDocks();
    addPage(m_blowPage = new BlowPage(m_observation));
    addPage(new WavePicturePage(m_observation));
    addPage(new RockPage(m_observation));
    addMenus();
    addStatusBar();
    wire();
    presentState();
    restoreChoices();
    m_exampleNote->explainFirst(example);
    present(m_job->solveNow(request()));
}

// The panel hands the last edits over as it goes: while the document is still there. A dock of its own does
// not go out of sight with the window.
MainWindow::~MainWindow() {
    hide();
    delete m_scenarioPanel;
}

void MainWindow::addNotices() {
    m_fileNotice = new FileNotice(m_document, m_watch, *m_questions);
    m_exampleNote = new ExampleNote;
    auto* center = new QWidget(this);
    auto* layout = new QVBoxLayout(center);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_fileNotice);
    layout->addWidget(m_exampleNote);
    layout->addWidget(m_pages, 1);
    setCentralWidget(center);
}

void MainWindow::addDocks() {
    const auto addDock = [this](const QString& title, const QString& name, QWidget* content,
                                Qt::DockWidgetArea area) {
        auto* dock = new QDockWidget(title, this);
        dock->setObjectName(name);
        dock->setWidget(content);
        addDockWidget(area, dock);
        m_docks.append(dock);
    };
    m_scenarioPanel = new ScenarioPanel(m_document, *m_questions);
    m_resultPanel = new ResultPanel;
    addDock(tr("Scenario"), QStringLiteral("scenario"), m_scenarioPanel, Qt::LeftDockWidgetArea);
    addDock(tr("Result"), QStringLiteral("result"), m_resultPanel, Qt::RightDockWidgetArea);
}

void MainWindow::addPage(Page* page) {
    m_pages->addTab(page, page->title());
    connect(page, &Page::exportRequested, this,
            [this](const PageExport& wanted) { m_exportMenu->save(wanted); });
    connect(m_solveStatus, &SolveStatus::currentChanged, page, &Page::setCurrent);
    connect(page, &Page::needsChanged, this, [this, page] {
        if (page == m_pages->currentWidget()) solve();
    });
}

void MainWindow::addMenus() {
    m_exportMenu = new ExportMenu(
        m_document, *m_questions,
        {[this] { return m_solveStatus->isCurrent() ? m_shown : nullptr; },
         [this](const QString& what, auto then) { m_solveStatus->whenCurrent(what, std::move(then)); }},
        this);
    m_exportMenu->setExports(currentPage().exports());
    m_fileMenu = new FileMenu(m_document, *m_questions, m_watch, m_exportMenu, this);
    menuBar()->addMenu(m_fileMenu);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_document.undoStack().createUndoAction(edit, tr("&Undo"));
    undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
    QAction* redo = m_document.undoStack().createRedoAction(edit, tr("&Redo"));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addActions({undo, redo});
    addViewMenu();
    menuBar()->addMenu(new HelpMenu(*m_questions, this));
}

void MainWindow::addViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    auto* units = new QActionGroup(this);
    m_dimensionlessAction = units->addAction(tr("&Dimensionless"));
    m_dimensionlessAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_D));
    m_siAction = units->addAction(tr("&SI units"));
    m_siAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_I));
    connect(m_dimensionlessAction, &QAction::triggered, this,
            [this] { setUnits(UnitSystem::dimensionless); });
    connect(m_siAction, &QAction::triggered, this, [this] { setUnits(UnitSystem::si); });
    for (QAction* action : units->actions()) action->setCheckable(true);
    view->addActions(units->actions());
    view->addSeparator();
    view->addAction(tr("&Fit plots"), QKeySequence(Qt::CTRL | Qt::Key_0), this,
                    [this] { currentPage().fit(); });
    view->addSeparator();
    for (QDockWidget* dock : std::as_const(m_docks)) view->addAction(dock->toggleViewAction());
    view->addAction(tr("&Reset layout"), this, &MainWindow::resetLayout);
    view->addSeparator();
    view->addAction(m_exampleNote->action());
}

void MainWindow::addStatusBar() {
    m_dimensionless = new QRadioButton(tr("dimensionless"), this);
    m_si = new QRadioButton(tr("SI"), this);
    m_dimensionless->setAccessibleName(tr("Show results dimensionless"));
    m_si->setAccessibleName(tr("Show results in SI units"));
    statusBar()->addWidget(m_solveStatus);
    statusBar()->addPermanentWidget(m_dimensionless);
    statusBar()->addPermanentWidget(m_si);
    connect(m_dimensionless, &QRadioButton::clicked, this, [this] { setUnits(UnitSystem::dimensionless); });
    connect(m_si, &QRadioButton::clicked, this, [this] { setUnits(UnitSystem::si); });
}

void MainWindow::wire() {
    connect(&m_document, &Document::scenarioChanged, this, [this] {
        // The case before a preset stays to compare with until the next change.
        if (m_ghostStays == GhostStay::untilTheNextChange) setGhost(nullptr);
        m_ghostStays =
            m_ghostStays == GhostStay::overThisChange ? GhostStay::untilTheNextChange : GhostStay::no;
        m_solveStatus->callOff(tr("the input was changed meanwhile."));
        solve();
    });
    connect(&m_document, &Document::stateChanged, this, &MainWindow::presentState);
    connect(&m_document, &Document::stateChanged, m_exampleNote,
            [this] { m_exampleNote->setChanged(m_document.scenario() != m_document.source().scenario); });
    connect(m_pages, &QTabWidget::currentChanged, this, [this] {
        m_solveStatus->callOff(tr("another page was chosen meanwhile."));
        m_exportMenu->setExports(currentPage().exports());
        solve();
    });
    connect(&m_document, &Document::replaced, m_exampleNote, &ExampleNote::forget);
    connect(m_fileMenu, &FileMenu::exampleOpened, m_exampleNote, &ExampleNote::explain);
    connect(new FileDrop(this), &FileDrop::dropped, m_fileMenu, &FileMenu::take);
    connect(m_exportMenu, &ExportMenu::exported, this,
            [this](const QString& message) { statusBar()->showMessage(message, messageMilliseconds); });
    connect(qApp, &QGuiApplication::commitDataRequest, this, &MainWindow::endSession, Qt::DirectConnection);
    connect(m_scenarioPanel, &ScenarioPanel::dragStarted, this, [this] { setGhost(m_shown); });
    connect(m_scenarioPanel, &ScenarioPanel::dragEnded, this, [this] { setGhost(nullptr); });
    connect(&m_document, &Document::presetTaken, this, [this] {
        setGhost(m_shown);
        m_ghostStays = GhostStay::overThisChange;
    });
    connect(m_resultPanel, &ResultPanel::timeChosen, &m_observation, &Observation::setTime);
    connect(&m_observation, &Observation::timeChanged, m_resultPanel, &ResultPanel::setTime);
    connect(m_resultPanel, &ResultPanel::parameterChosen, m_scenarioPanel, &ScenarioPanel::goTo);
    connect(m_job.get(), &SolveJob::solved, this, &MainWindow::present);
    connect(m_solveStatus, &SolveStatus::stopRequested, m_job.get(), &SolveJob::cancel);
    connect(m_solveStatus, &SolveStatus::solveRequested, this, &MainWindow::solve);
    connect(m_solveStatus, &SolveStatus::marked, this, &MainWindow::markResult);
    connect(m_solveStatus, &SolveStatus::calledOff, this,
            [this](const QString& message) { statusBar()->showMessage(message, messageMilliseconds); });
}

bool MainWindow::openFile(const QString& path) {
    return m_fileMenu->openFile(path);
}

void MainWindow::startRecovery(const QString& folder) {
    m_recovery = new Recovery(m_document, folder, this);
    connect(m_recovery, &Recovery::failed, this, [this](const QString& problem) {
        m_questions->tell(this, Questions::Tone::failure,
                          tr("Unsaved changes cannot be kept for the case of a crash."), problem);
    });
    offerLostChanges(folder, m_document, *m_recovery, *m_questions, this);
}

// The desktop ends the session: the window may not get another chance to ask.
void MainWindow::endSession(QSessionManager& session) {
    if (!session.allowsInteraction()) return;
    if (m_fileMenu->mayDiscard())
        saveChoices();
    else
        session.cancel();
    session.release();
}

Page& MainWindow::currentPage() const {
    return *static_cast<Page*>(m_pages->currentWidget());
}

void MainWindow::setGhost(const SolvedBlowPtr& before) {
    currentPage().setGhost(before);
}

SolveRequest MainWindow::request() {
    SolveRequest request;
    request.number = ++m_asked;
    request.scenario = m_document.scenario();
    const bool hasSi = naturalUnits(request.scenario) == UnitSystem::si;
    request.units = hasSi ? m_units : UnitSystem::dimensionless;
    request.pages = {currentPage().prepare()};
    return request;
}

void MainWindow::solve() {
    m_solveStatus->asked();
    m_job->submit(request());
}

void MainWindow::present(const SolvedBlowPtr& blow) {
    m_shown = blow;
    m_resultPanel->present(blow);
    currentPage().setResult(blow);
    presentUnits();
    if (blow->request.number == m_asked)
        m_solveStatus->answered(statusText(*blow));
    else
        m_solveStatus->answeredEarlier();
}

void MainWindow::markResult(bool outOfDate) {
    if (outOfDate) statusBar()->clearMessage();  // it would cover what the solver does
    m_pageVeil->raise();
    m_pageVeil->setVisible(outOfDate);
    m_resultPanel->setOutOfDate(outOfDate);
}

void MainWindow::setUnits(UnitSystem units) {
    m_units = units;
    presentUnits();
    m_solveStatus->callOff(tr("other units were chosen meanwhile."));
    solve();
}

void MainWindow::presentUnits() {
    const bool hasSi = naturalUnits(m_document.scenario()) == UnitSystem::si;
    const bool si = hasSi && m_units == UnitSystem::si;
    m_si->setEnabled(hasSi);
    m_siAction->setEnabled(hasSi);
    m_si->setToolTip(hasSi ? QString() : tr("This scenario is dimensionless: it has no SI values."));
    m_si->setChecked(si);
    m_siAction->setChecked(si);
    m_dimensionless->setChecked(!si);
    m_dimensionlessAction->setChecked(!si);
}

void MainWindow::presentState() {
    const QString file = QFileInfo(m_document.path()).fileName();
    const QString name = m_document.displayName();
    setWindowTitle(file.isEmpty() || file == name ? tr("%1[*] — Drillwave").arg(name)
                                                  : tr("%1 – %2[*] — Drillwave").arg(name, file));
    setWindowModified(m_document.isModified());
    setWindowFilePath(m_document.path());
}

void MainWindow::resetLayout() {
    m_stacked = false;
    QTimer::singleShot(0, this, &MainWindow::stackDocks);
    const QList<Qt::DockWidgetArea> areas{Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea};
    for (qsizetype i = 0; i < m_docks.size(); ++i) {
        m_docks[i]->setFloating(false);
        if (dockWidgetArea(m_docks[i]) != areas[i]) addDockWidget(areas[i], m_docks[i]);
        m_docks[i]->show();
    }
    const int wanted = m_scenarioPanel->sizeHint().width() + m_resultPanel->sizeHint().width();
    // A small window stays small: docks that ask for more than there is would widen it.
    if (wanted + m_pages->minimumSizeHint().width() > width()) return;
    resizeDocks(m_docks, {m_scenarioPanel->sizeHint().width(), m_resultPanel->sizeHint().width()},
                Qt::Horizontal);
}

void MainWindow::restoreChoices() {
    const Settings settings;
    resize(QSize(1440, 900).boundedTo(screen()->availableSize()));
    if (restoreGeometry(settings.value(geometryKey).toByteArray()))
        keepOnScreen(*this);
    else
        m_firstSize = size();
    if (settings.value(unitsKey).toString() == dimensionlessName) m_units = UnitSystem::dimensionless;
    const QString page = settings.value(pageKey).toString();
    for (int i = 0; i < m_pages->count(); ++i)
        if (QLatin1String(m_pages->widget(i)->metaObject()->className()) == page) m_pages->setCurrentIndex(i);
}

void MainWindow::saveChoices() const {
    Settings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(layoutKey, saveState(layoutVersion));
    settings.setValue(stackedKey, m_stacked);
    settings.setValue(unitsKey, m_units == UnitSystem::si ? siName : dimensionlessName);
    settings.setValue(pageKey, QLatin1String(currentPage().metaObject()->className()));
}

void MainWindow::restoreLayout() {
    if (restoreState(Settings().value(layoutKey).toByteArray(), layoutVersion))
        m_stacked = Settings().value(stackedKey).toBool();
    else
        resetLayout();
    for (QDockWidget* dock : std::as_const(m_docks))
        if (dock->isFloating()) keepOnScreen(*dock);
    stackDocks();
    if (size() == m_firstSize) fitOnScreen(*this);  // only now its frame is known
}

// Side by side the panels leave a narrow window no room for the page: they share one side.
void MainWindow::stackDocks() {
    const auto besideEachOther = [this] {
        return !m_docks[0]->isFloating() && !m_docks[1]->isFloating() && m_docks[0]->isVisible() &&
               m_docks[1]->isVisible() && dockWidgetArea(m_docks[0]) != dockWidgetArea(m_docks[1]);
    };
    const int wanted = m_scenarioPanel->minimumSizeHint().width() + m_resultPanel->minimumSizeHint().width() +
                       centralWidget()->minimumSizeHint().width();
    if (!m_stacked && width() < wanted && besideEachOther()) {
        tabifyDockWidget(m_docks[0], m_docks[1]);
        m_docks[0]->raise();
        m_stacked = true;
    } else if (m_stacked && width() >= wanted) {
        m_stacked = false;
        addDockWidget(Qt::RightDockWidgetArea, m_docks[1]);
    }
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (m_restored) QTimer::singleShot(0, this, &MainWindow::stackDocks);
}

// Restored before the window is shown, docks come out in wrong sizes.
void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_restored, true)) return;
    QTimer::singleShot(0, this, &MainWindow::restoreLayout);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_fileMenu->mayDiscard()) return event->ignore();
    saveChoices();
    if (m_recovery) m_recovery->end();
    event->accept();
}

}  // namespace drillwave

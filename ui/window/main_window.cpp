// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"
#include "core/report/study.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QSessionManager>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "core/blow/blow_waves.h"
#include "core/model/blow_traits.h"
#include "core/study/drilling/sequence.h"
#include "core/yaml/examples.h"
#include "ui/document/recovery.h"
#include "ui/export/export_menu.h"
#include "ui/export/report_writer.h"
#include "ui/form/scenario_panel.h"
#include "ui/help/help_topic.h"
#include "ui/import/importer.h"
#include "ui/job/study_status.h"
#include "ui/pages/accuracy/accuracy_page.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/design/design_page.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/pages/identify/identify_page.h"
#include "ui/pages/map/map_page.h"
#include "ui/pages/rock/rock_page.h"
#include "ui/pages/rod/rod_page.h"
#include "ui/pages/string/string_page.h"
#include "ui/pages/study/figure_page.h"
#include "ui/pages/wave_picture/wave_picture_page.h"
#include "ui/result/alert_list.h"
#include "ui/result/result_panel.h"
#include "ui/text/number_text.h"
#include "ui/window/blow_ghost.h"
#include "ui/window/document_notices.h"
#include "ui/window/file_menu.h"
#include "ui/window/manual_help.h"
#include "ui/window/page_notices.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/recovery_offer.h"
#include "ui/window/study_menu.h"
#include "ui/window/tab_strip.h"
#include "ui/window/units_choice.h"
#include "ui/window/view_menu.h"
#include "ui/window/window_layout.h"

namespace drillwave {
namespace {

constexpr int messageMilliseconds = 8000;

QString statusText(const SolvedBlow& blow) {
    const bool isExact = methodKey(blow.request.scenario, Method::exact) == name(Method::exact);
    if (!blow.fault.isEmpty())
        return isExact ? MainWindow::tr("exact method · not solved")
                       : MainWindow::tr("cell method · not solved");
    const QLocale locale;
    if (!isExact)
        return MainWindow::tr("cell method · computed in %1 · efficiency %2 ± %3")
            .arg(runTimeText(blow.runTime, locale), numberText(blow.summary.energy.rockWork, 4, locale),
                 magnitudeText(blow.summary.efficiencyError, locale));
    const int peaks = blow.summary.forcePeaks.value_or(0);
    return MainWindow::tr("exact method · %1 · computed in %2 · e = %3 ± %4")
        .arg(peaks == 1 ? MainWindow::tr("1 force peak") : MainWindow::tr("%1 force peaks").arg(peaks),
             runTimeText(blow.runTime, locale), numberText(blow.summary.cor, 4, locale),
             magnitudeText(blow.summary.corError, locale));
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : MainWindow(std::make_unique<DialogQuestions>(), std::make_unique<SolveJob>(), parent) {}

MainWindow::MainWindow(std::unique_ptr<Questions> questions, SolveJob::Solve solve, QWidget* parent)
    : MainWindow(std::move(questions), std::make_unique<SolveJob>(std::move(solve)), parent) {}

MainWindow::MainWindow(std::unique_ptr<Questions> questions, std::unique_ptr<SolveJob> job, QWidget* parent)
    : QMainWindow(parent),
      m_questions(std::move(questions)),
      m_job(std::move(job)),
      m_units(new UnitsChoice(m_document.units(), this)),
      m_report(new ReportWriter(m_document, *m_questions, this)),
      m_pages(new PageTabs(this)),
      m_solveStatus(new SolveStatus(this)),
      m_studyStatus(new StudyStatus(this)),
      m_layout(new WindowLayout(this)) {
    m_job->setParent(this);
    const Example& example = defaultExample();
    m_document.startFrom(example.text, QString::fromStdString(example.name));
    m_runs = new PinnedRuns(m_document, *m_questions, this);
    // Before any page hears of it: none is to ask for studies of what it cannot show.
    connect(&m_document, &Document::scenarioChanged, m_pages,
            [this] { m_pages->follow(m_document.scenario()); });
    connect(m_pages, &PageTabs::stringWanted, this, [this] {
        const QAction& toString = *m_formNotice->toString();
        if (!toString.isEnabled()) return inform(toString.toolTip());
        m_formNotice->toString()->trigger();
        if (m_stringPage->shows(m_document.scenario())) m_pages->setCurrentWidget(m_stringPage);
    });
    connect(&m_document, &Document::scenarioChanged, &m_observation, [this] {
        const Scenario& scenario = m_document.scenario();
        m_observation.setRear(hammerRear(scenario.drillString));
    });
    addTabs();
    addCenter();
    addDocks();
    auto* blow = new BlowPage(m_observation);
    blow->follow(m_measured, m_document.units());
    m_pages->add(blow, PageGroup::thisBlow);
    m_pages->add(new WavePicturePage(m_observation), PageGroup::thisBlow);
    m_pages->add(new RockPage(m_observation), PageGroup::thisBlow);
    m_identifyPage = new IdentifyPage(m_document);
    m_pages->add(m_identifyPage, PageGroup::thisBlow);
    m_rodPage = new RodPage(m_observation);
    m_pages->add(m_rodPage, PageGroup::thisBlow);
    m_stringPage = new StringPage(m_document);
    m_pages->add(m_stringPage, PageGroup::thisBlow);
    m_curvePage = new CurvePage(m_document);
    m_pages->add(m_curvePage, PageGroup::studies);
    const auto addStudies = [this](bool ofFeed) {
        for (const Study* study : studies()) {
            if (study->isOfFeed != ofFeed) continue;
            auto* page = new FigurePage(*study, m_document);
            m_pages->add(page, PageGroup::studies);
            connect(page, &Page::elsewhereRequested, this, [this] {
                m_curvePage->varyGap();
                m_pages->setCurrentWidget(m_curvePage);
            });
        }
    };
    addStudies(false);
    m_pages->add(new MapPage(m_document), PageGroup::studies);
    addStudies(true);
    auto* drilling = new DrillingPage(m_document);
    m_pages->add(drilling, PageGroup::studies);
    connect(drilling, &DrillingPage::blowOpened, this,
            [this, blow](const MarchedQuestion& opened, const QString& what) {
                m_marchedNotice->open(opened, what);
                m_pages->setCurrentWidget(blow);
            });
    auto* design = new DesignPage(m_document);
    m_pages->add(design, PageGroup::studies);
    connect(m_identifyPage, &IdentifyPage::drawsWanted, this,
            [this, design](const QString& source, const QByteArray& table) {
                design->takeDraws(source, table);
                m_pages->setCurrentWidget(design);
            });
    m_pages->add(new AccuracyPage(m_document), PageGroup::studies);
    m_runs->addTo(*m_pages);
    m_takenNotice->follow(*m_pages);
    addMenus();
    addStatusBar();
    wire();
    connect(m_resultPanel, &ResultPanel::drillingChosen, m_pages,
            [this, drilling] { m_pages->setCurrentWidget(drilling); });
    connect(m_resultPanel, &ResultPanel::waveLossWanted, this, [this] {
        m_document.assign(*findParameter("drill.wave_loss"), usualWaveLoss, m_document.newGesture());
    });
    new BlowGhost(
        m_document, *m_scenarioPanel, *m_pages, [this] { return m_shown; }, this);
    wireSolving();
    wireImport();
    presentState();
    m_pages->follow(m_document.scenario());
    m_layout->restoreSize();
    m_pages->restoreChoice();
    followPage();
    m_exampleNote->explainFirst(example);
    present(m_job->solveNow(request()));
}

// A floating dock is not hidden with the window: its panel is destroyed first.
MainWindow::~MainWindow() {
    hide();
}

// Adds the tabs above the docks, over the whole width.
void MainWindow::addTabs() {
    auto* bar = new QToolBar(tr("Pages"), this);
    bar->setObjectName(QStringLiteral("pages"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setVisible(false);
    bar->addWidget(m_pages->strip());
    bar->addWidget(m_units->button());
    bar->addAction(m_runs->pinAction());
    bar->addAction(m_report->action());
    addToolBar(bar);
}

void MainWindow::addCenter() {
    m_fileNotice = new FileNotice(m_document, m_watch, *m_questions);
    auto* tableNotice = new TableNotice(m_document, *new TableWatch(m_document, this), *m_questions);
    m_exampleNote = new ExampleNote;
    auto* center = new QWidget(this);
    auto* layout = new QVBoxLayout(center);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_fileNotice);
    layout->addWidget(tableNotice);
    layout->addWidget(m_exampleNote);
    auto* olderNotice = new Notice(Notice::Tone::information);
    olderNotice->setObjectName(QStringLiteral("olderNotice"));
    olderNotice->hide();
    connect(&m_document, &Document::replaced, olderNotice, &QWidget::hide);
    connect(&m_document, &Document::olderResultOpened, olderNotice, &Notice::say);
    layout->addWidget(olderNotice);
    m_formNotice = new FormNotice(m_document);
    layout->addWidget(m_formNotice);
    m_marchedNotice = new MarchedNotice(*m_pages);
    layout->addWidget(m_marchedNotice);
    m_wavesNotice = new WavesNotice(m_document, *m_pages);
    layout->addWidget(m_wavesNotice);
    layout->addWidget(new ElsewhereNotice(*m_pages));
    m_takenNotice = new TakenNotice(m_document);
    layout->addWidget(m_takenNotice);
    layout->addWidget(new PageScroll(m_pages), 1);
    setCentralWidget(center);
}

void MainWindow::addDocks() {
    m_scenarioPanel = std::make_unique<ScenarioPanel>(m_document, *m_questions);
    m_scenarioPanel->setProperty(helpTopicProperty, QStringLiteral("window §2"));
    m_resultPanel = new ResultPanel;
    m_layout->addDock(tr("Scenario"), QStringLiteral("scenario"), m_scenarioPanel.get());
    m_runs->follow(*m_resultPanel);
    m_resultSide = new QWidget;
    m_resultSide->setProperty(helpTopicProperty, QStringLiteral("window §3"));
    auto* layout = new QVBoxLayout(m_resultSide);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_resultPanel, 1);
    layout->addWidget(m_runs->panel());
    const QDockWidget* dock = m_layout->addDock(tr("Result"), QStringLiteral("result"), m_resultSide);
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        m_isResultShown = visible;
        showLead();
    });
    connect(m_resultPanel, &ResultPanel::answered, this, &MainWindow::showLead);
}

void MainWindow::addMenus() {
    m_exportMenu = new ExportMenu(
        m_document, *m_questions,
        {[this] { return m_solveStatus->isCurrent() ? m_shown : nullptr; },
         [this](const QString& what, auto then) { m_solveStatus->whenCurrent(what, std::move(then)); }},
        this);
    m_fileMenu = new FileMenu(m_document, *m_questions, m_watch, m_exportMenu, this);
    m_fileMenu->insertActions(m_exportMenu->menuAction(),
                              {m_report->action(), m_report->previewAction(), m_report->printAction()});
    m_fileMenu->insertAction(m_exportMenu->menuAction(), m_runs->keepAction());
    menuBar()->addMenu(m_fileMenu);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_document.undoStack().createUndoAction(edit, tr("&Undo"));
    undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
    QAction* redo = m_document.undoStack().createRedoAction(edit, tr("&Redo"));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addAction(m_runs->pinAction());
    edit->addSeparator();
    edit->addActions({m_formNotice->toString(), m_formNotice->toUniformRod(), m_formNotice->toForce(),
                      m_formNotice->toRig()});
    edit->setToolTipsVisible(true);
    auto* areas = new AreaKeys({m_scenarioPanel.get(), m_pages, m_resultSide}, this);
    auto* view = new ViewMenu({*m_units, *m_pages, *areas, *m_layout, *m_exampleNote, *m_questions}, this);
    // Queued: after the menu has closed.
    connect(view, &ViewMenu::restartWanted, this, &MainWindow::restart, Qt::QueuedConnection);
    menuBar()->addMenu(view);
    menuBar()->addMenu(new StudyMenu(*m_pages, this));
    menuBar()->addMenu(new HelpMenu(*new ManualHelp(this, *m_pages), *m_questions, this));
}

void MainWindow::addStatusBar() {
    m_alertLink = new AlertLink(*m_resultPanel->alerts(), this);
    m_alertLink->setObjectName(QStringLiteral("alertLink"));
    statusBar()->addWidget(m_solveStatus, 1);
    statusBar()->addPermanentWidget(m_studyStatus);
    statusBar()->addPermanentWidget(m_alertLink);  // at the edge, where no study moves it
}

// The answer is on the status line while its panel is out of sight.
void MainWindow::showLead() {
    m_solveStatus->setLead(m_isResultShown ? QString() : m_resultPanel->shortAnswer());
}

void MainWindow::wire() {
    connect(&m_document, &Document::stateChanged, this, &MainWindow::presentState);
    connect(&m_document, &Document::stateChanged, m_exampleNote,
            [this] { m_exampleNote->setChanged(m_document.isChangedExample()); });
    connect(&m_document, &Document::replaced, m_exampleNote, &ExampleNote::forget);
    connect(m_fileMenu, &FileMenu::exampleOpened, m_exampleNote, &ExampleNote::explain);
    connect(new FileDrop(this), &FileDrop::dropped, this, &MainWindow::takeDropped);
    connect(m_exportMenu, &ExportMenu::exported, this, &MainWindow::inform);
    m_report->setMeasured(m_measured);
    m_report->setStudies([this] {
        ReportStudies found;
        for (int i = 0; i < m_pages->count(); ++i) m_pages->page(i).addTo(found);
        return found;
    });
    connect(m_report, &ReportWriter::written, this, &MainWindow::inform);
    connect(m_report, &ReportWriter::begun, this,
            [this] { m_studyStatus->follow(&m_report->activity(), tr("Report")); });
    connect(m_report, &ReportWriter::ended, this, &MainWindow::followPage);
    connect(&m_runs->runs(), &Runs::changed, m_report, [this] { m_report->setRuns(m_runs->runs().list()); });
    connect(m_pages, &PageTabs::exportRequested, m_exportMenu, &ExportMenu::save);
    connect(m_runs->pinAction(), &QAction::triggered, m_runs, [this] { m_runs->pin(); });
    connect(m_resultPanel, &ResultPanel::timeChosen, &m_observation, &Observation::setTime);
    connect(&m_observation, &Observation::timeChanged, m_resultPanel, &ResultPanel::setTime);
    connect(m_resultPanel, &ResultPanel::placeChosen, this, &MainWindow::goToPlace);
    connect(m_alertLink, &QToolButton::clicked, this, [this] {
        m_layout->reveal(m_resultSide);
        m_resultPanel->goToAlerts();
    });
    connect(m_resultPanel, &ResultPanel::parameterChosen, this, &MainWindow::goToParameter);
    connect(m_scenarioPanel.get(), &ScenarioPanel::sectionsRequested, this,
            [this] { m_pages->setCurrentWidget(m_stringPage); });
    connect(m_scenarioPanel.get(), &ScenarioPanel::goalRequested, this, &MainWindow::seekGoal);
    connect(m_stringPage, &StringPage::goalRequested, this, &MainWindow::seekGoal);
    connect(qApp, &QGuiApplication::commitDataRequest, this, &MainWindow::endSession, Qt::DirectConnection);
}

// Connects the changes that start a job, and the parts that wait for its answer.
void MainWindow::wireSolving() {
    const auto askAnew = [this](const QString& reason) {
        m_solveStatus->callOff(reason);
        solve();
    };
    connect(&m_document, &Document::scenarioChanged, this, [=, this] {
        m_marchedNotice->forget();
        askAnew(tr("the input was changed meanwhile."));
    });
    connect(m_marchedNotice, &MarchedNotice::singleWanted, this, &MainWindow::solve);
    connect(m_pages, &PageTabs::currentChanged, this, [=, this] {
        followPage();
        askAnew(tr("another page was chosen meanwhile."));
    });
    connect(m_units, &UnitsChoice::chosen, this, [=, this] {
        m_units->present(m_document.scenario());
        askAnew(tr("other units were chosen meanwhile."));
    });
    connect(m_pages, &PageTabs::needsChanged, this, &MainWindow::solve);
    connect(m_job.get(), &SolveJob::solved, this, &MainWindow::present);
    connect(m_solveStatus, &SolveStatus::stopRequested, m_job.get(), &SolveJob::cancel);
    connect(m_solveStatus, &SolveStatus::solveRequested, this, &MainWindow::solve);
    connect(m_solveStatus, &SolveStatus::marked, this, &MainWindow::markResult);
    connect(m_solveStatus, &SolveStatus::currentChanged, m_pages, &PageTabs::setCurrent);
    connect(m_solveStatus, &SolveStatus::calledOff, this, &MainWindow::inform);
}

void MainWindow::wireImport() {
    m_importer = std::make_unique<Importer>(m_document, m_measured, *m_questions, this);
    connect(m_fileMenu, &FileMenu::importRequested, this, [this](const QString& path) {
        if (path.isEmpty())
            m_importer->start(ImportUse::normalForce);
        else
            m_importer->open(path, ImportUse::normalForce);
    });
    connect(m_scenarioPanel.get(), &ScenarioPanel::importRequested, this,
            [this] { m_importer->start(ImportUse::blow); });
    connect(m_importer.get(), &Importer::imported, this, &MainWindow::inform);
    connect(m_identifyPage, &IdentifyPage::recordWanted, this,
            [this] { m_importer->start(ImportUse::rockRecord); });
    connect(m_identifyPage, &IdentifyPage::moreRecordsWanted, this,
            [this] { m_identifyPage->addRecords(m_importer->chooseRecords()); });
    connect(m_importer.get(), &Importer::recordsTaken, this,
            [this](const QStringList& paths, const SignalOptions& settings) {
                m_pages->setCurrentWidget(m_identifyPage);
                m_identifyPage->openRecords(paths, settings);
            });
}

// Several tables, and every table on the page Identify, are records of it.
void MainWindow::takeDropped(const QStringList& paths) {
    const bool isThere = m_pages->currentWidget() == m_identifyPage;
    if (!FileMenu::areTables(paths) || (paths.size() == 1 && !isThere)) return m_fileMenu->take(paths);
    if (isThere && m_identifyPage->hasRecords()) return m_identifyPage->addRecords(paths);
    m_importer->open(paths.first(), ImportUse::rockRecord, paths.mid(1));
}

// Pages of this blow show the place themselves; from the others the page Rod does. Places are of rods: while
// a string is being solved they are of the blow before it.
void MainWindow::goToPlace(double section, double time) {
    // The blow on show may still be of another form.
    if (!m_shown || !areOfOneKind(m_document.scenario(), m_shown->request.scenario)) return;
    if (!m_pages->current().prepare()) m_pages->choose(m_pages->indexOf(m_rodPage));
    m_observation.setSection(section);
    m_observation.setTime(time);
}

// Numbers of sections are in the table of the page String, all others in the scenario.
void MainWindow::goToParameter(const QString& key) {
    const KeptParameter parameter = findParameter(key.toStdString());
    if (!parameter || !parameter->address) return m_scenarioPanel->goTo(key);
    if (!m_stringPage->shows(m_document.scenario())) return;
    m_pages->setCurrentWidget(m_stringPage);
    m_stringPage->goTo(*parameter->address);
}

// Shows the page first, so that the field for the goal can have the focus.
void MainWindow::seekGoal(const QString& key) {
    const KeptParameter parameter = findParameter(key.toStdString());
    if (!parameter || !parameter->applies(m_document.scenario())) return;
    m_pages->setCurrentWidget(m_curvePage);
    m_curvePage->seek(parameter);
}

// Connects the menu and the status line to the page on show.
void MainWindow::followPage() {
    const Page& page = m_pages->current();
    m_exportMenu->setExports(page.exports());
    if (m_report->activity().state() == StudyState::running) return;
    m_studyStatus->follow(page.activity(), page.title());
}

void MainWindow::inform(const QString& message) {
    statusBar()->showMessage(message, messageMilliseconds);
}

bool MainWindow::openFile(const QString& path) {
    return m_fileMenu->openFile(path);
}

void MainWindow::openExample(const Example& example) {
    m_fileMenu->openExample(example);
}

void MainWindow::startRecovery(const QString& folder) {
    m_recovery = new Recovery(m_document, folder, this);
    connect(m_recovery, &Recovery::failed, this, [this](const QString& problem) {
        m_questions->tell(this, Questions::Tone::failure,
                          tr("Unsaved changes cannot be kept for the case of a crash."), problem);
    });
    m_recovery->keepBeside([this] { return WorkBeside{m_runs->runs().toKeep(), m_measured.signalList()}; });
    connect(&m_runs->runs(), &Runs::changed, m_recovery, &Recovery::writeSoon);
    connect(&m_measured, &MeasuredList::changed, m_recovery, &Recovery::writeSoon);
    offerLostChanges(folder, m_document, *m_recovery, *m_questions, this, [this](const WorkBeside& beside) {
        m_runs->runs().add(beside.runs);
        for (const MeasuredSignal& signal : beside.measured)
            if (!m_measured.isFull()) m_measured.add(signal);
    });
}

// The desktop ends the session: the window may not get another chance to ask.
void MainWindow::endSession(QSessionManager& session) {
    if (!session.allowsInteraction()) return;
    if (mayClose())
        saveChoices();
    else
        session.cancel();
    session.release();
}

SolveRequest MainWindow::request() {
    std::vector<PreparePage> pages;
    const Page& page = m_pages->current();
    if (PreparePage prepare = page.prepare(); prepare && page.shows(m_document.scenario()))
        pages.push_back(std::move(prepare));
    return {.scenario = m_document.scenario(),
            .units = m_units->of(m_document.scenario()),
            .chosenUnits = m_document.units().chosen(),
            .physicalUnits = m_document.units().physicalSystem(),
            .pages = std::move(pages),
            .number = ++m_asked,
            .marched = m_marchedNotice->blowOf(page)};
}

void MainWindow::solve() {
    m_solveStatus->asked();
    SolveRequest asked = request();
    asked.quick = !isFollowedByEvents(asked.scenario);
    m_job->submit(asked);
}

void MainWindow::present(const SolvedBlowPtr& blow) {
    m_shown = blow;
    m_resultPanel->present(blow);
    m_runs->present(blow);
    // The answer to an earlier question may be of another form of scenario.
    Page& page = m_pages->current();
    if (page.shows(blow->request.scenario))
        page.setResult(blow->marchedBlow && page.showsMarched() ? blow->marchedBlow : blow);
    m_wavesNotice->present(*blow);
    m_units->present(m_document.scenario());
    if (blow->request.number != m_asked)
        m_solveStatus->answeredEarlier();
    else if (blow->request.quick && blow->fault.isEmpty())
        m_solveStatus->answeredQuickly(statusText(*blow));
    else
        m_solveStatus->answered(statusText(*blow));
}

void MainWindow::markResult(bool outOfDate) {
    if (outOfDate) statusBar()->clearMessage();  // it would cover what the solver does
    m_pages->setOutOfDate(outOfDate);
    m_resultPanel->setOutOfDate(outOfDate);
    m_alertLink->setDisabled(outOfDate);
}

void MainWindow::presentState() {
    const QString file = QFileInfo(m_document.path()).fileName();
    const QString name = m_document.displayName();
    setWindowTitle(file.isEmpty() || file == name ? tr("%1[*] — Drillwave").arg(name)
                                                  : tr("%1 – %2[*] — Drillwave").arg(name, file));
    setWindowModified(m_document.isModified());
    setWindowFilePath(m_document.path());
}

void MainWindow::saveChoices() const {
    m_layout->save();
    m_pages->saveChoice();
}

// Does nothing where the work cannot be carried over: the language then waits for the next start.
void MainWindow::restart() {
    if (!m_recovery || !m_runs->mayClose() || !m_recovery->writeForRestart()) return;
    m_wantsRestart = true;
    close();
}

bool MainWindow::mayClose() {
    return m_fileMenu->mayDiscard() && m_runs->mayClose();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_wantsRestart && !mayClose()) return event->ignore();
    saveChoices();
    if (m_recovery && !m_wantsRestart) m_recovery->end();
    event->accept();
}

}  // namespace drillwave

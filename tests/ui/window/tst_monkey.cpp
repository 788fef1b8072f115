// SPDX-License-Identifier: GPL-3.0-or-later
// Twenty thousand random events on the whole window: it never crashes, never hangs, and what it shows is
// always the answer to what it holds. DRILLWAVE_MONKEY_SEED and DRILLWAVE_MONKEY_EVENTS choose other runs,
// DRILLWAVE_MONKEY_TALK=1 prints every act before it is done.
#include <QApplication>
#include <QDesktopServices>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <atomic>
#include <cmath>
#include <ctime>
#include <thread>

#include "core/model/scales.h"
#include "core/model/string_edit.h"
#include "core/yaml/pulse_reader.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/tries.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "tests/ui/window/monkey.h"
#include "ui/job/solve_job.h"
#include "ui/job/study_status.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/settings.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr int eventsBetweenChecks = 20;
constexpr int eventsBetweenWindows = 1000;
// In seconds of the processor, which a machine that does much else does not take away.
constexpr double patience = 120;
constexpr double settlingWork = 60;

// On a string: followed for long, or through sections that differ much in length.
bool isLongBlow(const Scenario& scenario) {
    if (!isString(scenario)) return false;
    const DrillString& drill = scenario.drillString;
    double shortest = 1e300;
    for (const SectionSpot& spot : sectionSpots(drill))
        shortest = std::min(shortest, sectionAt(drill, spot).length);
    const double whole = stringProperties(drill).length;
    return drill.endTime.value_or(0) > 0.03 || whole > 2000 * shortest || sectionCount(drill) > 60;
}

// Returns the processor time of all threads of this program [s].
double processorSeconds() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Ends the program, with the last acts, when there is no progress at all: nothing else could.
class HangWatch {
  public:
    explicit HangWatch(const Monkey& monkey)
        : m_thread([this, &monkey](const std::stop_token& stop) { watch(monkey, stop); }) {}
    void beat() { ++m_beats; }

  private:
    void watch(const Monkey& monkey, const std::stop_token& stop) {
        double last = processorSeconds();
        long seen = -1;
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            const double now = processorSeconds();
            if (std::exchange(seen, m_beats.load()) != m_beats) last = now;
            if (now - last < patience) continue;
            std::fprintf(stderr, "no progress in two minutes of the processor after:\n%s\n",
                         qPrintable(monkey.record().join(QLatin1Char('\n'))));
            std::abort();
        }
    }

    std::atomic<long> m_beats = 0;
    std::jthread m_thread;
};

}  // namespace

class TestMonkey : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void randomEventsDoNoHarm_data();
    void randomEventsDoNoHarm();
    void cleanupTestCase();

  public slots:
    void swallow(const QUrl& /*url*/) {}

  private:
    void makeWindow();
    QString wrongNow() const;
    QString wrongWhenSettled();
    QString wrongText();

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestMonkey::initTestCase() {
    keepSettingsIn(m_folder.path());
    QApplication::setQuitOnLastWindowClosed(false);
    // Nothing of this leaves the program: no file manager, no browser.
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "swallow");
    QDesktopServices::setUrlHandler(QStringLiteral("https"), this, "swallow");
}

void TestMonkey::cleanupTestCase() {
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QDesktopServices::unsetUrlHandler(QStringLiteral("https"));
}

void TestMonkey::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_answers = {};
}

void TestMonkey::makeWindow() {
    m_window.reset();
    // Scenes that take seconds are another matter: here they are given up and reported at once.
    constexpr long mostPieces = 100'000;
    auto solver =
        std::make_shared<MethodSolver>(WorkLimits{.pieces = mostPieces, .cells = cellsOfPiece * mostPieces});
    m_window = std::make_unique<MainWindow>(
        std::make_unique<ScriptedQuestions>(m_answers), [solver](const SolveRequest& request) {
            if (isLongBlow(request.scenario)) return failedBlow(request, QStringLiteral("too long a blow"));
            return solveBlow(request, *solver);
        });
    m_window->resize(1100, 700);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

// Returns the first condition that is broken between two events.
QString TestMonkey::wrongNow() const {
    Document& document = m_window->document();
    const std::vector<InputProblem> problems = validate(document.scenario());
    if (!problems.empty())
        return QStringLiteral("the scenario is invalid: ") +
               QString::fromStdString(problems.front().text.text());
    const QUndoStack& stack = document.undoStack();
    if (stack.index() < 0 || stack.index() > stack.count() || stack.count() > stack.undoLimit())
        return QStringLiteral("undo step %1 of %2").arg(stack.index()).arg(stack.count());
    if (m_window->isWindowModified() != document.isModified())
        return QStringLiteral("the title does not say whether there are unsaved changes");
    for (const PlotWidget* plot : m_window->findChildren<PlotWidget*>())
        for (const QCPAxisRect* rect : plot->axisRects())
            for (const QCPAxis* axis : rect->axes())
                if (const QCPRange range = axis->range();
                    !std::isfinite(range.lower) || !std::isfinite(range.upper) || range.lower >= range.upper)
                    return QStringLiteral("the axis “%1” from %2 to %3")
                        .arg(axis->label())
                        .arg(range.lower)
                        .arg(range.upper);
    if (QWidget* dialog = QApplication::activeModalWidget())
        return QStringLiteral("a dialog was left open: ") + QLatin1String(dialog->metaObject()->className());
    return {};
}

// Returns the first condition that is broken once nothing is on its way any more.
QString TestMonkey::wrongWhenSettled() {
    const double begin = processorSeconds();
    while (part<SolveJob>(*m_window).isBusy()) {
        if (processorSeconds() - begin > settlingWork) return QStringLiteral("the job does not settle");
        QTest::qWait(1);
    }
    QCoreApplication::processEvents();
    const Scenario& scenario = m_window->document().scenario();
    const SolvedBlow& shown = *m_window->shown();
    // A blow that was cancelled leaves the result before it, and the window says so.
    const bool cancelled = !part<SolveStatus>(*m_window).isCurrent();
    if (shown.request.scenario != scenario && !cancelled)
        return QStringLiteral("the result belongs to another scenario");
    if (shown.fault.isEmpty() && !std::isfinite(shown.summary.cor))
        return QStringLiteral("the result is no number");
    return wrongText();
}

// Checks that a saved scenario means the same blow. Values that do not apply, such as a diameter beside an
// area, are left out.
QString TestMonkey::wrongText() {
    const Document& document = m_window->document();
    const Pulse& pulse = document.scenario().pulse;
    // The text names its table, and other programs change files.
    if (pulse.shape == PulseShape::table && !pulse.tableFile.empty()) {
        const std::string path = QFile::encodeName(document.tablePath()).toStdString();
        if (readPulseTable(path, path, document.scenario().form).points != pulse.tablePoints) return {};
    }
    const QByteArray text = document.text();
    try {
        const ScenarioDocument read = parseScenario(text.toStdString(), document.origin().toStdString());
        if (groupsOf(read.scenario) != groupsOf(document.scenario()))
            return QStringLiteral("the text means another blow");
        if (writeScenario(read) != text.toStdString())
            return QStringLiteral("the text changes when it is read");
    } catch (const ScenarioError& error) {
        return QStringLiteral("the text cannot be read: ") + QString::fromStdString(error.lines().front());
    }
    return {};
}

void TestMonkey::randomEventsDoNoHarm_data() {
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("events");
    const int events = tries("DRILLWAVE_MONKEY_EVENTS", 200, 600);
    if (qEnvironmentVariableIsSet("DRILLWAVE_MONKEY_SEED")) {
        QTest::newRow("given seed") << qEnvironmentVariableIntValue("DRILLWAVE_MONKEY_SEED") << events;
        return;
    }
    for (const int seed : {1, 2, 3, 4})
        if (isNightly() || test::seed() / 2 % 4 == seed - 1) QTest::addRow("seed %d", seed) << seed << events;
}

void TestMonkey::randomEventsDoNoHarm() {
    QFETCH(int, seed);
    QFETCH(int, events);
    MonkeyFiles files;
    Monkey monkey(static_cast<quint32>(seed), m_answers, files);
    monkey.setTalkative(qEnvironmentVariableIsSet("DRILLWAVE_MONKEY_TALK"));
    HangWatch watch(monkey);
    makeWindow();
    int windows = 1;
    for (int done = 1; done <= events; ++done) {
        monkey.act(*m_window);
        watch.beat();
        QString wrong = monkey.stuck();
        if (wrong.isEmpty()) wrong = wrongNow();
        if (wrong.isEmpty() && done % eventsBetweenChecks == 0) wrong = wrongWhenSettled();
        if (!wrong.isEmpty())
            QFAIL(qPrintable(QStringLiteral("event %1: %2\nwith\n%3\nafter:\n%4")
                                 .arg(done)
                                 .arg(wrong, QString::fromUtf8(m_window->document().text()),
                                      monkey.record().join(QLatin1Char('\n')))));
        // Closed by the monkey, or after a long day: in the middle of whatever it is doing.
        if (!m_window->isVisible() || done % eventsBetweenWindows == 0) {
            makeWindow();
            ++windows;
        }
    }
    m_window.reset();
    qInfo("seed %d: %d events, %d windows", seed, events, windows);
}

QTEST_MAIN(TestMonkey)
#include "tst_monkey.moc"

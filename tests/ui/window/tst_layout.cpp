// SPDX-License-Identifier: GPL-3.0-or-later
// Every page at every size, light and dark: nothing is cut off, covered, nameless or faint.
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>
#include <vector>

#include "core/yaml/examples.h"
#include "tests/support/themes.h"
#include "tests/support/tries.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "tests/ui/window/layout_check.h"
#include "ui/job/solve_job.h"
#include "ui/job/study_status.h"
#include "ui/text/language.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/window/manual_help.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/units_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

// By its menu, so that its explanation is on show as well.
void openExample(MainWindow& window, const QString& name) {
    const QString title = coreText(findExample(name.toStdString())->title);
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text() == title) return action->trigger();
    QFAIL(qPrintable(title));
}

// So that the list, the differences and the comparison are on show too.
void pinRuns(MainWindow& window) {
    Document& document = window.document();
    for (const double gamma : {0.2, 0.3}) {
        document.assign(*findParameter("gamma"), gamma, document.newGesture());
        part<PinnedRuns>(window).pinAction()->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(part<SolveStatus>(window).isCurrent(), 60000);
    }
    QCOMPARE(part<PinnedRuns>(window).runs().list()->size(), 2u);
}

QStringList docksOverThePage(const MainWindow& window) {
    QStringList found;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        if (dock->isVisible() && dock->geometry().intersects(window.centralWidget()->geometry()))
            found.append(dock->windowTitle() + QStringLiteral(" over the page"));
    return found;
}

QStringList problemsOf(const MainWindow& window) {
    return clippedTexts(window) + cutTabs(window) + flatPlots(window) + overlaps(window) +
           docksOverThePage(window) + namelessControls(window) + faintTexts(window);
}

}  // namespace

class TestLayout : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void theFirstSizeLeavesRoomForAFrame();
    void everythingCanBeReadAndReached_data();
    void everythingCanBeReadAndReached();
    void theManualCanBeReadAndReached_data();
    void theManualCanBeReadAndReached();
    void cleanup();

  private:
    QTemporaryDir m_folder;
    QFont m_font = QApplication::font();
    ScriptedAnswers m_answers;
};

void TestLayout::initTestCase() {
    keepSettingsIn(m_folder.path());
    QLocale::setDefault(QLocale::c());
}

void TestLayout::cleanup() {
    QApplication::setPalette(QPalette());
    QApplication::setFont(m_font);
    speak(languages[0]);
    Settings().clear();
}

/// The frame is not known before the window is shown, and sometimes not soon after.
void TestLayout::theFirstSizeLeavesRoomForAFrame() {
    const auto window = newWindow(m_answers);
    const QSize room = window->screen()->availableSize() - QSize(16, 48);
    const QSize least = window->minimumSizeHint();
    QVERIFY(window->width() <= std::max(room.width(), least.width()));
    QVERIFY2(window->height() <= std::max(room.height(), least.height()),
             qPrintable(QString::number(window->height())));
}

void TestLayout::everythingCanBeReadAndReached_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("points");
    QTest::addColumn<UnitSystem>("units");
    QTest::addColumn<QString>("language");
    constexpr int usualPoints = 9;
    // Texts that are faint in the dark are so at any size, and at one pixel a point.
    const bool isScaled = qApp->devicePixelRatio() > 1;
    int row = 0;
    const auto add = [&](const char* example, const QSize& size, bool dark, int points, UnitSystem units,
                         const char* language = "en") {
        if (dark && isScaled) return;
        if (!isChosen(row++, 7)) return;
        QTest::addRow("%s, %d × %d, %s, %d pt%s, %s", example, size.width(), size.height(),
                      dark ? "dark" : "light", points, units == UnitSystem::us ? ", US units" : "", language)
            << QString::fromLatin1(example) << size << dark << points << units
            << QString::fromLatin1(language);
    };
    std::vector<const char*> examples{"t38_medium_rock", "t38_string"};
    if (!isScaled)
        for (const char* more : {"t51_soft_rock", "paper_fig4b", "reference_case"}) examples.push_back(more);
    for (const char* example : examples)
        for (const QSize size : {QSize(800, 500), QSize(1000, 650), QSize(1440, 900)})
            for (const bool dark : {false, true})
                if (!dark || size.width() == 1440) add(example, size, dark, usualPoints, UnitSystem::si);
    for (const bool dark : {false, true})
        add("t38_medium_rock", {3200, 1800}, dark, usualPoints, UnitSystem::si);
    add("t38_medium_rock", {1440, 900}, false, 16, UnitSystem::si);
    add("t38_medium_rock", {1920, 1080}, true, 16, UnitSystem::si);
    add("t38_medium_rock", {1000, 650}, false, usualPoints, UnitSystem::us);
    // German words are long.
    for (const char* example : {"t38_medium_rock", "t38_string"})
        for (const QSize size : {QSize(800, 500), QSize(1000, 650), QSize(1280, 800)})
            add(example, size, false, usualPoints, UnitSystem::si, "de");
}

void TestLayout::everythingCanBeReadAndReached() {
    QFETCH(QString, example);
    QFETCH(QSize, size);
    QFETCH(bool, dark);
    QFETCH(int, points);
    QFETCH(UnitSystem, units);
    QFETCH(QString, language);
    speak(*findLanguage(language.toStdString()));
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
    QFont font = QApplication::font();
    font.setPointSize(points);
    QApplication::setFont(font);
    MainWindow window(std::make_unique<ScriptedQuestions>(m_answers), exactSolve());
    part<UnitsChoice>(window).choose(units);
    part<StudyStatus>(window).setPatience(std::chrono::milliseconds(0));  // as on a slow machine
    openExample(window, example);
    window.resize(size);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCoreApplication::processEvents();
    window.resize(size);  // now that the docks may have come together for want of room
    QCoreApplication::processEvents();
    pinRuns(window);
    auto* pages = window.findChild<PageTabs*>();
    QStringList problems;
    if (window.width() > size.width() || window.height() > size.height())
        problems.append(QStringLiteral("wants %1 × %2").arg(window.width()).arg(window.height()));
    for (int page = 0; page < pages->count(); ++page) {
        if (!pages->isOffered(page)) continue;
        pages->setCurrentIndex(page);
        QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(window).isBusy(), 60000);
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();  // what the last event has asked for
        // a study that began or went on in them leaves its line in the status bar to be laid out, from within
        // outwards and back
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        for (int pass = 0; pass < 2; ++pass)
            for (QLayout* each : window.findChildren<QLayout*>()) each->activate();
        QStringList found = problemsOf(window);
        if (!found.isEmpty()) {  // a study that ends meanwhile has its words laid out in the next turns
            QTest::qWait(300);
            found = problemsOf(window);
        }
        for (const QString& each : found)
            problems.append(pages->page(page).title() + QStringLiteral(": ") + each);
        if (window.width() > size.width() || window.height() > size.height())
            problems.append(pages->page(page).title() +
                            QStringLiteral(" wants %1 × %2").arg(window.width()).arg(window.height()));
    }
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(QLatin1Char('\n'))));
}

void TestLayout::theManualCanBeReadAndReached_data() {
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("points");
    for (const int points : {9, 18}) {
        QTest::addRow("light, %d pt", points) << false << points;
        QTest::addRow("dark, %d pt", points) << true << points;
    }
}

void TestLayout::theManualCanBeReadAndReached() {
    QFETCH(bool, dark);
    QFETCH(int, points);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
    QFont font = QApplication::font();
    font.setPointSize(points);
    QApplication::setFont(font);
    MainWindow window(std::make_unique<ScriptedQuestions>(m_answers), exactSolve());
    window.show();
    auto& manual = part<ManualHelp>(window);
    manual.showHere();
    HelpWindow& help = *manual.helpWindow();
    help.search().setText(QStringLiteral("impedance"));
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    QCoreApplication::processEvents();
    const QStringList found = clippedTexts(help) + overlaps(help) + namelessControls(help) + faintTexts(help);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

QTEST_MAIN(TestLayout)
#include "tst_layout.moc"

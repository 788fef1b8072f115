// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs in the whole window.
#include <QAction>
#include <QComboBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include "core/blow/outputs.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/job/output_text.h"
#include "ui/job/study_status.h"
#include "ui/pages/compare/compare_page.h"
#include "ui/result/result_panel.h"
#include "ui/text/settings.h"
#include "ui/window/file_menu.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/tab_strip.h"

using namespace drillwave;
using namespace drillwave::test;

class TestPinnedRuns : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void f7PinsThePresentResult();
    void theListHasThePresentResultFirst();
    void theListShowsTheChosenResult();
    void tickRenameAndRemove();
    void theTabCountsThem();
    void revertingIsOneStepByName();
    void pinWaitsForTheAnswer();
    void pinnedPointsOfAStudyAreSolved();
    void keptRunsSurviveTheWindow();
    void savedOverAnotherFileItsRunsAreReplacedIfConfirmed();
    void closingAsksAboutTheRunsOfAFileSavedOver();
    void closingWaitsForTheRunsAndTellsWhyTheyAreNotKept();
    void refusalsAreTold();

  private:
    MainWindow& window() { return *m_window; }
    Runs& runs() { return part<PinnedRuns>(window()).runs(); }
    QTreeWidget& list() { return *part<RunPanel>(window()).list(); }
    void set(const char* key, double si) {
        Document& document = window().document();
        QCOMPARE(document.assign(*findParameter(key), si, document.newGesture()), QString());
        QTRY_VERIFY_WITH_TIMEOUT(part<SolveStatus>(window()).isCurrent(), 60000);
    }
    void pinThree() {
        part<PinnedRuns>(window()).pinAction()->trigger();
        set("bit_rock.stiffness", 3e8);
        part<PinnedRuns>(window()).pinAction()->trigger();
        set("rod.length", 3);
        part<PinnedRuns>(window()).pinAction()->trigger();
        QCOMPARE(runs().list()->size(), 3u);
    }
    void saveAs(const char* name) {
        m_answers.save = m_folder.filePath(QLatin1String(name));
        QVERIFY(part<FileMenu>(window()).saveAs());
    }
    QAction* action(const QString& text) {
        for (QAction* each : list().actions())
            if (each->text().remove('&') == text) return each;
        return nullptr;
    }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestPinnedRuns::initTestCase() {
    keepSettingsIn(m_folder.path());
    QLocale::setDefault(QLocale::c());
}

void TestPinnedRuns::init() {
    m_window.reset();
    Settings().clear();
    m_answers = {};
    m_window = newWindow(m_answers);
    m_window->resize(1440, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void TestPinnedRuns::f7PinsThePresentResult() {
    QVERIFY(!list().isVisible());
    QTest::keyClick(&window(), Qt::Key_F7);
    QCOMPARE(runs().list()->size(), 1u);
    const Run& run = runs().list()->front();
    QCOMPARE(run.blow, window().shown());  // the value, not a copy
    QCOMPARE(run.contents.text, window().document().text().toStdString());
    QVERIFY(list().isVisible());
}

void TestPinnedRuns::theListHasThePresentResultFirst() {
    pinThree();
    QCOMPARE(list().topLevelItemCount(), 4);
    QCOMPARE(list().topLevelItem(0)->text(0), QString("● now"));
    QCOMPARE(list().topLevelItem(2)->text(0), QString("B  k 300 MN/m"));
    QCOMPARE(list().topLevelItem(1)->text(1), QString("0.4297"));
    QCOMPARE(list().topLevelItem(1)->text(2), QString("ref."));
    QVERIFY(list().topLevelItem(2)->text(2).startsWith(u'+'));
    // The present result is compared too, and follows.
    const QString before = list().topLevelItem(0)->text(2);
    set("bit_rock.stiffness", 2e8);
    QVERIFY(list().topLevelItem(0)->text(2) != before);
    QVERIFY(list().topLevelItem(0)->text(2).endsWith(u'%'));
}

void TestPinnedRuns::theListShowsTheChosenResult() {
    pinThree();
    auto* choice = window().findChild<QComboBox*>(QStringLiteral("runOutput"));
    choice->setCurrentIndex(choice->findData(QStringLiteral("peak_force")));
    QCOMPARE(list().headerItem()->text(1), choice->currentText());
    const Run& hard = *runs().find(1);
    QCOMPARE(list().topLevelItem(2)->text(1), outputText(*findOutput("peak_force"), *hard.blow));
    QCOMPARE(list().topLevelItem(1)->text(2), QString("ref."));
    QVERIFY(list().topLevelItem(2)->text(2).startsWith(u'+'));
    choice->setCurrentIndex(0);
    QCOMPARE(list().topLevelItem(1)->text(1), QString("0.4297"));
}

void TestPinnedRuns::tickRenameAndRemove() {
    pinThree();
    list().topLevelItem(2)->setCheckState(0, Qt::Unchecked);
    QTRY_VERIFY(!runs().find(1)->isShown);
    list().topLevelItem(2)->setText(0, "hard rock");
    QTRY_COMPARE(runs().find(1)->title(), QString("B  hard rock"));
    QTRY_COMPARE(list().topLevelItem(2)->text(0), QString("B  hard rock"));
    list().setCurrentItem(list().topLevelItem(2));
    action("Compare with this run")->trigger();
    QCOMPARE(runs().reference()->number, 1);
    action("Remove")->trigger();
    QCOMPARE(runs().list()->size(), 2u);
    QCOMPARE(runs().reference()->number, 0);
    list().setCurrentItem(list().topLevelItem(0));
    QVERIFY(!action("Remove")->isEnabled());  // the present result stays
    action("Compare with the present result")->trigger();
    QVERIFY(!runs().reference());
}

void TestPinnedRuns::theTabCountsThem() {
    TabStrip& strip = *part<PageTabs>(window()).strip();
    const int tab = strip.indexOf(&part<ComparePage>(window()));
    QCOMPARE(tab, strip.count() - 1);
    QCOMPARE(strip.tabText(tab), QString("Compare"));
    pinThree();
    QCOMPARE(strip.tabText(tab), QString("Compare (3)"));
    part<PageTabs>(window()).setCurrentWidget(&part<ComparePage>(window()));
    QTRY_COMPARE(part<ComparePage>(window()).table().titles.size(), 4);
}

void TestPinnedRuns::revertingIsOneStepByName() {
    Document& document = window().document();
    const QByteArray bytes = document.text();
    pinThree();
    const int steps = document.undoStack().count();
    list().setCurrentItem(list().topLevelItem(1));
    action("Revert to this run")->trigger();
    QCOMPARE(document.text(), bytes);
    QCOMPARE(document.undoStack().count(), steps + 1);
    QVERIFY(document.undoStack().undoText().startsWith("revert to A"));
    QTRY_COMPARE(window().shown()->summary.cor, runs().find(0)->blow->summary.cor);
    while (document.undoStack().canUndo()) document.undoStack().undo();
    QCOMPARE(document.text(), bytes);
    QCOMPARE(runs().list()->size(), 3u);
    while (document.undoStack().canRedo()) document.undoStack().redo();
    QCOMPARE(document.text(), bytes);
}

// The pinned blow is that of the present input.
void TestPinnedRuns::pinWaitsForTheAnswer() {
    Document& document = window().document();
    document.assign(*findParameter("bit_rock.stiffness"), 4e8, document.newGesture());
    part<PinnedRuns>(window()).pinAction()->trigger();
    // Neither the answer of the scenario before, nor lost by another page or another input.
    QCOMPARE(runs().list()->size(), 1u);
    QVERIFY(!runs().list()->front().blow);
    auto& pages = part<PageTabs>(window());
    pages.setCurrentIndex(pages.currentIndex() + 1);
    document.assign(*findParameter("bit_rock.stiffness"), 5e8, document.newGesture());
    QTRY_VERIFY_WITH_TIMEOUT(runs().list()->front().isSolved(), 60000);
    QCOMPARE(runs().list()->front().blow->scenario.bitRock.stiffness, 4e8);
    QCOMPARE(runs().list()->front().contents.scenario.bitRock.stiffness, 4e8);
    QCOMPARE(m_answers.told, QStringList());
}

void TestPinnedRuns::pinnedPointsOfAStudyAreSolved() {
    auto& pages = part<PageTabs>(window());
    ScenarioDocument contents;
    QCOMPARE(window().document().contentsWith({{findParameter("bit_rock.gap"), 1e-3}}, contents), QString());
    const QByteArray bytes = window().document().text();
    emit pages.page(0).pinRequested(contents);
    QTRY_VERIFY(runs().list()->size() == 1 && runs().list()->front().isSolved());
    QCOMPARE(runs().list()->front().blow->scenario.bitRock.gap, 1e-3);
    QCOMPARE(window().document().text(), bytes);
    QCOMPARE(window().document().undoStack().count(), 0);
}

void TestPinnedRuns::keptRunsSurviveTheWindow() {
    pinThree();
    m_answers.save = m_folder.filePath("kept.yaml");
    QAction* keep = part<PinnedRuns>(window()).keepAction();
    keep->trigger();
    QVERIFY(!keep->isChecked());  // beside no file
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY(part<FileMenu>(window()).saveAs());
    keep->trigger();
    QVERIFY(keep->isChecked());
    const RunList before = *runs().list();
    m_window = newWindow(m_answers);
    QVERIFY(runs().list()->empty());
    QVERIFY(window().openFile(m_folder.filePath("kept.yaml")));
    QCOMPARE(runs().list()->size(), 3u);
    QVERIFY(part<PinnedRuns>(window()).keepAction()->isChecked());
    for (std::size_t i = 0; i < before.size(); ++i) {
        QCOMPARE((*runs().list())[i].title(), before[i].title());
        QTRY_VERIFY((*runs().list())[i].isSolved());
        QCOMPARE((*runs().list())[i].blow->summary.cor, before[i].blow->summary.cor);
    }
    // Taken away only when that is confirmed.
    part<PinnedRuns>(window()).keepAction()->trigger();
    QVERIFY(part<PinnedRuns>(window()).keepAction()->isChecked());
    m_answers.confirm = true;
    part<PinnedRuns>(window()).keepAction()->trigger();
    QVERIFY(!part<PinnedRuns>(window()).keepAction()->isChecked());
    QVERIFY(!QFile::exists(m_folder.filePath("kept.runs")));
}

void TestPinnedRuns::savedOverAnotherFileItsRunsAreReplacedIfConfirmed() {
    const QString index = m_folder.filePath("other.runs/runs.csv");
    QVERIFY(QDir().mkpath(m_folder.filePath("other.runs")));
    write(index, "file,name,shown,reference,cor\n");
    pinThree();
    saveAs("mine.yaml");
    QAction* keep = part<PinnedRuns>(window()).keepAction();
    keep->trigger();
    QVERIFY(keep->isChecked());
    saveAs("other.yaml");
    QTRY_COMPARE(m_answers.confirmed.size(), 1);
    QVERIFY(!keep->isChecked());
    QCOMPARE(read(index).count('\n'), 1);
    m_answers.confirm = true;
    saveAs("mine.yaml");
    QVERIFY(keep->isChecked());  // they are there still
    saveAs("other.yaml");
    QTRY_COMPARE(m_answers.confirmed.size(), 2);
    QVERIFY(keep->isChecked());
    QTRY_COMPARE(read(index).count('\n'), 4);
    // Nothing is asked about a file that is left at once.
    saveAs("mine.yaml");
    QVERIFY(!keep->isChecked());
    window().document().start();
    QCoreApplication::processEvents();
    QCOMPARE(m_answers.confirmed.size(), 2);
    QVERIFY(m_answers.told.isEmpty());
}

// At once, before anything that waits for its turn can have come.
void TestPinnedRuns::closingAsksAboutTheRunsOfAFileSavedOver() {
    const QString index = m_folder.filePath("theirs.runs/runs.csv");
    QVERIFY(QDir().mkpath(m_folder.filePath("theirs.runs")));
    write(index, "file,name,shown,reference,cor\n");
    pinThree();
    for (const bool replaces : {false, true}) {
        saveAs("ours.yaml");
        part<PinnedRuns>(window()).keepAction()->setChecked(false);
        part<PinnedRuns>(window()).keepAction()->trigger();
        m_answers.confirmed.clear();
        m_answers.confirm = replaces;
        saveAs("theirs.yaml");
        QVERIFY(window().close());
        QCOMPARE(m_answers.confirmed.size(), 1);
        QVERIFY(m_answers.confirmed.first().contains("theirs.runs"));
        QCOMPARE(read(index).count('\n'), replaces ? 4 : 1);
        window().show();
    }
    QCoreApplication::processEvents();
    QCOMPARE(m_answers.confirmed.size(), 1);
    QCOMPARE(m_answers.unwritten, QStringList());
}

void TestPinnedRuns::closingWaitsForTheRunsAndTellsWhyTheyAreNotKept() {
    pinThree();
    saveAs("closed.yaml");
    part<PinnedRuns>(window()).keepAction()->trigger();
    QVERIFY(window().close());
    QCOMPARE(m_answers.unwritten, QStringList());
    QCOMPARE(read(m_folder.filePath("closed.runs/runs.csv")).count('\n'), 4);
    window().show();
    write(m_folder.filePath("closed.runs/A.yaml"), "mine");
    runs().rename(1, "renamed");
    m_answers.confirmClose = false;
    QVERIFY(!window().close());
    QVERIFY(window().isVisible());
    QCOMPARE(m_answers.unwritten.size(), 1);
    QVERIFY(m_answers.unwritten.first().contains("A.yaml"));
    QCOMPARE(m_answers.told, QStringList());
    QCOMPARE(read(m_folder.filePath("closed.runs/A.yaml")), QByteArray("mine"));
    // Nothing is left to be written.
    QVERIFY(window().close());
    QCOMPARE(m_answers.unwritten.size(), 1);
}

void TestPinnedRuns::refusalsAreTold() {
    part<PinnedRuns>(window()).pinAction()->trigger();
    part<PinnedRuns>(window()).pinAction()->trigger();
    QTRY_COMPARE(m_answers.told.size(), 1);
    QCOMPARE(runs().list()->size(), 1u);
    QVERIFY(m_answers.told.first().startsWith("This result is not pinned."));
}

QTEST_MAIN(TestPinnedRuns)
#include "tst_pinned_runs.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a whole: what its parts do together.
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QStatusBar>
#include <QTest>
#include <algorithm>

#include "core/model/law_parameter.h"
#include "core/yaml/examples.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "tests/support/window_fixture.h"
#include "tests/support/window_parts.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/study_status.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/result_panel.h"
#include "ui/window/document_notices.h"
#include "ui/window/file_menu.h"

using namespace drillwave;
using namespace drillwave::test;

class TestMainWindow : public QObject, private WindowFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() { m_window.reset(); }
    void opensWithASolvedBlow();
    void everyRowHasANameAndAnExplanation();
    void typingABetaMovesStiffnessAndResult();
    void movingTheStiffnessMovesBeta();
    void aDragIsOneStepAndUndoRestoresTheBytes();
    void wrongTextIsExplainedBelowItsRow();
    void theLocalesCommaIsTyped();
    void aFailingSolversTextReachesTheAlerts();
    void aSlowSolverNeverHoldsTheWindowUp();
    void savingIntoAnUnwritableFolderIsReportedAndNothingLost();
    void savedFilesAreRememberedAndReopened();
    void aBadFileIsReportedAndThePresentScenarioStays();
    void closingAsksAboutUnsavedChanges();
    void theShapeOfThePulseChangesItsRows();
    void everyExampleOpensSolved();
    void theTitleBarNamesTheFile();
    void controlEReachesTheWindowFromALineEdit();
    void theNoteOfAnExampleDoesNotOutliveItsValues();
    void aNarrowWindowStacksItsPanels();
    void aWindowCanGoWhileAFieldIsEdited_data();
    void aWindowCanGoWhileAFieldIsEdited();
};

void TestMainWindow::opensWithASolvedBlow() {
    MainWindow fresh(std::make_unique<ScriptedQuestions>(m_answers), exactSolve());
    // Solved before it is shown: no empty frame.
    QCOMPARE(fresh.shown()->fault, QString());
    QVERIFY(fresh.shown()->summary.cor > 0);
    QVERIFY(!part<BlowPage>(fresh).plot()->graph(0)->data()->isEmpty());
    QCOMPARE(part<BlowPage>(fresh).plot()->axisRectCount(), 4);
    QVERIFY(fresh.windowTitle().startsWith(QString::fromStdString(defaultExample().title)));
    QVERIFY(!fresh.isWindowModified());
    QVERIFY(part<ResultPanel>(fresh)
                .findChild<QLabel*>(QStringLiteral("cor"))
                ->text()
                .startsWith(QStringLiteral("0.")));
}

void TestMainWindow::everyRowHasANameAndAnExplanation() {
    int rows = 0;
    for (const QuantityField* each : part<ScenarioPanel>(window()).findChildren<QuantityField*>()) {
        QVERIFY(each->accessibleName().contains(QLatin1Char(':')));
        QVERIFY(!each->toolTip().isEmpty());
        if (each->objectName() == QLatin1String("table.impulse")) continue;  // follows from a table
        QVERIFY(findParameter(each->objectName().toStdString()));
        ++rows;
    }
    // A parameter that is in scales where there are no units has a row for each.
    const auto isScaled = [](const Parameter& parameter) { return bool(inScales(parameter)); };
    QCOMPARE(rows, int(parameters().size()) + int(std::ranges::count_if(parameters(), isScaled)));
    for (const QLabel* label : part<ResultPanel>(window()).findChildren<QLabel*>())
        if (label->textInteractionFlags() & Qt::TextSelectableByKeyboard)
            QVERIFY(!label->accessibleName().isEmpty());
}

void TestMainWindow::typingABetaMovesStiffnessAndResult() {
    const double before = cor();
    const double stiffness = *field("bit_rock.stiffness").value();
    type(field("beta"), QStringLiteral("0.25"));
    QTRY_VERIFY(cor() != before);
    settle();
    QCOMPARE(window().shown()->problem.law.beta, 0.25);
    QVERIFY(*field("bit_rock.stiffness").value() < stiffness);
    ExactSolver solver;
    const Scenario& scenario = window().document().scenario();
    QCOMPARE(cor(), solver.solve(problemOf(scenario)).cor);
    QVERIFY(window().isWindowModified());
    QVERIFY(part<SolveStatus>(window()).text().contains(QStringLiteral("e = 0.")));
}

void TestMainWindow::movingTheStiffnessMovesBeta() {
    const double beta = *field("beta").value();
    type(field("bit_rock.stiffness"), QStringLiteral("210 MN/m"));  // twice the example's
    QVERIFY(std::abs(*field("beta").value() / beta - 2) < 1e-12);
}

void TestMainWindow::aDragIsOneStepAndUndoRestoresTheBytes() {
    const QByteArray before = window().document().text();
    auto* slider = part<ScenarioPanel>(window()).findChild<QuantitySlider*>(QStringLiteral("beta.slider"));
    slider->setSliderDown(true);
    for (int position = 300; position <= 700; position += 10) slider->setValue(position);
    slider->setSliderDown(false);
    QCOMPARE(window().document().undoStack().count(), 1);
    type(field("rod.length"), QStringLiteral("12 ft"));
    QCOMPARE(window().document().undoStack().count(), 2);
    QVERIFY(window().document().text() != before);
    QTest::keyClick(&field("rod.length"), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(window().document().text(), before);
    QVERIFY(!window().isWindowModified());
    settle();
    QCOMPARE(window().shown()->request.scenario, window().document().scenario());
}

void TestMainWindow::wrongTextIsExplainedBelowItsRow() {
    const double before = cor();
    type(field("bit_rock.gamma"), QStringLiteral("1.3"));
    settle();
    QCOMPARE(cor(), before);
    const QList<QLabel*> labels = part<ScenarioPanel>(window()).findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
        return label->isVisible() && label->text().contains(QStringLiteral("must be in (0, 1]"));
    }));
}

void TestMainWindow::theLocalesCommaIsTyped() {
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    makeWindow(exactSolve());
    type(field("rod.length"), QStringLiteral("4,27"));
    QCOMPARE(window().document().scenario().rod.length, 4.27);
    QCOMPARE(field("rod.length").findChild<QLineEdit*>()->text(), QStringLiteral("4,27"));
    QVERIFY(window().document().text().contains("length: 4.27 m"));
    settle();
    QVERIFY(part<ResultPanel>(window())
                .findChild<QLabel*>(QStringLiteral("cor"))
                ->text()
                .startsWith(QStringLiteral("0,")));
}

void TestMainWindow::aFailingSolversTextReachesTheAlerts() {
    makeWindow([](const SolveRequest& request) {
        return failedBlow(request, QStringLiteral("The rod has melted."));
    });
    QCOMPARE(part<ResultPanel>(window()).alerts()->texts(),
             QStringList{QStringLiteral("The rod has melted.")});
    QCOMPARE(part<ResultPanel>(window()).findChild<QLabel*>(QStringLiteral("cor"))->text(),
             QStringLiteral("–"));
    QVERIFY(part<BlowPage>(window()).plots()->textSummary().contains(QStringLiteral("melted")));
    makeWindow([](const SolveRequest&) -> SolvedBlowPtr { throw std::runtime_error("out of rock"); });
    QCOMPARE(part<ResultPanel>(window()).alerts()->texts(), QStringList{QStringLiteral("out of rock")});
}

void TestMainWindow::aSlowSolverNeverHoldsTheWindowUp() {
    auto solver = std::make_shared<MethodSolver>();
    std::atomic<int> calls = 0;
    makeWindow([solver, &calls](const SolveRequest& request) {
        ++calls;
        QTest::qSleep(30);
        return solveBlow(request, *solver);
    });
    calls = 0;
    for (int i = 1; i <= 50; ++i) window().document().assign(*findParameter("beta"), 0.02 * i, 1);
    // All fifty were taken at once; the first and the last are solved.
    settle();
    QCOMPARE(calls.load(), 2);
    QCOMPARE(window().shown()->problem.law.beta, 1.0);
    m_window.reset();
}

void TestMainWindow::savingIntoAnUnwritableFolderIsReportedAndNothingLost() {
    type(field("rod.length"), QStringLiteral("5"));
    m_answers.save = m_folder.filePath(QStringLiteral("missing/a.yaml"));
    QVERIFY(!part<FileMenu>(window()).save());
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY2(m_answers.told.first().contains(QStringLiteral("a.yaml")), qPrintable(m_answers.told.first()));
    QVERIFY(window().isWindowModified());
    QCOMPARE(window().document().scenario().rod.length, 5.0);
    QVERIFY(window().document().undoStack().canUndo());
}

void TestMainWindow::savedFilesAreRememberedAndReopened() {
    const QString path = m_folder.filePath(QStringLiteral("mine.yaml"));
    type(field("rod.length"), QStringLiteral("5"));
    m_answers.save = path;
    QVERIFY(part<FileMenu>(window()).save());
    QVERIFY(!window().isWindowModified());
    QCOMPARE(read(path), window().document().text());
    makeWindow(exactSolve());
    const QList<QMenu*> menus = part<FileMenu>(window()).findChildren<QMenu*>();
    QVERIFY(std::ranges::any_of(menus, [&](const QMenu* menu) {
        return !menu->actions().isEmpty() &&
               menu->actions().first()->text().endsWith(QStringLiteral("mine.yaml"));
    }));
    QVERIFY(window().openFile(path));
    QCOMPARE(window().document().scenario().rod.length, 5.0);
    QTRY_COMPARE(window().shown()->request.scenario, window().document().scenario());
}

void TestMainWindow::aBadFileIsReportedAndThePresentScenarioStays() {
    const QString path = m_folder.filePath(QStringLiteral("bad.yaml"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("drillwave: 1\nrodd: 3\n");
    file.close();
    const Scenario before = window().document().scenario();
    QVERIFY(!window().openFile(path));
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY2(m_answers.told.first().contains(QStringLiteral("bad.yaml:2")),
             qPrintable(m_answers.told.first()));
    QCOMPARE(window().document().scenario(), before);
}

void TestMainWindow::closingAsksAboutUnsavedChanges() {
    QVERIFY(window().close());
    QCOMPARE(m_answers.unsavedAsked, 0);
    makeWindow(exactSolve());
    type(field("rod.length"), QStringLiteral("5"));
    m_answers.unsaved = Questions::Unsaved::cancel;
    QVERIFY(!window().close());
    QVERIFY(window().isVisible());
    m_answers.unsaved = Questions::Unsaved::save;
    m_answers.save = m_folder.filePath(QStringLiteral("missing/b.yaml"));
    QVERIFY(!window().close());  // it could not be saved, so it must not be lost
    m_answers.unsaved = Questions::Unsaved::discard;
    QVERIFY(window().close());
    QCOMPARE(m_answers.unsavedAsked, 3);
}

void TestMainWindow::theShapeOfThePulseChangesItsRows() {
    auto* shape = part<ScenarioPanel>(window()).findChild<QComboBox*>(QStringLiteral("pulse.shape"));
    QCOMPARE(shape->findText(QStringLiteral("table")), -1);  // there are no points
    QVERIFY(!field("pulse.rise").isVisible());
    shape->setCurrentIndex(shape->findText(QStringLiteral("trapezoid")));
    emit shape->activated(shape->currentIndex());
    QVERIFY(field("pulse.rise").isVisible());
    QCOMPARE(window().document().scenario().pulse.shape, PulseShape::trapezoid);
    shape->setCurrentIndex(shape->findText(QStringLiteral("piston")));
    emit shape->activated(shape->currentIndex());
    QVERIFY(!field("pulse.rise").isVisible());
    QVERIFY(field("pulse.velocity").isVisible());
    settle();
    QTRY_COMPARE(window().shown()->request.scenario, window().document().scenario());
    QCOMPARE(window().shown()->fault, QString());
}

void TestMainWindow::everyExampleOpensSolved() {
    for (const Example& example : builtInExamples()) {
        QCOMPARE(window().document().startFrom(example.text, QString::fromStdString(example.name)),
                 QString());
        settle();
        QTRY_COMPARE(window().shown()->request.scenario, window().document().scenario());
        QCOMPARE(window().shown()->fault, QString());
    }
}

void TestMainWindow::theTitleBarNamesTheFile() {
    QVERIFY(!window().windowTitle().contains(QStringLiteral(".yaml")));
    const QString path = m_folder.filePath(QStringLiteral("named.yaml"));
    QCOMPARE(window().document().save(path), QString());
    QCOMPARE(window().windowTitle(), QStringLiteral("T38 rod, medium rock – named.yaml[*] — Drillwave"));
    window().document().setTitle({});
    QCOMPARE(window().windowTitle(), QStringLiteral("named.yaml[*] — Drillwave"));
}

// As line edits do on X11, where Ctrl+E goes to the end of the line.
class GreedyLineEdit : public QLineEdit {
  public:
    using QLineEdit::QLineEdit;

  protected:
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ShortcutOverride) event->accept();
        return event->type() == QEvent::ShortcutOverride || QLineEdit::event(event);
    }
};

void TestMainWindow::controlEReachesTheWindowFromALineEdit() {
    GreedyLineEdit edit(window().centralWidget());
    edit.show();
    edit.setFocus();
    QVERIFY(edit.hasFocus());
    m_answers.folder = m_folder.filePath(QStringLiteral("everything"));
    QTest::keyClick(&edit, Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY(QFile::exists(m_answers.folder + QStringLiteral("/summary.json")));
}

void TestMainWindow::theNoteOfAnExampleDoesNotOutliveItsValues() {
    const QString explanation = part<ExampleNote>(window()).text();
    QCOMPARE(explanation, QString::fromStdString(defaultExample().explanation));
    window().document().assign(*findParameter("rod.length"), 4, 1);
    QVERIFY(part<ExampleNote>(window()).text().startsWith(QStringLiteral("You have changed this example")));
    window().document().undoStack().undo();
    QCOMPARE(part<ExampleNote>(window()).text(), explanation);
}

void TestMainWindow::aNarrowWindowStacksItsPanels() {
    const QList<QDockWidget*> docks = window().findChildren<QDockWidget*>();
    QCOMPARE(docks.size(), 2);
    window().resize(1500, 800);
    QTRY_VERIFY(window().tabifiedDockWidgets(docks[0]).isEmpty());
    window().setMinimumSize(1, 1);  // as a window manager may that knows no smallest size
    window().resize(800, 500);
    QTRY_COMPARE(window().tabifiedDockWidgets(docks[0]).size(), 1);
    QVERIFY(window().minimumSizeHint().width() <= 800);
    window().resize(1500, 800);
    QTRY_VERIFY(window().tabifiedDockWidgets(docks[0]).isEmpty());
}

void TestMainWindow::aWindowCanGoWhileAFieldIsEdited_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("title") << "title";
    QTest::newRow("quantity") << "rod.length";
}

// The last thing a field does is to lose the focus and to hand over its edits: to a document that must still
// be there.
void TestMainWindow::aWindowCanGoWhileAFieldIsEdited() {
    QFETCH(QString, name);
    auto* edited = part<ScenarioPanel>(window()).findChild<QWidget*>(name);
    edited->setFocus();
    QVERIFY(edited->hasFocus());
    QTest::keyClicks(edited, QStringLiteral("1"));
    m_window.reset();
    QVERIFY(!QApplication::focusWidget());
}

QTEST_MAIN(TestMainWindow)
#include "tst_main_window.moc"

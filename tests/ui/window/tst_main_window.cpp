// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a whole: what its parts do together.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include "core/file/examples.h"
#include "core/file/preset_file.h"
#include "core/model/scales.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/export/export_menu.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/solve_job.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/result_panel.h"
#include "ui/text/settings.h"
#include "ui/text/unit_choice.h"
#include "ui/window/example_note.h"
#include "ui/window/file_menu.h"
#include "ui/window/plot_view_menu.h"
#include "ui/window/units_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

void type(QuantityField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Backspace);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

}  // namespace

class TestMainWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void cleanup();
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
    void unitsOfResultsCanBeSwitched();
    void usUnitsAreThoseOfFieldsResultsAndPlots();
    void oneKindOfValueCanHaveAnotherUnit();
    void aFieldKeepsItsOwnUnitUntilASystemIsChosen();
    void aDimensionlessScenarioHasNoSi();
    void aNewScenarioCanBeDimensionless();
    void theViewMenuHasWhatThePlotOffers();
    void theTimeCursorMovesNoPlot();
    void theSectionOfTheWavesCanBeMoved();
    void theShapeOfThePulseChangesItsRows();
    void everyExampleOpensSolved();
    void theTitleBarNamesTheFile();
    void controlEReachesTheWindowFromALineEdit();
    void aChosenUnitIsKept();
    void aPresetLeavesAGhostUntilTheNextChange();
    void theNoteOfAnExampleDoesNotOutliveItsValues();
    void aNarrowWindowStacksItsPanels();
    void keysAimAtThePlotBelowThePointer();
    void theReasonOfAnUnsolvedCaseStaysInThePlot();
    void aWindowCanGoWhileAFieldIsEdited_data();
    void aWindowCanGoWhileAFieldIsEdited();

  private:
    MainWindow& window() { return *m_window; }
    QuantityField& field(const char* key) {
        return *part<ScenarioPanel>(*m_window).findChild<QuantityField*>(QLatin1String(key));
    }
    double cor() const { return m_window->shown()->summary.cor; }
    void makeWindow(SolveJob::Solve solve);
    QString forceAxis();
    void settle() { QTRY_VERIFY(!part<SolveJob>(*m_window).isBusy()); }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestMainWindow::initTestCase() {
    keepSettingsIn(m_folder.filePath(QStringLiteral("settings")));
}

void TestMainWindow::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_answers = {};
    makeWindow(exactSolve());
}

void TestMainWindow::cleanup() {
    m_window.reset();
}

void TestMainWindow::makeWindow(SolveJob::Solve solve) {
    m_window = newWindow(m_answers, std::move(solve));
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void TestMainWindow::opensWithASolvedBlow() {
    MainWindow fresh(std::make_unique<ScriptedQuestions>(m_answers), exactSolve());
    // Solved before it is shown: no empty frame.
    QCOMPARE(fresh.shown()->problem, QString());
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
    QCOMPARE(rows, int(parameters().size()));
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
    QCOMPARE(window().shown()->solved.law.beta, 0.25);
    QVERIFY(*field("bit_rock.stiffness").value() < stiffness);
    ExactSolver solver;
    const Scenario& scenario = window().document().scenario();
    QCOMPARE(cor(), solver.solve(problemOf(scenario)).cor);
    QVERIFY(window().isWindowModified());
    QVERIFY(
        window().findChild<QStatusBar*>()->findChild<QLabel*>()->text().contains(QStringLiteral("e = 0.")));
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
    QCOMPARE(window().shown()->solved.law.beta, 1.0);
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

void TestMainWindow::unitsOfResultsCanBeSwitched() {
    QVERIFY(part<BlowPage>(window())
                .plots()
                ->axisRect(1)
                ->axis(QCPAxis::atLeft)
                ->label()
                .contains(QStringLiteral("[kN]")));
    for (QAction* action : part<UnitsChoice>(window()).actions())
        if (action->text() == QStringLiteral("&Dimensionless")) action->trigger();
    settle();
    QTRY_VERIFY(part<BlowPage>(window())
                    .plots()
                    ->axisRect(1)
                    ->axis(QCPAxis::atLeft)
                    ->label()
                    .contains(QStringLiteral("F₀")));
    QCOMPARE(window().shown()->units.force.factor, 1.0);
}

QString TestMainWindow::forceAxis() {
    return part<BlowPage>(window()).plots()->axisRect(1)->axis(QCPAxis::atLeft)->label();
}

void TestMainWindow::usUnitsAreThoseOfFieldsResultsAndPlots() {
    const double length = *field("rod.length").value();
    part<UnitsChoice>(window()).choose(UnitSystem::us);
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("[kip]")));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    QCOMPARE(field("rod.diameter").unit().name, std::string_view("in"));
    QCOMPARE(field("rod.youngs_modulus").unit().name, std::string_view("Mpsi"));
    QCOMPARE(field("drill.thrust").unit().name, std::string_view("lbf"));
    QCOMPARE(*field("rod.length").value(), length);
    const QString results = part<ResultPanel>(window()).text();
    for (const char* unit : {"kip", "ft lbf", "ksi", "lbf s", "in\n"})
        QVERIFY2(results.contains(QLatin1String(unit)), unit);
    for (const char* unit : {"kN", "MPa", "mm"})
        QVERIFY2(!results.contains(QChar(QChar::Nbsp) + QLatin1String(unit)), unit);
    // Dimensionless results leave the fields as they are.
    part<UnitsChoice>(window()).choose(UnitSystem::dimensionless);
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("F₀")));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
}

void TestMainWindow::oneKindOfValueCanHaveAnotherUnit() {
    UnitChoice& units = UnitChoice::shared();
    units.choose(UnitKind::force, findUnit(Quantity::force, "lbf"));
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("[lbf]")));
    QCOMPARE(field("drill.thrust").unit().name, std::string_view("lbf"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("m"));
    QVERIFY(window().close());
    makeWindow(exactSolve());
    QVERIFY(forceAxis().contains(QStringLiteral("[lbf]")));
    units.choose(UnitKind::force, nullptr);
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("[kN]")));
}

void TestMainWindow::aFieldKeepsItsOwnUnitUntilASystemIsChosen() {
    const auto chooseInField = [this](const QString& name) {
        for (QAction* action : field("rod.length").unitButton()->menu()->actions())
            if (action->text() == name) action->trigger();
    };
    chooseInField(QStringLiteral("cm"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("cm"));
    UnitChoice::shared().choose(UnitKind::force, findUnit(Quantity::force, "N"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("cm"));
    part<UnitsChoice>(window()).choose(UnitSystem::si);
    QCOMPARE(field("rod.length").unit().name, std::string_view("m"));
    chooseInField(QStringLiteral("cm"));
    UnitChoice::shared().choose(UnitKind::length, findUnit(Quantity::length, "ft"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    QVERIFY(!Settings().contains(QStringLiteral("units/rod.length")));
}

void TestMainWindow::aDimensionlessScenarioHasNoSi() {
    const Example* example = findExample("paper_fig4b");
    QVERIFY(example);
    QCOMPARE(window().document().startFrom(example->text, QStringLiteral("example")), QString());
    settle();
    // Paper, Fig. 4 (b); the value of the reference solver, to its 1e-13.
    QTRY_VERIFY(std::abs(cor() - 0.40671074387478970) < 1e-13);
    QCOMPARE(window().shown()->request.units, UnitSystem::dimensionless);
    QVERIFY(!field("rod.length").isVisible());
    QVERIFY(field("beta").isVisible());
}

void TestMainWindow::aNewScenarioCanBeDimensionless() {
    QAction* chosen = nullptr;
    for (QAction* action : part<FileMenu>(window()).actions())
        if (action->text().remove(QLatin1Char('&')) == QLatin1String("New dimensionless")) chosen = action;
    QVERIFY(chosen);
    chosen->trigger();
    settle();
    QCOMPARE(window().document().scenario().form, ScenarioForm::dimensionless);
    QVERIFY(window().document().scenario().groups == Groups());
    QVERIFY(!window().document().isModified());
    QCOMPARE(window().document().path(), QString());
    QVERIFY(field("beta").isVisible());
    QTRY_VERIFY(std::isfinite(cor()));
}

void TestMainWindow::theViewMenuHasWhatThePlotOffers() {
    auto& menu = part<PlotViewMenu>(window());
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    emit menu.aboutToShow();
    const auto action = [&menu](const QString& text) {
        for (QAction* each : menu.actions())
            if (each->text().remove(QLatin1Char('&')).startsWith(text)) return each;
        return static_cast<QAction*>(nullptr);
    };
    for (const QString& text :
         {QStringLiteral("Fit"), QStringLiteral("Zoom back"), QStringLiteral("Logarithmic vertical"),
          QStringLiteral("Curves shown"), QStringLiteral("Cursor A")})
        QVERIFY2(action(text), qPrintable(text));
    action(QStringLiteral("Cursor A"))->trigger();
    QVERIFY(plot.reader().position(PlotCursor::a));
    plot.view().zoom(0.5);
    const QCPRange zoomed = plot.axisRect(0)->axis(QCPAxis::atLeft)->range();
    emit menu.aboutToShow();
    action(QStringLiteral("Zoom back"))->trigger();
    QVERIFY(plot.axisRect(0)->axis(QCPAxis::atLeft)->range() != zoomed);
    // The table below the plots goes and comes, and is remembered.
    plot.reader().clear();
    QVERIFY(plot.viewport().height() < plot.height());
    menu.tableAction()->trigger();
    QCOMPARE(plot.viewport().height(), plot.height());
    QVERIFY(!Settings().value(tableShownKey, true).toBool());
    menu.tableAction()->trigger();
    QVERIFY(plot.viewport().height() < plot.height());
}

void TestMainWindow::theTimeCursorMovesNoPlot() {
    settle();
    const PlotWidget& plot = *part<BlowPage>(window()).plot();
    const QRect place(plot.mapTo(&window(), QPoint()), plot.size());
    auto& observation = part<Observation>(window());
    for (const double time : {0.5, 12.3456789, 1e-9}) {
        observation.setTime(time);
        QCoreApplication::processEvents();
        QCOMPARE(QRect(plot.mapTo(&window(), QPoint()), plot.size()), place);
    }
}

void TestMainWindow::theSectionOfTheWavesCanBeMoved() {
    part<BlowPage>(window()).findChild<QDoubleSpinBox*>(QStringLiteral("section"))->setValue(0.25);
    QTRY_COMPARE(window().shown()->page<BlowCurves>()->section, 0.25);
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
    QCOMPARE(window().shown()->problem, QString());
}

void TestMainWindow::everyExampleOpensSolved() {
    for (const Example& example : builtInExamples()) {
        QCOMPARE(window().document().startFrom(example.text, QString::fromStdString(example.name)),
                 QString());
        settle();
        QTRY_COMPARE(window().shown()->request.scenario, window().document().scenario());
        QCOMPARE(window().shown()->problem, QString());
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

void TestMainWindow::aChosenUnitIsKept() {
    type(field("rod.length"), QStringLiteral("12 ft"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    makeWindow(exactSolve());
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    type(field("rod.length"), QStringLiteral("3 m"));
    makeWindow(exactSolve());
    QCOMPARE(field("rod.length").unit().name, std::string_view("m"));
}

void TestMainWindow::aPresetLeavesAGhostUntilTheNextChange() {
    const int graphs = part<BlowPage>(window()).plot()->graphCount();
    const auto hard = std::ranges::find(builtInPresets(), std::string("hard rock"), &Preset::name);
    QCOMPARE(window().document().applyPreset(*hard), QString());
    settle();
    QVERIFY(part<BlowPage>(window()).plot()->graphCount() > graphs);
    window().document().assign(*findParameter("rod.length"), 4, 1);
    settle();
    QCOMPARE(part<BlowPage>(window()).plot()->graphCount(), graphs);
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

void TestMainWindow::keysAimAtThePlotBelowThePointer() {
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    const QPointF middle = plot.axisRect(0)->center();
    QEnterEvent enter(middle, middle, plot.mapToGlobal(middle));
    QCoreApplication::sendEvent(&plot, &enter);
    auto* button = part<BlowPage>(window()).findChild<QPushButton*>();
    button->setFocus();
    QTest::keyClick(button, Qt::Key_A);
    QVERIFY(plot.reader().position(PlotCursor::a));
    // Text is typed where the focus is.
    auto* title = part<ScenarioPanel>(window()).findChild<QLineEdit*>(QStringLiteral("title"));
    title->setFocus();
    title->clear();
    QTest::keyClicks(title, QStringLiteral("b"));
    QCOMPARE(title->text(), QStringLiteral("b"));
    QVERIFY(!plot.reader().position(PlotCursor::b));
    // The wheel takes the focus, so that Backspace brings the view back.
    QWheelEvent wheel(middle, plot.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    const QCPRange before = plot.xAxis->range();
    QCoreApplication::sendEvent(&plot, &wheel);
    QVERIFY(plot.hasFocus());
    QTest::keyClick(window().focusWidget(), Qt::Key_Backspace);
    QCOMPARE(plot.xAxis->range().upper, before.upper);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&plot, &leave);
}

void TestMainWindow::theReasonOfAnUnsolvedCaseStaysInThePlot() {
    makeWindow([](const SolveRequest& request) {
        return failedBlow(request,
                          QString("The histories need more than 4 million wave pieces. ").repeated(5));
    });
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    plot.replot();
    const QCPItemText* message = nullptr;
    for (int i = 0; i < plot.itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(plot.item(i)); text && text->text().contains("million"))
            message = text;
    QVERIFY(message && message->visible());
    QVERIFY(message->brush().style() != Qt::NoBrush);
    QVERIFY(message->left->pixelPosition().x() >= 0);
    QVERIFY(message->right->pixelPosition().x() <= plot.width());
    QVERIFY(message->top->pixelPosition().y() >= 0);
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

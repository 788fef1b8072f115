// SPDX-License-Identifier: GPL-3.0-or-later
// A goal on the page Curve: its text, its marks, the value that a click takes, and the ways to it.
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QMenu>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "core/report/curve_figure.h"
#include "core/yaml/examples.h"
#include "tests/support/curve_page_fixture.h"
#include "tests/support/lossless_string.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/curve/goal_field.h"
#include "ui/pages/string/string_model.h"
#include "ui/pages/string/string_page.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/family_fields.h"
#include "ui/pages/study/output_box.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

std::vector<FigureMark> goalMarks(const CurvePage& page) {
    std::vector<FigureMark> found;
    for (const FigureMark& mark : panelOf(page).marks)
        if (mark.kind == MarkKind::goal) found.push_back(mark);
    return found;
}

}  // namespace

class TestGoalPage : public QObject, private CurvePageFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void everyPlaceOfTheGoalIsMarked();
    void aClickTakesTheValueInOneStep();
    void whatNothingGivesIsToldWithTheNearest();
    void otherLinesThatReachTheGoalAreNamed();
    void eachResultHasItsOwnGoal();
    void theGoalFollowsTheUnits();
    void whatIsNoGoalStaysAndChangesNothing_data();
    void whatIsNoGoalStaysAndChangesNothing();
    void commasAreTyped();
    void theCommandKeepsTheGoal();
    void placesBetweenPointsOfAStringAreSolvedFor();
    void theMenuOfAFieldLeadsHere();
    void aCellOfTheStringLeadsHere();

  private:
    void showPage(UnitSystem units = UnitSystem::si);
    void type(const QString& goal);
    const GoalAnswer& answer() const;
    const CurveQuestion& asked() const { return m_page->study().value()->question.curve; }
};

void TestGoalPage::showPage(UnitSystem units) {
    showIn(hasUnits(m_document->scenario()) ? units : UnitSystem::dimensionless);
}

void TestGoalPage::type(const QString& goal) {
    m_page->goal()->selectAll();
    QTest::keyClick(m_page->goal(), Qt::Key_Delete);
    QTest::keyClicks(m_page->goal(), goal);
    QTest::keyClick(m_page->goal(), Qt::Key_Return);
    finish();
}

const GoalAnswer& TestGoalPage::answer() const {
    const Scenario& scenario = m_document->scenario();
    const double gamma = hasUnits(scenario) ? scenario.bitRock.gamma : scenario.groups.gamma;
    return *markedLine(m_page->study().value()->curve, gamma)->goal;
}

// The elastic curve of theory §7 has its largest e, 1.41407, at β = 0.29983.
void TestGoalPage::everyPlaceOfTheGoalIsMarked() {
    openElastic();
    showPage();
    QVERIFY(goalMarks(*m_page).empty());
    type(QStringLiteral("1.3"));
    QCOMPARE(asked().goal, std::optional(1.3));
    const std::vector<FigureMark> marks = goalMarks(*m_page);
    QCOMPARE(marks.size(), answer().places.size());
    QVERIFY(marks.size() >= 2);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        QCOMPARE(marks[i].x, answer().places[i].x.value);
        QCOMPARE(marks[i].y, 1.3);
    }
    QCOMPARE(m_page->figure()->levels.back().y, 1.3);
    QVERIFY2(words().contains(QStringLiteral("COR e = 1.3 at ")) &&
                 words().contains(QStringLiteral("nowhere else")),
             qPrintable(words()));
    type(QString());
    QVERIFY(!asked().goal && goalMarks(*m_page).empty());
}

void TestGoalPage::aClickTakesTheValueInOneStep() {
    openElastic();
    showPage();
    type(QStringLiteral("1.3"));
    const double place = answer().places.front().x.value;
    const int before = m_document->undoStack().count();
    emit m_page->plot()->placeTaken(nullptr, {place * 1.001, 1.3}, Qt::NoModifier);
    QCOMPARE(m_document->undoStack().count(), before + 1);
    QCOMPARE(m_document->scenario().groups.beta, place);
    // what a place promises at worst
    QVERIFY(std::abs(solved(*m_document, UnitSystem::dimensionless)->summary.cor - 1.3) < 1.3e-9);
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario().groups.beta, 0.5);
    finish();
}

void TestGoalPage::whatNothingGivesIsToldWithTheNearest() {
    openElastic();
    showPage();
    type(QStringLiteral("2"));
    QVERIFY(goalMarks(*m_page).empty());
    QVERIFY2(words().contains(QStringLiteral(" gives COR e = 2: the nearest is 1.4141")),
             qPrintable(words()));
}

void TestGoalPage::otherLinesThatReachTheGoalAreNamed() {
    showPage();
    type(QStringLiteral("1"));
    QVERIFY2(words().contains(QStringLiteral("no stiffness k from 10")) &&
                 words().contains(QStringLiteral("gives COR e = 1: the nearest is")) &&
                 words().contains(QStringLiteral("γ = 1 is above it everywhere")),
             qPrintable(words()));
    type(QStringLiteral("0.6"));
    QVERIFY2(!words().contains(QStringLiteral("everywhere")), qPrintable(words()));
}

void TestGoalPage::eachResultHasItsOwnGoal() {
    openElastic();
    showPage();
    type(QStringLiteral("1.3"));
    m_page->output()->setOutput(*findOutput("peak_force"));
    finish();
    QVERIFY(m_page->goal()->text().isEmpty() && !asked().goal);
    m_page->output()->setOutput(*findOutput("cor"));
    finish();
    QCOMPARE(m_page->goal()->text(), QStringLiteral("1.3"));
    QCOMPARE(asked().goal, std::optional(1.3));
}

void TestGoalPage::theGoalFollowsTheUnits() {
    showPage();
    m_page->output()->setOutput(*findOutput("peak_force"));
    finish();
    type(QStringLiteral("240 kN"));
    QCOMPARE(asked().goal, std::optional(240e3));
    QVERIFY(std::abs(m_page->figure()->levels.back().y * m_page->figureFrame().yUnit().factor - 240) < 1e-9);
    type(QStringLiteral("250"));  // in the unit on show
    QCOMPARE(asked().goal, std::optional(250e3));
    m_document->units().choose(UnitSystem::us);
    m_page->setResult(solved(*m_document, UnitSystem::us));
    finish();
    QCOMPARE(asked().goal, std::optional(250e3));
    QVERIFY2(m_page->goal()->text().startsWith(QStringLiteral("56.2")), qPrintable(m_page->goal()->text()));
    m_document->units().choose(UnitSystem::dimensionless);
    m_page->setResult(solved(*m_document, UnitSystem::dimensionless));
    finish();
    const double force = scalesOf(m_document->scenario()).force;
    QVERIFY(std::abs(*asked().goal - 250e3 / force) < 1e-12);
    m_document->units().choose(UnitSystem::si);
}

void TestGoalPage::whatIsNoGoalStaysAndChangesNothing_data() {
    QTest::addColumn<QString>("typed");
    QTest::newRow("words") << "much";
    QTest::newRow("a unit of something else") << "5 mm";
    QTest::newRow("an expression without an end") << "2*";
}

void TestGoalPage::whatIsNoGoalStaysAndChangesNothing() {
    QFETCH(QString, typed);
    openElastic();
    showPage();
    type(QStringLiteral("1.3"));
    m_page->goal()->setText(typed);
    QTest::keyClick(m_page->goal(), Qt::Key_Return);
    QCOMPARE(m_page->goal()->text(), typed);
    QVERIFY(!m_page->goal()->problem().isEmpty());
    QVERIFY(m_page->goal()->toolTip().contains(m_page->goal()->problem()));
    QCOMPARE(asked().goal, std::optional(1.3));
    type(QStringLiteral("1.2"));
    QVERIFY(m_page->goal()->problem().isEmpty());
}

void TestGoalPage::commasAreTyped() {
    openElastic();
    m_page->setLocale(QLocale(QLocale::German));
    showPage();
    type(QStringLiteral("1,3"));
    QCOMPARE(asked().goal, std::optional(1.3));
}

void TestGoalPage::theCommandKeepsTheGoal() {
    m_page->output()->setOutput(*findOutput("peak_force"));
    showPage();
    m_page->output()->setOutput(*findOutput("peak_force"));
    finish();
    const QString before = m_page->command();
    QVERIFY2(before.contains(QStringLiteral(" -o -")), qPrintable(before));
    type(QStringLiteral("240 kN"));
    const QString command = m_page->command();
    QVERIFY2(command.startsWith(QStringLiteral("drillwave curve")) &&
                 command.contains(QStringLiteral("--goal '240 kN' --si")) &&
                 !command.contains(QStringLiteral(" -o -")),
             qPrintable(command));
    // The file of the page stays that of the curve.
    QVERIFY(m_page->exports().first().csv().startsWith("bit_rock.gamma,bit_rock.stiffness"));
}

void TestGoalPage::placesBetweenPointsOfAStringAreSolvedFor() {
    QCOMPARE(m_document->startFrom(test::losslessText("t38_string"), QStringLiteral("test")), QString());
    auto* points = m_page->findChild<QComboBox*>("points");
    points->setCurrentIndex(points->findData(51));
    showPage();
    // The manual's value of the scenario, which is a point of the range: half a thousandth below it.
    type(QStringLiteral("0.501"));
    QVERIFY(answer().isReached() && !answer().isComplete);
    QVERIFY(!goalMarks(*m_page).empty());
    QVERIFY2(words().contains(QStringLiteral("perhaps elsewhere")), qPrintable(words()));
    for (const GoalPlace& place : answer().places) {
        QCOMPARE(place.kind, GoalPlace::Kind::crossing);
        QVERIFY(place.x.error < 1e-4 * place.x.value);
    }
    QVERIFY(m_page->command().startsWith(QStringLiteral("drillwave curve - --along")));
}

void TestGoalPage::theMenuOfAFieldLeadsHere() {
    ScriptedAnswers answers;
    const std::unique_ptr<MainWindow> window = test::newWindow(answers);
    window->show();
    auto* field = window->findChild<QuantityField*>(QStringLiteral("rod.length"));
    QVERIFY(field);
    QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(3, 3), field->mapToGlobal(QPoint(3, 3)));
    QApplication::sendEvent(field, &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu);
    QAction* seek = nullptr;
    QStringList texts;
    for (QAction* action : menu->actions()) {
        texts << action->text();
        if (action->objectName() == QStringLiteral("seek")) seek = action;
    }
    QVERIFY2(seek, qPrintable(texts.join('|')));
    // what a spin box has
    QVERIFY(texts.contains(QStringLiteral("&Step up")) && texts.contains(QStringLiteral("Step &down")));
    menu->close();
    seek->trigger();
    auto* page = window->findChild<CurvePage*>();
    QVERIFY(page->isVisible());
    QCOMPARE(page->axis()->range().parameter->key, std::string_view("rod.length"));
    QVERIFY(!page->family()->family().parameter);
    QCOMPARE(window->focusWidget(), page->goal());
    // Nothing of one blow follows from it.
    const auto* ofMany = window->findChild<QuantityField*>(QStringLiteral("drill.damper_damping"));
    QVERIFY(ofMany && ofMany->actions().isEmpty());
}

void TestGoalPage::aCellOfTheStringLeadsHere() {
    ScriptedAnswers answers;
    const std::unique_ptr<MainWindow> window = test::newWindow(answers);
    window->show();
    window->openExample(*findExample("t38_string"));
    auto* string = window->findChild<StringPage*>();
    auto* seek = string->table()->findChild<QAction*>(QStringLiteral("seek"));
    QVERIFY(seek && !seek->isEnabled());
    const StringModel& model = *string->model();
    int coupling = -1;
    for (int row = 0; row < model.rowCount(); ++row)
        if (model.rows()[std::size_t(row)].section.name == "coupling") coupling = row;
    QVERIFY(coupling >= 0);
    string->table()->setCurrentIndex(model.index(coupling, StringModel::sectionName));
    QVERIFY(!seek->isEnabled());
    string->table()->setCurrentIndex(model.index(coupling, StringModel::diameter));
    QVERIFY(seek->isEnabled());
    seek->trigger();
    auto* page = window->findChild<CurvePage*>();
    QVERIFY(page->isVisible());
    QCOMPARE(page->axis()->range().parameter->key, std::string_view("string.coupling.diameter"));
}

QTEST_MAIN(TestGoalPage)
#include "tst_goal_page.moc"

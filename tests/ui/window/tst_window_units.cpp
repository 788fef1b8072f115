// SPDX-License-Identifier: GPL-3.0-or-later
// Units in the window: of fields, results and plots alike.
#include <QTest>

#include "core/yaml/examples.h"
#include "tests/support/window.h"
#include "tests/support/window_fixture.h"
#include "tests/support/window_parts.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/result/result_panel.h"
#include "ui/text/settings.h"
#include "ui/text/unit_choice.h"
#include "ui/window/file_menu.h"
#include "ui/window/units_choice.h"

using namespace drillwave;
using namespace drillwave::test;

class TestWindowUnits : public QObject, private WindowFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() { m_window.reset(); }
    void unitsOfResultsCanBeSwitched();
    void usUnitsAreThoseOfFieldsResultsAndPlots();
    void oneKindOfValueCanHaveAnotherUnit();
    void aFieldKeepsItsOwnUnitUntilASystemIsChosen();
    void aDimensionlessScenarioHasNoSi();
    void aNewScenarioCanBeDimensionless();
    void aChosenUnitIsKept();
    void twoWindowsHaveUnitsOfTheirOwn();

  private:
    QString forceAxis();
};

void TestWindowUnits::unitsOfResultsCanBeSwitched() {
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

QString TestWindowUnits::forceAxis() {
    return part<BlowPage>(window()).plots()->axisRect(1)->axis(QCPAxis::atLeft)->label();
}

void TestWindowUnits::usUnitsAreThoseOfFieldsResultsAndPlots() {
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

void TestWindowUnits::oneKindOfValueCanHaveAnotherUnit() {
    window().document().units().choose(UnitKind::force, findUnit(Quantity::force, "lbf"));
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("[lbf]")));
    QCOMPARE(field("drill.thrust").unit().name, std::string_view("lbf"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("m"));
    QVERIFY(window().close());
    makeWindow(exactSolve());
    QVERIFY(forceAxis().contains(QStringLiteral("[lbf]")));
    window().document().units().choose(UnitKind::force, nullptr);
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("[kN]")));
}

void TestWindowUnits::aFieldKeepsItsOwnUnitUntilASystemIsChosen() {
    const auto chooseInField = [this](const QString& name) {
        for (QAction* action : field("rod.length").unitButton()->menu()->actions())
            if (action->text() == name) action->trigger();
    };
    chooseInField(QStringLiteral("cm"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("cm"));
    window().document().units().choose(UnitKind::force, findUnit(Quantity::force, "N"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("cm"));
    part<UnitsChoice>(window()).choose(UnitSystem::si);
    QCOMPARE(field("rod.length").unit().name, std::string_view("m"));
    chooseInField(QStringLiteral("cm"));
    window().document().units().choose(UnitKind::length, findUnit(Quantity::length, "ft"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    QVERIFY(!Settings().contains(QStringLiteral("units/rod.length")));
}

void TestWindowUnits::aDimensionlessScenarioHasNoSi() {
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

void TestWindowUnits::aNewScenarioCanBeDimensionless() {
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

void TestWindowUnits::aChosenUnitIsKept() {
    type(field("rod.length"), QStringLiteral("12 ft"));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    makeWindow(exactSolve());
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    type(field("rod.length"), QStringLiteral("3 m"));
    makeWindow(exactSolve());
    QCOMPARE(field("rod.length").unit().name, std::string_view("m"));
}

void TestWindowUnits::twoWindowsHaveUnitsOfTheirOwn() {
    ScriptedAnswers answers;
    const auto other = newWindow(answers);
    const SolvedBlowPtr before = other->shown();
    const QString text = part<ResultPanel>(*other).text();
    part<UnitsChoice>(window()).choose(UnitSystem::us);
    settle();
    QTRY_VERIFY(forceAxis().contains(QStringLiteral("[kip]")));
    QCOMPARE(field("rod.length").unit().name, std::string_view("ft"));
    // Nothing was asked there, and nothing is shown in another way.
    QVERIFY(!part<SolveJob>(*other).isBusy());
    QCOMPARE(other->shown().get(), before.get());
    QCOMPARE(part<ResultPanel>(*other).text(), text);
    const auto* length = part<ScenarioPanel>(*other).findChild<QuantityField*>(QStringLiteral("rod.length"));
    QCOMPARE(length->unit().name, std::string_view("m"));
    QCOMPARE(other->document().units().system(), UnitSystem::si);
}

QTEST_MAIN(TestWindowUnits)
#include "tst_window_units.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of outputs: which are asked for, what they are called, and what they ask of the solver.
#include <QTest>

#include "core/study/rows/output_column.h"

using namespace drillwave;

namespace {

Detail detailOf(const char* outputs) {
    return detailFor(chooseOutputs(outputs, OutputUnits::dimensionless).columns);
}

QStringList headersOf(const std::vector<OutputColumn>& columns) {
    QStringList headers;
    for (const OutputColumn& column : columns) headers << QString::fromStdString(column.header());
    return headers;
}

}  // namespace

class TestOutputColumn : public QObject {
    Q_OBJECT

  private slots:
    void columnsAskForNoMoreThanTheyNeed();
    void allAreThoseThatTheScenarioHas();
    void headersHaveTheUnit();
    void theThrustNeedsAFrequency();
};

void TestOutputColumn::columnsAskForNoMoreThanTheyNeed() {
    QCOMPARE(detailOf("cor"), Detail::cor);
    QCOMPARE(detailOf("cor,impulse,thrust,cor_error"), Detail::cor);
    QCOMPARE(detailOf("cor,efficiency"), Detail::summary);
    QCOMPARE(detailOf("peak_tension,cor"), Detail::histories);
    QCOMPARE(detailOf("all"), Detail::histories);
}

void TestOutputColumn::allAreThoseThatTheScenarioHas() {
    Scenario drill;
    drill.drill.blowFrequency = 50;
    drill.drill.thrust = 5000;
    const auto ofRods = static_cast<std::size_t>(std::ranges::count_if(
        outputs(), [&](const Output& output) { return output.problem(drill).isEmpty(); }));
    QCOMPARE(ofRods, std::size_t{26});
    QCOMPARE(allOutputsOf(drill, OutputUnits::si).size(), ofRods);
    const std::vector<OutputColumn> columns = allOutputsOf(Scenario(), OutputUnits::si);
    QCOMPARE(columns.size() + 4, ofRods);  // thrust, its margin, power, penetration rate
    QVERIFY(!headersOf(columns).contains("thrust [N]"));
    QVERIFY(chooseOutputs("all", OutputUnits::si).all);
}

void TestOutputColumn::headersHaveTheUnit() {
    const char* chosen = "cor,peak_force,peak_tension,thrust";
    QCOMPARE(headersOf(chooseOutputs(chosen, OutputUnits::dimensionless).columns).join(','),
             QString("cor,peak_force,peak_tension,thrust [N]"));
    QCOMPARE(headersOf(chooseOutputs(chosen, OutputUnits::si).columns).join(','),
             QString("cor,peak_force [N],peak_tension [Pa],thrust [N]"));
}

void TestOutputColumn::theThrustNeedsAFrequency() {
    const auto columns = chooseOutputs("cor,thrust", OutputUnits::dimensionless).columns;
    QVERIFY(columnProblem(columns, Scenario()).text().find("drill.blow_frequency") != std::string::npos);
    Scenario drill;
    drill.drill.blowFrequency = 50;
    QVERIFY(columnProblem(columns, drill).isEmpty());
}

QTEST_GUILESS_MAIN(TestOutputColumn)
#include "tst_output_column.moc"

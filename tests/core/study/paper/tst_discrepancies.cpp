// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the paper beside ours: ours are those of the theory, and agreement means the printed digits.
#include <QTest>

#include <cmath>

#include "core/study/paper/discrepancies.h"

using namespace drillwave;

class TestDiscrepancies : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { m_all = discrepancies(); }
    void ourNumbersAreThoseOfTheTheory_data();
    void ourNumbersAreThoseOfTheTheory();
    void allDiscrepanciesAreExplained();
    void whatDisagreesIsExplained();
    void agreementIsHalfAUnitOfTheLastDigit_data();
    void agreementIsHalfAUnitOfTheLastDigit();
    void theTableHasOneRowForEach();

  private:
    std::vector<Discrepancy> m_all;
};

// theory §5 and theory §7, computed with 33 digits; half a unit of the last digit given there.
void TestDiscrepancies::ourNumbersAreThoseOfTheTheory_data() {
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("quantity");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("tolerance");
    const auto add = [](const char* place, const char* quantity, double value, double tolerance) {
        QTest::addRow("%s: %s", place, quantity) << place << quantity << value << tolerance;
    };
    add("section 5.2", "beta1", 1.25643120862617, 1e-14);
    add("section 6", "W/W0 at tau = 10", 20, 1e-12);
    add("section 6", "W/W0 at tau = 1/2", 1, 1e-14);
    add("section 6, Fig. 6", "largest e", 1.4140683, 5e-8);
    add("section 6, Fig. 6", "beta of the largest e", 0.29983, 5e-6);
    add("section 6, Fig. 6", "smallest e of the reference", 0.9710054, 5e-8);
    add("section 6, Fig. 6", "beta of it, k0 = Z/(2T)", 2.57847, 5e-6);
    add("section 6, Fig. 6", "beta of it, k0 = Z/t0", 0.12892, 5e-6);
    add("section 6, Fig. 6", "e of the reference case at beta = 2.6", 0.99801, 5e-6);
    add("section 6", "e of the reference case, gamma = 0.1, beta to 0", 0.31622776601683794, 1e-6);
    add("section 6, Fig. 7", "4 exp(-1/2) - 1", 1.42612, 5e-6);
    add("section 6, Fig. 8", "largest e", 1.4010825, 5e-8);
    add("section 6, Fig. 8", "smallest e", 0.8419988, 5e-8);
    add("section 6, Fig. 8", "frac(delta) of the smallest e", 0.52711, 5e-6);
    add("section 6, Fig. 8", "frac(delta) where e falls below 1", 0.326877, 5e-7);
    add("section 6, Fig. 8", "frac(delta) where e rises above 1", 0.778532, 5e-7);
    add("section 6, Fig. 8", "share of super rebounds", 0.548346, 5e-7);
    add("section 6", "d0 for L = 1 m", 0.4, 1e-12);
}

void TestDiscrepancies::ourNumbersAreThoseOfTheTheory() {
    QFETCH(QString, place);
    QFETCH(QString, quantity);
    QFETCH(double, value);
    QFETCH(double, tolerance);
    int found = 0;
    for (const Discrepancy& one : m_all) {
        const QString text = QString::fromStdString(one.quantity);
        if (QString::fromStdString(one.place) != place || !text.startsWith(quantity)) continue;
        ++found;
        QVERIFY2(std::abs(one.computed - value) <= tolerance, QByteArray::number(one.computed, 'g', 17));
    }
    QCOMPARE(found, 1);
}

void TestDiscrepancies::allDiscrepanciesAreExplained() {
    QStringList disagreeing;
    for (const Discrepancy& one : m_all)
        if (!one.agrees()) disagreeing << QString::fromStdString(one.place + ": " + one.quantity);
    const QStringList expected{
        "section 6, Fig. 6: beta of it, k0 = Z/t0",
        "section 6, Fig. 6: e of the reference case at beta = 2.6, k0 = Z/t0",
        "section 6, Fig. 8: largest e, gamma = 1",
        "section 6, Fig. 8: smallest e, gamma = 1",
        "section 6, Fig. 8: frac(delta) of the smallest e",
        "section 6: thrust above that of a rigid bottom [percent]",
    };
    QCOMPARE(disagreeing, expected);
}

void TestDiscrepancies::whatDisagreesIsExplained() {
    QVERIFY(m_all.size() >= 28);
    for (const Discrepancy& one : m_all) {
        QVERIFY2(std::isfinite(one.computed) && std::isfinite(one.printedValue()), one.quantity.c_str());
        QVERIFY2(one.agrees() || !one.explanation.empty(), one.quantity.c_str());
    }
}

void TestDiscrepancies::agreementIsHalfAUnitOfTheLastDigit_data() {
    QTest::addColumn<QString>("printed");
    QTest::addColumn<double>("computed");
    QTest::addColumn<bool>("agrees");
    QTest::newRow("same") << "1.414" << 1.414 << true;
    QTest::newRow("rounds to it") << "1.414" << 1.4144999 << true;
    QTest::newRow("rounds to the next") << "1.414" << 1.4145001 << false;
    QTest::newRow("trailing zeros count") << "0.300" << 0.3006 << false;
    QTest::newRow("whole number") << "20" << 20.4 << true;
    QTest::newRow("negative") << "-1" << -0.6 << true;
    QTest::newRow("not computed") << "1" << std::nan("") << false;
}

void TestDiscrepancies::agreementIsHalfAUnitOfTheLastDigit() {
    QFETCH(QString, printed);
    QFETCH(double, computed);
    QFETCH(bool, agrees);
    QCOMPARE((Discrepancy{"", "", printed.toStdString(), computed, ""}).agrees(), agrees);
}

void TestDiscrepancies::theTableHasOneRowForEach() {
    const QByteArray csv = QByteArray::fromStdString(discrepanciesCsv(m_all));
    QCOMPARE(csv.count('\n'), qsizetype(m_all.size()) + 1);
    QVERIFY(csv.startsWith("place,quantity,printed,computed,difference,agrees,explanation\n"));
    const std::string one = discrepanciesCsv({{"section 6, Fig. 8", "e", "0.5", 0.75, ""}});
    QVERIFY(one.ends_with("\n\"section 6, Fig. 8\",e,0.5,0.75,0.25,no,\n"));
}

QTEST_GUILESS_MAIN(TestDiscrepancies)
#include "tst_discrepancies.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The sketch of a string on paper is in the units of its reader.
#include <QTest>
#include <algorithm>

#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "ui/export/paper_plots.h"
#include "ui/pages/string/string_sketch.h"

using namespace drillwave;

class TestStringSketch : public QObject {
    Q_OBJECT

  private slots:
    void lengthsAndDiametersAreInTheUnitsOfTheReader_data();
    void lengthsAndDiametersAreInTheUnitsOfTheReader();
};

void TestStringSketch::lengthsAndDiametersAreInTheUnitsOfTheReader_data() {
    QTest::addColumn<UnitSystem>("system");
    QTest::addColumn<QString>("length");
    QTest::addColumn<QString>("across");
    QTest::addColumn<double>("metre");
    QTest::addColumn<double>("millimetre");
    QTest::newRow("SI") << UnitSystem::si << "[m]"
                        << "[mm]" << 1.0 << 1.0;
    QTest::newRow("US") << UnitSystem::us << "[ft]"
                        << "[in]" << 1 / 0.3048 << 1 / 25.4;
}

void TestStringSketch::lengthsAndDiametersAreInTheUnitsOfTheReader() {
    QFETCH(UnitSystem, system);
    QFETCH(QString, length);
    QFETCH(QString, across);
    QFETCH(double, metre);
    QFETCH(double, millimetre);
    const Scenario scenario = parseScenario(findExample("t38_string")->text, "t38_string").scenario;
    const PaperPlot paper = stringPaperPlot(scenario, PaperReader{.system = system});
    QCustomPlot& plot = *paper.plot;
    QVERIFY2(plot.xAxis->label().endsWith(length), qPrintable(plot.xAxis->label()));
    QVERIFY2(plot.yAxis->label().endsWith(across), qPrintable(plot.yAxis->label()));
    double front = 0, half = 0;
    for (const Section& section : scenario.drillString.hammer.sections)
        half = std::max(half, section.diameter);
    for (const Section* section : allSections(scenario.drillString)) {
        front += section->length;
        half = std::max(half, section->diameter);
    }
    for (const Section& section : scenario.drillString.hammer.sections) front -= section.length;
    // The front of the last section, and the widest one: bars but the first, which is the rock.
    double drawnFront = 0, drawnHalf = 0;
    for (int i = 1; i < plot.itemCount(); ++i)
        if (const auto* bar = qobject_cast<const QCPItemRect*>(plot.item(i))) {
            drawnFront = std::max(drawnFront, bar->bottomRight->coords().x());
            drawnHalf = std::max(drawnHalf, bar->topLeft->coords().y());
        }
    const double rounding = 1e-12;  // of a few sums
    QVERIFY(std::abs(drawnFront - front * metre) <= rounding * drawnFront);
    QVERIFY(std::abs(drawnHalf - half * 500 * millimetre) <= rounding * drawnHalf);
}

QTEST_MAIN(TestStringSketch)
#include "tst_string_sketch.moc"

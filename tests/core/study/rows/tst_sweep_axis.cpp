// SPDX-License-Identifier: GPL-3.0-or-later
// Axes of a sweep: read from text, evenly spaced, and written so that they read back.
#include <QTest>

#include <cmath>

#include "core/study/rows/sweep_axis.h"

using namespace drillwave;

namespace {

QString textsOf(const SweepAxis& axis) {
    QStringList texts;
    for (std::uint64_t i = 0; i < axis.count; ++i) {
        std::string text;
        axis.column().appendText(text, axis.value(i));
        texts << QString::fromStdString(text);
    }
    return texts.join(' ');
}

/// Sets the i-th value of an axis.
void assign(Scenario& scenario, const char* text, std::uint64_t i) {
    const SweepAxis axis = parseAxis(text).axis;
    axis.assign(scenario, axis.value(i));
}

}  // namespace

class TestSweepAxis : public QObject {
    Q_OBJECT

  private slots:
    void valuesAreThoseAPersonExpects_data();
    void valuesAreThoseAPersonExpects();
    void everyTextReadsBackAsItsValue_data();
    void everyTextReadsBackAsItsValue();
    void theEndsAreExactlyAsGiven();
    void logarithmicStepsHaveOneRatio();
    void assigningSetsTheParameterInSi();
    void aParameterWithoutMeaningIsLeftAlone();
    void extremesHoldTheSmallestAndLargestValue();
    void theCountMayBeLeftOutWhereOneIsAssumed();
    void wrongTextIsRefusedWithTheReason_data();
    void wrongTextIsRefusedWithTheReason();
};

void TestSweepAxis::valuesAreThoseAPersonExpects_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("header");
    QTest::addColumn<QString>("values");
    QTest::newRow("whole steps") << "beta=1:5:5"
                                 << "beta"
                                 << "1 2 3 4 5";
    QTest::newRow("whole numbers") << "string.repeat=1:5:3"
                                   << "string.repeat"
                                   << "1 3 5";
    QTest::newRow("sections by name") << "string.bit skirt.length=50 mm:70 mm:3"
                                      << "string.bit skirt.length [mm]"
                                      << "50 60 70";
    QTest::newRow("share") << "string.3.loss=0 %,2 %"
                           << "string.3.loss [%]"
                           << "0 2";
    QTest::newRow("tenths") << "delta=0:1:11"
                            << "delta"
                            << "0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1";
    QTest::newRow("a tenth to a half") << "gamma=0.1:0.5:5"
                                       << "gamma"
                                       << "0.1 0.2 0.3 0.4 0.5";
    QTest::newRow("downwards") << "tau=3:1:3"
                               << "tau"
                               << "3 2 1";
    QTest::newRow("decades") << "beta=1e-3:1e3:7:log"
                             << "beta"
                             << "0.001 0.01 0.1 1 10 100 1000";
    QTest::newRow("one value") << "beta=2:2:1"
                               << "beta"
                               << "2";
    QTest::newRow("list as given") << "beta=3,1,2.5"
                                   << "beta"
                                   << "3 1 2.5";
    QTest::newRow("blanks around") << " beta = 1 , 2 "
                                   << "beta"
                                   << "1 2";
    QTest::newRow("millimetres") << "rod.diameter=32mm:38mm:4"
                                 << "rod.diameter [mm]"
                                 << "32 34 36 38";
    QTest::newRow("metres") << "rod.length=3 m:6 m:4"
                            << "rod.length [m]"
                            << "3 4 5 6";
    QTest::newRow("inches") << "rod.diameter=1in:2in:3"
                            << "rod.diameter [in]"
                            << "1 1.5 2";
    QTest::newRow("several units give SI") << "rod.length=3m,10ft"
                                           << "rod.length [m]"
                                           << "3 3.048";
    QTest::newRow("shapes") << "pulse.shape=half_sine,rectangular"
                            << "pulse.shape"
                            << "half_sine rectangular";
}

void TestSweepAxis::valuesAreThoseAPersonExpects() {
    QFETCH(QString, text);
    const ParsedAxis parsed = parseAxis(text.toStdString());
    QCOMPARE(QString::fromStdString(parsed.problem.text()), QString());
    QTEST(QString::fromStdString(parsed.axis.column().header), "header");
    QTEST(textsOf(parsed.axis), "values");
}

void TestSweepAxis::everyTextReadsBackAsItsValue_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"beta=0.01:100:97:log", "delta=0:1:53", "rod.length=0.9m:7.3m:61", "rod.diameter=32mm:45mm:47",
          "rod.diameter=1.1in:2.3in:59", "pulse.duration=100us:430us:83:log",
          "drill.blow_frequency=3000bpm:4321bpm:41", "bit_rock.stiffness=10MN/m:3e3MN/m:71:log"})
        QTest::newRow(text) << text;
}

// A cell must give `table` and --set exactly the case that the sweep solved.
void TestSweepAxis::everyTextReadsBackAsItsValue() {
    QFETCH(QString, text);
    const SweepAxis axis = parseAxis(text.toStdString()).axis;
    for (std::uint64_t i = 0; i < axis.count; ++i) {
        std::string cell;
        axis.column().appendText(cell, axis.value(i));
        const TypedQuantity read =
            parseQuantity(cell, axis.parameter->quantity, BareNumber::inDefaultUnit, axis.unit);
        QVERIFY2(read.valid(), cell.c_str());
        QCOMPARE(read.si, axis.value(i));
    }
}

void TestSweepAxis::theEndsAreExactlyAsGiven() {
    const SweepAxis axis = parseAxis("beta=0.1234567890123:9.876543210987:777:log").axis;
    QCOMPARE(axis.value(0), 0.1234567890123);
    QCOMPARE(axis.value(776), 9.876543210987);
}

void TestSweepAxis::logarithmicStepsHaveOneRatio() {
    const SweepAxis axis = parseAxis("beta=0.03:700:101:log").axis;
    const double ratio = std::pow(700 / 0.03, 0.01);
    for (std::uint64_t i = 1; i < axis.count; ++i)
        // The exponent of ten is rounded to 2 ulp, 4e-16·log(10)·3 decades.
        QVERIFY(std::abs(axis.value(i) / axis.value(i - 1) / ratio - 1) < 1e-14);
}

void TestSweepAxis::assigningSetsTheParameterInSi() {
    Scenario scenario;
    assign(scenario, "rod.diameter=32mm:38mm:4", 2);
    QCOMPARE(scenario.rod.diameter, 0.036);
    assign(scenario, "pulse.shape=half_sine,piston", 1);
    QCOMPARE(scenario.pulse.shape, PulseShape::piston);
}

void TestSweepAxis::aParameterWithoutMeaningIsLeftAlone() {
    Scenario scenario;
    const Scenario before = scenario;
    assign(scenario, "pulse.rise=0.1,0.4", 1);
    QCOMPARE(scenario, before);
}

void TestSweepAxis::extremesHoldTheSmallestAndLargestValue() {
    const SweepAxis list = parseAxis("beta=3,7,1,5").axis;
    QCOMPARE(list.extremes(), (std::vector<std::uint64_t>{2, 1}));
    const SweepAxis range = parseAxis("beta=1:2:9").axis;
    QCOMPARE(range.extremes(), (std::vector<std::uint64_t>{0, 8}));
    const SweepAxis shapes = parseAxis("pulse.shape=half_sine,piston,rectangular").axis;
    QCOMPARE(shapes.extremes(), (std::vector<std::uint64_t>{0, 1, 2}));
}

void TestSweepAxis::theCountMayBeLeftOutWhereOneIsAssumed() {
    QVERIFY(!parseAxis("beta=1:2").problem.isEmpty());
    for (const auto& [text, count, kind] : {std::tuple("beta=1:2", 101, SweepAxis::Kind::linear),
                                            std::tuple("beta=1:2:log", 101, SweepAxis::Kind::logarithmic),
                                            std::tuple("string.repeat=1:5", 5, SweepAxis::Kind::linear),
                                            std::tuple("string.repeat=9:1", 9, SweepAxis::Kind::linear),
                                            std::tuple("string.repeat=1:301", 101, SweepAxis::Kind::linear),
                                            std::tuple("string.repeat=1:104", 2, SweepAxis::Kind::linear),
                                            std::tuple("beta=1:2:7", 7, SweepAxis::Kind::linear),
                                            std::tuple("beta=1:2:7:log", 7, SweepAxis::Kind::logarithmic),
                                            std::tuple("beta=1,2,4", 3, SweepAxis::Kind::list)}) {
        const ParsedAxis parsed = parseAxis(text, 101);
        QCOMPARE(parsed.problem.text(), std::string());
        QCOMPARE(parsed.axis.count, std::uint64_t(count));
        QCOMPARE(parsed.axis.kind, kind);
    }
    QVERIFY(!parseAxis("beta=1", 101).axis.list.empty());
    QVERIFY(!parseAxis("beta=1:2:lgo", 101).problem.isEmpty());
    QVERIFY(!parseAxis("beta=0:2:log", 101).problem.isEmpty());
}

void TestSweepAxis::wrongTextIsRefusedWithTheReason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    QTest::addColumn<bool>("isValue");
    QTest::newRow("no equals sign") << "beta"
                                    << "is not an axis" << false;
    QTest::newRow("mistyped key") << "bit_rock.gama=1,2"
                                  << "did you mean `bit_rock.gamma`?" << false;
    QTest::newRow("between whole numbers") << "string.repeat=1:4:3"
                                           << "takes only whole numbers" << false;
    QTest::newRow("true and false") << "hammer.restrike=0,1"
                                    << "give it with --set" << false;
    QTest::newRow("half a repeat") << "string.repeat=1,2.5"
                                   << "must be a whole number" << true;
    QTest::newRow("mistyped number of a section") << "string.rod.lenght=1 m,2 m"
                                                  << "did you mean `string.rod.length`?" << false;
    QTest::newRow("no count") << "beta=1:2"
                              << "START:STOP:COUNT" << false;
    QTest::newRow("count of zero") << "beta=1:2:0"
                                   << "whole number from 1" << false;
    QTest::newRow("negative count") << "beta=1:2:-3"
                                    << "whole number from 1" << false;
    QTest::newRow("count beyond the limit") << "beta=1:2:1000000000001"
                                            << "whole number from 1" << false;
    QTest::newRow("count with a fraction") << "beta=1:2:2.5"
                                           << "whole number from 1" << false;
    QTest::newRow("unknown spacing") << "beta=1:2:3:lin"
                                     << "only `log`" << false;
    QTest::newRow("logarithm of zero") << "delta=0:1:3:log"
                                       << "above 0" << false;
    QTest::newRow("out of range") << "gamma=0.5:1.5:3"
                                  << "gamma = 1.5 (must be in (0, 1])" << true;
    QTest::newRow("no unit") << "rod.length=3:6:4"
                             << "has no unit" << true;
    QTest::newRow("wrong unit") << "rod.length=3kg,4kg"
                                << "allowed units: m, mm" << true;
    QTest::newRow("no number") << "beta=a,b"
                               << "is not a number" << true;
    QTest::newRow("not a number") << "beta=nan,1"
                                  << "must be a finite number" << true;
    QTest::newRow("empty item") << "beta=1,,2"
                                << "is empty" << true;
    QTest::newRow("unknown shape") << "pulse.shape=square"
                                   << "rectangular, triangular" << true;
}

void TestSweepAxis::wrongTextIsRefusedWithTheReason() {
    QFETCH(QString, text);
    QFETCH(QString, reason);
    QFETCH(bool, isValue);
    const ParsedAxis parsed = parseAxis(text.toStdString());
    QVERIFY2(QString::fromStdString(parsed.problem.text()).contains(reason), parsed.problem.text().c_str());
    QCOMPARE(parsed.kind == ParsedAxis::Kind::badValue, isValue);
}

QTEST_GUILESS_MAIN(TestSweepAxis)
#include "tst_sweep_axis.moc"

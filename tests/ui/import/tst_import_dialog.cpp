// SPDX-License-Identifier: GPL-3.0-or-later
// The import of measured signals: what is found out of a file, and what can be changed.
#include <QDir>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/model/scales.h"
#include "core/signal/signal_reading.h"
#include "tests/support/import_fixture.h"
#include "tests/ui/window/layout_check.h"
#include "ui/form/choice_box.h"
#include "ui/import/import_dialog.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr double modulus = 210e9;
constexpr double area = M_PI / 4 * 0.038 * 0.038;

}  // namespace

class TestImportDialog : public QObject, private ImportFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() { m_window.reset(); }
    void aGaugeRecordIsUnderstood();
    void theSignIsThatOverTheZeroLine_data();
    void theSignIsThatOverTheZeroLine();
    void aBlowFromStrainHasTheImpulseOfItsIntegral();
    void ofAForceWithNoiseTheBlowIsTaken();
    void theSameFileAsAMeasuredForceKeepsItsSign();
    void aPreviewFollowsTheUnitsChosen();
    void everyChoiceCanBeChanged();
    void unitsThatAreNotKnownAreToBeChosen();
    void thePlaceOfAGaugeIsAskedFor();
    void aSamplingRateOutOfSightDoesNotMatter();
    void theSecondGaugeCanBeChosenWithoutTimes();
    void anotherFirstLineKeepsWhatWasChosen();
    void aLongHeaderIsPassedOverAndALongerOneIsTold();
    void rangeIsProposedAgainAtTheRightRate();
    void rangeStaysOnceTheUserHasEditedIt();
    void voltsNeedACalibrationOrABridge();
    void qualityIsStatedBelowThePlot();
    void fieldFilesAreReadAsByCommand_data();
    void fieldFilesAreReadAsByCommand();
    void wrongInputsAreToldInPlace_data();
    void wrongInputsAreToldInPlace();
    void everythingCanBeReadAndReached_data();
    void everythingCanBeReadAndReached();
};

void TestImportDialog::aGaugeRecordIsUnderstood() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    QVERIFY(settle(dialog));
    QCOMPARE(message(dialog), QString());
    QCOMPARE(control<ChoiceBox>(dialog, "separator").currentText(), QStringLiteral("semicolon ;"));
    QCOMPARE(control<ChoiceBox>(dialog, "decimal").currentText(), QStringLiteral("comma 1,5"));
    QCOMPARE(control<QSpinBox>(dialog, "firstLine").value(), 4);
    QCOMPARE(control<ChoiceBox>(dialog, "timeColumn").currentText(), QStringLiteral("column 1: Zeit [ms]"));
    QCOMPARE(control<ChoiceBox>(dialog, "timeUnit").currentText(), QStringLiteral("ms"));
    QCOMPARE(control<ChoiceBox>(dialog, "valueColumn").currentText(),
             QStringLiteral("column 2: DMS 1 [µm/m]"));
    QCOMPARE(control<ChoiceBox>(dialog, "kind").currentText(), QStringLiteral("strain"));
    QCOMPARE(control<ChoiceBox>(dialog, "valueUnit").currentText(), QStringLiteral("microstrain"));
    QCOMPARE(control<ChoiceBox>(dialog, "positive").currentText(), QStringLiteral("tension"));
    QVERIFY(control<QPlainTextEdit>(dialog, "lines").toPlainText().contains(QStringLiteral(">   4  0,0000")));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QVERIFY(control<QPushButton>(dialog, "take").isEnabled());
}

void TestImportDialog::theSignIsThatOverTheZeroLine_data() {
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("peak");
    QTest::addColumn<QString>("positive");
    QTest::addRow("down from above") << 500.0 << -900.0 << "tension";
    QTest::addRow("down from far above") << 5000.0 << -900.0 << "tension";
    QTest::addRow("up from below") << -500.0 << 900.0 << "compression";
    QTest::addRow("up from zero") << 0.0 << 900.0 << "compression";
}

// A blow presses, whatever the gauge shows at rest.
void TestImportDialog::theSignIsThatOverTheZeroLine() {
    QFETCH(double, offset);
    QFETCH(double, peak);
    QFETCH(QString, positive);
    QByteArray bytes("t [us];gauge [µm/m]\n");
    for (int t = 0; t <= 1000; ++t) {
        const double pulse = t > 100 && t < 200 ? peak * std::sin(M_PI * (t - 100) / 100.0) : 0;
        bytes += QByteArray::number(t) + ';' + QByteArray::number(offset + pulse) + '\n';
    }
    ImportDialog& dialog = open(write("offset.csv", bytes), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(control<ChoiceBox>(dialog, "positive").currentText(), positive);
    const Rod& rod = m_window->document().scenario().rod;
    const double expected = 900e-6 * rod.youngsModulus * propertiesOf(rod).area;
    QVERIFY(std::abs(dialog.result()->peak / expected - 1) < 1e-3);
}

// E A ∫ε dt = E A · 1000 µε · 100 µs · 2/π; what is left of the noise after clipping and trimming at 2 % of
// the peak is less than 1e-3 of it.
void TestImportDialog::aBlowFromStrainHasTheImpulseOfItsIntegral() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    choose(dialog, "bar", QStringLiteral("another bar"));
    type(dialog, "diameter", QStringLiteral("38 mm"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    const double integral = modulus * area * 1e-3 * 100e-6 * 2 / M_PI;
    QVERIFY2(std::abs(dialog.result()->impulse / integral - 1) < 1e-3,
             qPrintable(QString::number(dialog.result()->impulse / integral, 'g', 9)));
    const QString summary = control<QLabel>(dialog, "summary").text();
    QVERIFY2(summary.contains(QStringLiteral("Impulse 15.2")) && summary.contains(QStringLiteral("samples")),
             qPrintable(summary));
    control<QPushButton>(dialog, "take").click();
    QVERIFY(std::abs(pulseImpulse(m_window->document().scenario()) / integral - 1) < 1e-3);
}

// The length of the table is the t0 of the blow, which the rest before and after it would stretch.
void TestImportDialog::ofAForceWithNoiseTheBlowIsTaken() {
    QByteArray noisy("t [us];F [kN]\n"), clean(noisy);
    for (int t = 0; t <= 1000; ++t) {
        const double force = t > 300 && t < 500 ? 255 : 0;
        noisy += QByteArray::number(t) + ';' + QByteArray::number(force + std::sin(1000.0 * t)) + '\n';
        clean += QByteArray::number(t) + ';' + QByteArray::number(force) + '\n';
    }
    ImportDialog& dialog = open(write("noisy.csv", noisy), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QVERIFY(std::abs(dialog.result()->start - 300e-6) < 2e-6);
    QVERIFY(std::abs(dialog.result()->points.back().time - 200e-6) < 4e-6);
    control<QPushButton>(dialog, "take").click();
    // A signal that never goes below zero may be a computed blow, and is taken whole.
    ImportDialog& other = open(write("clean.csv", clean), ImportUse::blow);
    QVERIFY(settle(other));
    QVERIFY2(other.result() != nullptr, qPrintable(message(other)));
    QCOMPARE(other.result()->points.back().time, 1e-3);
}

// The preview has the units of the window, before and while the dialog is open, in the plot as in the words.
void TestImportDialog::aPreviewFollowsTheUnitsChosen() {
    UnitChoice& units = m_window->document().units();
    units.choose(UnitKind::force, findUnit(Quantity::force, "lbf"));
    ImportDialog& dialog = open(write("blow.csv", "t [us];F [kN]\n0;0\n100;50\n200;0\n"), ImportUse::blow);
    QVERIFY(settle(dialog));
    const auto& plot = *dialog.findChild<PlotWidget*>();
    const auto& summary = control<QLabel>(dialog, "summary");
    QVERIFY2(plot.yAxis->label().contains(QStringLiteral("[lbf]")), qPrintable(plot.yAxis->label()));
    QVERIFY2(summary.text().contains(QStringLiteral("lbf at")), qPrintable(summary.text()));
    units.choose(UnitKind::force, nullptr);
    QVERIFY2(plot.yAxis->label().contains(QStringLiteral("[kN]")), qPrintable(plot.yAxis->label()));
    QVERIFY2(summary.text().contains(QStringLiteral("kN at")), qPrintable(summary.text()));
}

void TestImportDialog::theSameFileAsAMeasuredForceKeepsItsSign() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    choose(dialog, "valueColumn", QStringLiteral("DMS 2"));
    type(dialog, "place", QStringLiteral("1.5 m"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QVERIFY(dialog.result()->peak < 0);
    QVERIFY(std::abs(dialog.result()->peakTime - 300e-6) < 2e-6);
    QVERIFY(std::abs(dialog.result()->zero + 3) < 0.5);
    QCOMPARE(dialog.measured().place, 1.5);
    QCOMPARE(dialog.measured().name, std::string("record"));
    QCOMPARE(dialog.measured().quantity, MeasuredQuantity::normalForce);
}

void TestImportDialog::everyChoiceCanBeChanged() {
    const QByteArray bytes("0.5\n1.5\nNaN\n3.5\n-1.5\n");
    ImportDialog& dialog = open(write("plain.txt", bytes), ImportUse::impactForce);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("sampling rate: not given in the table")),
             qPrintable(message(dialog)));
    type(dialog, "rate", QStringLiteral("2 Hz"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("no known unit")), qPrintable(message(dialog)));
    choose(dialog, "valueUnit", QStringLiteral("kN"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("line 3")), qPrintable(message(dialog)));
    choose(dialog, "wrongRows", QStringLiteral("skip"));
    choose(dialog, "zero", QStringLiteral("a value"));
    type(dialog, "zeroValue", QStringLiteral("0.5"));
    choose(dialog, "positive", QStringLiteral("compression"));
    type(dialog, "from", QStringLiteral("0.5 s"));
    type(dialog, "to", QStringLiteral("1.5 s"));
    choose(dialog, "scaling", QStringLiteral("by a factor"));
    type(dialog, "factor", QStringLiteral("-2"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->points, (TablePoints{{0.5, -2000}, {1.5, -6000}}));
    QVERIFY(control<QLabel>(dialog, "summary").text().contains(QStringLiteral("1 rows without a number")));
    choose(dialog, "kind", QStringLiteral("bridge"));
    choose(dialog, "valueUnit", QStringLiteral("mV/V"));
    choose(dialog, "bar", QStringLiteral("another bar"));
    type(dialog, "diameter", QStringLiteral("38 mm"));
    type(dialog, "gaugeFactor", QStringLiteral("2.1"));
    type(dialog, "bridgeFactor", QStringLiteral("4"));
    choose(dialog, "scaling", QStringLiteral("as it is"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    // 1 mV/V of a full bridge with k = 2.1.
    const double expected = modulus * area * 1e-3 / 2.1;
    QVERIFY(std::abs(dialog.result()->points.front().force / expected - 1) < 1e-12);
    // And with commas and columns of its own, whatever they give.
    choose(dialog, "separator", QStringLiteral("tab"));
    choose(dialog, "decimal", QStringLiteral("comma"));
    QVERIFY(settle(dialog));
    QVERIFY(!dialog.result());
    QVERIFY(!message(dialog).isEmpty());
}

void TestImportDialog::unitsThatAreNotKnownAreToBeChosen() {
    const QByteArray bytes("Time [ticks];Load [counts]\n0;1\n1;2\n2;0\n");
    ImportDialog& dialog = open(write("units.csv", bytes), ImportUse::impactForce);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("ticks is not known")), qPrintable(message(dialog)));
    choose(dialog, "timeUnit", QStringLiteral("ms"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("header has no known unit")),
             qPrintable(message(dialog)));
    QVERIFY(!dialog.result());
    choose(dialog, "kind", QStringLiteral("strain"));
    QVERIFY(settle(dialog));
    QVERIFY(!dialog.result());
    choose(dialog, "kind", QStringLiteral("force"));
    choose(dialog, "valueUnit", QStringLiteral("kN"));
    choose(dialog, "positive", QStringLiteral("compression"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->points, (TablePoints{{0, 1000}, {1e-3, 2000}, {2e-3, 0}}));
}

/// One that nobody has given would be compared with the waves of another section.
void TestImportDialog::thePlaceOfAGaugeIsAskedFor() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).startsWith(QStringLiteral("place x: not given")), qPrintable(message(dialog)));
    QVERIFY(!control<QPushButton>(dialog, "take").isEnabled());
    type(dialog, "place", QStringLiteral("0 m"));
    QVERIFY(settle(dialog));
    QVERIFY(control<QPushButton>(dialog, "take").isEnabled());
    QCOMPARE(dialog.measured().place, 0.0);
}

void TestImportDialog::aSamplingRateOutOfSightDoesNotMatter() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    type(dialog, "place", QStringLiteral("1 m"));
    choose(dialog, "timeColumn", QStringLiteral("evenly"));
    type(dialog, "rate", QStringLiteral("-5 kHz"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("sampling rate")), qPrintable(message(dialog)));
    choose(dialog, "timeColumn", QStringLiteral("Zeit"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
}

void TestImportDialog::theSecondGaugeCanBeChosenWithoutTimes() {
    ImportDialog& dialog = open(write("two.csv", "a [kN];b [kN]\n1;3\n2;4\n3;5\n"), ImportUse::impactForce);
    const auto& second = control<ChoiceBox>(dialog, "secondGauge");
    // Two columns of forces have no times.
    type(dialog, "rate", QStringLiteral("1 kHz"));
    QVERIFY(second.isVisible());
    choose(dialog, "valueColumn", QStringLiteral("column 1"));
    choose(dialog, "secondGauge", QStringLiteral("column 2"));
    choose(dialog, "positive", QStringLiteral("compression"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->points.front().force, 2000.0);
    // Out of sight it is not taken.
    choose(dialog, "valueColumn", QStringLiteral("column 2"));
    choose(dialog, "timeColumn", QStringLiteral("column 1"));
    choose(dialog, "timeUnit", QStringLiteral("ms"));
    QVERIFY(settle(dialog));
    QVERIFY(!second.isVisible());
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->points.front().force, 3000.0);
}

void TestImportDialog::anotherFirstLineKeepsWhatWasChosen() {
    const QByteArray bytes("a;b;c\n0;0.5;5\n1;2;6\n2;3;7\n3;4;8\n");
    ImportDialog& dialog = open(write("chosen.csv", bytes), ImportUse::impactForce);
    choose(dialog, "timeColumn", QStringLiteral("column 1"));
    choose(dialog, "valueColumn", QStringLiteral("column 3"));
    choose(dialog, "secondGauge", QStringLiteral("column 2"));
    choose(dialog, "timeUnit", QStringLiteral("ms"));
    choose(dialog, "valueUnit", QStringLiteral("kN"));
    choose(dialog, "positive", QStringLiteral("compression"));
    control<QSpinBox>(dialog, "firstLine").setValue(3);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->points, (TablePoints{{1e-3, 4000}, {2e-3, 5000}, {3e-3, 6000}}));
    // Other columns are detected again.
    choose(dialog, "separator", QStringLiteral("tab"));
    choose(dialog, "separator", QStringLiteral("semicolon"));
    QVERIFY(settle(dialog));
    QCOMPARE(control<ChoiceBox>(dialog, "valueColumn").currentText(), QStringLiteral("column 2: b"));
}

void TestImportDialog::aLongHeaderIsPassedOverAndALongerOneIsTold() {
    const QByteArray header = QByteArray("a setting of the recorder\n").repeated(1500);
    const QByteArray table("t [us];F [kN]\n0;0\n100;50\n200;0\n");
    ImportDialog& dialog = open(write("long.csv", header + table), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(control<QSpinBox>(dialog, "firstLine").value(), 1502);
    ImportDialog& longer = open(write("longer.csv", header + header + table), ImportUse::blow);
    QVERIFY(settle(longer));
    QVERIFY2(message(longer).contains(QStringLiteral("in the first 2000 lines")),
             qPrintable(message(longer)));
    QCOMPARE(control<QSpinBox>(longer, "firstLine").maximum(), 2000);
}

namespace {

/// A half sine of 250 kN and 200 us from 150 us on, 5 MHz, with ripple.
QByteArray evenRecord(const QByteArray& header) {
    QByteArray bytes = header;
    for (int i = 0; i < 5000; ++i) {
        const double t = i * 0.2;
        const double force = t > 150 && t < 350 ? 250 * std::sin(M_PI * (t - 150) / 200) : 0;
        bytes += QByteArray::number(force + 0.3 * std::sin(1.0 * i), 'f', 3) + '\n';
    }
    return bytes;
}

}  // namespace

// Noise became the blow after the rate was put right: the range of the wrong rate stayed.
void TestImportDialog::rangeIsProposedAgainAtTheRightRate() {
    ImportDialog& dialog = open(write("even.csv", evenRecord("F [kN]\n")), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY(!control<QPushButton>(dialog, "take").isEnabled());
    for (const auto& [rate, start] : {std::pair{"1 MHz", 750e-6}, std::pair{"5 MHz", 150e-6}}) {
        type(dialog, "rate",
             QString::fromLatin1(rate).replace(QStringLiteral(" MHz"), QStringLiteral("000 kHz")));
        QVERIFY(settle(dialog));
        QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
        QVERIFY2(std::abs(dialog.result()->start / start - 1) < 0.03,
                 qPrintable(QString::number(dialog.result()->start)));
    }
    QVERIFY(std::abs(dialog.result()->impulse / (250e3 * 200e-6 * 2 / M_PI) - 1) < 2e-3);
}

void TestImportDialog::rangeStaysOnceTheUserHasEditedIt() {
    ImportDialog& dialog =
        open(write("even.csv", evenRecord("# sampling rate: 5 MHz\nF [kN]\n")), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    type(dialog, "from", QStringLiteral("200 us"));
    choose(dialog, "wrongRows", QStringLiteral("skip"));
    QVERIFY(settle(dialog));
    // To one sample.
    QVERIFY(std::abs(dialog.result()->start - 200e-6) < 0.3e-6);
}

void TestImportDialog::voltsNeedACalibrationOrABridge() {
    ImportDialog& dialog =
        open(write("volts.csv", "Time/s,bar/voltage\n0,0\n0.0001,2\n0.0002,0\n"), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("Volts are no forces")), qPrintable(message(dialog)));
    type(dialog, "forcePerVolt", QStringLiteral("100 kN"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->peak, 200e3);
}

void TestImportDialog::qualityIsStatedBelowThePlot() {
    QByteArray bytes("t [us];F [kN]\n");
    for (int t = 0; t <= 1000; ++t) {
        const double force = t > 300 && t < 500 ? 250 * std::sin(M_PI * (t - 300) / 200.0) : 0;
        const double noise = 0.5 * std::sin(7.3 * t * t);
        bytes += QByteArray::number(t) + ';' + QByteArray::number(std::min(180.0, force + noise)) + '\n';
    }
    ImportDialog& dialog = open(write("flat.csv", bytes), ImportUse::blow);
    QVERIFY(settle(dialog));
    const QString summary = control<QLabel>(dialog, "summary").text();
    QVERIFY2(summary.contains(QStringLiteral("equal samples at the largest value, 180: clipped?")),
             qPrintable(summary));
}

void TestImportDialog::fieldFilesAreReadAsByCommand_data() {
    QTest::addColumn<QString>("path");
    const QDir folder(QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/field"));
    const QStringList files = folder.entryList({QStringLiteral("*.csv")});
    QVERIFY(files.size() > 20);
    for (const QString& file : files)
        if (!file.contains(QStringLiteral("_table_")))  // of scenarios, not of samples
            QTest::addRow("%s", qPrintable(file)) << folder.filePath(file);
}

/// The dialog takes what the command takes without options, with the same impulse, and nothing else, but that
/// it shows which column it takes and has the bar of the scenario, and that channels in rows are read by the
/// command only, which its message names.
void TestImportDialog::fieldFilesAreReadAsByCommand() {
    QFETCH(QString, path);
    std::ifstream in(path.toStdString(), std::ios::binary);
    const SignalReading reading = readSignal(in, {});
    const bool isAnswered = std::ranges::all_of(reading.questions, [](const std::string& question) {
        return question == "column" || question == "area" || question == "modulus";
    });
    const bool isRead = reading.problem.isEmpty() && isAnswered && !reading.table.hasRows;
    ImportDialog& dialog = open(path, ImportUse::blow);
    settle(dialog);
    QCOMPARE(control<QPushButton>(dialog, "take").isEnabled(), isRead);
    if (!isRead) {
        QVERIFY(!message(dialog).isEmpty());
        QVERIFY(!reading.table.hasRows || message(dialog).contains(QStringLiteral("drillwave signal")));
        return;
    }
    if (reading.isOpen()) return;
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QVERIFY2(
        std::abs(dialog.result()->impulse / reading.blow.impulse - 1) < 1e-3,
        qPrintable(
            QStringLiteral("%1, by command %2").arg(dialog.result()->impulse).arg(reading.blow.impulse)));
}

void TestImportDialog::wrongInputsAreToldInPlace_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    QTest::newRow("word") << QByteArray("t [s],F [N]\n0,1\n1,2\n2,x\n")
                          << "line 4: column 2: `x` is not a number";
    QTest::newRow("time goes back") << QByteArray("t [s],F [N]\n0,1\n1,2\n0.5,1\n")
                                    << "line 4: the time 500 ms";
    QTest::newRow("nothing") << QByteArray() << "is empty";
    QTest::newRow("junk from the beginning") << QByteArray("\1\2\0\3", 4) << "no text";
    QTest::newRow("prose") << QByteArray("a letter\nto nobody\n") << "No line of numbers";
    QTest::newRow("no blow") << QByteArray("t [s],F [N]\n0,0\n1,0\n2,0\n") << "no force is greater than 0";
    QTest::newRow("junk") << QByteArray("t [s],F [N]\n1,2\n2,3\n3,4\n\0\0\1\2\n", 29)
                          << "line 5: holds a NUL byte";
}

void TestImportDialog::wrongInputsAreToldInPlace() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, words);
    ImportDialog& dialog = open(write("wrong.csv", bytes), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(words), qPrintable(message(dialog)));
    QVERIFY(!dialog.result());
    QVERIFY(!control<QPushButton>(dialog, "take").isEnabled());
    QVERIFY(m_answers.told.isEmpty());
}

void TestImportDialog::everythingCanBeReadAndReached_data() {
    QTest::addColumn<ImportUse>("use");
    QTest::addColumn<int>("points");
    for (const int points : {9, 16}) {
        QTest::addRow("blow, %d pt", points) << ImportUse::blow << points;
        QTest::addRow("normal force, %d pt", points) << ImportUse::normalForce << points;
    }
}

void TestImportDialog::everythingCanBeReadAndReached() {
    QFETCH(ImportUse, use);
    QFETCH(int, points);
    const QFont usual = QApplication::font();
    QFont font = usual;
    font.setPointSize(points);
    QApplication::setFont(font);
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), use);
    choose(dialog, "kind", QStringLiteral("bridge"));
    choose(dialog, "scaling", QStringLiteral("to an impulse"));
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    QVERIFY(settle(dialog));
    const QStringList problems =
        clippedTexts(dialog) + overlaps(dialog) + namelessControls(dialog) + faintTexts(dialog);
    QApplication::setFont(usual);
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(QLatin1Char('\n'))));
    QVERIFY(dialog.width() <= (points == 9 ? 1000 : 1400) && dialog.height() <= (points == 9 ? 680 : 1000));
}

QTEST_MAIN(TestImportDialog)
#include "tst_import_dialog.moc"

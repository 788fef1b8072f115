// SPDX-License-Identifier: GPL-3.0-or-later
// The import of measured signals: what is found out, what can be changed, what is taken.
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/file/examples.h"
#include "core/model/scales.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "tests/ui/window/layout_check.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/import/import_dialog.h"
#include "ui/import/importer.h"
#include "ui/job/solve_job.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/blow/measured_curves.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/settings.h"
#include "ui/text/unit_choice.h"
#include "ui/window/file_menu.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr double modulus = 210e9;
constexpr double area = M_PI / 4 * 0.038 * 0.038;

/// Two gauges, zero at 12 and −3 µε, noise of ±2: a half sine of 100 µs and −1000 µε at the first, half of it
/// later at the second; semicolons, decimal commas, ms.
QByteArray gaugeRecord() {
    QString text = QStringLiteral("Recorder 7\nZeit;DMS 1;DMS 2\nms;µm/m;µm/m\n");
    const auto pulse = [](double t) { return t > 0 && t < 100 ? -1000 * std::sin(M_PI * t / 100) : 0; };
    for (int i = 0; i <= 4000; ++i) {
        const double t = 0.1 * i;
        const double noise = 2 * std::sin(1000.0 * i);
        const QString row = QStringLiteral("%1;%2;%3\n")
                                .arg(t / 1000, 0, 'f', 4)
                                .arg(pulse(t - 50) + 12 + noise, 0, 'f', 2)
                                .arg(pulse(t - 250) / 2 - 3 - noise, 0, 'f', 2);
        text += QString(row).replace(QLatin1Char('.'), QLatin1Char(','));
    }
    return text.toUtf8();
}

template <class Control>
Control& control(const QWidget& dialog, const char* name) {
    auto* found = dialog.findChild<Control*>(QLatin1String(name));
    if (!found) qFatal("the dialog has no %s", name);
    return *found;
}

void choose(const QWidget& dialog, const char* name, const QString& text) {
    auto& box = control<ChoiceBox>(dialog, name);
    const int index = box.findText(text, Qt::MatchContains);
    if (index < 0) qFatal("%s has no such entry", name);
    box.setCurrentIndex(index);
}

void type(const QWidget& dialog, const char* name, const QString& text) {
    auto& field = control<QuantityField>(dialog, name);
    auto* edit = field.findChild<QLineEdit*>();
    edit->selectAll();
    QTest::keyClicks(edit, text);
}

}  // namespace

class TestImportDialog : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aGaugeRecordIsUnderstood();
    void theSignIsThatOverTheZeroLine_data();
    void theSignIsThatOverTheZeroLine();
    void aBlowFromStrainHasTheImpulseOfItsIntegral();
    void theSameFileAsAMeasuredForceKeepsItsSign();
    void everyChoiceCanBeChanged();
    void unitsThatAreNotKnownAreToBeChosen();
    void aSamplingRateOutOfSightDoesNotMatter();
    void theSecondGaugeCanBeChosenWithoutTimes();
    void anotherFirstLineKeepsWhatWasChosen();
    void aLongHeaderIsPassedOverAndALongerOneIsTold();
    void wrongInputsAreToldInPlace_data();
    void wrongInputsAreToldInPlace();
    void theBlowIsOneUndoStepAndIsKeptInTheFile();
    void aBlowOfAllThePointsThereMayBeFitsItsFile();
    void withoutPhysicalUnitsOnlyTheShapeIsTaken();
    void aPlaceBeyondTheRodIsRefused();
    void aBlowThatTheScenarioRefusesStaysInTheDialog();
    void theDialogFollowsTheRod();
    void theWindowMayCloseWhileTheDialogIsOpen();
    void aDroppedTableOpensTheDialog();
    void aDroppedCsvThatIsNoBlowOpensTheDialog();
    void aMeasuredForceLiesOnTheComputedOneOfTheSameBlow_data();
    void aMeasuredForceLiesOnTheComputedOneOfTheSameBlow();
    void anExportedCurveIsReadBack();
    void measuredCurvesAreShiftedAndRemoved();
    void theMeasuredRowFollowsTheUnits();
    void everythingCanBeReadAndReached_data();
    void everythingCanBeReadAndReached();

  private:
    QString write(const QString& name, const QByteArray& bytes);
    ImportDialog& open(const QString& path, ImportUse use);
    static bool settle(ImportDialog& dialog);
    QString message(const ImportDialog& dialog) const { return control<QLabel>(dialog, "message").text(); }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestImportDialog::initTestCase() {
    keepSettingsIn(m_folder.path());
}

void TestImportDialog::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_answers = {};
    m_window = newWindow(m_answers);
    m_window->show();
}

void TestImportDialog::cleanup() {
    m_window.reset();
}

QString TestImportDialog::write(const QString& name, const QByteArray& bytes) {
    QFile file(m_folder.filePath(name));
    if (file.open(QIODevice::WriteOnly)) file.write(bytes);
    return file.fileName();
}

// As from the menu, or the button of the section of the blow.
ImportDialog& TestImportDialog::open(const QString& path, ImportUse use) {
    m_answers.import = path;
    if (use == ImportUse::blow) {
        m_window->findChild<QPushButton*>(QStringLiteral("importBlow"))->click();
    } else {
        for (QAction* action : m_window->findChildren<QAction*>())
            if (action->text() == QStringLiteral("&Import…")) action->trigger();
    }
    auto* dialog = m_window->findChild<ImportDialog*>();
    if (!dialog) qFatal("no dialog");
    if (dialog->use() != use) {
        auto& box = control<ChoiceBox>(*dialog, "use");
        box.setCurrentIndex(box.findData(static_cast<int>(use)));
    }
    return *dialog;
}

bool TestImportDialog::settle(ImportDialog& dialog) {
    // What one answer proposes is asked anew.
    return QTest::qWaitFor(
        [&dialog] {
            if (dialog.isBusy()) return false;
            QCoreApplication::processEvents();
            return !dialog.isBusy();
        },
        60000);
}

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
    QVERIFY2(message(dialog).contains(QStringLiteral("line 3")), qPrintable(message(dialog)));
    choose(dialog, "wrongRows", QStringLiteral("skip"));
    type(dialog, "rate", QStringLiteral("2 Hz"));
    choose(dialog, "valueUnit", QStringLiteral("kN"));
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
    choose(dialog, "bar", QStringLiteral("another bar"));
    type(dialog, "diameter", QStringLiteral("38 mm"));
    type(dialog, "gaugeFactor", QStringLiteral("2.1"));
    choose(dialog, "activeGauges", QStringLiteral("4"));
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
    const QByteArray bytes("Time [ticks];Load [tf]\n0;1\n1;2\n2;0\n");
    ImportDialog& dialog = open(write("units.csv", bytes), ImportUse::impactForce);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("ticks is not known")), qPrintable(message(dialog)));
    choose(dialog, "timeUnit", QStringLiteral("ms"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("unit in the header is not known")),
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

void TestImportDialog::aSamplingRateOutOfSightDoesNotMatter() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
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
    QVERIFY(!second.isVisible());
    choose(dialog, "timeColumn", QStringLiteral("evenly"));
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
    const QByteArray bytes("a;b;c\n0;1;5\n1;2;6\n2;3;7\n3;4;8\n");
    ImportDialog& dialog = open(write("chosen.csv", bytes), ImportUse::impactForce);
    choose(dialog, "valueColumn", QStringLiteral("column 3"));
    choose(dialog, "secondGauge", QStringLiteral("column 2"));
    choose(dialog, "timeUnit", QStringLiteral("ms"));
    choose(dialog, "valueUnit", QStringLiteral("kN"));
    choose(dialog, "positive", QStringLiteral("compression"));
    control<QSpinBox>(dialog, "firstLine").setValue(3);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QCOMPARE(dialog.result()->points, (TablePoints{{1e-3, 4000}, {2e-3, 5000}, {3e-3, 6000}}));
    // Other columns are found out anew.
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

void TestImportDialog::wrongInputsAreToldInPlace_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    QTest::newRow("word") << QByteArray("t [s],F [N]\n0,1\n1,2\n2,x\n")
                          << "line 4: column 2: `x` is not a number";
    QTest::newRow("time goes back") << QByteArray("t [s],F [N]\n0,1\n1,2\n0.5,1\n")
                                    << "line 4: the time 0.5 s";
    QTest::newRow("nothing") << QByteArray() << "No line of numbers";
    QTest::newRow("prose") << QByteArray("a letter\nto nobody\n") << "No line of numbers";
    QTest::newRow("no blow") << QByteArray("t [s],F [N]\n0,0\n1,0\n2,0\n") << "no force is greater than 0";
    QTest::newRow("junk") << QByteArray("1,2\n2,3\n3,4\n\0\0\1\2\n", 17) << "line 4: holds a NUL byte";
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

void TestImportDialog::theBlowIsOneUndoStepAndIsKeptInTheFile() {
    Document& document = m_window->document();
    const QByteArray before = document.text();
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    QVERIFY(settle(dialog));
    control<QPushButton>(dialog, "take").click();
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("take the hammer blow from record.csv"));
    QVERIFY(document.scenario().pulse.shape == PulseShape::table);
    const TablePoints points = document.scenario().pulse.tablePoints;
    QVERIFY(points.size() > 10 && points.size() <= 1000);
    // The file reads back as the same blow, digit by digit.
    const std::string text = document.text().toStdString();
    QCOMPARE(parseScenario(text, "x.yaml").scenario.pulse.tablePoints, points);
    document.undoStack().undo();
    QCOMPARE(document.text(), before);
}

// Noise, of which no point can be left out.
void TestImportDialog::aBlowOfAllThePointsThereMayBeFitsItsFile() {
    QByteArray bytes("t [us],F [kN]\n");
    for (int i = 0; i < 30000; ++i)
        bytes += QByteArray::number(0.0137 * i) + ',' + QByteArray::number(100 + 50 * std::sin(1e4 * i * i)) +
                 '\n';
    ImportDialog& dialog = open(write("noise.csv", bytes), ImportUse::blow);
    control<QSpinBox>(dialog, "points").setValue(1'000'000);
    QCOMPARE(control<QSpinBox>(dialog, "points").value(), 10'000);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    QVERIFY(dialog.result()->points.size() > 5000);
    control<QPushButton>(dialog, "take").click();
    const QByteArray text = m_window->document().text();
    QCOMPARE(parseScenario(text.toStdString(), "x.yaml").scenario.pulse.tablePoints,
             m_window->document().scenario().pulse.tablePoints);
}

void TestImportDialog::withoutPhysicalUnitsOnlyTheShapeIsTaken() {
    const QString path = write("blow.csv", "t [us];F [kN]\n0;0\n100;50\n200;0\n");
    const QString words = QStringLiteral("Only the shape is taken");
    ImportDialog& dialog = open(path, ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY(dialog.result() != nullptr);
    QVERIFY(!control<QLabel>(dialog, "summary").text().contains(words));
    m_window->document().startFrom(findExample("paper_fig4b")->text, QStringLiteral("paper"));
    QVERIFY(settle(dialog));
    QVERIFY(control<QLabel>(dialog, "summary").text().contains(words));
    auto& use = control<ChoiceBox>(dialog, "use");
    use.setCurrentIndex(use.findData(static_cast<int>(ImportUse::impactForce)));
    QVERIFY(settle(dialog));
    QVERIFY(!control<QLabel>(dialog, "summary").text().contains(words));
}

void TestImportDialog::aPlaceBeyondTheRodIsRefused() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    type(dialog, "place", QStringLiteral("3.7 m"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("at most 3.66")), qPrintable(message(dialog)));
    QVERIFY(!control<QPushButton>(dialog, "take").isEnabled());
    type(dialog, "place", QStringLiteral("3.6 m"));
    QVERIFY(settle(dialog));
    QVERIFY(control<QPushButton>(dialog, "take").isEnabled());
}

void TestImportDialog::aBlowThatTheScenarioRefusesStaysInTheDialog() {
    // A blow of 1e-30 s asks for more than any solver can place.
    const QByteArray bytes("t [s],F [N]\n0,0\n1e-30,1\n2e-30,0\n");
    ImportDialog& dialog = open(write("short.csv", bytes), ImportUse::blow);
    QVERIFY(settle(dialog));
    if (dialog.result()) control<QPushButton>(dialog, "take").click();
    QVERIFY(!message(dialog).isEmpty());
    QVERIFY(dialog.isVisible());
    QVERIFY(!m_window->document().isModified());
}

void TestImportDialog::theDialogFollowsTheRod() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    QVERIFY(settle(dialog));
    const double before = dialog.result()->peak;
    Document& document = m_window->document();
    const Parameter* stiffness = findParameter("rod.youngs_modulus");
    document.assign(*stiffness, 2 * document.scenario().rod.youngsModulus, document.newGesture());
    QVERIFY(settle(dialog));
    QVERIFY(std::abs(dialog.result()->peak / before - 2) < 1e-6);
}

void TestImportDialog::theWindowMayCloseWhileTheDialogIsOpen() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    type(dialog, "from", QStringLiteral("50 us"));
    m_window.reset();
    QVERIFY(true);
}

void TestImportDialog::aDroppedTableOpensTheDialog() {
    part<FileMenu>(*m_window).take({write("record.txt", gaugeRecord())});
    auto* dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog && settle(*dialog));
    QVERIFY(dialog->result() != nullptr);
    // Another one takes its place.
    part<FileMenu>(*m_window).take({write("other.txt", gaugeRecord())});
    QCOMPARE(m_window->findChildren<ImportDialog*>().size(), 1);
    QVERIFY(m_window->findChild<ImportDialog*>()->windowTitle().contains(QStringLiteral("other.txt")));
    QPushButton* help =
        m_window->findChild<ImportDialog*>()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Help);
    QCOMPARE(help->shortcut(), QKeySequence(Qt::Key_F1));
    help->click();
    QVERIFY(m_answers.told.value(0).contains(QStringLiteral("Zero line")));
}

void TestImportDialog::aDroppedCsvThatIsNoBlowOpensTheDialog() {
    part<FileMenu>(*m_window).take({write("record.csv", gaugeRecord())});
    auto* dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog && settle(*dialog));
    QVERIFY2(dialog->result() != nullptr, qPrintable(message(*dialog)));
    QVERIFY(m_answers.told.isEmpty());
    QVERIFY(!m_window->document().isModified());
}

void TestImportDialog::aMeasuredForceLiesOnTheComputedOneOfTheSameBlow_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<bool>("atBit");
    QTest::addRow("N, 50 points") << 50 << false;
    QTest::addRow("N, 1000 points") << 1000 << false;
    QTest::addRow("F, 200 points") << 200 << true;
}

// N(t) of the example at mid-rod, or its impact force, written as a recorder would, comes back through the
// dialog, and its curve on the page is no further from the computed one than the dialog has said.
void TestImportDialog::aMeasuredForceLiesOnTheComputedOneOfTheSameBlow() {
    QFETCH(int, points);
    QFETCH(bool, atBit);
    const SolvedBlowPtr blow = m_window->shown();
    const WaveField field(blow->impact);
    const Scales scales = scalesOf(blow->request.scenario);
    QByteArray bytes("t [us];force [kN]\n");
    constexpr int samples = 20000;
    for (int i = 0; i <= samples; ++i) {
        const double t = 15.0 * i / samples;
        const double force = atBit ? field.impactForce(t) : field.force(0.5, t);
        bytes += QByteArray::number(1e6 * t * scales.time, 'g', 17) + ';' +
                 QByteArray::number(1e-3 * force * scales.force, 'g', 17) + '\n';
    }
    ImportDialog& dialog =
        open(write("computed.csv", bytes), atBit ? ImportUse::impactForce : ImportUse::normalForce);
    control<QSpinBox>(dialog, "points").setValue(points);
    if (!atBit) type(dialog, "place", QString::number(blow->request.scenario.rod.length / 2) + " m");
    if (atBit) choose(dialog, "positive", QStringLiteral("compression"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    const double deviation = dialog.result()->deviation;
    control<QPushButton>(dialog, "take").click();
    auto* page = m_window->findChild<BlowPage*>();
    QCOMPARE(page->measuredCurves()->graphs().size(), 1);
    const QCPGraph* graph = page->measuredCurves()->graphs().first();
    QVERIFY(graph->data()->size() <= points);
    // Moved away it is put back where it fits.
    type(*page, "measuredShift", QStringLiteral("130 us"));
    page->findChild<QPushButton*>(QStringLiteral("alignMeasured"))->click();
    const std::optional<double> shift =
        page->findChild<QuantityField*>(QStringLiteral("measuredShift"))->value();
    QVERIFY2(std::abs(*shift) < 2e-6, qPrintable(QString::number(*shift)));
    type(*page, "measuredShift", QStringLiteral("0"));
    const ShownUnits& units = blow->units;
    double largest = 0;
    auto next = graph->data()->constBegin();
    for (int i = 0; i <= samples; ++i) {
        const double t = 15.0 * i / samples;
        const double shownTime = t * units.time.factor;
        while (next + 1 != graph->data()->constEnd() && (next + 1)->key < shownTime) ++next;
        if (next + 1 == graph->data()->constEnd()) break;
        const auto &a = *next, &b = *(next + 1);
        const double line = a.value + (b.value - a.value) * (shownTime - a.key) / (b.key - a.key);
        const double force = atBit ? field.impactForce(t) : field.force(0.5, t);
        largest = std::max(largest, std::abs(line / units.force.factor - force) * scales.force);
    }
    // Beside it nothing but the rounding of times where the force jumps.
    QVERIFY2(largest <= deviation * (1 + 1e-6) + 1e-3,
             qPrintable(QStringLiteral("%1 N, said %2 N").arg(largest).arg(deviation)));
    QVERIFY(deviation > 0);
}

// The data of the page, exported and imported again: jumps, blank cells and other columns included.
void TestImportDialog::anExportedCurveIsReadBack() {
    auto* page = m_window->findChild<BlowPage*>();
    ImportDialog& dialog = open(write("exported.csv", page->plot()->csv()), ImportUse::impactForce);
    choose(dialog, "valueColumn", QStringLiteral("impact force"));
    auto& time = control<ChoiceBox>(dialog, "timeColumn");
    time.setCurrentIndex(control<ChoiceBox>(dialog, "valueColumn").currentIndex() - 1);
    choose(dialog, "wrongRows", QStringLiteral("skip"));
    choose(dialog, "positive", QStringLiteral("compression"));
    control<QSpinBox>(dialog, "points").setValue(100'000);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    const QCPGraph* drawn = page->plots()->forceGraph();
    const double peak = std::max_element(drawn->data()->constBegin(), drawn->data()->constEnd(),
                                         [](const auto& a, const auto& b) { return a.value < b.value; })
                            ->value;
    QVERIFY(std::abs(dialog.result()->peak / 1e3 / peak - 1) < 1e-12);
    const SolvedBlow& blow = *m_window->shown();
    const double impulse = blow.summary.impulse * scalesOf(blow.request.scenario).impulse;
    // The drawn chords of a curve that is drawn as straight lines between exact points.
    QVERIFY2(std::abs(dialog.result()->impulse / impulse - 1) < 1e-3,
             qPrintable(QString::number(dialog.result()->impulse / impulse, 'g', 9)));
}

void TestImportDialog::measuredCurvesAreShiftedAndRemoved() {
    auto* page = m_window->findChild<BlowPage*>();
    auto* bar = m_window->findChild<QWidget*>(QStringLiteral("measured"));
    QVERIFY(!bar->isVisible());
    for (int i = 0; i < 2; ++i) {
        ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
        QVERIFY(settle(dialog));
        control<QPushButton>(dialog, "take").click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY(bar->isVisible());
    const auto graph = [page](int i) { return page->measuredCurves()->graphs().at(i); };
    QCOMPARE(page->measuredCurves()->graphs().size(), 2);
    QCOMPARE(graph(1)->name(), QStringLiteral("record (2)"));
    QVERIFY(graph(0)->pen().color() != graph(1)->pen().color());
    QVERIFY(graph(0)->pen().dashPattern() != graph(1)->pen().dashPattern());
    // 1 m of 3.66 m: the section that is on show now.
    QVERIFY(std::abs(m_window->findChild<QDoubleSpinBox*>(QStringLiteral("section"))->value() - 0.273) <
            1e-9);
    const double before = graph(1)->data()->at(0)->key;
    type(*bar, "measuredShift", QStringLiteral("250 us"));
    QVERIFY(std::abs(graph(1)->data()->at(0)->key - before - 0.25) < 1e-9);
    QVERIFY(graph(0)->data()->at(0)->key == before);
    // It outlives a blow that cannot be solved, and one without units.
    page->setResult(failedBlow(m_window->shown()->request, QStringLiteral("too stiff")));
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    m_window->document().startFrom(findExample("paper_fig4b")->text, QStringLiteral("paper"));
    QTRY_VERIFY(!part<SolveJob>(*m_window).isBusy());
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    QVERIFY(bar->isVisible());
    m_window->document().startFrom(defaultExample().text, QStringLiteral("rod"));
    QTRY_COMPARE(page->measuredCurves()->graphs().size(), 2);
    // It stays where it is when the scenario changes, and other units show the same.
    Document& document = m_window->document();
    document.assign(*findParameter("pulse.duration"), 150e-6, document.newGesture());
    QTRY_VERIFY(!part<SolveJob>(*m_window).isBusy());
    QVERIFY(std::abs(graph(0)->data()->at(0)->key - before) < 1e-9);
    control<QToolButton>(*bar, "removeMeasured").click();
    QCOMPARE(page->measuredCurves()->graphs().size(), 1);
    control<QToolButton>(*bar, "removeMeasured").click();
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    QVERIFY(!bar->isVisible());
}

void TestImportDialog::theMeasuredRowFollowsTheUnits() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    type(dialog, "place", QStringLiteral("1.5 m"));
    QVERIFY(settle(dialog));
    control<QPushButton>(dialog, "take").click();
    const auto& place = control<QPushButton>(*m_window, "measuredPlace");
    const auto& box = control<ChoiceBox>(*m_window, "measuredSignal");
    const QString before = place.text() + box.toolTip();
    QVERIFY2(place.text().endsWith(QStringLiteral("m")), qPrintable(place.text()));
    UnitChoice::shared().choose(UnitSystem::us);
    const QString after = place.text(), toolTip = box.toolTip();
    UnitChoice::shared().choose(UnitSystem::si);
    QVERIFY2(after.endsWith(QStringLiteral("ft")) || after.endsWith(QStringLiteral("in")), qPrintable(after));
    QVERIFY2(toolTip.contains(QStringLiteral("lbf")) || toolTip.contains(QStringLiteral("kip")),
             qPrintable(toolTip));
    QCOMPARE(place.text() + box.toolTip(), before);
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

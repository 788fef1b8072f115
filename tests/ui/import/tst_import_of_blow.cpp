// SPDX-License-Identifier: GPL-3.0-or-later
// A measured signal as the hammer blow: what the scenario takes, and the dialog beside the window.
#include <QAction>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <cmath>

#include "core/yaml/examples.h"
#include "tests/support/import_fixture.h"
#include "tests/support/window_parts.h"
#include "ui/form/choice_box.h"
#include "ui/import/import_dialog.h"
#include "ui/window/file_menu.h"

using namespace drillwave;
using namespace drillwave::test;

class TestImportOfBlow : public QObject, private ImportFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() { m_window.reset(); }
    void theBlowIsOneUndoStepAndIsKeptInTheFile();
    void aBlowOfAllThePointsThereMayBeFitsItsFile();
    void whatLeavingOutSamplesDoesToTheReboundIsTold();
    void withoutPhysicalUnitsOnlyTheShapeIsTaken();
    void blowTakesThePlaceOfTheHammerOfAString();
    void aPlaceBeyondTheRodIsRefused();
    void aBlowThatTheScenarioRefusesStaysInTheDialog();
    void theDialogFollowsTheRod();
    void theWindowMayCloseWhileTheDialogIsOpen();
    void aDroppedTableOpensTheDialog();
    void aDroppedCsvThatIsNoBlowOpensTheDialog();
};

void TestImportOfBlow::theBlowIsOneUndoStepAndIsKeptInTheFile() {
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
void TestImportOfBlow::aBlowOfAllThePointsThereMayBeFitsItsFile() {
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

// A scenario keeps the points alone: later nobody knows.
void TestImportOfBlow::whatLeavingOutSamplesDoesToTheReboundIsTold() {
    const QString words = QStringLiteral("this changes e = ");
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    control<QSpinBox>(dialog, "points").setValue(20);
    QVERIFY(settle(dialog));
    const QString few = control<QLabel>(dialog, "summary").text();
    QVERIFY2(few.contains(words), qPrintable(few));
    // Another rod has another e.
    Document& document = m_window->document();
    document.assign(*findParameter("bit_rock.stiffness"), 2 * document.scenario().bitRock.stiffness,
                    document.newGesture());
    QVERIFY(settle(dialog));
    QVERIFY(control<QLabel>(dialog, "summary").text() != few);
    auto& use = control<ChoiceBox>(dialog, "use");
    use.setCurrentIndex(use.findData(static_cast<int>(ImportUse::impactForce)));
    QVERIFY(settle(dialog));
    QVERIFY(!control<QLabel>(dialog, "summary").text().contains(words));
}

void TestImportOfBlow::withoutPhysicalUnitsOnlyTheShapeIsTaken() {
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

void TestImportOfBlow::blowTakesThePlaceOfTheHammerOfAString() {
    Document& document = m_window->document();
    document.startFrom(findExample("t38_string")->text, QStringLiteral("string"));
    const Scenario before = document.scenario();
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).isEmpty(), qPrintable(message(dialog)));
    QVERIFY(control<QLabel>(dialog, "summary").text().contains(QStringLiteral("replaces the hammer")));
    control<QPushButton>(dialog, "take").click();
    QVERIFY(document.scenario().pulse.shape == PulseShape::table);
    QVERIFY(document.scenario().drillString.hammer.sections.empty());
    document.undoStack().undo();
    QVERIFY(document.scenario() == before);
}

void TestImportOfBlow::aPlaceBeyondTheRodIsRefused() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    type(dialog, "place", QStringLiteral("3.7 m"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("at most 3.66")), qPrintable(message(dialog)));
    QVERIFY(!control<QPushButton>(dialog, "take").isEnabled());
    type(dialog, "place", QStringLiteral("3.6 m"));
    QVERIFY(settle(dialog));
    QVERIFY(control<QPushButton>(dialog, "take").isEnabled());
}

void TestImportOfBlow::aBlowThatTheScenarioRefusesStaysInTheDialog() {
    // A blow of 1e-30 s asks for more than any solver can place.
    const QByteArray bytes("t [s],F [N]\n0,0\n1e-30,1\n2e-30,0\n");
    ImportDialog& dialog = open(write("short.csv", bytes), ImportUse::blow);
    QVERIFY(settle(dialog));
    if (dialog.result()) control<QPushButton>(dialog, "take").click();
    QVERIFY(!message(dialog).isEmpty());
    QVERIFY(dialog.isVisible());
    QVERIFY(!m_window->document().isModified());
}

void TestImportOfBlow::theDialogFollowsTheRod() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    // The same points for both rods, however few each of them needs.
    control<QSpinBox>(dialog, "points").setValue(500);
    QVERIFY(settle(dialog));
    const double before = dialog.result()->peak;
    Document& document = m_window->document();
    const KeptParameter stiffness = findParameter("rod.youngs_modulus");
    document.assign(*stiffness, 2 * document.scenario().rod.youngsModulus, document.newGesture());
    QVERIFY(settle(dialog));
    QVERIFY(std::abs(dialog.result()->peak / before - 2) < 1e-6);
}

void TestImportOfBlow::theWindowMayCloseWhileTheDialogIsOpen() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::blow);
    type(dialog, "from", QStringLiteral("50 us"));
    m_window.reset();
    QVERIFY(true);
}

void TestImportOfBlow::aDroppedTableOpensTheDialog() {
    part<FileMenu>(*m_window).take({write("record.txt", gaugeRecord())});
    auto* dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog);
    type(*dialog, "place", QStringLiteral("1 m"));
    QVERIFY(settle(*dialog));
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

void TestImportOfBlow::aDroppedCsvThatIsNoBlowOpensTheDialog() {
    part<FileMenu>(*m_window).take({write("record.csv", gaugeRecord())});
    auto* dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog);
    type(*dialog, "place", QStringLiteral("1 m"));
    QVERIFY(settle(*dialog));
    QVERIFY2(dialog->result() != nullptr, qPrintable(message(*dialog)));
    QVERIFY(m_answers.told.isEmpty());
    QVERIFY(!m_window->document().isModified());
}

QTEST_MAIN(TestImportOfBlow)
#include "tst_import_of_blow.moc"

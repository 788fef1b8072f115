// SPDX-License-Identifier: GPL-3.0-or-later
// Edits through the window's own fields, sliders and menus: what they leave in the file, and what undo takes
// back.
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QRandomGenerator>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <bit>

#include "core/yaml/examples.h"
#include "tests/support/files.h"
#include "tests/support/tries.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/form/quantity_slider.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/solve_job.h"
#include "ui/text/settings.h"
#include "ui/window/file_menu.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

void pressKeys(QuantityField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
}

void paste(QuantityField& field, const QString& text) {
    QApplication::clipboard()->setText(text);
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_V, Qt::ControlModifier);
}

void turnWheel(QWidget& widget) {
    const QPointF at = widget.rect().center();
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    // As from the hand: only such events go on to the parent when the widget does not want them.
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&widget, &event);
}

}  // namespace

class TestEdits : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void cleanup() { m_window.reset(); }
    void manyEditsUndoneGiveTheSameBytes_data();
    void manyEditsUndoneGiveTheSameBytes();
    void unitsSwitchedAHundredTimesLeaveEveryValueAsItIs();
    void theWheelOverAFieldWithoutFocusScrollsThePanel();
    void theWheelOverAFocusedFieldChangesItsValue();
    void aDecimalMarkMeansWhatTheUserMeant_data();
    void aDecimalMarkMeansWhatTheUserMeant();

  private:
    void makeWindow();
    QList<QuantityField*> fields() const;
    QuantityField& field(const char* key) const;
    void editSomething(QRandomGenerator& random);
    void typeSomething(QRandomGenerator& random);
    void dragSomething(QRandomGenerator& random);
    void chooseSomeShape(QRandomGenerator& random);
    void chooseSomeUnit(QRandomGenerator& random);

    QLocale m_environment;
    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestEdits::initTestCase() {
    keepSettingsIn(m_folder.filePath(QStringLiteral("settings")));
}

void TestEdits::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_answers = {};
    makeWindow();
}

void TestEdits::makeWindow() {
    m_window = newWindow(m_answers);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

QList<QuantityField*> TestEdits::fields() const {
    QList<QuantityField*> shown;
    for (QuantityField* each : part<ScenarioPanel>(*m_window).findChildren<QuantityField*>())
        if (each->isVisible()) shown.append(each);
    return shown;
}

QuantityField& TestEdits::field(const char* key) const {
    return *part<ScenarioPanel>(*m_window).findChild<QuantityField*>(QLatin1String(key));
}

void TestEdits::typeSomething(QRandomGenerator& random) {
    static const char* const texts[] = {"0.7", "12", "1e-3", "3.25", "0", "-4", "7e5", "0.123456789012345",
                                        "x",   ""};
    const QList<QuantityField*> all = fields();
    QuantityField& chosen = *all[random.bounded(int(all.size()))];
    pressKeys(chosen, QString::fromUtf8(texts[random.bounded(int(std::size(texts)))]));
    if (random.bounded(4) > 0) QTest::keyClick(&chosen, Qt::Key_Return);
}

void TestEdits::dragSomething(QRandomGenerator& random) {
    QList<QuantitySlider*> sliders;
    for (QuantitySlider* each : part<ScenarioPanel>(*m_window).findChildren<QuantitySlider*>())
        if (each->isVisible()) sliders.append(each);
    QuantitySlider& slider = *sliders[random.bounded(int(sliders.size()))];
    slider.setSliderDown(true);
    for (int i = 0; i < 3; ++i) slider.setValue(random.bounded(slider.minimum(), slider.maximum() + 1));
    slider.setSliderDown(false);
}

void TestEdits::chooseSomeShape(QRandomGenerator& random) {
    auto* shape = part<ScenarioPanel>(*m_window).findChild<QComboBox*>(QStringLiteral("pulse.shape"));
    shape->setCurrentIndex(random.bounded(shape->count()));
    emit shape->activated(shape->currentIndex());
}

void TestEdits::chooseSomeUnit(QRandomGenerator& random) {
    for (QuantityField* each : fields()) {
        if (!each->unitButton() || random.bounded(4) > 0) continue;
        const QList<QAction*> units = each->unitButton()->menu()->actions();
        units[random.bounded(int(units.size()))]->trigger();
    }
}

void TestEdits::editSomething(QRandomGenerator& random) {
    switch (random.bounded(8)) {
        case 0:
            return chooseSomeShape(random);
        case 1:
            return chooseSomeUnit(random);
        case 2:
            return m_window->document().setTitle(QStringLiteral("Rod %1: \"#%1\"").arg(random.bounded(100)));
        case 3:
        case 4:
            return dragSomething(random);
        default:
            return typeSomething(random);
    }
}

void TestEdits::manyEditsUndoneGiveTheSameBytes_data() {
    QTest::addColumn<QString>("example");
    for (const Example& example : builtInExamples())
        QTest::newRow(example.name.c_str()) << QString::fromStdString(example.name);
}

void TestEdits::manyEditsUndoneGiveTheSameBytes() {
    QFETCH(QString, example);
    Document& document = m_window->document();
    QCOMPARE(document.startFrom(findExample(example.toStdString())->text, example), QString());
    const QByteArray before = document.text();
    QRandomGenerator random(7);
    const int edits = tries("DRILLWAVE_MONKEY_EVENTS", 150, 600) / 5;
    for (int i = 0; i < edits; ++i) editSomething(random);
    QVERIFY(document.undoStack().count() > edits / 5);
    const QByteArray after = document.text();
    QVERIFY(after != before);
    while (document.undoStack().canUndo()) document.undoStack().undo();
    QCOMPARE(document.text(), before);
    QVERIFY(!m_window->isWindowModified());
    while (document.undoStack().canRedo()) document.undoStack().redo();
    QCOMPARE(document.text(), after);
    QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(*m_window).isBusy(), 200000);  // strings beyond measure
    QCOMPARE(m_window->shown()->request.scenario, document.scenario());
}

void TestEdits::unitsSwitchedAHundredTimesLeaveEveryValueAsItIs() {
    int switched = 0;
    for (QuantityField* each : fields()) {
        if (!each->value()) continue;
        // A value with all its digits, as a slider or a group leaves it.
        const double awkward = *each->value() * (1 + 0x1p-50);
        m_window->document().assign(*findParameter(each->objectName().toStdString()), awkward, 0);
    }
    const Scenario before = m_window->document().scenario();
    const int steps = m_window->document().undoStack().count();
    for (QuantityField* each : fields()) {
        if (!each->unitButton() || !each->value()) continue;
        const auto bits = std::bit_cast<quint64>(*each->value());
        const QList<QAction*> units = each->unitButton()->menu()->actions();
        for (int i = 0; i < 100; ++i) units[i % units.size()]->trigger();
        QCOMPARE(std::bit_cast<quint64>(*each->value()), bits);
        ++switched;
    }
    QVERIFY(switched > 5);
    QVERIFY(m_window->document().scenario() == before);
    QCOMPARE(m_window->document().undoStack().count(), steps);
}

void TestEdits::theWheelOverAFieldWithoutFocusScrollsThePanel() {
    m_window->resize(1000, 500);
    QCoreApplication::processEvents();
    QScrollBar* bar = part<ScenarioPanel>(*m_window).verticalScrollBar();
    QVERIFY(bar->maximum() > 0);
    field("beta").setFocus();
    const Scenario before = m_window->document().scenario();
    auto* shape = part<ScenarioPanel>(*m_window).findChild<QWidget*>(QStringLiteral("pulse.shape"));
    auto* slider = part<ScenarioPanel>(*m_window).findChild<QWidget*>(QStringLiteral("rod.length.slider"));
    for (QWidget* passed : {static_cast<QWidget*>(&field("rod.length")), slider, shape}) {
        bar->setValue(0);
        turnWheel(*passed);
        QVERIFY2(bar->value() > 0, qPrintable(passed->objectName()));
        QCOMPARE(m_window->document().scenario(), before);
    }
}

void TestEdits::theWheelOverAFocusedFieldChangesItsValue() {
    m_window->resize(1000, 500);
    QCoreApplication::processEvents();
    field("beta").setFocus();
    const double before = *field("beta").value();
    const int scrolled = part<ScenarioPanel>(*m_window).verticalScrollBar()->value();
    turnWheel(field("beta"));
    QVERIFY(*field("beta").value() < before);
    QCOMPARE(part<ScenarioPanel>(*m_window).verticalScrollBar()->value(), scrolled);
}

void TestEdits::aDecimalMarkMeansWhatTheUserMeant_data() {
    QTest::addColumn<QLocale>("locale");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("pasted");
    const QLocale german(QStringLiteral("de_DE"));
    const QLocale swedish(QStringLiteral("sv_SE"));
    int row = 0;
    for (const QString& text : {QStringLiteral("3,2"), QStringLiteral("3.2"), QStringLiteral("3,2 m"),
                                QStringLiteral("320 cm"), QStringLiteral("3200,0 mm")})
        for (const bool pasted : {false, true}) {
            if (!isChosen(row++, 3)) continue;
            const char* how = pasted ? "pasted" : "typed";
            QTest::addRow("German, %s, %s", how, qPrintable(text)) << german << text << pasted;
            QTest::addRow("Swedish, %s, %s", how, qPrintable(text)) << swedish << text << pasted;
            // The locale that the tests run under, as a user has it.
            if (m_environment.decimalPoint() == QLatin1String(","))
                QTest::addRow("environment, %s, %s", how, qPrintable(text))
                    << m_environment << text << pasted;
        }
}

// Whatever the locale, the file is the same as after typing "3.2" under the C locale.
void TestEdits::aDecimalMarkMeansWhatTheUserMeant() {
    QFETCH(QLocale, locale);
    QFETCH(QString, text);
    QFETCH(bool, pasted);
    m_window->document().assign(*findParameter("rod.length"), 3.2, 0);
    const QByteArray wanted = m_window->document().text();
    QVERIFY(wanted.contains("length: 3.2 m\n"));

    QLocale::setDefault(locale);
    makeWindow();
    if (pasted)
        paste(field("rod.length"), text);
    else
        pressKeys(field("rod.length"), text);
    QTest::keyClick(&field("rod.length"), Qt::Key_Return);
    QCOMPARE(m_window->document().scenario().rod.length, 3.2);
    m_answers.save = m_folder.filePath(QStringLiteral("typed.yaml"));
    QVERIFY(part<FileMenu>(*m_window).saveAs());
    QCOMPARE(read(m_answers.save), wanted);
}

QTEST_MAIN(TestEdits)
#include "tst_edits.moc"

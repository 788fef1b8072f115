// SPDX-License-Identifier: GPL-3.0-or-later
// A field for a number with a unit: what may be typed, what is kept, and what it says of mistakes.
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <bit>

#include "core/model/parameter.h"
#include "ui/form/quantity_field.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

using namespace drillwave;

namespace {

const Unit& unit(Quantity quantity, std::string_view name) {
    return *findUnit(quantity, name);
}

void type(QuantityField& field, const QString& text) {
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Backspace);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

QString shown(const QuantityField& field) {
    return field.findChild<QLineEdit*>()->text();
}

void turnWheel(QWidget& widget) {
    QWheelEvent wheel(QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), QPoint(), QPoint(0, 120),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &wheel);
}

}  // namespace

class TestQuantityField : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void anyUnitIsTakenExactly_data();
    void anyUnitIsTakenExactly();
    void aTypedUnitIsShownFromThenOn();
    void aHundredUnitChangesLeaveEveryBitOfTheValue();
    void wrongTextStaysWithItsReasonAndTheOldValue_data();
    void wrongTextStaysWithItsReasonAndTheOldValue();
    void reasonsAreInTheLanguageOfTheWindow();
    void escapeBringsTheValueBack();
    void aNewValueFromElsewhereReplacesWrongText();
    void theWheelTurnsOnlyAFocusedField();
    void aStepIsAFewPerCent_data();
    void aStepIsAFewPerCent();
    void germanUsersReadAndTypeCommas();
    void anOptionalFieldCanBeEmptied();
    void undoIsLeftToTheDocument();
};

void TestQuantityField::init() {
    QLocale::setDefault(QLocale::c());
}

void TestQuantityField::anyUnitIsTakenExactly_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("si");
    QTest::newRow("bare number in the unit shown") << "38" << 0.038;
    QTest::newRow("same unit") << "38 mm" << 0.038;
    QTest::newRow("inches") << "1.5 in" << 0.0381;
    QTest::newRow("decimal comma") << "3,2 m" << 3.2;
    QTest::newRow("no blank") << "4cm" << 0.04;
    QTest::newRow("micrometres") << QStringLiteral("7 µm") << 7e-6;
}

void TestQuantityField::anyUnitIsTakenExactly() {
    QFETCH(QString, typed);
    QFETCH(double, si);
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    field.setValue(0.05);
    QList<double> taken;
    field.setTaker([&](double given) {
        taken.append(given);
        return QString();
    });
    field.findChild<QLineEdit*>()->clear();
    field.findChild<QLineEdit*>()->insert(typed);
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.problem(), QString());
    QCOMPARE(std::bit_cast<quint64>(*field.value()), std::bit_cast<quint64>(si));
    QCOMPARE(taken.last(), si);
}

void TestQuantityField::aTypedUnitIsShownFromThenOn() {
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    field.setValue(0.05);
    type(field, QStringLiteral("1.5 in"));
    QCOMPARE(field.unit().name, std::string_view("in"));
    QCOMPARE(shown(field), QStringLiteral("1.5"));
}

void TestQuantityField::aHundredUnitChangesLeaveEveryBitOfTheValue() {
    const double value = 0.1 + 0.2;  // not a short decimal in any unit
    QuantityField field(Quantity::length, unit(Quantity::length, "m"));
    field.setValue(value);
    QList<double> taken;
    field.setTaker([&](double given) {
        taken.append(given);
        return QString();
    });
    const std::span<const Unit> units = unitsOf(Quantity::length);
    for (std::size_t i = 0; i < 100; ++i) {
        field.setUnit(units[i % units.size()]);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    QCOMPARE(std::bit_cast<quint64>(*field.value()), std::bit_cast<quint64>(value));
    QVERIFY(taken.isEmpty());
}

void TestQuantityField::wrongTextStaysWithItsReasonAndTheOldValue_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no number") << "abc"
                               << "not a number";
    QTest::newRow("unit of something else") << "3 kN"
                                            << "allowed units";
    QTest::newRow("out of range") << "-3 mm"
                                  << "must be positive";
    QTest::newRow("empty") << ""
                           << "empty";
    QTest::newRow("too large for a double") << "1e400"
                                            << "too large";
}

void TestQuantityField::wrongTextStaysWithItsReasonAndTheOldValue() {
    QFETCH(QString, typed);
    QFETCH(QString, reason);
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    QList<double> taken;
    field.setTaker([&](double si) {
        if (si <= 0) return QStringLiteral("must be positive");
        taken.append(si);
        return QString();
    });
    field.setToolTip(QStringLiteral("help"));
    field.setValue(0.05);
    type(field, typed);
    QCOMPARE(shown(field), typed);
    QCOMPARE(*field.value(), 0.05);
    QVERIFY2(field.problem().contains(reason), qPrintable(field.problem()));
    QCOMPARE(field.toolTip(), field.problem());
    QCOMPARE(field.accessibleDescription(), field.problem());
    // Whatever the beginning of the text meant on the way, the last word was the old value.
    QVERIFY(taken.isEmpty() || taken.last() == 0.05);
    field.setValue(0.05);  // another field was edited: this one is shown again
    QCOMPARE(shown(field), typed);
}

void TestQuantityField::reasonsAreInTheLanguageOfTheWindow() {
    Catalogue german(*findLanguage("de"));
    QCoreApplication::installTranslator(&german);
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    field.setTaker([](double si) { return translated(rangeProblem(*findParameter("rod.length"), si)); });
    type(field, QStringLiteral("drei"));
    QCOMPARE(field.problem(), QStringLiteral("ist keine Zahl"));
    type(field, QStringLiteral("-3"));
    QCOMPARE(field.problem(), QStringLiteral("muss größer als 0 sein"));
    QCoreApplication::removeTranslator(&german);
}

void TestQuantityField::escapeBringsTheValueBack() {
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    field.setToolTip(QStringLiteral("help"));
    field.setValue(0.05);
    type(field, QStringLiteral("abc"));
    QTest::keyClick(&field, Qt::Key_Escape);
    QCOMPARE(shown(field), QStringLiteral("50"));
    QCOMPARE(field.problem(), QString());
    QCOMPARE(field.toolTip(), QStringLiteral("help"));
}

void TestQuantityField::aNewValueFromElsewhereReplacesWrongText() {
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    field.setValue(0.05);
    type(field, QStringLiteral("abc"));
    field.setValue(0.06);
    QCOMPARE(shown(field), QStringLiteral("60"));
    QCOMPARE(field.problem(), QString());
}

void TestQuantityField::theWheelTurnsOnlyAFocusedField() {
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* field = new QuantityField(Quantity::length, unit(Quantity::length, "mm"));
    auto* other = new QLineEdit;
    layout->addWidget(field);
    layout->addWidget(other);
    field->setValue(0.05);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    other->setFocus();
    turnWheel(*field);
    QCOMPARE(*field->value(), 0.05);
    field->setFocus();
    turnWheel(*field);
    QVERIFY(*field->value() > 0.05);
}

void TestQuantityField::aStepIsAFewPerCent_data() {
    QTest::addColumn<double>("si");
    QTest::addColumn<int>("steps");
    QTest::addColumn<QString>("text");
    QTest::newRow("up") << 0.038 << 1 << "39";
    QTest::newRow("down") << 0.038 << -1 << "37";
    QTest::newRow("ten up") << 0.038 << 10 << "48";
    QTest::newRow("across a power of ten, upwards") << 0.0099 << 1 << "10";
    QTest::newRow("across a power of ten, downwards") << 0.01 << -1 << "9.9";
    QTest::newRow("from zero") << 0.0 << 1 << "2";
}

void TestQuantityField::aStepIsAFewPerCent() {
    QFETCH(double, si);
    QFETCH(int, steps);
    QFETCH(QString, text);
    QuantityField field(Quantity::length, unit(Quantity::length, "mm"));
    field.setStepAtZero(0.002);
    field.setValue(si);
    field.stepBy(steps);
    QCOMPARE(shown(field), text);
}

void TestQuantityField::germanUsersReadAndTypeCommas() {
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    QuantityField field(Quantity::length, unit(Quantity::length, "m"));
    field.setValue(3.66);
    QCOMPARE(shown(field), QStringLiteral("3,66"));
    type(field, QStringLiteral("1,5"));
    QCOMPARE(*field.value(), 1.5);
    QCOMPARE(shown(field), QStringLiteral("1,5"));
}

void TestQuantityField::anOptionalFieldCanBeEmptied() {
    QuantityField field(Quantity::force, unit(Quantity::force, "kN"));
    field.setOptional(QStringLiteral("not given"));
    field.setValue(8000);
    QSignalSpy cleared(&field, &QuantityField::cleared);
    type(field, QString());
    QCOMPARE(cleared.count(), 1);
    QVERIFY(!field.value());
    QCOMPARE(field.problem(), QString());
}

void TestQuantityField::undoIsLeftToTheDocument() {
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* field = new QuantityField(Quantity::length, unit(Quantity::length, "mm"));
    layout->addWidget(field);
    QAction undo;
    undo.setShortcut(Qt::CTRL | Qt::Key_Z);
    window.addAction(&undo);
    QSignalSpy triggered(&undo, &QAction::triggered);
    field->setValue(0.05);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    field->setFocus();
    type(*field, QStringLiteral("60"));
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(triggered.count(), 1);
    QCOMPARE(shown(*field), QStringLiteral("60"));
}

QTEST_MAIN(TestQuantityField)
#include "tst_quantity_field.moc"

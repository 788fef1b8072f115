// SPDX-License-Identifier: GPL-3.0-or-later
// A uniform rod becomes a drill string and a string a uniform rod in the window, undone like any edit.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <cmath>

#include "core/model/scales.h"
#include "core/yaml/examples.h"
#include "ui/form/quantity_field.h"
#include "ui/form/rig_dialog.h"
#include "ui/window/document_notices.h"

using namespace drillwave;

namespace {

void open(Document& document, const char* example) {
    QCOMPARE(document.startFrom(findExample(example)->text, QString::fromLatin1(example)), QString());
}

}  // namespace

class TestFormNotice : public QObject {
    Q_OBJECT

  private slots:
    void aRodBecomesAStringAndUndoBringsItsBytesBack();
    void aStringBecomesARodAndSaysWhatIsLost();
    void whatIsNeitherIsLeftAlone();
    void groupsBecomeARigOfTheSameGroups();
    void theNoteGoesWithTheNextEdit();
};

void TestFormNotice::aRodBecomesAStringAndUndoBringsItsBytesBack() {
    Document document;
    open(document, "t38_medium_rock");
    const QByteArray before = document.text();
    FormNotice notice(document);
    QVERIFY(notice.toString()->isEnabled());
    QVERIFY(!notice.toUniformRod()->isEnabled());
    notice.toString()->trigger();
    QVERIFY(isString(document.scenario()));
    QVERIFY(!notice.isHidden());
    QVERIFY(document.text().contains("drillwave: 2"));
    QVERIFY(!notice.toString()->isEnabled());
    QVERIFY(notice.toUniformRod()->isEnabled());
    QVERIFY(document.undoStack().undoText().contains(QStringLiteral("drill string")));
    notice.findChild<QPushButton*>()->click();
    QCOMPARE(document.text(), before);
    QVERIFY(notice.isHidden());
    QVERIFY(notice.toString()->isEnabled());
}

void TestFormNotice::aStringBecomesARodAndSaysWhatIsLost() {
    Document document;
    open(document, "t38_string");
    FormNotice notice(document);
    notice.toUniformRod()->trigger();
    QVERIFY(!isString(document.scenario()));
    QVERIFY2(notice.text().contains(QStringLiteral("6 of 9 sections")), qPrintable(notice.text()));
    QVERIFY(document.text().contains("drillwave: 1"));
}

void TestFormNotice::whatIsNeitherIsLeftAlone() {
    Document document;
    open(document, "paper_fig4b");
    const FormNotice notice(document);
    QVERIFY(!notice.toString()->isEnabled());
    QVERIFY(!notice.toUniformRod()->isEnabled());
    QVERIFY(notice.toString()->toolTip().contains(QStringLiteral("physical units")));
}

void TestFormNotice::groupsBecomeARigOfTheSameGroups() {
    Document document;
    open(document, "t38_medium_rock");
    FormNotice notice(document);
    QVERIFY(!notice.toRig()->isEnabled());
    open(document, "paper_fig4b");
    QVERIFY(notice.toRig()->isEnabled());
    const QByteArray before = document.text();
    const Groups groups = document.scenario().groups;
    notice.toRig()->trigger();
    auto* dialog = notice.findChild<RigDialog*>();
    QVERIFY(dialog);
    auto* rod = dialog->findChild<QComboBox*>(QStringLiteral("rod"));
    rod->setCurrentIndex(rod->findText(QStringLiteral("T51, round 52 mm")));
    emit rod->activated(rod->currentIndex());
    auto* duration = dialog->findChild<QuantityField*>(QStringLiteral("pulse.duration"));
    QTest::keyClick(duration, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(duration, QStringLiteral("250 us"));
    QCOMPARE(dialog->choice().duration, 250e-6);
    QVERIFY(
        dialog->findChild<QLabel*>(QStringLiteral("result"))->text().contains(QStringLiteral("a rod of")));
    dialog->accept();
    QVERIFY(hasUnits(document.scenario()));
    QCOMPARE(document.scenario().pulse.duration, 250e-6);
    const Groups after = groupsOf(document.scenario());
    const auto isClose = [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); };
    QVERIFY(isClose(after.beta, groups.beta) && isClose(after.tau, groups.tau));
    QVERIFY(isClose(after.delta, groups.delta) && after.gamma == groups.gamma);
    QVERIFY(!notice.toRig()->isEnabled());
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("make a rig of the groups"));
    document.undoStack().undo();
    QCOMPARE(document.text(), before);
}

void TestFormNotice::theNoteGoesWithTheNextEdit() {
    Document document;
    open(document, "t38_string");
    FormNotice notice(document);
    notice.toUniformRod()->trigger();
    QVERIFY(!notice.isHidden());
    document.assign(*findParameter("rod.length"), 5, document.newGesture());
    QVERIFY(notice.isHidden());
}

QTEST_MAIN(TestFormNotice)
#include "tst_form_notice.moc"

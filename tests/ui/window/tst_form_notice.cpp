// SPDX-License-Identifier: GPL-3.0-or-later
// A uniform rod becomes a drill string and a string a uniform rod in the window, undone like any edit.
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "core/yaml/examples.h"
#include "ui/window/form_notice.h"

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

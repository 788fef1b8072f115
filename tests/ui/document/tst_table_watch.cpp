// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a measured blow changed by other programs: reported, read again on request, taken back by undo.
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QSaveFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/model/scales.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/window/document_notices.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const QByteArray table = "time [us],force [kN]\n0,0\n100,300\n200,0\n";
const QByteArray stronger = "time [us],force [kN]\n0,0\n100,600\n200,0\n";

}  // namespace

class TestTableWatch : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cleanup() { m_window.reset(); }
    void aChangedTableIsToldAndReadAgain();
    void pointsOfTheHistoryAreNotThoseOfTheFile();
    void anotherShapeAndBackIsNoReading();
    void savedElsewhereTheTableIsStillWatched();
    void aFileInItsPlaceIsToldToo();
    void keepingMineStaysKept();
    void touchingTheFileIsNoChange();
    void aDeletedTableIsTold();
    void anotherShapeForgetsTheTable();

  private:
    TableNotice& notice() { return part<TableNotice>(*m_window); }
    double impulse() const { return pulseImpulse(m_window->document().scenario()); }
    void click(const char* button) { notice().findChild<QPushButton*>(QLatin1String(button))->click(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestTableWatch::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    keepSettingsIn(m_folder->filePath(QStringLiteral("settings")));
    m_path = m_folder->filePath(QStringLiteral("blow.csv"));
    write(m_path, table);
    m_answers = {};
    m_window = newWindow(m_answers);
    m_window->show();
    QCOMPARE(m_window->document().useTable(m_path), QString());
    QVERIFY(notice().isHidden());
}

void TestTableWatch::aChangedTableIsToldAndReadAgain() {
    QCOMPARE(impulse(), 30.0);
    write(m_path, stronger);
    QTRY_VERIFY(notice().isVisible());
    QVERIFY(notice().text().contains(QStringLiteral("blow.csv")));
    QCOMPARE(impulse(), 30.0);
    click("reloadBlow");
    QVERIFY(notice().isHidden());
    QCOMPARE(impulse(), 60.0);
    m_window->document().undoStack().undo();
    QCOMPARE(impulse(), 30.0);
}

// Points that undo brings back are of a file that is not there any more.
void TestTableWatch::pointsOfTheHistoryAreNotThoseOfTheFile() {
    write(m_path, stronger);
    QTRY_VERIFY(notice().isVisible());
    click("reloadBlow");
    QUndoStack& history = m_window->document().undoStack();
    for (int again = 0; again < 2; ++again) {
        history.undo();
        QCOMPARE(impulse(), 30.0);
        QTRY_VERIFY(notice().isVisible());
        QVERIFY(notice().text().contains(QStringLiteral("changed by another program")));
        history.redo();
        QCOMPARE(impulse(), 60.0);
        QTRY_VERIFY(notice().isHidden());
    }
    history.undo();
    write(m_path, table);
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isHidden());
}

void TestTableWatch::anotherShapeAndBackIsNoReading() {
    m_window->document().setShape(PulseShape::rectangular);
    write(m_path, stronger);
    m_window->document().undoStack().undo();
    QCOMPARE(impulse(), 30.0);
    QTRY_VERIFY(notice().isVisible());
    click("reloadBlow");
    QCOMPARE(impulse(), 60.0);
    QVERIFY(notice().isHidden());
}

// The name of the table is another one for a moment before its folder is.
void TestTableWatch::savedElsewhereTheTableIsStillWatched() {
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("elsewhere")));
    QCOMPARE(m_window->document().save(m_folder->filePath(QStringLiteral("t38.yaml"))), QString());
    QCOMPARE(m_window->document().save(m_folder->filePath(QStringLiteral("elsewhere/t38.yaml"))), QString());
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isHidden());
    write(m_path, stronger);
    QTRY_VERIFY(notice().isVisible());
    QVERIFY(notice().text().contains(QStringLiteral("changed by another program")));
}

void TestTableWatch::aFileInItsPlaceIsToldToo() {
    for (const QByteArray& bytes : {stronger, table + "\n", stronger}) {
        QSaveFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit());
        QTRY_VERIFY(notice().isVisible());
        click("reloadBlow");
        QVERIFY(notice().isHidden());
    }
}

void TestTableWatch::keepingMineStaysKept() {
    write(m_path, stronger);
    QTRY_VERIFY(notice().isVisible());
    click("keepBlow");
    QVERIFY(notice().isHidden());
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isHidden());
    QCOMPARE(impulse(), 30.0);
}

void TestTableWatch::touchingTheFileIsNoChange() {
    QFile file(m_path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(100), QFileDevice::FileModificationTime));
    file.close();
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isHidden());
}

void TestTableWatch::aDeletedTableIsTold() {
    QVERIFY(QFile::remove(m_path));
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isVisible());
    QVERIFY(notice().text().contains(QStringLiteral("deleted or moved")));
    // The same again is no change.
    write(m_path, table);
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isHidden());
}

void TestTableWatch::anotherShapeForgetsTheTable() {
    write(m_path, stronger);
    QTRY_VERIFY(notice().isVisible());
    m_window->document().setShape(PulseShape::rectangular);
    QVERIFY(notice().isHidden());
    part<TableWatch>(*m_window).check();
    QVERIFY(notice().isHidden());
}

QTEST_MAIN(TestTableWatch)
#include "tst_table_watch.moc"

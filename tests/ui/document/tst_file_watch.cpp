// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the file by other programs: noticed, reported in passing, never overwritten unasked.
#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QSaveFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/yaml/examples.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/window/document_notices.h"
#include "ui/window/file_menu.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

QByteArray scenarioBytes(const QByteArray& length) {
    QByteArray bytes(defaultExample().text.data(), qsizetype(defaultExample().text.size()));
    return bytes.replace("length: 3.66 m", "length: " + length);
}

// As most editors save: a new file takes the place of the old one.
void replaceBy(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit());
}

}  // namespace

class TestFileWatch : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cleanup();
    void aRewrittenFileIsToldAndReloaded();
    void aReplacedFileIsToldEveryTime();
    void aFileThatComesBackIsNoChange();
    void touchingAndSavingAreNoChanges();
    void aDeletedFileIsToldAndSavedAgain();
    void keepingMineIsNotAskedAboutAgain();
    void savingOverAChangedFileAsksFirst();
    void anotherFileInTheFolderIsNoChange();
    void aReloadThatFailsChangesNothing();
    void anotherScenarioTakesTheNoticeAway();

  private:
    MainWindow& window() { return *m_window; }
    FileNotice& notice() { return part<FileNotice>(*m_window); }
    double length() const { return m_window->document().scenario().rod.length; }
    void edit(double metres) { window().document().assign(*findParameter("rod.length"), metres, 1); }
    void click(const char* button) { notice().findChild<QPushButton*>(QLatin1String(button))->click(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestFileWatch::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    keepSettingsIn(m_folder->filePath(QStringLiteral("settings")));
    m_path = m_folder->filePath(QStringLiteral("mine.yaml"));
    write(m_path, scenarioBytes("3.66 m"));
    m_answers = {};
    m_window = newWindow(m_answers);
    m_window->show();
    QVERIFY(m_window->openFile(m_path));
}

void TestFileWatch::cleanup() {
    m_window.reset();
}

void TestFileWatch::aRewrittenFileIsToldAndReloaded() {
    QVERIFY(!notice().isVisible());
    write(m_path, scenarioBytes("7 m"));
    QTRY_VERIFY(notice().isVisible());
    QVERIFY2(notice().text().contains(QStringLiteral("mine.yaml")), qPrintable(notice().text()));
    QCOMPARE(length(), 3.66);
    click("reload");
    QCOMPARE(length(), 7.0);
    QVERIFY(!notice().isVisible());
    QVERIFY(!window().isWindowModified());
    window().document().undoStack().undo();
    QCOMPARE(length(), 3.66);
}

void TestFileWatch::aReplacedFileIsToldEveryTime() {
    for (const char* metres : {"4 m", "5 m", "6 m"}) {
        replaceBy(m_path, scenarioBytes(metres));
        QTRY_VERIFY(notice().isVisible());
        click("reload");
        QCOMPARE(window().document().text(), scenarioBytes(metres));
        QVERIFY(!notice().isVisible());
    }
}

void TestFileWatch::aFileThatComesBackIsNoChange() {
    replaceBy(m_path, scenarioBytes("7 m"));
    QTRY_VERIFY(notice().isVisible());
    replaceBy(m_path, scenarioBytes("3.66 m"));
    QTRY_VERIFY(!notice().isVisible());
}

void TestFileWatch::touchingAndSavingAreNoChanges() {
    write(m_path, scenarioBytes("3.66 m"));
    edit(5);
    QVERIFY(part<FileMenu>(window()).save());
    edit(6);
    QVERIFY(part<FileMenu>(window()).save());
    QSignalSpy agrees(&part<FileWatch>(window()), &FileWatch::agrees);
    QTRY_VERIFY(!agrees.isEmpty());  // it has looked
    QVERIFY(!notice().isVisible());
    QCOMPARE(m_answers.confirmed, QStringList());
}

void TestFileWatch::aDeletedFileIsToldAndSavedAgain() {
    QVERIFY(QFile::remove(m_path));
    QTRY_VERIFY(notice().isVisible());
    QVERIFY(!notice().findChild<QPushButton*>(QStringLiteral("reload"))->isVisible());
    QVERIFY(window().isWindowModified());  // closing must ask: it is in no file any more
    QVERIFY(part<FileMenu>(window()).save());
    QCOMPARE(read(m_path), scenarioBytes("3.66 m"));
    QVERIFY(!notice().isVisible());
    QVERIFY(!window().isWindowModified());
    replaceBy(m_path, scenarioBytes("8 m"));
    QTRY_VERIFY(notice().isVisible());
}

void TestFileWatch::keepingMineIsNotAskedAboutAgain() {
    replaceBy(m_path, scenarioBytes("7 m"));
    QTRY_VERIFY(notice().isVisible());
    click("keep");
    QVERIFY(!notice().isVisible());
    QVERIFY(window().isWindowModified());
    QVERIFY(part<FileMenu>(window()).save());
    QCOMPARE(m_answers.confirmed, QStringList());
    QCOMPARE(read(m_path), scenarioBytes("3.66 m"));
}

void TestFileWatch::savingOverAChangedFileAsksFirst() {
    edit(5);
    write(m_path, scenarioBytes("7 m"));
    // Before any notice: the watch may be late, the question must not be.
    QVERIFY(!part<FileMenu>(window()).save());
    QCOMPARE(m_answers.confirmed.size(), 1);
    QCOMPARE(read(m_path), scenarioBytes("7 m"));
    QVERIFY(window().isWindowModified());
    m_answers.confirm = true;
    QVERIFY(part<FileMenu>(window()).save());
    QVERIFY(read(m_path).contains("length: 5 m"));
}

void TestFileWatch::anotherFileInTheFolderIsNoChange() {
    QSignalSpy agrees(&part<FileWatch>(window()), &FileWatch::agrees);
    write(m_folder->filePath(QStringLiteral("other.yaml")), "anything");
    QTRY_VERIFY(!agrees.isEmpty());  // it has looked
    QVERIFY(!notice().isVisible());
}

void TestFileWatch::aReloadThatFailsChangesNothing() {
    write(m_path, "drillwave: 1\nrodd: 3\n");
    QTRY_VERIFY(notice().isVisible());
    click("reload");
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY2(m_answers.told.first().contains(QStringLiteral("mine.yaml:2")),
             qPrintable(m_answers.told.first()));
    QCOMPARE(length(), 3.66);
    QVERIFY(notice().isVisible());
    notice().findChild<QToolButton*>(QStringLiteral("dismiss"))->click();
    QVERIFY(!notice().isVisible());
    QVERIFY(window().isWindowModified());
}

void TestFileWatch::anotherScenarioTakesTheNoticeAway() {
    write(m_path, scenarioBytes("7 m"));
    QTRY_VERIFY(notice().isVisible());
    window().document().start();
    QVERIFY(!notice().isVisible());
}

QTEST_MAIN(TestFileWatch)
#include "tst_file_watch.moc"

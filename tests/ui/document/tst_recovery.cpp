// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes survive the death of the program, and only that.
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/yaml/examples.h"
#include "tests/support/child_process.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/document/recovery.h"
#include "ui/job/study_status.h"
#include "ui/text/language.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/view_menu.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

void setLength(Document& document, double metres) {
    document.assign(*findParameter("rod.length"), metres, 1);
}

QStringList recoveryFiles(const QString& folder) {
    return QDir(folder).entryList({QStringLiteral("*.recovery")}, QDir::Files);
}

// A window with an unsaved change to a file, until it is killed.
int editForEver(const QString& folder, const QString& path) {
    keepSettingsIn(QFileInfo(folder).path() + QStringLiteral("/settings"));
    ScriptedAnswers answers;
    const auto window = newWindow(answers);
    window->startRecovery(folder);
    if (!window->openFile(path)) return 1;
    setLength(window->document(), 4);
    auto& pinned = part<PinnedRuns>(*window);
    pinned.pinAction()->trigger();
    pinned.runs().rename(pinned.runs().list()->front().number, QStringLiteral("four metres"));
    setLength(window->document(), 5);
    if (!QTest::qWaitFor([&] { return !recoveryFiles(folder).isEmpty(); })) return 1;
    QTest::qWait(1500);  // the last of what is kept follows within a second
    sayReady();
    return QCoreApplication::exec();
}

}  // namespace

class TestRecovery : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cleanup();
    void changesAreKeptSoonAndRemovedWhenSaved();
    void anEndLeavesNothing();
    void aLivingInstanceKeepsItsChanges();
    void changesOfAKilledProgramAreRestored();
    void runsAndSignalsComeBackWithTheScenario();
    void aRestartCarriesEverythingOver();
    void laterKeepsThemAndDiscardRemovesThem();
    void aDamagedFileIsToldOfOnceAndKept_data();
    void aDamagedFileIsToldOfOnceAndKept();
    void locksOfTheDeadAreRemoved();
    void aFolderThatCannotBeWrittenIsToldOfOnce();

  private:
    void leaveChangesOfAKilledProgram();

    std::unique_ptr<QTemporaryDir> m_place;
    QString m_folder;
    QString m_original;
    ScriptedAnswers m_answers;
};

void TestRecovery::init() {
    m_place = std::make_unique<QTemporaryDir>();
    keepSettingsIn(m_place->path() + QStringLiteral("/settings"));
    m_folder = m_place->filePath(QStringLiteral("recovery"));
    m_original = m_place->filePath(QStringLiteral("original.yaml"));
    write(m_original, QByteArray(defaultExample().text.data(), qsizetype(defaultExample().text.size())));
    m_answers = {};
}

void TestRecovery::cleanup() {
    m_place.reset();
}

void TestRecovery::leaveChangesOfAKilledProgram() {
    QProcess child;
    QVERIFY(startChild(child, {QStringLiteral("--edit"), m_folder, m_original}));
    QVERIFY(findLostChanges(m_folder).empty());  // it is alive
    QVERIFY(killChild(child));
    QCOMPARE(recoveryFiles(m_folder).size(), 1);
}

void TestRecovery::changesAreKeptSoonAndRemovedWhenSaved() {
    Document document;
    QCOMPARE(document.open(m_original), QString());
    const Recovery recovery(document, m_folder);
    setLength(document, 5);
    QTRY_VERIFY(QFile::exists(recovery.file()));
    QTRY_VERIFY(read(recovery.file()).contains("length: 5 m"));
    setLength(document, 6);
    QTRY_VERIFY(read(recovery.file()).contains("length: 6 m"));
    document.undoStack().undo();
    QTRY_VERIFY(!QFile::exists(recovery.file()));
    setLength(document, 7);
    QTRY_VERIFY(QFile::exists(recovery.file()));
    QCOMPARE(document.save(m_original), QString());
    QTRY_VERIFY(!QFile::exists(recovery.file()));
}

void TestRecovery::anEndLeavesNothing() {
    const auto window = newWindow(m_answers);
    window->startRecovery(m_folder);
    setLength(window->document(), 5);
    QTRY_COMPARE(recoveryFiles(m_folder).size(), 1);
    m_answers.unsaved = Questions::Unsaved::cancel;
    QVERIFY(!window->close());
    QCOMPARE(recoveryFiles(m_folder).size(), 1);
    m_answers.unsaved = Questions::Unsaved::discard;
    QVERIFY(window->close());
    QCOMPARE(recoveryFiles(m_folder).size(), 0);
    QCOMPARE(m_answers.found, QStringList());
}

void TestRecovery::aLivingInstanceKeepsItsChanges() {
    const auto first = newWindow(m_answers);
    first->startRecovery(m_folder);
    setLength(first->document(), 5);
    QTRY_COMPARE(recoveryFiles(m_folder).size(), 1);
    m_answers.recovery = Questions::Recovery::restore;
    const auto second = newWindow(m_answers);
    second->startRecovery(m_folder);
    QCOMPARE(m_answers.found, QStringList());
    QVERIFY(!second->document().isModified());
    QCOMPARE(recoveryFiles(m_folder).size(), 1);
}

void TestRecovery::changesOfAKilledProgramAreRestored() {
    const QByteArray original = read(m_original);
    leaveChangesOfAKilledProgram();
    m_answers.recovery = Questions::Recovery::restore;
    const auto window = newWindow(m_answers);
    window->startRecovery(m_folder);
    QCOMPARE(m_answers.found.size(), 1);
    QVERIFY2(m_answers.found.first().contains(QStringLiteral("original.yaml")),
             qPrintable(m_answers.found.first()));
    const Document& document = window->document();
    QByteArray expected = original;
    expected.replace("length: 3.66 m              # a 12 ft extension rod", "length: 5 m");
    QCOMPARE(document.text().simplified(), expected.simplified());
    QVERIFY(document.isModified());
    QVERIFY(window->isWindowModified());
    // The next file to be opened is as it was read, whatever came before.
    {
        const auto other = newWindow(m_answers);
        other->document().markUnsaved();
        QVERIFY(other->openFile(m_original));
        QVERIFY(!other->document().isModified());
        QVERIFY(!other->isWindowModified());
        other->document().markUnsaved();
        other->document().start();
        QVERIFY(!other->document().isModified());
    }
    // With its file, whose saved state undo brings back; and it is safe again already.
    QCOMPARE(document.path(), m_original);
    const RunList& runs = *part<PinnedRuns>(*window).runs().list();
    QCOMPARE(runs.size(), 1u);
    QCOMPARE(runs.front().contents.scenario.rod.length, 4.0);
    QCOMPARE(runs.front().name, QStringLiteral("four metres"));
    QCOMPARE(read(m_original), original);
    QCOMPARE(recoveryFiles(m_folder).size(), 1);
    QVERIFY(findLostChanges(m_folder).empty());
    while (window->document().undoStack().canUndo()) window->document().undoStack().undo();
    QCOMPARE(document.text(), original);
    QVERIFY(!document.isModified());
}

// The file of a window contains all that another one needs.
void TestRecovery::runsAndSignalsComeBackWithTheScenario() {
    Document document;
    QCOMPARE(document.open(m_original), QString());
    setLength(document, 5);
    MeasuredSignal gauge;
    gauge.name = "gauge";
    gauge.place = 1.5;
    gauge.timeShift = -2e-6;
    gauge.deviation = 120;
    gauge.points = std::vector<TablePoint>{{0, 0}, {1.0 / 3e6, -2.5e5}};
    MeasuredSignal force = gauge;
    force.quantity = MeasuredQuantity::impactForce;
    KeptRun run;
    run.number = 3;
    run.name = "k";
    run.contents = parseScenario(read(m_original).toStdString(), m_original.toStdString());
    run.isReference = true;
    run.cor = 0.1;
    Recovery recovery(document, m_folder);
    recovery.keepBeside([&] { return WorkBeside{{run}, {gauge, force}}; });
    recovery.writeNow();
    const LostChanges kept(recovery.file(), nullptr);
    QCOMPARE(kept.problem(), QString());
    const UnsavedScenario& found = kept.scenario();
    QCOMPARE(found.path, m_original);
    QCOMPARE(QByteArray::fromStdString(found.saved), read(m_original));
    QCOMPARE(QByteArray::fromStdString(found.text), document.text());
    QVERIFY(found.beside.measured == (std::vector<MeasuredSignal>{gauge, force}));
    QCOMPARE(found.beside.runs.size(), 1u);
    const KeptRun& again = found.beside.runs.front();
    QVERIFY(again.contents.scenario == run.contents.scenario && again.contents.text == run.contents.text);
    QVERIFY(again.number == 3 && again.name == "k" && again.isReference && again.cor == 0.1);
    QVERIFY(!found.isRestart && found.isUnsaved);
    recovery.end();
}

// Nothing is asked, and what was not changed is not changed then.
void TestRecovery::aRestartCarriesEverythingOver() {
    for (const bool isChanged : {true, false}) {
        QByteArray text;
        {
            const auto first = newWindow(m_answers);
            first->startRecovery(m_folder);
            QVERIFY(first->openFile(m_original));
            if (isChanged) setLength(first->document(), 5);
            QTRY_VERIFY(part<SolveStatus>(*first).isCurrent());
            part<PinnedRuns>(*first).pinAction()->trigger();
            text = first->document().text();
            m_answers.restart = true;
            for (QAction* action : part<LanguageMenu>(*first).actions())
                if (action->text() == (isChanged ? QStringLiteral("Svenska") : QStringLiteral("Deutsch")))
                    action->trigger();
            QTRY_VERIFY(first->wantsRestart());
            QCOMPARE(m_answers.unsavedAsked, 0);
        }
        const auto second = newWindow(m_answers);
        second->startRecovery(m_folder);
        QCOMPARE(m_answers.found, QStringList());
        QCOMPARE(second->document().text(), text);
        QCOMPARE(second->document().path(), m_original);
        QCOMPARE(second->document().isModified(), isChanged);
        QCOMPARE(part<PinnedRuns>(*second).runs().list()->size(), 1u);
        second->document().undoStack().setClean();
        m_answers.unsaved = Questions::Unsaved::discard;
        QVERIFY(second->close());
        QCOMPARE(recoveryFiles(m_folder), QStringList());
        m_answers.unsavedAsked = 0;
    }
    chooseLanguage(nullptr);
}

void TestRecovery::laterKeepsThemAndDiscardRemovesThem() {
    leaveChangesOfAKilledProgram();
    m_answers.recovery = Questions::Recovery::later;
    newWindow(m_answers)->startRecovery(m_folder);
    QCOMPARE(recoveryFiles(m_folder).size(), 1);
    m_answers.recovery = Questions::Recovery::discard;
    const auto window = newWindow(m_answers);
    window->startRecovery(m_folder);
    QCOMPARE(m_answers.found.size(), 2);
    QCOMPARE(recoveryFiles(m_folder).size(), 0);
    QVERIFY(!window->document().isModified());
}

void TestRecovery::aDamagedFileIsToldOfOnceAndKept_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("cut off") << QByteArray(R"({"drillwave_recovery": 1, "scen)");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("binary") << QByteArray("\0\1\2\3", 4);
    QTest::newRow("another format") << QByteArray(R"({"drillwave_recovery": 2, "scenario": "drillwave: 1"})");
    QTest::newRow("not a scenario") << QByteArray(R"({"drillwave_recovery": 1, "scenario": "rodd: 1"})");
}

void TestRecovery::aDamagedFileIsToldOfOnceAndKept() {
    QFETCH(QByteArray, bytes);
    QVERIFY(QDir().mkpath(m_folder));
    write(QDir(m_folder).filePath(QStringLiteral("a.recovery")), bytes);
    m_answers.recovery = Questions::Recovery::restore;
    for (int start = 0; start < 2; ++start) {
        const auto window = newWindow(m_answers);
        const Scenario before = window->document().scenario();
        window->startRecovery(m_folder);
        QCOMPARE(m_answers.told.size(), 1);
        QVERIFY(window->document().scenario() == before);
    }
    QCOMPARE(read(QDir(m_folder).filePath(QStringLiteral("a.damaged"))), bytes);
}

void TestRecovery::locksOfTheDeadAreRemoved() {
    QProcess child;
    QVERIFY(startChild(child, {QStringLiteral("--edit"), m_folder, m_original}));
    QVERIFY(killChild(child));
    for (const QString& name : recoveryFiles(m_folder)) QFile::remove(QDir(m_folder).filePath(name));
    QCOMPARE(QDir(m_folder).entryList(QDir::Files).size(), 1);
    QVERIFY(findLostChanges(m_folder).empty());
    QCOMPARE(QDir(m_folder).entryList(QDir::Files), QStringList());
}

void TestRecovery::aFolderThatCannotBeWrittenIsToldOfOnce() {
    write(m_folder, "a file where the folder should be");
    const auto window = newWindow(m_answers);
    window->startRecovery(m_folder);
    setLength(window->document(), 5);
    QTRY_COMPARE(m_answers.told.size(), 1);
    setLength(window->document(), 6);
    part<Recovery>(*window).writeNow();
    QCoreApplication::processEvents();
    QCOMPARE(m_answers.told.size(), 1);
    QCOMPARE(window->document().scenario().rod.length, 6.0);
}

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const QStringList words = QCoreApplication::arguments();
    if (words.value(1) == QLatin1String("--edit")) return editForEver(words.value(2), words.value(3));
    TestRecovery test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_recovery.moc"

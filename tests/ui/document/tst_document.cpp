// SPDX-License-Identifier: GPL-3.0-or-later
// The document being edited: edits and their names, undo, opening, saving, and the tables it reads.
#include <sys/resource.h>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <csignal>

#include "core/model/scales.h"
#include "core/yaml/examples.h"
#include "core/yaml/preset_file.h"
#include "tests/support/files.h"
#include "ui/document/document.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const Parameter& parameter(std::string_view key) {
    return *findParameter(key);
}

QByteArray exampleBytes() {
    return QByteArray(defaultExample().text.data(), static_cast<qsizetype>(defaultExample().text.size()));
}

}  // namespace

class TestDocument : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void undoOfManyEditsRestoresTheBytesOfTheFile();
    void editsOfOneGestureAreOneNamedStep();
    void anEditThatComesBackLeavesNoStep();
    void anEditIsCheckedOnce();
    void aThousandStepsShareOneTable();
    void aPresetLeavesItsSourcesInTheFile();
    void valuesInBracesGetNoComments();
    void settingAGroupMovesItsPhysicalParameter();
    void whatWouldSpoilTheScenarioIsRefused();
    void optionalParametersCanBeCleared();
    void savingMakesTheDocumentClean();
    void aFailedSaveIsReportedAndLosesNothing();
    void aFileThatCannotBeReadChangesNothing();
    void savingElsewhereKeepsTheTableInReach();
    void aResultIsOpenedWithoutAPath();
    void aNewFileIsNamedAfterItsTitle();
    void wordsOfAnExampleDoNotOutliveItsValues();
    void aReloadIsAStepThatCanBeUndone();
    void aRestoredScenarioIsUnsavedAndHasNoPath();
    void aHammerBlowIsTakenFromATable();
    void aTableThatIsNoneChangesNothing();
    void aScenarioTooLargeForAFileIsReported();
    void savingKeepsLinksAndPermissions();
    void aReadOnlyFileIsNotSavedOver();
    void aFullDiskLosesNothing();
    void whatIsNoScenarioChangesNothing_data();
    void whatIsNoScenarioChangesNothing();

  private:
    QTemporaryDir m_folder;
    std::unique_ptr<Document> m_document;
};

void TestDocument::init() {
    m_document = std::make_unique<Document>();
    QCOMPARE(m_document->startFrom(defaultExample().text, QStringLiteral("example")), QString());
}

void TestDocument::undoOfManyEditsRestoresTheBytesOfTheFile() {
    QCOMPARE(m_document->text(), exampleBytes());
    int gesture = 0;
    for (int i = 1; i <= 40; ++i) {
        m_document->assign(parameter("beta"), 0.1 * i, ++gesture);
        m_document->assign(parameter("rod.length"), 1 + 0.07 * i, ++gesture);
        m_document->assign(parameter("pulse.force"), 1e5 + 333 * i, ++gesture);
    }
    m_document->setShape(PulseShape::trapezoid);
    m_document->setTitle(QStringLiteral("another"));
    QVERIFY(m_document->text() != exampleBytes());
    const QByteArray edited = m_document->text();
    while (m_document->undoStack().canUndo()) m_document->undoStack().undo();
    QCOMPARE(m_document->text(), exampleBytes());
    QVERIFY(!m_document->isModified());
    while (m_document->undoStack().canRedo()) m_document->undoStack().redo();
    QCOMPARE(m_document->text(), edited);
}

void TestDocument::editsOfOneGestureAreOneNamedStep() {
    for (int i = 1; i <= 20; ++i) m_document->assign(parameter("beta"), 0.1 * i, 7);
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY2(m_document->undoStack().undoText().contains(QStringLiteral("stiffness β to 2")),
             qPrintable(m_document->undoStack().undoText()));
    m_document->assign(parameter("beta"), 3, 8);
    m_document->assign(parameter("gamma"), 0.5, 8);
    QCOMPARE(m_document->undoStack().count(), 3);
}

void TestDocument::anEditThatComesBackLeavesNoStep() {
    const double length = m_document->scenario().rod.length;
    m_document->assign(parameter("rod.length"), 5, 1);
    m_document->assign(parameter("rod.length"), length, 1);
    QCOMPARE(m_document->undoStack().count(), 0);
    QVERIFY(!m_document->isModified());
}

void TestDocument::anEditIsCheckedOnce() {
    int checks = 0;
    Document document(nullptr, [&](const Scenario& scenario) {
        ++checks;
        return validate(scenario);
    });
    document.start();
    QCOMPARE(document.assign(parameter("beta"), 0.7, 1), QString());
    QCOMPARE(checks, 1);
    QVERIFY(!document.assign(parameter("rod.bore"), 0.05, 2).isEmpty());  // wider than the rod
    QCOMPARE(checks, 2);
    QVERIFY(!document.assign(parameter("gamma"), 1.3, 3).isEmpty());  // outside its range whatever the rest
    QCOMPARE(checks, 2);
    QCOMPARE(document.undoStack().count(), 1);
}

void TestDocument::aThousandStepsShareOneTable() {
    // 1.6 MB of points: a history of copies would hold 3.2 GB.
    QByteArray table("time [us],force [kN]\n");
    for (int i = 0; i < 100000; ++i)
        table += QByteArray::number(i) + "," + QByteArray::number(1 + i % 7) + "\n";
    const QString path = m_folder.filePath(QStringLiteral("long.csv"));
    write(path, table);
    QCOMPARE(m_document->useTable(path), QString());
    const TablePoints points = m_document->scenario().pulse.tablePoints;
    QCOMPARE(points.size(), std::size_t{100000});
    for (int i = 1; i <= 990; ++i)
        QCOMPARE(m_document->assign(parameter("bit_rock.gamma"), 0.1 + i * 1e-4, i), QString());
    // The same points from another file are read into other memory.
    const QString copy = m_folder.filePath(QStringLiteral("copy.csv"));
    write(copy, table);
    QCOMPARE(m_document->useTable(copy), QString());
    QCOMPARE(m_document->undoStack().count(), 992);
    int steps = 0;
    for (; m_document->undoStack().index() > 1; ++steps) {
        QVERIFY(m_document->scenario().pulse.tablePoints.isSharedWith(points));
        m_document->undoStack().undo();
    }
    for (; m_document->undoStack().canRedo(); --steps) {
        QVERIFY(m_document->scenario().pulse.tablePoints.isSharedWith(points));
        m_document->undoStack().redo();
    }
    QCOMPARE(steps, 0);
    QVERIFY(m_document->scenario().pulse.tablePoints.isSharedWith(points));
}

void TestDocument::aPresetLeavesItsSourcesInTheFile() {
    const auto preset = std::ranges::find(builtInPresets(), "T45, round 46 mm", &Preset::name);
    QVERIFY(preset != builtInPresets().end());
    const QByteArray before =
        exampleBytes().replace("density: 7850 kg/m^3        # steel", "density: 7850 kg/m^3");
    QCOMPARE(m_document->startFrom(before.toStdString(), QStringLiteral("example")), QString());
    QCOMPARE(m_document->applyPreset(*preset), QString());
    const QByteArray after = m_document->text();
    QVERIFY2(after.contains("  diameter: 46 mm  # preset T45, round 46 mm: nominal"), after);
    // An unchanged value keeps its comment, or has none yet.
    QVERIFY2(after.contains("  youngs_modulus: 210 GPa     # steel\n"), after);
    QVERIFY2(after.contains("  density: 7850 kg/m^3  # preset T45, round 46 mm: steel, usual value\n"),
             after);
    QVERIFY2(after.contains("  length: 3.66 m              # a 12 ft extension rod\n"), after);
    QCOMPARE(m_document->undoStack().count(), 1);
    // Another value is not that of the preset.
    m_document->assign(parameter("rod.diameter"), 0.05, 1);
    QVERIFY2(m_document->text().contains("  diameter: 50 mm\n"), m_document->text());
    m_document->undoStack().undo();
    QCOMPARE(m_document->text(), after);
    m_document->undoStack().undo();
    QCOMPARE(m_document->text(), before);
    QVERIFY(!m_document->isModified());
    m_document->undoStack().redo();
    const QString path = m_folder.filePath(QStringLiteral("preset.yaml"));
    QCOMPARE(m_document->save(path), QString());
    QCOMPARE(read(path), after);
    Document again;
    QCOMPARE(again.open(path), QString());
    QCOMPARE(again.scenario(), m_document->scenario());
}

// One comment would be about all of them.
void TestDocument::valuesInBracesGetNoComments() {
    const auto preset = std::ranges::find(builtInPresets(), "hard rock", &Preset::name);
    QVERIFY(preset != builtInPresets().end());
    const char text[] =
        "drillwave: 1\nrod: {length: 3 m, diameter: 38 mm, youngs_modulus: 210 GPa, density: 7850 "
        "kg/m^3}\npulse: {shape: rectangular, duration: 200 us, "
        "impulse: 51 N s}\nbit_rock: {stiffness: 105 MN/m, gamma: 0.1}  # mine\n";
    QCOMPARE(m_document->startFrom(text, QStringLiteral("braces")), QString());
    QCOMPARE(m_document->applyPreset(*preset), QString());
    QVERIFY2(!m_document->text().contains("preset"), m_document->text());
    QVERIFY2(m_document->text().contains("}  # mine\n"), m_document->text());
}

void TestDocument::settingAGroupMovesItsPhysicalParameter() {
    m_document->assign(parameter("beta"), 1.25, 1);
    const Scenario& scenario = m_document->scenario();
    // β = k t0/Z with Z = A √(E ρ), written out here.
    const Rod& rod = scenario.rod;
    const double area = M_PI / 4 * (rod.diameter * rod.diameter - rod.bore * rod.bore);
    const double impedance = area * std::sqrt(rod.youngsModulus * rod.density);
    const double stiffness = 1.25 * impedance / scenario.pulse.duration;
    // 1e-14: a handful of roundings in either formula.
    QVERIFY(std::abs(scenario.bitRock.stiffness / stiffness - 1) < 1e-14);
}

void TestDocument::whatWouldSpoilTheScenarioIsRefused() {
    const Scenario before = m_document->scenario();
    QVERIFY(!m_document->assign(parameter("gamma"), 1.3, 1).isEmpty());
    m_document->assign(parameter("gamma"), 1.3, 1);
    QVERIFY(!m_document->assign(parameter("rod.bore"), 0.05, 1).isEmpty());  // wider than the rod
    m_document->assign(parameter("rod.bore"), 0.05, 1);
    m_document->setShape(PulseShape::table);  // there are no points
    QVERIFY(m_document->scenario() == before);
    QCOMPARE(m_document->undoStack().count(), 0);
}

void TestDocument::optionalParametersCanBeCleared() {
    QVERIFY(m_document->scenario().drill.thrust);
    m_document->clear(parameter("drill.thrust"), 1);
    QVERIFY(!m_document->scenario().drill.thrust);
    QVERIFY(!m_document->text().contains("thrust: 8 kN"));
    m_document->undoStack().undo();
    QCOMPARE(m_document->text(), exampleBytes());
}

void TestDocument::savingMakesTheDocumentClean() {
    const QString path = m_folder.filePath(QStringLiteral("saved.yaml"));
    m_document->assign(parameter("rod.length"), 5, 1);
    QVERIFY(m_document->isModified());
    QCOMPARE(m_document->save(path), QString());
    QVERIFY(!m_document->isModified());
    QCOMPARE(read(path), m_document->text());
    Document second;
    QCOMPARE(second.open(path), QString());
    QVERIFY(second.scenario() == m_document->scenario());
    m_document->undoStack().undo();
    QVERIFY(m_document->isModified());
}

void TestDocument::aFailedSaveIsReportedAndLosesNothing() {
    const QString blocked = m_folder.filePath(QStringLiteral("file"));
    write(blocked, "not a folder");
    m_document->assign(parameter("rod.length"), 5, 1);
    for (const QString& path :
         {blocked + QStringLiteral("/a.yaml"), m_folder.filePath(QStringLiteral("none/a.yaml"))}) {
        const QString problem = m_document->save(path);
        QVERIFY2(problem.contains(QStringLiteral("a.yaml")), qPrintable(problem));
        QVERIFY(m_document->isModified());
        QCOMPARE(m_document->path(), QString());
        QCOMPARE(m_document->scenario().rod.length, 5.0);
    }
    QCOMPARE(read(blocked), QByteArray("not a folder"));
}

void TestDocument::aFileThatCannotBeReadChangesNothing() {
    const QString path = m_folder.filePath(QStringLiteral("wrong.yaml"));
    write(path,
          "drillwave: 1\ndimensionless: {beta: 1, gamma: 1.3, tau: 10, delta: 0}\npulse: {shape: "
          "rectangular}\n");
    m_document->assign(parameter("rod.length"), 5, 1);
    const Scenario before = m_document->scenario();
    const QString problem = m_document->open(path);
    QVERIFY2(problem.contains(QStringLiteral("wrong.yaml:2:")), qPrintable(problem));
    QVERIFY2(problem.contains(QStringLiteral("gamma")), qPrintable(problem));
    QVERIFY(!m_document->open(m_folder.filePath(QStringLiteral("none.yaml"))).isEmpty());
    QVERIFY(m_document->scenario() == before);
    QVERIFY(m_document->isModified());
}

void TestDocument::savingElsewhereKeepsTheTableInReach() {
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("a")));
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("b")));
    write(m_folder.filePath(QStringLiteral("a/blow.csv")), "time [us],force [kN]\n0,0\n100,300\n200,0\n");
    write(m_folder.filePath(QStringLiteral("a/s.yaml")),
          "drillwave: 1\n"
          "rod: {length: 3 m, diameter: 38 mm, youngs_modulus: 210 GPa, density: 7850 kg/m^3}\n"
          "pulse: {shape: table, file: blow.csv}\n"
          "bit_rock: {stiffness: 100 MN/m, gamma: 0.5, gap: 0 mm}\n");
    QCOMPARE(m_document->open(m_folder.filePath(QStringLiteral("a/s.yaml"))), QString());
    QCOMPARE(m_document->save(m_folder.filePath(QStringLiteral("b/s.yaml"))), QString());
    Document moved;
    QCOMPARE(moved.open(m_folder.filePath(QStringLiteral("b/s.yaml"))), QString());
    QVERIFY(moved.scenario().pulse.tablePoints == m_document->scenario().pulse.tablePoints);
}

void TestDocument::aResultIsOpenedWithoutAPath() {
    const QString path = m_folder.filePath(QStringLiteral("histories.csv"));
    QByteArray header;
    for (const QByteArray& line : exampleBytes().split('\n')) header += "# " + line + '\n';
    write(path, header + "time,impact_force\n0,0\n");
    Document document;
    QCOMPARE(document.open(path), QString());
    QVERIFY(document.scenario() == m_document->scenario());
    QCOMPARE(document.path(), QString());
    QCOMPARE(document.suggestedPath(), m_folder.filePath(QStringLiteral("histories.yaml")));
    QVERIFY(!document.isModified());
    const QString table = m_folder.filePath(QStringLiteral("table.csv"));
    write(table, "time,force\n0,0\n1,1\n");
    QVERIFY(document.open(table).contains(QStringLiteral("holds no scenario")));
}

void TestDocument::wordsOfAnExampleDoNotOutliveItsValues() {
    const std::string title = m_document->scenario().title;
    QVERIFY(m_document->text().startsWith("#"));
    const double stiffness = m_document->scenario().bitRock.stiffness;
    m_document->assign(parameter("bit_rock.stiffness"), 333e6, 1);
    QCOMPARE(m_document->scenario().title, title + ", changed");
    QVERIFY2(m_document->text().startsWith("drillwave:"), m_document->text().left(60));
    QVERIFY(m_document->isChangedExample());
    // Saved, it still is none.
    QCOMPARE(m_document->save(m_folder.filePath("changed.yaml")), QString());
    QVERIFY(m_document->isChangedExample());
    m_document->assign(parameter("bit_rock.stiffness"), stiffness, 2);
    QCOMPARE(m_document->scenario().title, title);
    QCOMPARE(m_document->text(), exampleBytes());
    // A title by somebody else stays.
    QCOMPARE(m_document->open(m_folder.filePath("changed.yaml")), QString());
    m_document->assign(parameter("bit_rock.stiffness"), 222e6, 3);
    QCOMPARE(m_document->scenario().title, title + ", changed");
    m_document->setTitle("mine");
    m_document->assign(parameter("bit_rock.stiffness"), 223e6, 4);
    QCOMPARE(m_document->scenario().title, std::string("mine"));
}

void TestDocument::aNewFileIsNamedAfterItsTitle() {
    Document document;
    QCOMPARE(document.suggestedPath(), QStringLiteral("scenario.yaml"));
    const auto named = [&](const QString& title) {
        document.setTitle(title);
        return document.suggestedPath();
    };
    QCOMPARE(named(QStringLiteral("T38 rod, medium rock")), QStringLiteral("t38_rod_medium_rock.yaml"));
    QCOMPARE(named(QStringLiteral("../a/b: 50 % …")), QStringLiteral("a_b_50.yaml"));
    QCOMPARE(named(QStringLiteral("Gestänge ⌀38")), QStringLiteral("gestänge_38.yaml"));
    QCOMPARE(named(QStringLiteral("?!")), QStringLiteral("scenario.yaml"));
    QVERIFY(named(QString(500, QLatin1Char('x'))).size() < 100);
}

void TestDocument::aReloadIsAStepThatCanBeUndone() {
    const QString path = m_folder.filePath(QStringLiteral("reloaded.yaml"));
    QCOMPARE(m_document->save(path), QString());
    m_document->assign(parameter("rod.length"), 5, 1);
    QByteArray outside = exampleBytes();
    outside.replace("length: 3.66 m ", "length: 7 m    ");
    write(path, outside);
    QCOMPARE(m_document->reload(), QString());
    QCOMPARE(m_document->scenario().rod.length, 7.0);
    QCOMPARE(m_document->text(), outside);
    QVERIFY(!m_document->isModified());
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario().rod.length, 5.0);
    QVERIFY(m_document->isModified());
    write(path, "rubbish");
    QVERIFY(m_document->reload().contains(QStringLiteral("reloaded.yaml")));
    QCOMPARE(m_document->scenario().rod.length, 5.0);
}

void TestDocument::aRestoredScenarioIsUnsavedAndHasNoPath() {
    const QString origin = m_folder.filePath(QStringLiteral("original.yaml"));
    m_document->assign(parameter("rod.length"), 5, 1);
    Document restored;
    QCOMPARE(restored.restore(m_document->text().toStdString(), origin), QString());
    QCOMPARE(restored.text(), m_document->text());
    QVERIFY(restored.isModified());
    QCOMPARE(restored.path(), QString());
    QCOMPARE(restored.suggestedPath(), origin);
    QVERIFY(!QFile::exists(origin));
    QVERIFY(!restored.undoStack().canUndo());
    QVERIFY(!restored.restore("rubbish", origin).isEmpty());
    QCOMPARE(restored.text(), m_document->text());
}

void TestDocument::aHammerBlowIsTakenFromATable() {
    const QString table = m_folder.filePath(QStringLiteral("hammer.csv"));
    write(table, "time [us],force [kN]\n0,0\n100,300\n200,0\n");
    const Scenario before = m_document->scenario();
    QCOMPARE(m_document->useTable(table), QString());
    QCOMPARE(m_document->scenario().pulse.shape, PulseShape::table);
    QCOMPARE(m_document->scenario().pulse.tablePoints.size(), size_t(3));
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY(m_document->undoStack().undoText().contains(QStringLiteral("hammer.csv")));
    // The file that is saved finds its table again.
    const QString path = m_folder.filePath(QStringLiteral("hammered.yaml"));
    QCOMPARE(m_document->save(path), QString());
    Document second;
    QCOMPARE(second.open(path), QString());
    QVERIFY(second.scenario().pulse.tablePoints == m_document->scenario().pulse.tablePoints);
    m_document->undoStack().undo();
    QVERIFY(m_document->scenario() == before);
}

void TestDocument::aTableThatIsNoneChangesNothing() {
    const QString table = m_folder.filePath(QStringLiteral("bad.csv"));
    write(table, "time [us],force [kN]\n0,0\n100,300\n50,0\n");
    const Scenario before = m_document->scenario();
    const QString problem = m_document->useTable(table);
    QVERIFY2(problem.contains(QStringLiteral("bad.csv:4")), qPrintable(problem));
    QVERIFY(!m_document->useTable(m_folder.filePath(QStringLiteral("none.csv"))).isEmpty());
    QVERIFY(m_document->scenario() == before);
    QCOMPARE(m_document->undoStack().count(), 0);
}

// Reading takes at most 1 MiB, so nothing larger may be written.
void TestDocument::aScenarioTooLargeForAFileIsReported() {
    const QString path = m_folder.filePath(QStringLiteral("large.yaml"));
    m_document->setTitle(QString(2 << 20, QLatin1Char('x')));
    const QString problem = m_document->save(path);
    QVERIFY2(problem.contains(QStringLiteral("large.yaml")), qPrintable(problem));
    QVERIFY(!QFile::exists(path));
    QVERIFY(m_document->isModified());
}

void TestDocument::savingKeepsLinksAndPermissions() {
    const QString path = m_folder.filePath(QStringLiteral("shared.yaml"));
    const QString link = m_folder.filePath(QStringLiteral("link.yaml"));
    write(path, exampleBytes());
    const QFile::Permissions permissions = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup;
    QVERIFY(QFile::setPermissions(path, permissions));
    const QFile::Permissions before = QFile::permissions(path);
    QVERIFY(QFile::link(path, link));
    QCOMPARE(m_document->open(link), QString());
    m_document->assign(parameter("rod.length"), 5, 1);
    QCOMPARE(m_document->save(link), QString());
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(read(path), m_document->text());
    QCOMPARE(QFile::permissions(path), before);
}

void TestDocument::aReadOnlyFileIsNotSavedOver() {
    const QString path = m_folder.filePath(QStringLiteral("readonly.yaml"));
    write(path, "kept");
    QVERIFY(QFile::setPermissions(path, QFile::ReadOwner));
    if (QFileInfo(path).isWritable()) QSKIP("the superuser may write everything");
    const QString problem = m_document->save(path);
    QVERIFY2(problem.contains(QStringLiteral("readonly.yaml")), qPrintable(problem));
    QCOMPARE(read(path), QByteArray("kept"));
}

// The limit on the size of files stands for the end of the disk: a write stops short in the same way.
void TestDocument::aFullDiskLosesNothing() {
    const QString path = m_folder.filePath(QStringLiteral("full.yaml"));
    write(path, "the file before");
    m_document->assign(parameter("rod.length"), 5, 1);
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{100, before.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    const QString problem = m_document->save(path);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
    QVERIFY2(problem.contains(QStringLiteral("full.yaml")), qPrintable(problem));
    QVERIFY(m_document->isModified());
    QCOMPARE(read(path), QByteArray("the file before"));
    QCOMPARE(m_document->save(path), QString());
    QCOMPARE(read(path), m_document->text());
}

void TestDocument::whatIsNoScenarioChangesNothing_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    QTest::newRow("huge") << QByteArray(3 << 20, 'a') << QStringLiteral("larger than 1024 KiB");
    QTest::newRow("binary") << QByteArray(
                                   "\x7f"
                                   "ELF\0\1\2",
                                   7)
                            << QStringLiteral("is not a text file");
    QTest::newRow("empty") << QByteArray() << QStringLiteral("the file is empty");
}

void TestDocument::whatIsNoScenarioChangesNothing() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    const QString path = m_folder.filePath(QStringLiteral("junk.yaml"));
    write(path, bytes);
    m_document->assign(parameter("rod.length"), 5, 1);
    const Scenario before = m_document->scenario();
    const QString problem = m_document->open(path);
    QVERIFY2(problem.contains(says), qPrintable(problem));
    QCOMPARE(problem.count(QLatin1Char('\n')), 0);
    QVERIFY(m_document->scenario() == before);
    QVERIFY(m_document->isModified());
}

QTEST_MAIN(TestDocument)
#include "tst_document.moc"

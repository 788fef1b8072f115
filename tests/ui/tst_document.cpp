#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/file/examples.h"
#include "core/model/scales.h"
#include "ui/document.h"

using namespace drillwave;

namespace {

const Parameter& parameter(std::string_view key) {
    return *findParameter(key);
}

QByteArray exampleBytes() {
    return QByteArray(defaultExample().text.data(), static_cast<qsizetype>(defaultExample().text.size()));
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

}  // namespace

class TestDocument : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void undoOfManyEditsRestoresTheBytesOfTheFile();
    void editsOfOneGestureAreOneNamedStep();
    void anEditThatComesBackLeavesNoStep();
    void settingAGroupMovesItsPhysicalParameter();
    void whatWouldSpoilTheScenarioIsRefused();
    void optionalParametersCanBeCleared();
    void savingMakesTheDocumentClean();
    void aFailedSaveIsReportedAndLosesNothing();
    void aFileThatCannotBeReadChangesNothing();
    void savingElsewhereKeepsTheTableInReach();

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
    QVERIFY(!m_document->whyNot(parameter("gamma"), 1.3).isEmpty());
    m_document->assign(parameter("gamma"), 1.3, 1);
    QVERIFY(!m_document->whyNot(parameter("rod.bore"), 0.05).isEmpty());  // wider than the rod
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
    QCOMPARE(bytesOf(path), m_document->text());
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
    QCOMPARE(bytesOf(blocked), QByteArray("not a folder"));
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

QTEST_MAIN(TestDocument)
#include "tst_document.moc"

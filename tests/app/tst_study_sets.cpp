// SPDX-License-Identifier: GPL-3.0-or-later
// Rows, record, contours and pictures of a study, and the files of a report, are of one run, whoever else
// writes there and whenever a run is ended. DRILLWAVE_TRIAL=200 tries that many rounds and signals instead of
// a few.
#include <QTest>

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <csignal>
#include <memory>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/tries.h"

using namespace drillwave::test;

namespace {

constexpr int writers = 4;

/// Names and bytes of all that is visible in a folder.
using Set = QMap<QString, QByteArray>;

Set setIn(const QString& folder) {
    Set set;
    for (const QString& name : QDir(folder).entryList(QDir::Files, QDir::Name)) {
        // One of another run may replace it between the look and the reading.
        QFile file(folder + "/" + name);
        if (file.open(QIODevice::ReadOnly)) set[name] = file.readAll();
    }
    return set;
}

QStringList hiddenIn(const QString& folder) {
    return QDir(folder).entryList({".*"}, QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

/// PDF without the time of day.
QProcessEnvironment environment() {
    QProcessEnvironment fixed = QProcessEnvironment::systemEnvironment();
    fixed.insert("SOURCE_DATE_EPOCH", "0");
    return fixed;
}

/// One kind of set: how it is made, by which writer, and in which place of a folder.
struct Kind {
    QStringList words;
    QString main;  ///< the file of -o; empty: the folder itself

    QStringList wordsOf(int writer, const QString& folder) const {
        return words +
               QStringList{"--set", QString("gamma=0.%1").arg(2 * writer + 1), "-o", folder + "/" + main};
    }
};

void addKinds() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("main");
    const QString drill = example("t38_medium_rock");
    QTest::newRow("sweep") << QStringList{"sweep", drill, "--vary", "rod.length=3m:6m:20"} << "x.csv";
    QTest::newRow("map with contours and plots") << QStringList{"map",      drill,
                                                                "--x",      "rod.length=3m:6m:5",
                                                                "--y",      "bit_rock.gap=0mm:1mm:5",
                                                                "--level",  "0.4",
                                                                "--plots",  "png,svg,pdf",
                                                                "--output", "cor"}
                                                 << "x.csv";
    QTest::newRow("report") << QStringList{"report", drill} << "";
}

std::unique_ptr<QProcess> started(const QStringList& words) {
    auto process = std::make_unique<QProcess>();
    process->setProcessEnvironment(environment());
    process->start(QStringLiteral(DRILLWAVE_PROGRAM), words);
    return process;
}

/// Returns the sets that each writer makes without company.
const std::vector<Set>& setsOf(const Kind& kind) {
    static QMap<QStringList, std::vector<Set>> made;
    std::vector<Set>& sets = made[kind.words];
    if (!sets.empty()) return sets;
    for (int writer = 0; writer < writers; ++writer) {
        const QTemporaryDir place;
        const Finished alone = run(kind.wordsOf(writer, place.path()), environment());
        if (alone.exitCode != 0) qFatal("%s", alone.error.constData());
        sets.push_back(setIn(place.path()));
    }
    return sets;
}

/// Whether all of it is in the other one, with the same bytes.
bool isPartOf(const Set& some, const Set& all) {
    for (auto file = some.begin(); file != some.end(); ++file)
        if (all.value(file.key(), "none") != file.value()) return false;
    return true;
}

}  // namespace

class TestStudySets : public QObject {
    Q_OBJECT

  private slots:
    void oneOfFourWritersSucceeds_data() { addKinds(); }
    void oneOfFourWritersSucceeds() { tryWriters({}); }
    void forcedWritersNeverMix_data() { addKinds(); }
    void forcedWritersNeverMix() { tryWriters({"--force"}); }
    void aSignalNeverLeavesHalfOfTwoRuns_data() { addKinds(); }
    void aSignalNeverLeavesHalfOfTwoRuns();
    void whatAnOlderRunLeftBesideGoes_data();
    void whatAnOlderRunLeftBesideGoes();
    void filesOfOthersStay();
    void aLinkIsFollowedByTheWholeSet();

  private:
    void tryWriters(const QStringList& more);
};

void TestStudySets::tryWriters(const QStringList& more) {
    QFETCH(QStringList, words);
    QFETCH(QString, main);
    const Kind kind{words, main};
    const std::vector<Set>& sets = setsOf(kind);
    for (int round = 0, rounds = tries("DRILLWAVE_TRIAL", 1, 2); round < rounds; ++round) {
        const QTemporaryDir place;
        std::vector<std::unique_ptr<QProcess>> runs;
        for (int writer = 0; writer < writers; ++writer)
            runs.push_back(started(kind.wordsOf(writer, place.path()) + more));
        QList<int> codes;
        for (const auto& one : runs) {
            QVERIFY(one->waitForFinished(60000));
            codes << one->exitCode();
        }
        const auto winner = std::find(sets.begin(), sets.end(), setIn(place.path()));
        QVERIFY2(winner != sets.end(), "files of several runs");
        QCOMPARE(hiddenIn(place.path()), QStringList());
        if (more.isEmpty()) {
            QCOMPARE(codes.count(0), 1);
            QCOMPARE(codes.count(4), writers - 1);
            QCOMPARE(codes[winner - sets.begin()], 0);
        } else {
            QCOMPARE(codes.count(0), writers);
        }
    }
}

void TestStudySets::aSignalNeverLeavesHalfOfTwoRuns() {
    QFETCH(QStringList, words);
    QFETCH(QString, main);
    const Kind kind{words, main};
    const std::vector<Set>& sets = setsOf(kind);
    const QTemporaryDir place;
    QRandomGenerator random(38);
    int ended = 0;
    // More signals where each of them came too late, as on a machine that was slow for a moment.
    const int signals_ = tries("DRILLWAVE_TRIAL", 5);
    for (int i = 0; i < signals_ || (ended == 0 && i < 4 * signals_); ++i) {
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(run(kind.wordsOf(0, place.path()) + QStringList{"--force"}, environment()).exitCode, 0);
        const qint64 whole = timer.nsecsElapsed() / 1000;
        QVERIFY(setIn(place.path()) == sets[0]);
        const auto process = started(kind.wordsOf(1, place.path()) + QStringList{"--force"});
        QVERIFY(process->waitForStarted());
        // Every second time at the end, where files change places.
        const qint64 at = i % 2 ? random.bounded(whole) : whole * 3 / 4 + random.bounded(whole / 2);
        QTest::qWait(0);
        ::usleep(static_cast<useconds_t>(at));
        const int signal = std::array{SIGKILL, SIGINT, SIGHUP, SIGTERM}[i % 4];
        ::kill(static_cast<pid_t>(process->processId()), signal);
        QVERIFY(process->waitForFinished(60000));
        const bool byItself = process->exitStatus() == QProcess::NormalExit;
        const bool isDone = byItself && process->exitCode() == 0;
        ended += !isDone;
        const Set left = setIn(place.path());
        QVERIFY2(isPartOf(left, sets[0]) || isPartOf(left, sets[1]), "files of two runs");
        if (!main.isEmpty() && left.contains(main))
            QVERIFY2(left == sets[0] || left == sets[1], "a file without what belongs to it");
        if (isDone) QVERIFY(left == sets[1]);
        if (byItself && !isDone) QCOMPARE(process->exitCode(), 130);
        // The next run mends, whether it may overwrite or not.
        QCOMPARE(run(kind.wordsOf(2, place.path()), environment()).exitCode, 4);
        const Set mended = setIn(place.path());
        QVERIFY2(mended == sets[0] || mended == sets[1], "not mended");
        QCOMPARE(hiddenIn(place.path()), QStringList());
    }
    QVERIFY(ended > 0);
}

void TestStudySets::whatAnOlderRunLeftBesideGoes_data() {
    QTest::addColumn<QStringList>("older");
    QTest::addColumn<QStringList>("newer");
    QTest::addColumn<QStringList>("left");
    const QString drill = example("t38_medium_rock");
    const QStringList map{"map", drill,        "--x", "gamma=0.1:1:4", "--y", "rod.length=3m:6m:4",
                          "-o",  "PLACE/x.csv"};
    const QStringList sweep{"sweep", drill, "--vary", "gamma=0.1:1:4", "-o", "PLACE/x.csv"};
    QTest::newRow("map without levels and plots")
        << map + QStringList{"--level", "0.5", "--plots", "png,svg,pdf"} << map
        << QStringList{"x.csv", "x.csv.yaml"};
    QTest::newRow("sweep without plots")
        << sweep + QStringList{"--plots", "png"} << sweep << QStringList{"x.csv", "x.csv.yaml"};
    QTest::newRow("gap, which has no record")
        << map + QStringList{"--level", "0.5", "--plots", "png"}
        << QStringList{"gap", drill, "-o", "PLACE/x.csv", "--plots", "svg"} << QStringList{"x.csv", "x.svg"};
    const QStringList figures{"figures", "-o", "PLACE", "--plots"};
    QTest::newRow("figures in other formats")
        << figures + QStringList{"png,svg"} << figures + QStringList{"svg"}
        << QStringList{"discrepancies.csv", "fig3.svg", "fig3a.csv", "fig3b.csv", "fig4.svg",  "fig4a.csv",
                       "fig4b.csv",         "fig5.svg", "fig5a.csv", "fig5b.csv", "fig6.csv",  "fig6.svg",
                       "fig7.csv",          "fig7.svg", "fig8.csv",  "fig8.svg",  "index.html"};
    QTest::newRow("report, page") << QStringList{"report", drill, "-o", "PLACE/"}
                                  << QStringList{"report", drill, "-o", "PLACE/report.html"}
                                  << QStringList{"report.html"};
    QTest::newRow("report, PDF") << QStringList{"report", drill, "-o", "PLACE/"}
                                 << QStringList{"report", drill, "-o", "PLACE/report.pdf"}
                                 << QStringList{"report.pdf"};
}

void TestStudySets::whatAnOlderRunLeftBesideGoes() {
    QFETCH(QStringList, older);
    QFETCH(QStringList, newer);
    QFETCH(QStringList, left);
    const QTemporaryDir place;
    for (QStringList* words : {&older, &newer}) words->replaceInStrings("PLACE", place.path());
    QCOMPARE(run(older).exitCode, 0);
    const Set before = setIn(place.path());
    QCOMPARE(run(newer).exitCode, 4);
    QVERIFY(setIn(place.path()) == before);
    QCOMPARE(run(newer + QStringList{"--force"}).exitCode, 0);
    QCOMPARE(QStringList(setIn(place.path()).keys()), left);
}

void TestStudySets::filesOfOthersStay() {
    const QTemporaryDir place;
    write(place.filePath("x.png"), "drawn by hand");
    write(place.filePath("x_contours.csv"), "of the ground");
    const QString report = place.filePath("x.pdf");
    QCOMPARE(run({"report", example("t38_medium_rock"), "-o", report}).exitCode, 0);
    const QByteArray page = read(report);
    for (const char* gamma : {"0.3", "0.7"})
        QCOMPARE(run({"sweep", example("t38_medium_rock"), "--vary", "rod.length=3m,4m", "--set",
                      QString("gamma=%1").arg(gamma), "-o", place.filePath("x.csv"), "--force"})
                     .exitCode,
                 0);
    QCOMPARE(read(place.filePath("x.png")), QByteArray("drawn by hand"));
    QCOMPARE(read(place.filePath("x_contours.csv")), QByteArray("of the ground"));
    QVERIFY(read(report) == page);
    // A page and a PDF of one blow, made one after the other, stay side by side.
    QCOMPARE(run({"report", example("t38_medium_rock"), "-o", place.filePath("x.html")}).exitCode, 0);
    QVERIFY(read(report) == page);
}

void TestStudySets::aLinkIsFollowedByTheWholeSet() {
    const QTemporaryDir place;
    QVERIFY(QDir(place.path()).mkdir("data"));
    QVERIFY(QFile::link("data/x.csv", place.filePath("link.csv")));
    const QStringList words{"sweep", example("t38_medium_rock"), "--vary", "gamma=0.1,0.2",
                            "-o",    place.filePath("link.csv"), "--force"};
    QCOMPARE(run(words).exitCode, 0);
    QVERIFY(QFileInfo(place.filePath("link.csv")).isSymLink());
    QCOMPARE(QStringList(setIn(place.filePath("data")).keys()), QStringList({"x.csv", "x.csv.yaml"}));
}

QTEST_GUILESS_MAIN(TestStudySets)
#include "tst_study_sets.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// `drillwave join`: parts of rows put together are the rows in one piece, or there is a reason why not.
#include <QTest>

#include <QDir>
#include <QTemporaryDir>
#include <random>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

/// The command, its words, and how many parts.
QStringList sweepOf(const char* beta = "0.1:10:5:log") {
    // A title that looks like the option.
    return {
        "sweep",     example("paper_fig4b"),         "--vary", QString("beta=%1").arg(beta), "delta=0:1:7",
        "--outputs", "cor,peak_force,thrust_margin", "--set",  "title=it's a --shard 2/3"};
}

}  // namespace

class TestJoin : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }
    void partsAreTheWholeByteForByte_data();
    void partsAreTheWholeByteForByte();
    void partsThatAreNoWholeAreNamed();
    void aFolderIsItsParts();
    void unsolvedRowsAreStillUnsolved();
    void partsOfAnEditedTableAreNamed();
    void damagedPartsAreNeverJoined();
    void partsOfAnotherRunAreNamed_data();
    void partsOfAnotherRunAreNamed();
    void partsThatCannotBeReadAreNamed();
    void anOutputIsNeverAPart();
    void aPartOfAMapIsRowsAlone_data();
    void aPartOfAMapIsRowsAlone();

  private:
    QString path(const QString& name) const { return m_place->filePath(name); }
    QString part(int index) const { return path(QString("part%1.csv").arg(index)); }
    /// Writes it as part(index).
    void writePart(const QStringList& words, int index, int count) const {
        output(words + QStringList{"--shard", QString("%1/%2").arg(index).arg(count), "-o", part(index)});
    }
    QStringList joinOf(std::initializer_list<int> parts) const {
        QStringList words{"join"};
        for (const int index : parts) words << part(index);
        return words << "-o" << path("all.csv");
    }
    std::unique_ptr<QTemporaryDir> m_place;
};

void TestJoin::partsAreTheWholeByteForByte_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("sweep") << (sweepOf().mid(0, 6) << "cor,peak_force" << sweepOf().mid(7));
    QTest::newRow("map") << QStringList{"map", example("t38_medium_rock"), "--x",      "gamma=0.1:1:5",
                                        "--y", "rod.length=3m:6m:7",       "--output", "peak_force",
                                        "--si"};
    QTest::newRow("table with quoted line feeds")
        << QStringList{"table", example("paper_fig4a"), "CASES", "--method", "lattice", "--segments", "200"};
}

void TestJoin::partsAreTheWholeByteForByte() {
    QFETCH(QStringList, words);
    QByteArray cases = "beta,remark\n";
    for (int i = 1; i <= 11; ++i) cases += QByteArray::number(i) + ",\"two\nlines, \"\"said\"\"\"\n";
    write(path("cases.csv"), cases);
    words.replaceInStrings("CASES", path("cases.csv"));
    output(words + QStringList{"-o", path("whole.csv")});
    for (int index = 1; index <= 4; ++index) writePart(words, index, 4);
    const Finished joined = run(joinOf({3, 1, 4, 2}));
    QVERIFY2(joined.exitCode == 0, joined.error);
    QVERIFY(read(path("all.csv")) == read(path("whole.csv")));
    QCOMPARE(QString::fromUtf8(read(path("all.csv.yaml"))), QString::fromUtf8(read(path("whole.csv.yaml"))));
    QVERIFY(output({"join", part(1), part(2), part(3), part(4), "-o", "-"}) == read(path("whole.csv")));
    QCOMPARE(run(joinOf({1, 2, 3, 4})).exitCode, 4);
    QCOMPARE(run(joinOf({1, 2, 3, 4}) + QStringList{"--force"}).exitCode, 0);
}

void TestJoin::partsThatAreNoWholeAreNamed() {
    for (int index = 1; index <= 4; ++index) writePart(sweepOf().mid(0, 5), index, 4);
    const auto refusal = [&](const QStringList& words) {
        const Finished finished = run(words);
        return finished.exitCode == 5 && !QFile::exists(path("all.csv")) ? finished.error : "not refused";
    };
    QCOMPARE(refusal(joinOf({1, 4})),
             QByteArray("parts 2, 3 of 4 are missing; run them, or name their files\n"));
    const QByteArray twice = refusal(joinOf({1, 2, 3, 4, 3}));
    QVERIFY2(twice.contains("part3.csv: is part 3 of 4, as "), twice);
    // Lines are lost without the record being touched.
    QByteArray rows = read(part(2));
    write(part(2), rows.left(rows.lastIndexOf('\n', -2) + 1));
    const QByteArray shorter = refusal(joinOf({1, 2, 3, 4}));
    QVERIFY2(shorter.contains("part2.csv: differs from its record"), shorter);
}

void TestJoin::aFolderIsItsParts() {
    const QDir parts(path("parts"));
    QVERIFY(parts.mkpath("."));
    const QStringList words = sweepOf().mid(0, 5);
    output(words + QStringList{"-o", parts.filePath("whole.csv")});
    for (int index = 1; index <= 3; ++index)
        output(words + QStringList{"--shard", QString("%1/3").arg(index), "-o",
                                   parts.filePath(QString("p%1.csv").arg(index))});
    output({"join", parts.path(), "-o", path("all.csv")});
    QVERIFY(read(path("all.csv")) == read(parts.filePath("whole.csv")));
    // `p*` names the records too.
    QStringList all{"join"};
    for (const QString& file : parts.entryList({"p*"}, QDir::Files)) all << parts.filePath(file);
    QCOMPARE(all.size(), 7);
    QVERIFY(output(all + QStringList{"-o", "-"}) == read(parts.filePath("whole.csv")));
    QVERIFY(QDir(path(".")).mkpath("none"));
    const Finished none = run({"join", path("none"), "-o", path("x.csv")});
    QCOMPARE(none.exitCode, 3);
    QVERIFY2(none.error.contains("none: has no parts of --shard"), none.error);
}

void TestJoin::unsolvedRowsAreStillUnsolved() {
    const QStringList words{"sweep", example("paper_fig4b"), "--vary", "beta=1,1e-300,2,3"};
    const Finished whole = run(words + QStringList{"-o", path("whole.csv")});
    QCOMPARE(whole.exitCode, 6);
    for (int index = 1; index <= 2; ++index)
        run(words + QStringList{"--shard", QString("%1/2").arg(index), "-o", part(index)});
    const Finished joined = run(joinOf({1, 2}));
    QCOMPARE(joined.exitCode, 6);
    QVERIFY2(joined.error.contains("1 of 4 rows could not be solved"), joined.error);
    QVERIFY(read(path("all.csv")) == read(path("whole.csv")));
    QCOMPARE(read(path("all.csv.yaml")), read(path("whole.csv.yaml")));
}

void TestJoin::partsOfAnEditedTableAreNamed() {
    write(path("cases.csv"), "beta\n1\n2\n3\n4\n");
    const QStringList words{"table", example("paper_fig4b"), path("cases.csv")};
    writePart(words, 1, 2);
    write(path("cases.csv"), "beta\n1\n2\n3\n9\n");
    writePart(words, 2, 2);
    const Finished refused = run(joinOf({1, 2}));
    QCOMPARE(refused.exitCode, 5);
    QVERIFY2(refused.error.contains("its cases_crc32 differs"), refused.error);
}

void TestJoin::damagedPartsAreNeverJoined() {
    const int trials = std::max(40, qEnvironmentVariableIntValue("DRILLWAVE_JOIN_TRIALS"));
    const QStringList words{"sweep", example("paper_fig4b"), "--vary", "beta=0.1:10:20:log"};
    output(words + QStringList{"-o", path("whole.csv")});
    QList<QByteArray> files;
    for (int index = 1; index <= 3; ++index) {
        writePart(words, index, 3);
        files << read(part(index)) << read(part(index) + ".yaml");
    }
    std::mt19937 random(55);
    const auto below = [&](qsizetype end) {
        return static_cast<qsizetype>(random() % static_cast<quint64>(end));
    };
    int joined = 0;
    for (int trial = 0; trial < trials; ++trial) {
        QList<QByteArray> damaged = files;
        for (int n = 1 + static_cast<int>(random() % 2); n > 0; --n) {
            QByteArray& file = damaged[below(damaged.size())];
            const qsizetype at = below(file.size());
            switch (random() % 7) {
                case 0:
                    file[at] = static_cast<char>(file[at] ^ (1 << random() % 8));
                    break;
                case 1:
                    file.remove(at, 1 + below(20));
                    break;
                case 2:
                    file.insert(at, "hello world");
                    break;
                case 3:
                    file = damaged[below(damaged.size())];
                    break;
                case 4:
                    file.replace("\n", "\r\n");
                    break;
                case 5:
                    file.truncate(at);
                    break;
                default:
                    file[at] = static_cast<char>('0' + random() % 10);
            }
        }
        for (int i = 0; i < 6; ++i) write(part(i / 2 + 1) + (i % 2 == 0 ? "" : ".yaml"), damaged[i]);
        const Finished finished = run(joinOf({1, 2, 3}) + QStringList{"--force"});
        QVERIFY2(finished.exitCode == 0 || finished.exitCode == 3 || finished.exitCode == 5, finished.error);
        if (finished.exitCode != 0) continue;
        ++joined;
        QVERIFY2(read(path("all.csv")) == read(path("whole.csv")), qPrintable(QString::number(trial)));
        QVERIFY(damaged == files);
    }
    QVERIFY(joined < trials / 4);
}

void TestJoin::partsOfAnotherRunAreNamed_data() {
    QTest::addColumn<QStringList>("other");
    QTest::addColumn<int>("count");
    QTest::addColumn<QString>("differs");
    const QStringList same = sweepOf().mid(0, 5);
    QTest::newRow("axes") << sweepOf("0.1:11:5:log").mid(0, 5) << 3 << "axes";
    QTest::newRow("scenario") << same + QStringList{"--set", "gamma=0.9"} << 3 << "scenario";
    QTest::newRow("outputs") << same + QStringList{"--outputs", "impulse"} << 3 << "outputs";
    QTest::newRow("number of parts") << same << 4 << "number of parts";
    QTest::newRow("work limit") << same + QStringList{"--work-limit", "1000"} << 3 << "command";
}

void TestJoin::partsOfAnotherRunAreNamed() {
    QFETCH(QStringList, other);
    QFETCH(int, count);
    QFETCH(QString, differs);
    for (int index = 1; index <= 3; ++index)
        writePart(index == 2 ? other : sweepOf().mid(0, 5), index, index == 2 ? count : 3);
    const Finished refused = run(joinOf({1, 2, 3}));
    QCOMPARE(refused.exitCode, 5);
    QVERIFY2(refused.error.contains("part2.csv: belongs to another run than "), refused.error);
    QVERIFY2(refused.error.contains("its " + differs.toUtf8() + " differs"), refused.error);
    QCOMPARE(refused.error.count('\n'), 1);
}

void TestJoin::partsThatCannotBeReadAreNamed() {
    for (int index = 1; index <= 2; ++index) writePart(sweepOf().mid(0, 5), index, 2);
    const auto refusal = [&] {
        const Finished finished = run(joinOf({1, 2}));
        return finished.exitCode == 3 && finished.error.count('\n') == 1 ? finished.error : "not refused";
    };
    QVERIFY(QFile::rename(part(2), path("away")));
    QVERIFY2(refusal().contains("part2.csv: the part does not exist"), refusal());
    QVERIFY(QFile::rename(path("away"), part(2)));
    QVERIFY(QFile::rename(part(2) + ".yaml", path("away")));
    QVERIFY2(refusal().contains("part2.csv.yaml: cannot be opened"), refusal());
    write(part(2) + ".yaml", "beta: 1\n");
    QVERIFY2(refusal().contains("part2.csv.yaml: is not a record of rows"), refusal());
}

void TestJoin::anOutputIsNeverAPart() {
    for (int index = 1; index <= 2; ++index) writePart(sweepOf().mid(0, 5), index, 2);
    const QByteArray before = read(part(1));
    QCOMPARE(run({"join", part(1), part(2), "-o", part(1), "--force"}).exitCode, 2);
    QVERIFY(read(part(1)) == before);
    QCOMPARE(run({"join", part(1), part(2)}).exitCode, 2);
}

void TestJoin::aPartOfAMapIsRowsAlone_data() {
    QTest::addColumn<QStringList>("more");
    QTest::newRow("no file") << QStringList{};
    QTest::newRow("contours") << QStringList{"-o", "FILE", "--level", "0.5"};
    QTest::newRow("JSON") << QStringList{"-o", "FILE", "--json"};
    QTest::newRow("plots") << QStringList{"-o", "FILE", "--plots", "png"};
}

void TestJoin::aPartOfAMapIsRowsAlone() {
    QFETCH(QStringList, more);
    more.replaceInStrings("FILE", part(1));
    const Finished refused = run(QStringList{"map", example("paper_fig4b"), "--x", "beta=1:2:3", "--y",
                                             "gamma=0.1:1:3", "--shard", "1/2"} +
                                 more);
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.error.contains("--shard"), refused.error);
    QVERIFY(!QFile::exists(part(1)));
}

QTEST_GUILESS_MAIN(TestJoin)
#include "tst_join.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// --decimal-comma: the same table with other signs, of every command that writes CSV.
#include <QTest>

#include <QDir>
#include <QTemporaryDir>
#include <sstream>

#include "core/disk/file_bytes.h"
#include "core/text/csv.h"
#include "tests/support/files.h"
#include "tests/support/program.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Cells of all records behind the lines with the scenario.
QList<QStringList> cellsOf(const QByteArray& csv, char separator) {
    std::istringstream in(csv.toStdString());
    CsvReader reader(in, 1 << 20, separator);
    CsvRecord record;
    QList<QStringList> cells;
    while (reader.next(record)) {
        cells.emplace_back();
        for (const std::string& cell : record.cells) cells.back() << QString::fromStdString(cell);
    }
    return cells;
}

/// Returns the cells with points for the commas of numbers.
QList<QStringList> withPoints(QList<QStringList> cells) {
    for (QStringList& record : cells)
        for (QString& cell : record) {
            bool isNumber = false;
            QString point = cell;
            point.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
            if (isNumber) cell = point;
        }
    return cells;
}

}  // namespace

class TestDecimalComma : public QObject {
    Q_OBJECT

  private slots:
    void everyTableIsTheSameInOtherSigns_data();
    void everyTableIsTheSameInOtherSigns();
    void summaryIsNoTable();
    void partsAndKeptRowsHavePoints();
    void recordsAreOfTheFileAsWritten();
    void withoutAFileItIsRefused();
    void signsOfTextsAreRewrittenPieceByPiece();
};

void TestDecimalComma::everyTableIsTheSameInOtherSigns_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QStringList>("files");  // in the folder of -o; none: -o FILE.csv
    const QString rod = QStringLiteral("t38_medium_rock");
    const auto add = [](const char* name, const QStringList& words, const QStringList& files = {}) {
        QTest::newRow(name) << words << files;
    };
    add("gap", {"gap", rod, "--si"});
    add("thrust", {"thrust", rod, "--along", "drill.thrust=4kN:8kN:3"});
    add("curve", {"curve", rod, "--along", "bit_rock.stiffness=50MN/m:60MN/m"});
    add("map", {"map", rod, "--x", "gamma=0.1:0.2:3", "--y", "beta=0.5:1:3"});
    add("sweep", {"sweep", rod, "--vary", "gamma=0.1:0.2:3", "--outputs", "cor,peak_force", "--si"});
    add("drill", {"drill", rod, "--blows", "20", "--settle", "5"});
    add("scan", {"drill", rod, "--blows", "20", "--settle", "5", "--scan", "drill.thrust=6kN:8kN:2"});
    add("run", {"run", rod}, {"events.csv", "histories.csv"});
    add("design",
        {"design", rod, "--choose", "pulse.duration=150us,200us", "--uncertain",
         "bit_rock.stiffness=50MN/m:200MN/m", "--samples", "32"},
        {"designs.csv", "pareto.csv", "sensitivity.csv", "worst.csv"});
}

void TestDecimalComma::everyTableIsTheSameInOtherSigns() {
    QFETCH(QStringList, words);
    QFETCH(QStringList, files);
    const QTemporaryDir folder;
    const auto write = [&](const QString& name, const QStringList& signs) {
        const QString out = folder.filePath(files.isEmpty() ? name + ".csv" : name);
        const Finished finished = run(words + QStringList{"-o", out} + signs);
        if (finished.exitCode != 0) qWarning("%s", finished.error.constData());
        QList<QByteArray> written;
        if (files.isEmpty()) written << read(out);
        for (const QString& file : files) written << read(QDir(out).filePath(file));
        return written;
    };
    const QList<QByteArray> points = write("points", {}), commas = write("commas", {"--decimal-comma"});
    QCOMPARE(commas.size(), points.size());
    for (qsizetype i = 0; i < points.size(); ++i) {
        const QList<QStringList> cells = cellsOf(points[i], ',');
        QVERIFY(cells.size() > 1);
        QVERIFY(cells.first().size() > 1);
        QCOMPARE(withPoints(cellsOf(commas[i], ';')), cells);
    }
}

void TestDecimalComma::summaryIsNoTable() {
    const QTemporaryDir folder;
    const Finished finished =
        run({"run", "t38_medium_rock", "-o", folder.filePath("blow"), "--decimal-comma"});
    QCOMPARE(finished.exitCode, 0);
    QVERIFY2(finished.out.startsWith("T38 rod, medium rock\n"), finished.out.constData());
}

void TestDecimalComma::partsAndKeptRowsHavePoints() {
    const QTemporaryDir folder;
    for (const QStringList& rows : {QStringList{"--shard", "1/2"}, QStringList{"--resume"}}) {
        const Finished refused = run(QStringList{"sweep", "t38_medium_rock", "--vary", "gamma=0.1:0.2:3",
                                                 "--decimal-comma", "-o", folder.filePath("rows.csv")} +
                                     rows);
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.error.contains("leave out --decimal-comma"), refused.error.constData());
    }
}

/// A record has the checksum of the file beside it, whatever its signs are.
void TestDecimalComma::recordsAreOfTheFileAsWritten() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("blows.csv");
    const Finished finished =
        run({"drill", "t38_medium_rock", "--blows", "20", "--settle", "5", "--decimal-comma", "-o", out});
    QCOMPARE(finished.exitCode, 0);
    const std::string sum = "crc32: \"" + sumOf(read(out).toStdString()).checksum() + "\"";
    QVERIFY2(read(out + ".yaml").contains(sum.c_str()), read(out + ".yaml"));
}

void TestDecimalComma::withoutAFileItIsRefused() {
    const Finished refused = run({"gap", "t38_medium_rock", "--decimal-comma"});
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.error.contains("--decimal-comma applies to files; add -o FILE.csv"),
             refused.error.constData());
}

void TestDecimalComma::signsOfTextsAreRewrittenPieceByPiece() {
    CsvInSigns signs(CsvSigns::commaAndSemicolon);
    QCOMPARE(signs.text("# gap: 0.5, mm\n#\n"), std::string("# gap: 0.5, mm\n#\n"));
    QCOMPARE(signs.text("gap [mm],\"a, b\",name\n0.5,-1e-05,x;y\n"),
             std::string("gap [mm];\"a, b\";name\n0,5;-1e-05;\"x;y\"\n"));
    QCOMPARE(signs.text("#1.5,\"say \"\"1.5\"\"\",v1.5\n,,\n"),
             std::string("#1.5;\"say \"\"1.5\"\"\";v1.5\n;;\n"));
    CsvInSigns same(CsvSigns::pointAndComma);
    QCOMPARE(same.text("a,b\n0.5,1\n"), std::string("a,b\n0.5,1\n"));
}

QTEST_GUILESS_MAIN(TestDecimalComma)
#include "tst_decimal_comma.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of rows identified by their records: which belong together, and what is missing.
#include <QTest>

#include "core/archive/row_record.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

RowRecord recordOf(std::uint64_t index, std::uint64_t count, std::uint64_t rows) {
    return {.command = "drillwave sweep S --vary beta=1:2:11" +
                       (count > 1 ? " --shard " + std::to_string(index) + "/" + std::to_string(count)
                                  : std::string()),
            .method = MethodChoice(),
            .rows = rows,
            .unsolved = index,
            .file = FileSum{.bytes = 10 * rows, .crc32 = 7},
            .shard = {index, count},
            .axes = {{"beta", "1:2:11", 11}},
            .cases = {},
            .outputs = {"cor"},
            .scenario = "drillwave: 1\n\npulse: {shape: rectangular}\n\n\n"};
}

RowPart partOf(std::uint64_t index, std::uint64_t count, std::uint64_t rows) {
    return parseRowPart(recordText(recordOf(index, count, rows)), "part" + std::to_string(index));
}

/// 11 rows in three parts.
std::vector<RowPart> whole() {
    return {partOf(1, 3, 3), partOf(2, 3, 4), partOf(3, 3, 4)};
}

QString linesOf(const std::vector<RowPart>& parts) {
    QString lines;
    for (const Message& line : wholeProblems(parts)) lines += QString::fromStdString(line.text()) + "\n";
    return lines;
}

}  // namespace

class TestRowPart : public QObject {
    Q_OBJECT

  private slots:
    void theRecordOfTheWholeIsThatOfOnePiece() {
        const RowPart part = partOf(2, 3, 4);
        QCOMPARE(part.shard, (Shard{2, 3}));
        QCOMPARE(part.rows, std::uint64_t{4});
        QCOMPARE(part.unsolved, std::uint64_t{2});
        QCOMPARE(part.sum, (FileSum{.bytes = 40, .crc32 = 7}));
        const WholeRows rows{.rows = 11, .unsolved = 1, .sum = {.bytes = 110, .crc32 = 7}};
        QCOMPARE(wholeRecord(part, "drillwave sweep S --vary beta=1:2:11", rows),
                 recordText(recordOf(1, 1, 11)));
    }

    void aRecordThatWasChangedIsNone() {
        const std::string record = recordText(recordOf(2, 3, 4));
        for (std::size_t i = 0; i < record.size(); ++i) {
            std::string changed = record;
            changed[i] = static_cast<char>(changed[i] ^ 1);
            QVERIFY_EXCEPTION_THROWN(parseRowPart(changed, "x"), ScenarioError);
        }
    }

    void partsAgreeInAllButTheirOwn() {
        QCOMPARE(differingKey(partOf(1, 3, 3), partOf(2, 3, 4)), std::string());
        const auto differing = [](const auto& change) {
            RowRecord record = recordOf(2, 3, 4);
            change(record);
            const RowPart other = parseRowPart(recordText(record), "x");
            const std::string key = differingKey(partOf(1, 3, 3), other);
            return key == differingKey(other, partOf(1, 3, 3)) ? key : "not both ways";
        };
        QCOMPARE(differing([](RowRecord& r) { r.scenario += "# other\n"; }), std::string("scenario"));
        QCOMPARE(differing([](RowRecord& r) { r.axes[0].values = "1:3:11"; }), std::string("axes"));
        QCOMPARE(differing([](RowRecord& r) { r.outputs = {"impulse"}; }), std::string("outputs"));
        QCOMPARE(differing([](RowRecord& r) { r.cases = "c.csv"; }), std::string("cases"));
        QCOMPARE(differing([](RowRecord& r) { r.method->method = Method::closedForm; }),
                 std::string("method"));
    }

    void whatIsMissingOrDoubledIsNamed() {
        QCOMPARE(linesOf(whole()), QString());
        std::vector<RowPart> parts = whole();
        parts.pop_back();
        QVERIFY2(linesOf(parts).startsWith("part 3 of 3 is missing"), qPrintable(linesOf(parts)));
        parts = whole();
        parts.push_back(partOf(2, 3, 4));
        QVERIFY2(linesOf(parts).startsWith("part2: is part 2 of 3, as part2 is"), qPrintable(linesOf(parts)));
        parts = {partOf(2, 1000, 1), partOf(4, 1000, 1)};
        QVERIFY2(linesOf(parts).startsWith("parts 1, 3, 5 to 1000 of 1000 are missing"),
                 qPrintable(linesOf(parts)));
    }

    void rowsThatAreNotThoseOfThePartAreForeign() {
        std::vector<RowPart> parts = whole();
        parts[1].rows = 40;
        QVERIFY2(linesOf(parts).contains("part2: has 40 rows"), qPrintable(linesOf(parts)));
    }

    void whatIsNoRecordIsRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("a scenario") << QByteArray("drillwave: 1\n");
        QTest::newRow("a newer format") << QByteArray("drillwave_result: 2\ncommand: x\nrows: 1\n");
        QTest::newRow("no rows") << QByteArray("drillwave_result: 1\ncommand: x\n");
        QTest::newRow("no part") << QByteArray("drillwave_result: 1\ncommand: x\nrows: 1\npart: 3/2\n");
        QTest::newRow("cut short") << QByteArray("drillwave_result: 1\ncommand: [x\n");
    }

    void whatIsNoRecordIsRefused() {
        QFETCH(QByteArray, text);
        try {
            parseRowPart(text.toStdString(), "x");
        } catch (const ScenarioError& error) {
            QCOMPARE(error.kind(), ScenarioError::Kind::unreadable);
            QVERIFY(error.lines().front().starts_with("x.yaml: "));
            return;
        }
        QFAIL("is read");
    }
};

QTEST_GUILESS_MAIN(TestRowPart)
#include "tst_row_part.moc"

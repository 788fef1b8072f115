// SPDX-License-Identifier: GPL-3.0-or-later
// Answers about several records in words.
#include <QTest>

#include "core/report/identify_report.h"
#include "core/report/report_text.h"

using namespace drillwave;

namespace {

RecordAnswer recordOf(ModelVerdict model) {
    RecordAnswer record;
    record.file = "hole_1.csv";
    record.model = model;
    return record;
}

QString sentenceOf(const IdentifyFindings& findings) {
    return QString::fromStdString(plainStyle().said(recordsSentence(findings, plainStyle())));
}

}  // namespace

class TestIdentifyWords : public QObject {
    Q_OBJECT

  private slots:
    void oneRecord_hasNoSentenceOnRecords();
    void severalRecords_areCountedByTheirVerdict();
    void nextBlow_isStatedAsChangingOrNot();
    void name_hasTheBlowOfFilesWithSeveral();
};

void TestIdentifyWords::oneRecord_hasNoSentenceOnRecords() {
    IdentifyFindings findings;
    findings.records = {recordOf(ModelVerdict::accepted)};
    QCOMPARE(sentenceOf(findings), QString());
}

void TestIdentifyWords::severalRecords_areCountedByTheirVerdict() {
    IdentifyFindings findings;
    RecordAnswer refused = recordOf(ModelVerdict::accepted);
    refused.refusal = RecordRefusal{};
    findings.records = {recordOf(ModelVerdict::accepted), recordOf(ModelVerdict::rejected), refused,
                        recordOf(ModelVerdict::strained)};
    QCOMPARE(sentenceOf(findings), QStringLiteral("The model agrees with 2 of 4 records."));
}

void TestIdentifyWords::nextBlow_isStatedAsChangingOrNot() {
    IdentifyFindings findings;
    findings.records.assign(3, recordOf(ModelVerdict::accepted));
    findings.nextBlow = {{.key = "bit_rock.stiffness", .value = 1.2e8, .low = 6.55e7, .high = 2.265e8}};
    QCOMPARE(sentenceOf(findings),
             QStringLiteral("The model agrees with 3 of 3 records. No change of the rock's stiffness is seen "
                            "from blow to blow: at the next blow, it will be between 65.5 MN/m and 226.5 "
                            "MN/m (95 %)."));
    findings.nextBlow[0].hasChange = true;
    QVERIFY(sentenceOf(findings).contains("The stiffness of the rock changes from blow to blow: at"));
}

void TestIdentifyWords::name_hasTheBlowOfFilesWithSeveral() {
    RecordAnswer record = recordOf(ModelVerdict::accepted);
    record.blow = 2;
    QCOMPARE(recordName(record, false), std::string("hole_1.csv"));
    QCOMPARE(recordName(record, true), std::string("hole_1.csv, 3"));
}

QTEST_GUILESS_MAIN(TestIdentifyWords)
#include "tst_identify_words.moc"

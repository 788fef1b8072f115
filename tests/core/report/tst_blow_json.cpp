// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON object of a blow, read by another reader.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/blow/blow.h"
#include "core/blow/outputs.h"
#include "core/report/blow_json.h"

using namespace drillwave;

namespace {

QJsonObject json(const Blow& blow, const std::string& scenarioText = "drillwave: 1\n") {
    return QJsonDocument::fromJson(QByteArray::fromStdString(blowJson(blow, scenarioText))).object();
}

}  // namespace

class TestBlowJson : public QObject {
    Q_OBJECT

  private slots:
    void numbersReadBackExactly();
    void everyNumberInSiHasItsUnit();
    void anUnsolvedBlowHasReasonAndNoNumbers();
};

void TestBlowJson::numbersReadBackExactly() {
    // With the waves that the stresses are taken from.
    const Blow blow = solveBlow(Scenario{}, MethodChoice{}, Detail::histories, {}, Stresses::wanted);
    const QJsonObject object = json(blow);
    QVERIFY(blow.isSolved());
    QCOMPARE(object["outcome"].toString(), QString("rebounded"));
    const QJsonObject dimensionless = object["dimensionless"].toObject(), si = object["si"].toObject();
    qsizetype written = 0;
    for (const Output& output : outputs()) {
        const std::optional<double> value = output.value({blow.summary, blow.scenario});
        if (!output.problem(blow.scenario).isEmpty()) continue;
        const QString name = QString::fromUtf8(output.name.data(), qsizetype(output.name.size()));
        QVERIFY2(si[name].isDouble() && value, qPrintable(name));
        QCOMPARE(si[name].toDouble(), inSi(output, *value, blow));
        if (!output.isOnlySi()) QCOMPARE(dimensionless[name].toDouble(), *value);
        ++written;
    }
    QCOMPARE(si.size(), written);
    const double work = blow.scales.energy * blow.summary.workRatio;
    QCOMPARE(si["rock_work"].toDouble(), dimensionless["rock_work"].toDouble() * work);
    QCOMPARE(object["units"].toObject()["rock_work"].toString(), QString("J"));
    QVERIFY(written >= 15);
    QCOMPARE(object["events"].toArray().size(), qsizetype(blow.impact.events.size()));
    QCOMPARE(object["scenario"].toString(), QString("drillwave: 1\n"));
}

void TestBlowJson::everyNumberInSiHasItsUnit() {
    const QJsonObject object = json(solveBlow(Scenario{}, MethodChoice{}, Detail::ledger));
    QCOMPARE(object["units"].toObject().keys(), object["si"].toObject().keys());
    QCOMPARE(object["units"].toObject()["peak_force"].toString(), QString("N"));
    QCOMPARE(object["units"].toObject()["cor"].toString(), QString("1"));
}

void TestBlowJson::anUnsolvedBlowHasReasonAndNoNumbers() {
    Blow blow = solveBlow(Scenario{}, MethodChoice{}, Detail::ledger);
    blow.impact.outcome = Outcome::notSolved;
    blow.impact.reason = "it takes too long";
    const QJsonObject object = json(blow);
    QCOMPARE(object["outcome"].toString(), QString("not_solved"));
    QCOMPARE(object["reason"].toString(), QString("it takes too long"));
    for (const char* part : {"dimensionless", "si"})
        for (const QJsonValue& value : object[part].toObject()) QVERIFY(value.isNull());
}

QTEST_GUILESS_MAIN(TestBlowJson)
#include "tst_blow_json.moc"

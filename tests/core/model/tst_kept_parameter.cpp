// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <memory>
#include <utility>

#include "core/model/parameter.h"

using namespace drillwave;

class TestKeptParameter : public QObject {
    Q_OBJECT

  private slots:
    void whatIsNoParameterIsNone();
    void aRowOfTheTableIsTheRowItself();
    void parametersAreEqualByKey();
    void aNumberOfASectionOutlivesWhoFoundIt();
    void nothingIsKeptForNobody();
};

void TestKeptParameter::whatIsNoParameterIsNone() {
    for (const char* key : {"", "rod.lenght", "string.rod", "string.0.length"}) QVERIFY(!findParameter(key));
    QCOMPARE(KeptParameter(), findParameter("rod.lenght"));
    QVERIFY(KeptParameter() != findParameter("rod.length"));
}

void TestKeptParameter::aRowOfTheTableIsTheRowItself() {
    for (const Parameter& row : parameters()) {
        QCOMPARE(&*findParameter(row.key), &row);
        QCOMPARE(&*KeptParameter(row), &row);
    }
    QCOMPARE(&*findParameter("string.repeat"), &*findParameter("string.repeat"));
}

void TestKeptParameter::parametersAreEqualByKey() {
    const char* const keys[] = {
        "rod.length",      "string.repeat",           "string.3.length",        "string.3.bore",
        "hammer.3.length", "string.bit_skirt.length", "string.bit skirt.length"};
    for (const char* one : keys)
        for (const char* other : keys) QCOMPARE(findParameter(one) == findParameter(other), one == other);
}

void TestKeptParameter::aNumberOfASectionOutlivesWhoFoundIt() {
    KeptParameter found = findParameter("string.3.length");
    const KeptParameter kept = *found;  // as of a function that is given a const Parameter&
    const KeptParameter copy = found;
    found = nullptr;
    for (const KeptParameter& each : {kept, copy}) {
        QCOMPARE(QString::fromStdString(std::string(each->label)), QString("length of section 3"));
        Scenario scenario;
        scenario.form = ScenarioForm::string;
        scenario.drillString.parts = {{.group = true, .sections = std::vector<Section>(3)}};
        each->assign(scenario, 1.5);
        QCOMPARE(scenario.drillString.parts[0].sections[2].length, 1.5);
        QCOMPARE(each->value(scenario), std::optional(1.5));
    }
}

void TestKeptParameter::nothingIsKeptForNobody() {
    auto own = std::make_shared<const Parameter>(parameters().front());
    const std::weak_ptr<const Parameter> watched = own;
    KeptParameter kept(std::move(own));
    KeptParameter copy = kept;
    kept = nullptr;
    QVERIFY(!watched.expired());
    copy = nullptr;
    QVERIFY(watched.expired());
}

QTEST_GUILESS_MAIN(TestKeptParameter)
#include "tst_kept_parameter.moc"

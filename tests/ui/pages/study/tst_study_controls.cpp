// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of a study: parameter, range, family and result.
#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/study/rows/sweep_axis.h"
#include "tests/support/window.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/family_fields.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;

class TestStudyControls : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        test::keepSettingsIn(m_folder.path());
        m_units = std::make_unique<UnitChoice>();
    }
    void everyRangeAroundAValueCanBeVaried_data();
    void everyRangeAroundAValueCanBeVaried();
    void aRangeReadsBackAsTheSameDoubles();
    void noThrustOfManyBlowsPushesTheMachineBack();
    void theFirstThatAppliesIsChosen();
    void anotherParameterHasFieldsOfItsOwn();
    void endsThatCannotBeAreMarkedAndChangeNothing();
    void aFamilyIsReadFromText();
    void wrongFamiliesAreMarkedAndChangeNothing();
    void resultsAreThoseThatTheScenarioHas();
    void aNarrowRowWraps();

  private:
    QTemporaryDir m_folder;
    std::unique_ptr<UnitChoice> m_units;  // once settings have their place
};

void TestStudyControls::everyRangeAroundAValueCanBeVaried_data() {
    QTest::addColumn<const Parameter*>("parameter");
    const Scenario scenario;
    for (const Parameter& parameter : parameters())
        if (parameter.applies(scenario)) QTest::addRow("%s", parameter.key.data()) << &parameter;
}

void TestStudyControls::everyRangeAroundAValueCanBeVaried() {
    QFETCH(const Parameter*, parameter);
    const Scenario scenario;
    const StudyRange range = rangeAround(*parameter, scenario);
    QVERIFY(range.start < range.stop);
    QVERIFY(parameter->hard.contains(range.start));
    QVERIFY(parameter->hard.contains(range.stop));
    if (const auto value = parameter->value(scenario)) {
        QVERIFY(range.start <= *value);
        QVERIFY(range.stop >= *value);
    }
    if (range.logarithmic) QVERIFY(range.start > 0);
}

void TestStudyControls::aRangeReadsBackAsTheSameDoubles() {
    const KeptParameter stiffness = findParameter("bit_rock.stiffness");
    const StudyRange range{stiffness, 1.2345678901e7, 1e9 / 3, true};
    const ParsedAxis parsed = parseAxis(range.text() + ":7" + range.tail());
    QVERIFY2(parsed.problem.isEmpty(), parsed.problem.text().c_str());
    QCOMPARE(parsed.axis.start, range.start);
    QCOMPARE(parsed.axis.stop, range.stop);
    QCOMPARE(parsed.axis.kind, SweepAxis::Kind::logarithmic);
    const StudyFamily family{findParameter("rod.length"), {3.66, 1.0 / 3}};
    const ParsedAxis list = parseAxis(family.text());
    QVERIFY2(list.problem.isEmpty(), list.problem.text().c_str());
    QVERIFY(list.axis.list == family.values);
}

void TestStudyControls::noThrustOfManyBlowsPushesTheMachineBack() {
    const Parameter& thrust = *findParameter("drill.thrust");
    Scenario scenario;
    scenario.form = ScenarioForm::dimensional;
    scenario.drill.thrust = 8000;
    scenario.drill.blowFrequency = 60;
    scenario.pulse.impulse = 51;
    QVERIFY(rangeAround(thrust, scenario).start < 3060);
    const StudyRange range = rangeOfManyBlows(thrust, scenario);
    QCOMPARE(range.start, 3100.0);
    QCOMPARE(range.stop, rangeAround(thrust, scenario).stop);
    scenario.drill.blowFrequency = 400;  // the reaction is more than what is installed
    QCOMPARE(rangeOfManyBlows(thrust, scenario).start, 21000.0);
    QCOMPARE(rangeOfManyBlows(thrust, scenario).stop, 41000.0);
    const Parameter& stiffness = *findParameter("bit_rock.stiffness");
    QCOMPARE(rangeOfManyBlows(stiffness, scenario), rangeAround(stiffness, scenario));
}

void TestStudyControls::theFirstThatAppliesIsChosen() {
    AxisFields axis(QStringLiteral("vary"), {"bit_rock.stiffness", "beta"}, *m_units);
    const QSignalSpy changed(&axis, &AxisFields::changed);
    Scenario scenario;
    axis.present(scenario);
    QCOMPARE(axis.range().parameter, findParameter("bit_rock.stiffness"));
    QVERIFY(axis.isValid());
    QCOMPARE(changed.count(), 1);
    scenario.bitRock.stiffness *= 2;  // the range stays where it is
    axis.present(scenario);
    QCOMPARE(changed.count(), 1);
    const auto* box = axis.findChild<QComboBox*>(QStringLiteral("parameter"));
    const int offered = box->count();
    for (int i = 0; i < 5; ++i) axis.present(scenario);
    QCOMPARE(box->count(), offered);
    scenario.form = ScenarioForm::dimensionless;
    axis.present(scenario);
    QCOMPARE(axis.range().parameter, findParameter("beta"));
    QCOMPARE(changed.count(), 2);
}

void TestStudyControls::anotherParameterHasFieldsOfItsOwn() {
    AxisFields axis(QStringLiteral("vary"), {"beta"}, *m_units);
    axis.present(Scenario());
    auto* box = axis.findChild<QComboBox*>(QStringLiteral("parameter"));
    box->setCurrentIndex(box->findData(QStringLiteral("rod.length")));
    QCOMPARE(axis.range().parameter, findParameter("rod.length"));
    axis.setRange({findParameter("rod.length"), 1, 10, false});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(axis.findChild<QuantityField*>(QStringLiteral("start"))->value(), 1.0);
    QCOMPARE(axis.findChild<QuantityField*>(QStringLiteral("stop"))->value(), 10.0);
}

void TestStudyControls::endsThatCannotBeAreMarkedAndChangeNothing() {
    AxisFields axis(QStringLiteral("vary"), {"gamma"}, *m_units);
    axis.present(Scenario());
    const StudyRange before = axis.range();
    const QSignalSpy changed(&axis, &AxisFields::changed);
    auto* stop = axis.findChild<QuantityField*>(QStringLiteral("stop"));
    stop->show();
    stop->selectAll();
    QTest::keyClicks(stop, QStringLiteral("5"));
    QVERIFY(!stop->problem().isEmpty());
    QVERIFY(!axis.isValid());
    QVERIFY(axis.range() == before);
    QCOMPARE(changed.count(), 0);
}

void TestStudyControls::aFamilyIsReadFromText() {
    FamilyFields fields(QStringLiteral("family"), {{findParameter("gamma"), {0.1, 1}}}, *m_units);
    fields.present(Scenario());
    QCOMPARE(fields.family().values, (std::vector<double>{0.1, 1}));
    const QSignalSpy changed(&fields, &FamilyFields::changed);
    auto* box = fields.findChild<QComboBox*>(QStringLiteral("familyParameter"));
    auto* line = fields.findChild<QLineEdit*>(QStringLiteral("familyValues"));
    box->setCurrentIndex(box->findData(QStringLiteral("rod.length")));
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("3 m; 10 ft"));
    QCOMPARE(fields.family().values, (std::vector<double>{3, 3.048}));
    QVERIFY(changed.count() > 0);
    box->setCurrentIndex(0);
    QVERIFY(!fields.family().parameter);
    QVERIFY(fields.family().text().empty());
}

void TestStudyControls::wrongFamiliesAreMarkedAndChangeNothing() {
    FamilyFields fields(QStringLiteral("family"), {{findParameter("gamma"), {0.1, 1}}}, *m_units);
    fields.present(Scenario());
    auto* line = fields.findChild<QLineEdit*>(QStringLiteral("familyValues"));
    for (const char* text :
         {"2", "0.1; x", ";", "0.01;0.02;0.03;0.04;0.05;0.06;0.07;0.08;0.09;0.1;0.2;0.3;0.4"}) {
        line->setText(QLatin1String(text).chopped(1));
        line->end(false);
        QTest::keyClicks(line, QString(QLatin1Char(text[qstrlen(text) - 1])));
        QVERIFY2(!fields.problem().isEmpty(), text);
        QCOMPARE(fields.family().values, (std::vector<double>{0.1, 1}));
    }
}

void TestStudyControls::resultsAreThoseThatTheScenarioHas() {
    OutputBox box;
    Scenario scenario;
    scenario.drill = {};
    box.present(scenario);
    QCOMPARE(box.output().name, std::string_view("cor"));
    QCOMPARE(box.findData(QStringLiteral("thrust")), -1);
    scenario.drill.blowFrequency = 60;
    box.present(scenario);
    QVERIFY(box.findData(QStringLiteral("thrust")) >= 0);
    box.setOutput(*findOutput("thrust"));
    const QSignalSpy changed(&box, &OutputBox::changed);
    scenario.drill.blowFrequency.reset();
    box.present(scenario);
    QCOMPARE(box.output().name, std::string_view("cor"));
    QCOMPARE(changed.count(), 1);
}

void TestStudyControls::aNarrowRowWraps() {
    QWidget row;
    auto* layout = new FlowLayout(&row);
    for (int i = 0; i < 6; ++i) layout->addWidget(new QCheckBox(QStringLiteral("some words %1").arg(i)));
    const int wide = layout->heightForWidth(2000), narrow = layout->heightForWidth(200);
    QVERIFY(narrow > 3 * wide / 2);
    row.resize(200, narrow);
    row.show();
    for (const QCheckBox* box : row.findChildren<QCheckBox*>()) QVERIFY(row.rect().contains(box->geometry()));
}

QTEST_MAIN(TestStudyControls)
#include "tst_study_controls.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The law of bit and rock in the form: chosen, bent, and undone.
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "tests/support/scripted_questions.h"
#include "tests/support/window.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/form/scenario_panel.h"
#include "ui/questions/questions.h"

using namespace drillwave;
using namespace drillwave::test;

class TestLawSection : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { keepSettingsIn(m_folder.path()); }
    void init();
    void anotherLawIsTheSameRockAtFirst_data();
    void anotherLawIsTheSameRockAtFirst();
    void cornersAreEditedAddedAndRemoved();
    void groupsMeasureTheLawInTheirScales();
    void aForceOutOfOrderIsRefusedAtItsField();
    void cornersOfAFileAreShown();

  private:
    void open(const char* example);
    ChoiceBox& law() const { return *m_panel->findChild<ChoiceBox*>(QStringLiteral("bit_rock.law")); }
    QuantityField* field(const char* key) const {
        const auto fields = m_panel->findChildren<QuantityField*>(QLatin1String(key));
        const auto shown = std::ranges::find_if(
            fields, [this](const QuantityField* each) { return each->isVisibleTo(m_panel.get()); });
        return shown != fields.end() ? *shown : fields.value(0);
    }
    void choose(RockLaw wanted) const {
        law().setCurrentIndex(static_cast<int>(wanted));
        emit law().activated(static_cast<int>(wanted));
    }
    void type(const char* key, double number) const;
    double cor() const { return ExactSolver().solve(problemOf(m_document->scenario())).cor; }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    ScriptedQuestions m_questions{m_answers};
    std::unique_ptr<Document> m_document;
    std::unique_ptr<ScenarioPanel> m_panel;
};

void TestLawSection::init() {
    open("t38_medium_rock");
}

void TestLawSection::open(const char* example) {
    m_panel.reset();
    m_document = std::make_unique<Document>();
    QVERIFY(m_document->startFrom(findExample(example)->text, QStringLiteral("example")).isEmpty());
    m_panel = std::make_unique<ScenarioPanel>(*m_document, m_questions);
    m_panel->resize(400, 900);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
}

void TestLawSection::type(const char* key, double number) const {
    QuantityField& typed = *field(key);
    typed.setFocus();
    typed.selectAll();
    QTest::keyClicks(&typed, QLocale().toString(number));
}

void TestLawSection::anotherLawIsTheSameRockAtFirst_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::newRow("units") << QByteArray("t38_medium_rock");
    QTest::newRow("groups") << QByteArray("paper_fig4b");
}

void TestLawSection::anotherLawIsTheSameRockAtFirst() {
    QFETCH(QByteArray, example);
    open(example.constData());
    const double before = cor();
    const Scenario bilinear = m_document->scenario();
    for (const RockLaw wanted : {RockLaw::corners, RockLaw::power}) {
        const int steps = m_document->undoStack().index();
        choose(wanted);
        QCOMPARE(m_document->scenario().bitRock.law, wanted);
        QCOMPARE(m_document->undoStack().index(), steps + 1);
        QVERIFY(std::abs(cor() - before) < 1e-12);
        m_document->undoStack().undo();
        QCOMPARE(m_document->scenario(), bilinear);
        QCOMPARE(law().currentIndex(), 0);
    }
    choose(RockLaw::power);
    QVERIFY(field("bit_rock.exponent")->isVisibleTo(m_panel.get()));
    choose(RockLaw::bilinear);
    QCOMPARE(m_document->scenario(), bilinear);
    QVERIFY(!field("bit_rock.exponent")->isVisibleTo(m_panel.get()));
}

void TestLawSection::cornersAreEditedAddedAndRemoved() {
    choose(RockLaw::corners);
    type("bit_rock.corner.1.force", 90);
    type("bit_rock.corner.1.slope", 0.35);
    QCOMPARE(m_document->scenario().bitRock.corners, (std::vector<RockCorner>{{90e3, 0.35}}));
    m_panel->findChild<QToolButton*>(QStringLiteral("addCorner"))->click();
    QCOMPARE(m_document->scenario().bitRock.corners.size(), std::size_t{2});
    QCOMPARE(m_document->scenario().bitRock.corners[1], (RockCorner{135e3, 0.35}));
    QVERIFY(field("bit_rock.corner.2.force"));
    const auto away = [&](int corner) {
        for (QToolButton* button : m_panel->findChildren<QToolButton*>())
            if (button->accessibleName() == QStringLiteral("Remove corner %1").arg(corner) &&
                button->isVisibleTo(m_panel.get()))
                return button->click();
        QFAIL("there is no such button");
    };
    away(1);
    QCOMPARE(m_document->scenario().bitRock.corners, (std::vector<RockCorner>{{135e3, 0.35}}));
    away(1);
    QCOMPARE(m_document->scenario().bitRock.law, RockLaw::bilinear);
}

void TestLawSection::groupsMeasureTheLawInTheirScales() {
    open("paper_fig4b");
    choose(RockLaw::corners);
    const double force = m_document->scenario().bitRock.corners.front().force;
    QCOMPARE(field("bit_rock.corner.1.force")->value(), std::optional(force));
    QVERIFY2(field("bit_rock.corner.1.force")->text().startsWith(QLocale().toString(force)),
             qPrintable(field("bit_rock.corner.1.force")->text()));
    type("bit_rock.corner.1.force", 0.25);
    QCOMPARE(m_document->scenario().bitRock.corners.front().force, 0.25);  // F0
    choose(RockLaw::power);
    type("bit_rock.reference_penetration", 0.75);
    QCOMPARE(m_document->scenario().bitRock.referencePenetration, 0.75);  // d0
    // With units again, the same fields have them.
    QVERIFY(
        m_document->startFrom(findExample("rock_that_yields")->text, QStringLiteral("example")).isEmpty());
    QCOMPARE(field("bit_rock.corner.1.force")->value(), std::optional(90e3));
    type("bit_rock.corner.1.force", 80);
    QCOMPARE(m_document->scenario().bitRock.corners.front().force, 80e3);
}

void TestLawSection::aForceOutOfOrderIsRefusedAtItsField() {
    choose(RockLaw::corners);
    m_panel->findChild<QToolButton*>(QStringLiteral("addCorner"))->click();
    const BitRock before = m_document->scenario().bitRock;
    type("bit_rock.corner.2.force", 1);
    QVERIFY(!field("bit_rock.corner.2.force")->problem().isEmpty());
    QVERIFY(m_document->scenario().bitRock.corners[1].force >= before.corners[0].force);
}

void TestLawSection::cornersOfAFileAreShown() {
    open("rock_that_yields");
    QCOMPARE(law().currentIndex(), static_cast<int>(RockLaw::corners));
    QCOMPARE(field("bit_rock.corner.1.force")->value(), std::optional(90e3));
    QCOMPARE(field("bit_rock.corner.1.slope")->value(), std::optional(0.35));
    QVERIFY(field("bit_rock.corner.1.force")->isVisibleTo(m_panel.get()));
}

QTEST_MAIN(TestLawSection)
#include "tst_law_section.moc"

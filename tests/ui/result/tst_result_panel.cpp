// SPDX-License-Identifier: GPL-3.0-or-later
// The result panel: energy, stresses, thrust, events, alerts.
#include <QClipboard>
#include <QLabel>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "core/blow/outputs.h"
#include "core/model/alerts.h"
#include "core/model/form_conversion.h"
#include "core/report/sequence_words.h"
#include "core/study/drilling/quick_march.h"
#include "core/study/drilling/sequence.h"
#include "core/text/printed_text.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "ui/result/result_panel.h"
#include "ui/result/result_row.h"
#include "ui/runs/difference_text.h"
#include "ui/text/number_text.h"

using namespace drillwave;

namespace {

SolvedBlowPtr solved(const Scenario& scenario, UnitSystem units = UnitSystem::dimensionless) {
    MethodSolver solver;
    SolveRequest request;
    request.scenario = scenario;
    request.units = units;
    return solveBlow(request, solver);
}

Scenario scenarioOf(double beta, double gamma, double tau, double delta) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = {beta, gamma, tau, delta};
    return scenario;
}

Scenario drillOf(double thrust) {
    Scenario scenario;
    scenario.drill.blowFrequency = 60;
    scenario.drill.thrust = thrust;
    return scenario;
}

SolvedBlowPtr withShares(double rock, double rebound, double waves) {
    auto blow = std::make_shared<SolvedBlow>(*solved(scenarioOf(0.5, 0.1, 10, 0)));
    blow->summary.energy = {rock, rebound, waves, 0};
    return blow;
}

/// The value that the panel's text has behind a name.
QString valueOf(const ResultPanel& panel, const QString& name) {
    for (const QString& line : panel.text().split('\n'))
        if (line.section('\t', 0, 0) == name) return line.section('\t', 1).replace(QChar(QChar::Nbsp), ' ');
    return {};
}

QTableView& eventsOf(ResultPanel& panel) {
    return *panel.findChild<QTableView*>();
}

}  // namespace

class TestResultPanel : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void sharesOfTheEnergyAreAPatternedBar() {
        ResultPanel panel;
        panel.resize(300, 900);
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.show();
        auto* bar = panel.findChild<EnergyBar*>();
        QVERIFY(bar);
        QVERIFY(bar->accessibleName().contains("no result"));
        panel.present(withShares(0.6, 0.3, 0.1));
        QCOMPARE(bar->accessibleName().replace(QChar(QChar::Nbsp), ' '),
                 QString("Energy: rock 60 %, rebound 30 %, waves 10 %"));
        const QList<EnergySwatch*> swatches = panel.findChildren<EnergySwatch*>();
        QCOMPARE(std::ranges::count(swatches, false, &QWidget::isHidden), 3);  // others are of drill strings
        QVERIFY(bar->labelOf(EnergyPart::rock).contains("60"));
        // A share that no word fits into stays in the list below.
        panel.present(withShares(0.98, 0.01, 0.01));
        QCOMPARE(bar->labelOf(EnergyPart::waves), QString());
        QCOMPARE(valueOf(panel, "Energy: remaining in waves"), QString("1 %"));
    }

    void sharesOfAStringAddUpToAllOfItsEnergy() {
        const Example& example = *findExample("t38_string");
        ResultPanel panel;
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.show();
        const SolvedBlowPtr blow = solved(parseScenario(example.text, example.name).scenario, UnitSystem::si);
        panel.present(blow);
        double sum = 0;
        int shares = 0;
        for (const Output& output : outputs()) {
            const bool isShown = output.group == OutputGroup::share && output.measure == Measure::energy;
            if (!isShown || !output.concerns(blow->scenario)) continue;
            const QString text =
                valueOf(panel, "Energy: " + QString::fromStdString(std::string(output.label())));
            QVERIFY2(text.endsWith(" %"), qPrintable(QString::fromStdString(std::string(output.name))));
            sum += text.chopped(2).toDouble();
            ++shares;
        }
        QCOMPARE(shares, 7);
        QVERIFY2(std::abs(sum - 100) < 0.05, qPrintable(QString::number(sum)));  // four digits of each
        // m v²/2 of 6.85 kg at 10 m/s, of which the shares are: the work on the string is less
        QCOMPARE(valueOf(panel, "Energy: hammer energy E₀"), QString("342.5 J"));
        QCOMPARE(valueOf(panel, "Energy: hammer work W"), QString("335.3 J"));
    }

    void noShareOfAGivenPulseIsOfAHammer() {
        const Example& example = *findExample("t38_medium_rock");
        ResultPanel panel;
        panel.present(solved(parseScenario(example.text, example.name).scenario, UnitSystem::si));
        QCOMPARE(valueOf(panel, "Energy: hammer energy E₀"), QString());
        QVERIFY(!valueOf(panel, "Energy: hammer work W").isEmpty());
    }

    void theHeadlineOfAForceOnAStringHasItsWork() {
        const Example& example = *findExample("t38_string");
        const Scenario hammer = parseScenario(example.text, example.name).scenario;
        ResultPanel panel;
        panel.present(solved(forcedStringOf(hammer).scenario, UnitSystem::si));
        const QString headline = panel.findChild<QLabel*>(QStringLiteral("headline"))
                                     ->text()
                                     .replace(QChar(QChar::Nbsp), QLatin1Char(' '));
        const QString work = valueOf(panel, "Energy: hammer work W");
        QVERIFY2(!work.isEmpty() && headline.contains(work), qPrintable(headline));
    }

    void sharesThatRoundingMakesNegativeAreNotDrawn() {
        EnergyBar bar;
        ImpactSummary summary;
        summary.energy = {-1e-17, 0.7, 0.3, 0};
        bar.present(summary);
        QCOMPARE(bar.accessibleName().replace(QChar(QChar::Nbsp), ' '),
                 QString("Energy: rebound 70 %, waves 30 %"));
        bar.resize(200, 24);
        QVERIFY(!bar.grab().isNull());
        ResultPanel panel;
        panel.present(withShares(-1e-15, 0.7, 0.3));
        QCOMPARE(valueOf(panel, "Energy: into the rock"), QString("0 %"));
    }

    void magnitudesHaveOneDigit() {
        QCOMPARE(magnitudeText(3.2e-15, QLocale::c()), QStringLiteral("3·10⁻¹⁵"));
        QCOMPARE(magnitudeText(9.6e-14, QLocale::c()), QStringLiteral("1·10⁻¹³"));  // not 10·10⁻¹⁴
        QCOMPARE(magnitudeText(-9.6e3, QLocale::c()), QStringLiteral("−1·10⁴"));
        QCOMPARE(magnitudeText(0, QLocale::c()), QStringLiteral("0"));
    }

    void stressIsShownInMegapascalAndAsAForce() {
        ResultPanel panel;
        Scenario scenario;
        const SolvedBlowPtr blow = solved(scenario, UnitSystem::si);
        panel.present(blow);
        const double area = std::acos(-1.0) * 0.038 * 0.038 / 4;
        const double stress = blow->summary.rodForces->compression.size * 255e3 / area / 1e6;
        QCOMPARE(valueOf(panel, "Stress in the rod: compression, blow"),
                 QString::number(stress, 'g', 4) + " MPa");
        panel.present(solved(scenario));
        QVERIFY(valueOf(panel, "Stress in the rod: tension, after").endsWith(" F₀"));
    }

    void numbersSayHowFarTheyAreOffTheReference() {
        ResultPanel panel;
        Scenario scenario;
        const SolvedBlowPtr before = solved(scenario, UnitSystem::si);
        scenario.bitRock.stiffness *= 2;
        scenario.pulse.impulse *= 3;
        const SolvedBlowPtr now = solved(scenario, UnitSystem::si);
        panel.present(now);
        const auto changeOf = [&](const char* name) { return valueOf(panel, name).section('\t', 1); };
        QCOMPARE(changeOf("Rebound: COR e"), QString());
        panel.setReference(before, "A  first");
        const auto percent = [](double value, double reference) {
            return relativeText(value, reference).replace(QChar(QChar::Nbsp), ' ');
        };
        QVERIFY(now->summary.cor != before->summary.cor);
        QCOMPARE(changeOf("Rebound: COR e"), percent(now->summary.cor, before->summary.cor));
        // In newtons, not in the unit of each blow.
        QCOMPARE(changeOf("Force and times: peak force"),
                 percent(3 * now->summary.peakForce, before->summary.peakForce));
        QCOMPARE(changeOf("Energy: hammer work W"), percent(9, 1));
        QCOMPARE(changeOf("Energy: balance error"), QString());
        panel.present(before);
        QCOMPARE(changeOf("Rebound: COR e"), QString("±0 %"));
        panel.setReference(nullptr, {});
        QCOMPARE(changeOf("Rebound: COR e"), QString());
    }

    // The energy of a hammer was set against the scale of energies of a given blow, W₀.
    void rowsThatTheReferenceHasNotAreNotCompared() {
        const auto ofExample = [](const char* name) {
            const Example& example = *findExample(name);
            return solved(parseScenario(example.text, example.name).scenario, UnitSystem::si);
        };
        ResultPanel panel;
        panel.present(ofExample("t38_string"));
        panel.setReference(ofExample("t38_medium_rock"), "A  rod");
        const auto changeOf = [&](const char* name) { return valueOf(panel, name).section('\t', 1); };
        QVERIFY(!valueOf(panel, "Energy: hammer energy E₀").isEmpty());
        QCOMPARE(changeOf("Energy: hammer energy E₀"), QString());
        QVERIFY(!changeOf("Energy: hammer work W").isEmpty());
    }

    void aLargestStressLeadsToItsPlaceAndTime() {
        ResultPanel panel;
        const SolvedBlowPtr blow = solved(Scenario(), UnitSystem::si);
        panel.present(blow);
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.show();
        QSignalSpy chosen(&panel, &ResultPanel::placeChosen);
        const QList<PlaceLink*> links = panel.findChildren<PlaceLink*>();
        QCOMPARE(links.size(), 4);
        QVERIFY(links[1]->text().contains("from the hammer"));
        QTest::mouseClick(links[1], Qt::LeftButton);
        const RodForce& tension = blow->summary.rodForces->tension;
        QCOMPARE(chosen.takeFirst(), QVariantList({tension.section, tension.time}));
        QTest::keyClick(links[2], Qt::Key_Return);
        const RodForce& after = blow->summary.rodForces->compressionAfter;
        QCOMPARE(chosen.takeFirst(), QVariantList({after.section, after.time}));
        panel.present(failedBlow({}, "The rod has melted."));
        QTest::mouseClick(links[1], Qt::LeftButton);
        QVERIFY(chosen.isEmpty());
    }

    void theInstalledFeedIsCompared() {
        const double needed = solved(drillOf(1))->feed->need(ThrustCase::scenario).thrust;
        for (const double share : {0.6, 0.9, 1.1, 3.0}) {
            ResultPanel panel;
            panel.present(solved(drillOf(share * needed)));
            const QString percent =
                QString("(%1%2 %)").arg(share > 1 ? "+" : "−").arg(std::round(100 * std::abs(share - 1)));
            QVERIFY2(valueOf(panel, "Feed: margin, this blow").endsWith(percent), qPrintable(panel.text()));
        }
        // Without a drill there is nothing to say.
        ResultPanel panel;
        panel.present(solved(scenarioOf(0.5, 1, 10, 0)));
        QVERIFY(!panel.text().contains("Feed:"));
    }

    // For this blow at once, for every gap as soon as a study has it; in the numbers of the reader.
    void theRequiredFeedStandsFirst() {
        ResultPanel panel;
        const auto first = [&] { return panel.text().section('\n', 0, 0); };
        panel.present(solved(drillOf(9.5e3), UnitSystem::si));
        QVERIFY2(first().startsWith(
                     "A feed force of 9.5 kN is enough for this blow and for rigid rock. It even returns") &&
                     first().endsWith(" …"),
                 qPrintable(first()));
        QTRY_VERIFY2_WITH_TIMEOUT(
            first().contains("A feed force of 9.5 kN is enough for a single blow at any gap (") &&
                first().endsWith(" kN required)."),
            qPrintable(first()), 30000);
        const QLocale before;
        const auto restore = qScopeGuard([&] { QLocale::setDefault(before); });
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        panel.present(solved(drillOf(1.5e3), UnitSystem::si));
        QTRY_VERIFY2_WITH_TIMEOUT(first().startsWith("⚠ The feed force of 1,5 kN is less than ") &&
                                      first().endsWith(": the machine is pushed back."),
                                  qPrintable(first()), 30000);
        panel.present(solved(scenarioOf(0.5, 1, 10, 0)));
        QVERIFY2(first().startsWith("The feed cannot be judged: "), qPrintable(first()));
        panel.present(failedBlow({}, "The rod has melted."));
        QVERIFY(!panel.text().contains("judged"));
    }

    // The sequence is followed beside the blow, and its line says what it gives.
    void theSequenceStandsBelow() {
        Scenario scenario = drillOf(9.5e3);
        scenario.drill.waveLoss = 0.1;
        ResultPanel panel;
        panel.present(solved(scenario, UnitSystem::si));
        const auto* line = panel.findChild<QLabel*>("sequence");
        QVERIFY(line->text().contains("Consecutive blows are being solved …"));
        const DrillingResult march = studyDrilling(scenario, windowSettingsOf(scenario), quickWants());
        const QString expected = QString::fromStdString(sequenceText(march, PrintedStyle(plainStyle())));
        QTRY_VERIFY2_WITH_TIMEOUT(line->text().startsWith(expected.section(": ", 0, 0)),
                                  qPrintable(line->text()), 60000);
        QVERIFY(panel.text().contains(
            " of the blows, the bit is in contact with the rock when the blow arrives."));
        QVERIFY(!line->text().contains("href=\"loss\""));
    }

    // Without a loss of waves the mean may not be known: a click sets one.
    void anUnresolvedSequenceOffersAWaveLoss() {
        Scenario scenario = drillOf(4.5e3);
        scenario.drill.waveLoss.reset();
        scenario.drill.blows = 40;
        scenario.drill.settle = 10;
        const DrillingResult march = studyDrilling(scenario, windowSettingsOf(scenario), quickWants());
        QCOMPARE(sequenceOf(march)->unresolved, UnresolvedReason::noWaveLoss);
        ResultPanel panel;
        panel.present(solved(scenario, UnitSystem::si));
        auto* line = panel.findChild<QLabel*>("sequence");
        QTRY_VERIFY2_WITH_TIMEOUT(
            line->text().contains("no wave loss is defined") && line->text().contains("href=\"loss\""),
            qPrintable(line->text()), 60000);
        // as the form calls it, not by the key of a file
        QVERIFY2(line->text().contains("“wave loss η”"), qPrintable(line->text()));
        QVERIFY2(!line->text().contains("drill."), qPrintable(line->text()));
        QSignalSpy wanted(&panel, &ResultPanel::waveLossWanted);
        emit line->linkActivated("loss");
        QCOMPARE(wanted.count(), 1);
    }

    // Straight up, half a ton less of it.
    void weightAlongTheHoleIsToldBesideTheThrust() {
        Scenario scenario = drillOf(8e3);
        scenario.drill.inclination = -90;
        scenario.drill.machineMass = 500 - propertiesOf(scenario.rod).mass;
        ResultPanel panel;
        panel.present(solved(scenario, UnitSystem::si));
        QCOMPARE(valueOf(panel, "Feed: installed"), QString("8 kN, effective 3.097 kN"));
        QVERIFY2(valueOf(panel, "Feed: margin, this blow").startsWith("−"), qPrintable(panel.text()));
    }

    void whatADrillerDecidesByComesFirst() {
        ResultPanel panel;
        panel.present(solved(drillOf(8e3), UnitSystem::si));
        QStringList titles;
        for (const QString& line : panel.text().split('\n', Qt::SkipEmptyParts).mid(1))
            if (!titles.contains(line.section(": ", 0, 0))) titles << line.section(": ", 0, 0);
        QCOMPARE(titles, QStringList({"Feed", "Energy", "Penetration", "Rebound", "Stress in the rod",
                                      "Force and times"}));
        QVERIFY(valueOf(panel, "Energy: percussion power").endsWith(" kW"));
        QVERIFY(valueOf(panel, "Penetration: penetration rate").endsWith(" m/min"));
        // 51 N s (1 + e)
        QCOMPARE(valueOf(panel, "Rebound: COR e"), QString("0.3672"));
        QCOMPARE(valueOf(panel, "Rebound: impulse on the rock"), QString("69.73 N s = 1.37 I₀"));
    }

    void theWorstNeedIsFoundBesideTheBlow() {
        ResultPanel panel;
        const Scenario scenario = drillOf(8e3);
        panel.present(solved(scenario, UnitSystem::si));
        QCOMPARE(valueOf(panel, "Feed: required, every gap"), QString("…"));
        const double worst = studyThrust(scenario).largestNeed().thrust;
        const QString text =
            quantityText(worst, {1e-3, "kN", false}, QLocale()).replace(QChar(QChar::Nbsp), ' ');
        QTRY_COMPARE_WITH_TIMEOUT(valueOf(panel, "Feed: required, every gap"), text, 30000);
        // The value of another blow stays, marked, until there is an answer.
        Scenario other = scenario;
        other.drill.blowFrequency = 30;
        panel.present(solved(other, UnitSystem::si));
        QCOMPARE(valueOf(panel, "Feed: required, every gap"), "(" + text + ") …");
        const QString half =
            quantityText(worst / 2, {1e-3, "kN", false}, QLocale()).replace(QChar(QChar::Nbsp), ' ');
        QTRY_COMPARE_WITH_TIMEOUT(valueOf(panel, "Feed: required, every gap"), half, 30000);
        // Without a frequency there is none.
        other.drill.blowFrequency.reset();
        panel.present(solved(other, UnitSystem::si));
        QVERIFY(!panel.text().contains("Feed: required, every gap\t("));
    }

    void theThrustSaysHowFarItIsOffTheReference() {
        ResultPanel panel;
        const auto changeOf = [&](const char* name) {
            return valueOf(panel, QStringLiteral("Feed: ") + QLatin1String(name)).section('\t', 1);
        };
        const SolvedBlowPtr before = solved(drillOf(8e3), UnitSystem::si);
        const SolvedBlowPtr now = solved(drillOf(10e3), UnitSystem::si);
        panel.present(now);
        panel.setReference(before, "A  first");
        QCOMPARE(changeOf("installed"), QString("+25 %"));
        // As a force: the margin may be zero.
        QCOMPARE(changeOf("margin, this blow"), QString("+2 kN"));
        QCOMPARE(changeOf("required, this blow"), QString("±0 %"));
        // Both needs take a study.
        QCOMPARE(changeOf("required, every gap"), QString());
        QTRY_COMPARE_WITH_TIMEOUT(changeOf("required, every gap"), QString("±0 %"), 30000);
        Scenario slower = drillOf(8e3);
        slower.drill.blowFrequency = 30;
        panel.setReference(solved(slower, UnitSystem::si), "B  slower");
        QCOMPARE(changeOf("required, every gap"), QString());
        QTRY_COMPARE_WITH_TIMEOUT(changeOf("required, every gap"), QString("+100 %"), 30000);
        // A blow without a required force has no difference, and neither has one without a reference.
        slower.drill.blowFrequency.reset();
        panel.setReference(solved(slower, UnitSystem::si), "C  silent");
        QCOMPARE(changeOf("required, every gap"), QString());
        QCOMPARE(changeOf("margin, this blow"), QString());
        panel.setReference(before, "A  first");
        QTRY_COMPARE_WITH_TIMEOUT(changeOf("required, every gap"), QString("±0 %"), 30000);
        panel.present(before);
        QCOMPARE(changeOf("margin, this blow"), QString("±0 kN"));
        panel.setReference(nullptr, {});
        for (const char* name : {"margin, this blow", "required, every gap", "installed"})
            QCOMPARE(changeOf(name), QString());
    }

    // The margin of this blow may be one while the worst of four needs is not met.
    void theWorstNeedIsMetOrSaidNotToBe_data() {
        QTest::addColumn<double>("share");
        QTest::addColumn<QString>("said");
        QTest::newRow("short") << 0.8 << "⚠ short by %1 (−20 %)";
        QTest::newRow("met") << 1.25 << "✓ met, %1 (25 %) to spare";
    }

    void theWorstNeedIsMetOrSaidNotToBe() {
        QFETCH(double, share);
        QFETCH(QString, said);
        const double worst = studyThrust(drillOf(1)).largestNeed().thrust;
        ResultPanel panel;
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.findChild<SectionBox*>(QStringLiteral("feed"))->setOpen(true);
        panel.show();
        panel.present(solved(drillOf(share * worst), UnitSystem::si));
        const QString size = quantityText(std::abs(share - 1) * worst, {1e-3, "kN", false}, QLocale())
                                 .replace(QChar(QChar::Nbsp), ' ');
        const QString text = said.arg(size);
        QTRY_VERIFY2_WITH_TIMEOUT(panel.text().replace(QChar(QChar::Nbsp), ' ').contains(text),
                                  qPrintable(panel.text()), 30000);
        for (const QLabel* label : panel.findChildren<QLabel*>("worstNeed")) {
            if (label->text() == "…" || !label->text().contains(said.left(1))) continue;
            QCOMPARE(label->font().bold(), share < 1);
            const QColor usual = panel.palette().color(QPalette::WindowText);
            QCOMPARE(label->palette().color(QPalette::WindowText) == usual, share > 1);
            QVERIFY(label->sizeHint().width() <= label->width());
            return;
        }
        QFAIL("the margin has no row");
    }

    void allNumbersAreCopiedAsText() {
        ResultPanel panel;
        panel.present(solved(scenarioOf(0.5, 1, 10, 0)));
        QCOMPARE(panel.actions().size(), 1);
        panel.actions().first()->trigger();
        const QString text = QGuiApplication::clipboard()->text();
        QVERIFY2(text.section('\n', 1).startsWith("Energy: hammer work W\t"), qPrintable(text));
        QCOMPARE(valueOf(panel, "Rebound: COR e"), QString("1.401"));
        QCOMPARE(valueOf(panel, "Rebound: impulse on the rock"), QString("2.401 I₀"));
        QVERIFY(panel.findChild<QLabel*>("cor")->toolTip().contains("Numerical error ± "));
    }

    void noValueIsWiderThanItsColumn() {
        ResultPanel panel;
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        for (SectionBox* section : panel.findChildren<SectionBox*>()) section->setOpen(true);
        panel.show();
        panel.resize(panel.minimumSizeHint());
        for (const SolvedBlowPtr& blow :
             {solved(scenarioOf(0.5, 0.1, 10, 0)), solved(scenarioOf(1e-7, 1e-3, 3, 12345.678)),
              solved(scenarioOf(1e9, 1e-6, 1000, 0)), solved(drillOf(50e3), UnitSystem::si)}) {
            panel.present(blow);
            QCoreApplication::processEvents();
            for (const QLabel* label : panel.findChildren<QLabel*>()) {
                if (label->wordWrap() || label->isHidden()) continue;
                QVERIFY2(label->sizeHint().width() <= label->width(), qPrintable(label->text()));
                QVERIFY(
                    panel.widget()->rect().contains(label->mapTo(panel.widget(), label->rect().topRight())));
            }
            QVERIFY(panel.widget()->width() <= panel.viewport()->width());
        }
    }

    void anEventMovesTheTimeCursorAndIsMarkedByIt() {
        ResultPanel panel;
        const SolvedBlowPtr blow = solved(scenarioOf(0.5, 0.1, 10, 0.3));
        panel.present(blow);
        QTableView& table = eventsOf(panel);
        QVERIFY(table.model()->rowCount() > 2);
        QSignalSpy chosen(&panel, &ResultPanel::timeChosen);
        table.setCurrentIndex(table.model()->index(1, 0));
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(*chosen.at(0).at(0).value<std::optional<double>>(), blow->impact.events[1].time);
        // The cursor from elsewhere: marked, not chosen again.
        panel.setTime(blow->impact.events[2].time);
        QCOMPARE(table.currentIndex().row(), 2);
        QVERIFY(table.selectionModel()->isRowSelected(2, {}));
        panel.setTime(blow->impact.events[2].time + 0.01);
        QVERIFY(!table.selectionModel()->hasSelection());
        panel.setTime(blow->impact.events[0].time);
        panel.present(solved(scenarioOf(0.5, 0.1, 10, 0.3)));  // the same blow, solved again
        QVERIFY(table.selectionModel()->isRowSelected(0, {}));
        panel.setTime(std::nullopt);
        QVERIFY(!table.selectionModel()->hasSelection());
        QCOMPARE(chosen.count(), 1);
        // With the keys.
        table.setCurrentIndex(table.model()->index(1, 0));
        QTest::keyClick(&table, Qt::Key_Down);
        QCOMPARE(chosen.count(), 3);
        QCOMPARE(*chosen.last().at(0).value<std::optional<double>>(), blow->impact.events[2].time);
    }

    // The keyboard passes on its way through the window.
    void theTabKeyChoosesNoEvent() {
        ResultPanel panel;
        panel.present(solved(scenarioOf(0.5, 0.1, 10, 0.3)));
        panel.show();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        QTableView& table = eventsOf(panel);
        QSignalSpy chosen(&panel, &ResultPanel::timeChosen);
        table.setFocus(Qt::TabFocusReason);
        QCoreApplication::processEvents();
        QVERIFY(table.hasFocus());
        QCOMPARE(chosen.count(), 0);
        QVERIFY(!table.selectionModel()->hasSelection());
        QTest::keyClick(&table, Qt::Key_Down);
        QCOMPARE(chosen.count(), 1);
    }

    // A second at most in these plots, and the events of a blow that began after minutes.
    void theEventsHaveAUnitInWhichTheyCanBeRead() {
        Scenario late = drillOf(8e3);
        late.bitRock.gap = 200;  // [m]
        ResultPanel panel;
        panel.present(solved(late, UnitSystem::si));
        const QAbstractItemModel& events = *eventsOf(panel).model();
        QVERIFY(events.rowCount() > 0);
        QCOMPARE(events.headerData(0, Qt::Horizontal).toString(), QString("t [s]"));
        QVERIFY(events.index(0, 0).data().toString().size() <= 6);
    }

    // Whether there is something to scroll or not.
    void theScrollBarTakesNoWidthFromTheNumbers() {
        ResultPanel panel;
        panel.present(solved(drillOf(8e3), UnitSystem::si));
        panel.resize(320, 300);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QTRY_VERIFY(panel.verticalScrollBar()->maximum() > 0);
        const int width = panel.widget()->width();
        panel.resize(320, 3000);
        QTRY_COMPARE(panel.verticalScrollBar()->maximum(), 0);
        QCOMPARE(panel.widget()->width(), width);
    }

    void thousandsOfEventsAreMarkedOneByOne() {
        auto blow = std::make_shared<SolvedBlow>(*solved(scenarioOf(0.5, 0.1, 10, 0)));
        blow->impact.events.clear();
        for (int i = 0; i < 200'000; ++i) blow->impact.events.push_back({ContactEvent::contact, 0.5 * i});
        ResultPanel panel;
        panel.present(blow);
        for (const int row : {0, 77, 123'456, 199'999}) {
            panel.setTime(0.5 * row);
            QCOMPARE(eventsOf(panel).currentIndex().row(), row);
        }
    }

    void alertsKeepTheirLabelsAndTheirRoom() {
        const LocalStyle style(QLocale::c(), UnitSystem::si, {});
        AlertList list;
        list.setAttribute(Qt::WA_DontShowOnScreen);
        list.resize(200, 300);
        list.show();
        const Alert warning{AlertLevel::warning,
                            AlertCode::closedFormInvalid,
                            "tau",
                            {{"tau", 0.4}, {"closed_form_cor", 0.5}, {"difference", 0.1}}};
        list.present({}, {warning, warning}, style);
        QCoreApplication::processEvents();
        const QList<QLabel*> labels = list.findChildren<QLabel*>();
        QCOMPARE(labels.size(), 2);
        QVERIFY(labels[0]->accessibleName().contains("tau = 0.4 < 0.5"));
        QVERIFY(labels[0]->text().contains("tau = 0.4 &lt; 0.5"));
        const int height = list.height();
        list.present({}, {}, style);
        QCOMPARE(list.findChildren<QLabel*>(), labels);
        QVERIFY(labels[1]->isHidden());
        QVERIFY(list.minimumHeight() >= height);  // what is below stands still
        QTRY_COMPARE(list.minimumHeight(), 0);    // until values rest
        list.present(QStringLiteral("out of rock"), {}, style);
        QCOMPARE(list.texts(), QStringList{"out of rock"});
    }
};

QTEST_MAIN(TestResultPanel)
#include "tst_result_panel.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The page Design: the numbers of the command, rows that say what is not known, and designs in the hand.
#include <QCheckBox>
#include <QFile>
#include <QFontMetricsF>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMenu>
#include <QProcess>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStyleOptionComboBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <mutex>

#include "core/model/form_conversion.h"
#include "core/model/section_parameter.h"
#include "core/report/design_figure.h"
#include "core/study/design/constant_energy.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "ui/form/quantity_field.h"
#include "ui/form/section_box.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/design/design_card.h"
#include "ui/pages/design/design_page.h"
#include "ui/pages/design/range_rows.h"
#include "ui/plot/curve_reader.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

// For a study of some seconds on a machine that is busy with other tests.
constexpr int patienceForDesigns = 120'000;

}  // namespace

class TestDesignPage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void aPageThatCannotBeSeenComputesNothing();
    void aFirstAnswerIsRefined();
    void theNumbersAreThoseOfTheCopiedCommand_data();
    void theNumbersAreThoseOfTheCopiedCommand();
    void aClickLoadsADesignWithItsEnergyInOneStep();
    void aClickWithShiftPinsADesign();
    void theWorstCaseIsLoaded();
    void theCardSaysWhatIsGivenAwayInTheRockOfTheFile();
    void aRangeUpsideDownIsMarkedAndAsksNothing();
    void whatCannotBeSolvedIsSaid();
    void theDesignsFillTheirPlot();
    void twoChoicesAreAMap();
    void rowsAreAddedAndRemoved();
    void aimsAreCustomaryUntilTheyAreChosen();
    void anotherFormHasOtherRows();
    void anotherDocumentBeginsWithWhatIsProposedForIt();
    void anAimThatTheScenarioNoLongerHasIsTheProposedOne();
    void aMeasuredBlowHasADesignToChoose();
    void parametersAreCalledAsInTheForm();
    void aShareIsNeverMoreThanAll();
    void barsHaveRoomForTheirNames();
    void boxesAreAsWideAsWhatIsChosen();
    void theCountOfSolvesNeverGoesBack();
    void aStudyOutOfSightIsStopped();
    void theSetUpOfTheDocumentIsShownAndKept();
    void untouchedControlsChangeNoFile();
    void tickedHammersAreDesigns();
    void hammersAreNamedPointsOfTheirAxis();
    void undoWithHammersKeepsTheTickOfTheEnergy();
    void whatNoRowShowsStaysAsText();
    void aStudyOfAStringStopsAndOffersTheRest();
    void theCardHasTheMarksOfTheFiles();
    void theHeadlineHasTheUnitsAndWordsOfThePage();
    void whereThePresentDesignStaysNoOtherIsOffered();

  private:
    /// Inputs of the rows.
    struct Asked {
        std::vector<std::string> uncertain, choices;
        std::vector<DesignAim> aims;
        bool keepsEnergy;
        bool operator==(const Asked&) const = default;
    };
    Asked asked() const;
    void open(const char* name);
    void showPage();
    bool isAnswered() const;
    void few() const;
    QCPGraph* objective() const;
    QCPAxisRect* axesOf(DesignPanel panel) const;
    RangeRows& rows(const char* name) const { return *m_page->findChild<RangeRows*>(QLatin1String(name)); }
    QuantityField& field(RangeRow& row, const char* name) const {
        return *row.findChild<QuantityField*>(QLatin1String(name));
    }
    void click(std::size_t design, Qt::KeyboardModifiers modifiers) const;

    QTemporaryDir m_folder;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<DesignPage> m_page;
};

void TestDesignPage::initTestCase() {
    keepSettingsIn(m_folder.path());
}

void TestDesignPage::init() {
    open("t38_medium_rock");
}

void TestDesignPage::open(const char* name) {
    m_page.reset();
    m_document = std::make_unique<Document>();
    QVERIFY(m_document->open(example(QString::fromLatin1(name))).isEmpty());
    m_page = std::make_unique<DesignPage>(*m_document);
    m_page->resize(900, 1100);
    few();
}

// So many samples that a first answer and a refined one differ.
void TestDesignPage::few() const {
    auto* samples = m_page->findChild<QComboBox*>(QStringLiteral("samples"));
    samples->setCurrentIndex(samples->findData(1024));
}

/// Returns the curve of the objective with the best design.
QCPGraph* TestDesignPage::objective() const {
    const FigureFrame& frame = m_page->figureFrame();
    return frame.graph(0, frame.figure().panels[0].marked);
}

QCPAxisRect* TestDesignPage::axesOf(DesignPanel panel) const {
    return m_page->figureFrame().graph(std::size_t(panel), 0)->keyAxis()->axisRect();
}

void TestDesignPage::showPage() {
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    few();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    m_page->plot()->replot();
}

bool TestDesignPage::isAnswered() const {
    return m_page->activity()->state() == StudyState::finished && m_page->activity()->isCurrent();
}

void TestDesignPage::click(std::size_t design, Qt::KeyboardModifiers modifiers) const {
    const QCPGraph* graph = objective();
    const QCPGraphData& at = *graph->data()->at(static_cast<int>(design));
    const QPointF pixel(graph->keyAxis()->coordToPixel(at.key), graph->valueAxis()->coordToPixel(at.value));
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, modifiers, pixel.toPoint());
}

void TestDesignPage::aPageThatCannotBeSeenComputesNothing() {
    m_document->assign(*findParameter("pulse.duration"), 210e-6, m_document->newGesture());
    QTest::qWait(0);
    QCOMPARE(m_page->studies(), 0);
    showPage();
    const int studies = m_page->studies();
    m_page->hide();
    m_document->assign(*findParameter("pulse.duration"), 220e-6, m_document->newGesture());
    QCOMPARE(m_page->studies(), studies);
}

void TestDesignPage::aFirstAnswerIsRefined() {
    std::vector<std::uint64_t> samples;
    connect(m_page->activity(), &StudyActivity::changed, this, [&] {
        // Where the machine is idle, the page's own first question may be answered before `few` asks for
        // less.
        const auto& answer = m_page->answer();
        if (answer && answer->hasBest() && answer->wanted == 1024)
            samples.push_back(m_page->answer()->report.study.samples);
    });
    showPage();
    QVERIFY(!samples.empty());
    QVERIFY(std::ranges::is_sorted(samples));
    QCOMPARE(samples.back(), std::uint64_t{1024});
    QVERIFY(m_page->answer()->isRefined());
    QVERIFY(m_page->card().toPlainText().contains(QStringLiteral("1024")));
}

void TestDesignPage::theNumbersAreThoseOfTheCopiedCommand_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("rod") << QByteArray("t38_medium_rock");
    QTest::newRow("groups") << QByteArray("paper_fig4b");
}

void TestDesignPage::theNumbersAreThoseOfTheCopiedCommand() {
    QFETCH(QByteArray, name);
    open(name.constData());
    const QString path = m_folder.filePath(QString::fromLatin1(name) + QStringLiteral(".yaml"));
    QVERIFY(m_document->save(path).isEmpty());
    showPage();
    const QString command = m_page->command();
    QVERIFY2(command.startsWith(QStringLiteral("drillwave design ") + m_document->path()),
             qPrintable(command));
    QStringList typed = QProcess::splitCommand(QString(command).replace(QLatin1Char('\''), QLatin1Char('"')));
    typed.removeFirst();
    const Finished finished = run(typed << QStringLiteral("--json"));
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    const QJsonObject json = QJsonDocument::fromJson(finished.out).object();
    const DesignReport& report = m_page->answer()->report;
    const QJsonArray designs = json[QLatin1String("designs")].toArray();
    QCOMPARE(static_cast<std::size_t>(designs.size()), report.findings.designs.size());
    QVERIFY(designs.size() > 5);
    const DesignAim& aim = report.study.aims.front();
    const StatisticPlace place = report.study.placeOf(*aim.output, aim.statistic);
    const QString key = QString::fromStdString(std::string(aim.output->name) + "_" + aim.statistic.name());
    for (qsizetype d = 0; d < designs.size(); ++d) {
        const QJsonValue told = designs[d][QLatin1String("statistics")][key];
        const SampledValue& value =
            report.findings.designs[std::size_t(d)].statistics[place.output][place.statistic];
        QCOMPARE(value.value, told[QLatin1String("value")].toDouble());
        QCOMPARE(value.error(), told[QLatin1String("error")].toDouble());
    }
    QCOMPARE(static_cast<int>(*report.findings.best.robust) + 1, json[QLatin1String("robust_best")].toInt());
    QCOMPARE(report.findings.worst[0]->value,
             json[QLatin1String("worst")][0][QLatin1String("value")].toDouble());
    QVERIFY(m_page->exports().first().csv().contains(key.toUtf8()));
}

void TestDesignPage::aClickLoadsADesignWithItsEnergyInOneStep() {
    showPage();
    const double energy = blowEnergy(m_document->scenario());
    const int steps = m_document->undoStack().count();
    click(1, {});
    QCOMPARE(m_document->undoStack().count(), steps + 1);
    const Scenario& loaded = m_document->scenario();
    QVERIFY(std::abs(loaded.pulse.duration / 120e-6 - 1) < 1e-12);
    QVERIFY(std::abs(blowEnergy(loaded) / energy - 1) < 1e-12);
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario().pulse.duration, 200e-6);
}

void TestDesignPage::aClickWithShiftPinsADesign() {
    showPage();
    QSignalSpy pinned(m_page.get(), &Page::pinRequested);
    click(2, Qt::ShiftModifier);
    QCOMPARE(pinned.count(), 1);
    QCOMPARE(m_document->scenario().pulse.duration, 200e-6);
}

void TestDesignPage::theWorstCaseIsLoaded() {
    showPage();
    const WorstCase worst = *m_page->answer()->report.findings.worst[0];
    auto* card = m_page->findChild<DesignCard*>();
    QVERIFY(card->toHtml().contains(DesignCard::linkToWorst(0).toString()));
    emit card->anchorClicked(DesignCard::linkToWorst(0));
    QCOMPARE(m_document->scenario().bitRock.stiffness, worst.at[0]);
    QCOMPARE(m_document->scenario().bitRock.gamma, worst.at[1]);
    QCOMPARE(m_document->scenario().bitRock.gap, worst.at[2]);
}

void TestDesignPage::theCardSaysWhatIsGivenAwayInTheRockOfTheFile() {
    showPage();
    const auto& findings = m_page->answer()->report.findings;
    QVERIFY(findings.best.nominal && *findings.best.nominal != *findings.best.robust);
    const double robust = findings.designs[*findings.best.robust].nominal[0];
    const double nominal = findings.designs[*findings.best.nominal].nominal[0];
    QVERIFY(robust < nominal);
    // Plain text has no fixed blanks.
    const QString text =
        QStringLiteral("the objective of the best design for uncertain rock is %1 % smaller.")
            .arg(QLocale().toString(100 * (1 - robust / nominal), 'g', 2));
    QVERIFY2(m_page->card().toPlainText().contains(text), qPrintable(m_page->card().toPlainText()));
}

void TestDesignPage::aRangeUpsideDownIsMarkedAndAsksNothing() {
    showPage();
    const int studies = m_page->studies();
    QuantityField& low = field(*rows("uncertain").rows()[1], "low");
    low.setFocus();
    low.selectAll();
    QTest::keyClicks(&low, QLocale().toString(0.9));
    QVERIFY2(low.problem().contains(QStringLiteral("reversed")), qPrintable(low.problem()));
    QCOMPARE(m_page->studies(), studies);
    // what is shown is no longer what stands there
    QTRY_VERIFY(pageWords(*m_page).contains(QStringLiteral("reversed")));
    QVERIFY(m_page->command().isEmpty());
    low.selectAll();
    QTest::keyClicks(&low, QLocale().toString(0.07));
    QTRY_VERIFY(!pageWords(*m_page).contains(QStringLiteral("reversed")));
    QVERIFY(low.problem().isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY(m_page->studies() > studies);
    QCOMPARE(m_page->answer()->report.study.uncertain[1].low, 0.07);
}

void TestDesignPage::whatCannotBeSolvedIsSaid() {
    showPage();
    // a design variable that is uncertain, too
    rows("choices").rows()[0]->setRange({findParameter("bit_rock.stiffness"), 50e6, 100e6, false});
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    const QString words = pageWords(*m_page);
    QVERIFY2(words.contains(QStringLiteral("stiffness k is both")), qPrintable(words));
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
}

// Also where all of them are in the Pareto set, or none is out of it.
void TestDesignPage::theDesignsFillTheirPlot() {
    showPage();
    DesignReport report = m_page->answer()->report;
    const DesignNames names(report.study);
    const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
    const QCPAxisRect* scatter = axesOf(DesignPanel::tradeOff);
    for (const bool all : {false, true}) {
        if (all) report.findings.best.pareto.assign(report.findings.designs.size(), true);
        const StudyFigure figure = designFigure(report, names);
        std::vector<double> values;
        for (const FigureSeries& series : figure.panels[1].series)
            values.insert(values.end(), series.x.begin(), series.x.end());
        m_page->figureFrame().present({figure, {{}, unit}});
        const auto [least, most] = std::ranges::minmax(values);
        const QCPRange range = scatter->axis(QCPAxis::atBottom)->range();
        QVERIFY(range.contains(least) && range.contains(most));
        QVERIFY2(range.size() < 1.5 * (most - least), qPrintable(QString::number(range.size())));
    }
}

void TestDesignPage::twoChoicesAreAMap() {
    showPage();
    RangeRows& choices = rows("choices");
    choices.add();
    choices.rows()[1]->setRange({findParameter("rod.length"), 3, 6, false});
    for (RangeRow* row : choices.rows()) row->findChild<QSpinBox*>(QStringLiteral("count"))->setValue(5);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    m_page->plot()->replot();
    const DesignReport& report = m_page->answer()->report;
    QCOMPARE(report.findings.designs.size(), std::size_t{25});
    const FigureFrame& frame = m_page->figureFrame();
    const FieldItem* field = frame.field();
    QVERIFY(field && frame.graph(0, 0)->data()->isEmpty());
    const DesignAim& aim = report.study.aims.front();
    const StatisticPlace place = report.study.placeOf(*aim.output, aim.statistic);
    for (std::size_t d = 0; d < 25; ++d)
        QCOMPARE(field->field()->grid->value(d % 5, d / 5),
                 designOrdinate(report.study, *aim.output,
                                report.findings.designs[d].statistics[place.output][place.statistic].value));
    const std::size_t robust = *report.findings.best.robust;
    QVERIFY(frame.keyPlaces().marks().contains(field->placeOf({robust % 5, robust / 5})));

    // A click within a cell takes its design.
    constexpr std::uint64_t taken = 7;
    const QCPAxisRect* rect = axesOf(DesignPanel::objective);
    const QPointF at = field->placeOf({taken % 5, taken / 5});
    const QPointF pixel(rect->axis(QCPAxis::atBottom)->coordToPixel(at.x()) + 4,
                        rect->axis(QCPAxis::atLeft)->coordToPixel(at.y()) - 4);
    QVERIFY2(frame.fieldWords(at).contains(QStringLiteral(" · ")), "no words");
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, pixel.toPoint());
    QVERIFY(std::abs(m_document->scenario().pulse.duration / report.study.choice(taken)[0] - 1) < 1e-12);
    QVERIFY(std::abs(m_document->scenario().rod.length / report.study.choice(taken)[1] - 1) < 1e-12);

    // With one choice less there are curves again.
    choices.rows()[1]->findChild<QToolButton*>(QStringLiteral("remove"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY(!frame.field() && !objective()->data()->isEmpty());
}

void TestDesignPage::rowsAreAddedAndRemoved() {
    showPage();
    RangeRows& uncertain = rows("uncertain");
    QCOMPARE(uncertain.rows().size(), std::size_t{3});
    uncertain.rows()[2]->findChild<QToolButton*>(QStringLiteral("remove"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QCOMPARE(m_page->answer()->report.study.uncertain.size(), std::size_t{2});
    uncertain.add();
    QCOMPARE(std::string(uncertain.rows()[2]->range().parameter->key), std::string("bit_rock.gap"));
    // beyond the usual ones any other that the scenario has, and what stands there stays
    uncertain.rows()[0]->setRange({findParameter("bit_rock.stiffness"), 50e6, 250e6, true});
    uncertain.add();
    QCOMPARE(uncertain.rows().size(), std::size_t{4});
    QVERIFY(uncertain.rows()[3]->range().parameter);
    QCOMPARE(uncertain.rows()[0]->range().stop, 250e6);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY(m_page->answer()->problems.empty());
    QCOMPARE(m_page->answer()->report.study.uncertain.size(), std::size_t{4});
    rows("choices").rows()[0]->findChild<QToolButton*>(QStringLiteral("remove"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QCOMPARE(m_page->answer()->report.findings.designs.size(), std::size_t{1});
    QVERIFY(!objective()->data()->isEmpty());
}

void TestDesignPage::aimsAreCustomaryUntilTheyAreChosen() {
    showPage();
    auto* aims = m_page->findChild<AimRows*>();
    QCOMPARE(aims->aims().size(), std::size_t{2});
    aims->setAims({{Sense::largest, findOutput("loading_work"), {Statistic::Kind::mean}}});
    m_document->assign(*findParameter("drill.blow_frequency"), 50, m_document->newGesture());
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QCOMPARE(m_page->answer()->report.study.aims.size(), std::size_t{1});
    QVERIFY(m_page->command().contains(QStringLiteral("--aim max:loading_work@mean")));
}

void TestDesignPage::anotherFormHasOtherRows() {
    showPage();
    QVERIFY(m_document->open(example(QStringLiteral("t38_string"))).isEmpty());
    QCOMPARE(std::string(rows("choices").rows()[0]->range().parameter->key), std::string("hammer.1.length"));
    QVERIFY(m_document->open(example(QStringLiteral("paper_fig4b"))).isEmpty());
    QCOMPARE(std::string(rows("uncertain").rows()[0]->range().parameter->key), std::string("beta"));
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY(m_page->answer()->hasBest());
}

TestDesignPage::Asked TestDesignPage::asked() const {
    return {rows("uncertain").texts(), rows("choices").texts(), m_page->findChild<AimRows*>()->aims(),
            m_page->findChild<QCheckBox*>(QStringLiteral("keepEnergy"))->isChecked()};
}

// The box of results had followed the string and back, and with that the aim counted as chosen.
void TestDesignPage::anotherDocumentBeginsWithWhatIsProposedForIt() {
    const char* const examples[] = {"t38_medium_rock", "t38_string", "t38_medium_rock", "t38_string"};
    std::vector<Asked> alone;
    for (const char* name : examples) {
        open(name);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        alone.push_back(asked());
    }
    QVERIFY(alone[0].uncertain != alone[1].uncertain);
    open(examples[0]);
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    for (std::size_t i = 0; i < std::size(examples); ++i) {
        QVERIFY(m_document->open(example(QString::fromLatin1(examples[i]))).isEmpty());
        QCOMPARE(asked().aims.front().output->name, std::string_view("efficiency"));
        QVERIFY(asked() == alone[i]);
        // what is chosen by hand stays with an edit, and goes with the document
        m_page->findChild<AimRows*>()->setAims(
            {{Sense::largest, findOutput("cor"), {Statistic::Kind::mean}}});
        m_page->findChild<QCheckBox*>(QStringLiteral("keepEnergy"))->setChecked(false);
        m_document->assign(*findParameter("bit_rock.gamma"), 0.25, m_document->newGesture());
        QCOMPARE(asked().aims.front().output->name, std::string_view("cor"));
        QVERIFY(!asked().keepsEnergy);
    }
    // also where the page was out of sight meanwhile
    m_page->hide();
    QVERIFY(m_document->open(example(QString::fromLatin1(examples[0]))).isEmpty());
    m_page->show();
    QVERIFY(asked() == alone[0]);
}

void TestDesignPage::anAimThatTheScenarioNoLongerHasIsTheProposedOne() {
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    m_page->findChild<AimRows*>()->setAims({{Sense::least, findOutput("thrust"), {Statistic::Kind::mean}}});
    m_document->clear(*findParameter("drill.blow_frequency"), m_document->newGesture());
    QVERIFY(asked().aims == customaryAims(m_document->scenario()));
}

void TestDesignPage::aMeasuredBlowHasADesignToChoose() {
    open("t38_string");
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    Scenario scenario = forcedStringOf(m_document->scenario()).scenario;
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tablePoints = {{0, 0}, {50e-6, 200e3}, {200e-6, 100e3}, {250e-6, 0}};
    QCOMPARE(m_document->useScenario(scenario, QStringLiteral("take a blow")), QString());
    RangeRows& choices = rows("choices");
    choices.add();
    QCOMPARE(choices.rows().size(), std::size_t{2});
    QCOMPARE(std::string(choices.rows()[0]->range().parameter->key),
             std::string(typicalSize(m_document->scenario())->key));
    const std::string_view second = choices.rows()[1]->range().parameter->key;
    QVERIFY2(!second.ends_with("youngs_modulus") && !second.ends_with("density"), second.data());
}

void TestDesignPage::parametersAreCalledAsInTheForm() {
    open("t38_string");
    QVERIFY(m_document->assign(*findParameter("bit_rock.gap"), 0, m_document->newGesture()).isEmpty());
    DesignStudy study;
    study.base = m_document->scenario();
    study.uncertain = {parseUncertain("bit_rock.stiffness=50MN/m:150MN/m").input};
    study.choices = {parseAxis("hammer.1.length=0.2m:0.4m:2").axis};
    study.aims = customaryAims(study.base);
    DesignAnswer answer{.report = {.study = study, .findings = {}, .scenarioText = {}}, .problems = {}};
    answer.report.study.samples = answer.wanted = leastDesignSamples;
    answer.report.findings = runDesign(answer.report.study, {});
    QVERIFY(answer.hasBest());
    DesignCard card;
    const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
    card.present(answer, DesignUnits(answer.report.study, ShownUnits(), unit, QLocale::c()));
    const QString text = card.toPlainText();  // of two values either is an end
    QVERIFY2(text.contains(QStringLiteral("end of the range of length of hammer 1: extend")),
             qPrintable(text));
    QVERIFY2(!text.contains(QStringLiteral("hammer.1")), qPrintable(text));
}

void TestDesignPage::aShareIsNeverMoreThanAll() {
    showPage();
    DesignAnswer answer = *m_page->answer();
    for (OutputSensitivity& output : answer.report.findings.sensitivity.outputs)
        output.indices[1].total = {1.7, 0.1};
    const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
    const DesignUnits units(answer.report.study, ShownUnits(), unit, QLocale::c());
    DesignCard card;
    card.present(answer, units);
    QVERIFY2(
        card.toPlainText().contains(QStringLiteral("elasticity γ first: it causes 100 % of the scatter")),
        qPrintable(card.toPlainText()));
    const auto bars = [&] { return designFigure(answer.report, DesignNames(answer.report.study)).panels[2]; };
    QVERIFY(!bars().isHidden);
    for (const FigureSeries& series : bars().series)
        for (const double share : series.x) QVERIFY(share <= 1);
    // of few samples there is neither advice nor a picture of it
    answer.report.study.samples = 16;
    card.present(answer, units);
    QVERIFY(!card.toPlainText().contains(QStringLiteral("of the scatter")));
    QVERIFY(bars().isHidden);
}

void TestDesignPage::barsHaveRoomForTheirNames() {
    showPage();
    m_page->resize(900, 500);
    for (const int rowsOfRanges : {3, 6}) {
        while (rows("uncertain").rows().size() < std::size_t(rowsOfRanges)) rows("uncertain").add();
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
        QCoreApplication::processEvents();
        m_page->plot()->replot();
        const QCPAxisRect* bars = axesOf(DesignPanel::causes);
        if (!bars->visible()) continue;  // a study that was refused has none
        const QCPAxis* names = bars->axis(QCPAxis::atLeft);
        const double row = std::abs(names->coordToPixel(-1) - names->coordToPixel(-2));
        const double line = QFontMetricsF(names->tickLabelFont()).height();
        QVERIFY2(row >= line, qPrintable(QStringLiteral("%1 px for %2 px").arg(row).arg(line)));
    }
}

void TestDesignPage::boxesAreAsWideAsWhatIsChosen() {
    open("t38_string");
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    rows("choices").rows()[0]->setRange({findParameter("material.youngs_modulus"), 100e9, 200e9, false});
    for (SectionBox* section : m_page->findChildren<SectionBox*>()) section->setOpen(true);
    for (const QSize size : {QSize(700, 900), QSize(1100, 900)}) {
        m_page->resize(size);
        QCoreApplication::processEvents();
        for (QWidget* group :
             {static_cast<QWidget*>(&rows("uncertain")), static_cast<QWidget*>(&rows("choices")),
              static_cast<QWidget*>(m_page->findChild<AimRows*>())})
            for (QComboBox* box : group->findChildren<QComboBox*>()) {
                QStyleOptionComboBox option;
                option.initFrom(box);
                option.subControls = QStyle::SC_All;
                const int room =
                    box->style()
                        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box)
                        .width();
                QVERIFY2(room >= box->fontMetrics().horizontalAdvance(box->currentText()),
                         qPrintable(box->currentText()));
            }
    }
}

void TestDesignPage::theCountOfSolvesNeverGoesBack() {
    showPage();
    DesignStudy study = m_page->answer()->report.study;
    study.samples = 1024;
    std::mutex lock;
    std::vector<std::size_t> told;
    const std::stop_source never;
    const DesignAnswer answer = answerDesign({study}, {never.get_token(),
                                                       [&](const StudyProgress& progress) {
                                                           const std::lock_guard guard(lock);
                                                           told.push_back(progress.done);
                                                       },
                                                       [](const DesignAnswer&) {}});
    QVERIFY(answer.isRefined());
    QVERIFY(told.size() > 10);
    QVERIFY(std::ranges::is_sorted(told));
}

void TestDesignPage::aStudyOutOfSightIsStopped() {
    open("t38_string");
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_COMPARE(m_page->activity()->state(), StudyState::running);
    m_page->hide();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
}

// Undone, saved and opened as every other edit.
void TestDesignPage::theSetUpOfTheDocumentIsShownAndKept() {
    showPage();
    m_document->undoStack().clear();
    QVERIFY(!m_document->isModified());
    const DesignSetup before = m_document->design();
    rows("uncertain").rows()[0]->setRange({findParameter("bit_rock.stiffness"), 60e6, 240e6, false});
    QVERIFY(m_document->isModified());
    QCOMPARE(m_document->design().uncertain[0], std::string("bit_rock.stiffness=60 MN/m:240 MN/m"));
    m_document->undoStack().undo();
    QVERIFY(!m_document->isModified() && m_document->design() == before);
    QVERIFY(rows("uncertain").texts()[0] != "bit_rock.stiffness=60 MN/m:240 MN/m");
    m_document->undoStack().redo();
    auto* aims = m_page->findChild<AimRows*>();
    aims->setAims({{Sense::largest, findOutput("loading_work"), {Statistic::Kind::mean}}});
    const QString path = m_folder.filePath(QStringLiteral("with_design.yaml"));
    QVERIFY(m_document->save(path).isEmpty());
    const Asked kept = asked();
    QVERIFY(m_document->open(example(QStringLiteral("t38_medium_rock"))).isEmpty());
    QVERIFY(!(asked() == kept) && m_document->design().isEmpty());
    QVERIFY(m_document->open(path).isEmpty());
    QVERIFY(asked() == kept);
    QVERIFY(!m_document->isModified());
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QCOMPARE(m_page->answer()->report.study.aims[0].name(), std::string("max:loading_work@mean"));
}

void TestDesignPage::untouchedControlsChangeNoFile() {
    const QByteArray before = m_document->text();
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_VERIFY(m_page->studies() > 0);
    QVERIFY(!m_document->isModified() && m_document->design().isEmpty());
    QCOMPARE(m_document->text(), before);
}

void TestDesignPage::tickedHammersAreDesigns() {
    showPage();
    auto* menu = m_page->findChild<QToolButton*>(QStringLiteral("hammer"))->menu();
    QVERIFY(m_page->findChild<QToolButton*>(QStringLiteral("bit"))->isHidden());
    for (const char* name : {"light drifter, short blow", "heavy drifter, piston"})
        menu->findChild<QCheckBox*>(QString::fromLatin1(name))->click();
    // the duration of the blow is the hammer's now, and so is its energy
    QVERIFY(rows("choices").rows().empty());
    QVERIFY(!m_page->findChild<QCheckBox*>(QStringLiteral("keepEnergy"))->isEnabled());
    QCOMPARE(m_document->design().choose,
             std::vector<std::string>{"hammer=light drifter, short blow,heavy drifter, piston"});
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY2(m_page->answer()->problems.empty(), "cannot run");
    QCOMPARE(m_page->figureFrame().figure().panels[0].x.names.size(), std::size_t{2});
    QCOMPARE(m_page->answer()->report.findings.designs.size(), std::size_t{2});
    QVERIFY(
        m_page->command().contains(QStringLiteral("hammer=light drifter, short blow,heavy drifter, piston")));
    const int steps = m_document->undoStack().count();
    auto* card = m_page->findChild<DesignCard*>();
    const Scenario expected = designScenario(m_page->answer()->report.study, 1);
    emit card->designWanted(1);
    QCOMPARE(m_document->undoStack().count(), steps + 1);
    QVERIFY(m_document->scenario().pulse == expected.pulse);
}

// Numbers stood for hammers below the plot, lines joined them, and the last name had no room.
void TestDesignPage::hammersAreNamedPointsOfTheirAxis() {
    showPage();
    auto* menu = m_page->findChild<QToolButton*>(QStringLiteral("hammer"))->menu();
    for (const char* name : {"light drifter, short blow", "heavy drifter, piston", "Epiroc COP 1838"})
        menu->findChild<QCheckBox*>(QString::fromLatin1(name))->click();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QCOMPARE(m_page->figureFrame().figure().panels[0].x.names.size(), std::size_t{3});
    CurveReader& reader = m_page->plot()->reader();
    reader.setTableShown(true);
    m_page->plot()->replot();
    const QCPGraph& aim = *objective();
    // the names at the ends have room, and no line leads from one hammer to the next
    QCOMPARE(aim.keyAxis()->range().lower, -0.5);
    QCOMPARE(aim.keyAxis()->range().upper, 2.5);
    for (const double between : {0.5, 1.5}) {
        const auto at = aim.data()->findBegin(between - 0.1, false);
        QVERIFY(std::abs(at->key - between) < 0.1 && std::isnan(at->value));
    }
    const QString text = reader.text();
    QVERIFY2(text.contains(QStringLiteral("Epiroc COP 1838")) ||
                 text.contains(QStringLiteral("heavy drifter, piston")),
             qPrintable(text));
    QVERIFY2(!text.contains(QStringLiteral("from")), qPrintable(text));
    QCOMPARE(inLines(QStringLiteral("medium drifter, piston"), 6),
             QStringLiteral("medium\ndrifter,\npiston"));
    QCOMPARE(inLines(QStringLiteral("medium drifter"), 3), QStringLiteral("medium drifter"));
    for (const char* name : {"light drifter, short blow", "heavy drifter, piston", "Epiroc COP 1838"})
        menu->findChild<QCheckBox*>(QString::fromLatin1(name))->click();
    QVERIFY(rows("choices").rows().empty());
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    m_page->plot()->replot();
    QVERIFY2(!reader.text().contains(QStringLiteral("0.4")), qPrintable(reader.text()));
    QVERIFY2(reader.text().contains(QStringLiteral("this scenario")), qPrintable(reader.text()));
}

// The set-up of hammers has no energy to keep, and an undo with them showed that as the tick of the user.
void TestDesignPage::undoWithHammersKeepsTheTickOfTheEnergy() {
    showPage();
    const auto* keeps = m_page->findChild<QCheckBox*>(QStringLiteral("keepEnergy"));
    auto* menu = m_page->findChild<QToolButton*>(QStringLiteral("hammer"))->menu();
    const auto click = [&] {
        for (const char* name : {"light drifter, short blow", "heavy drifter, piston"})
            menu->findChild<QCheckBox*>(QString::fromLatin1(name))->click();
    };
    click();
    m_page->findChild<QToolButton*>(QStringLiteral("addAim"))->click();
    QVERIFY(!keeps->isEnabled() && keeps->isChecked());
    m_document->undoStack().undo();
    QTRY_COMPARE(m_page->findChild<AimRows*>()->aims().size(), std::size_t{2});
    QVERIFY(!keeps->isEnabled() && keeps->isChecked());
    click();
    QVERIFY(keeps->isEnabled() && keeps->isChecked());
    QVERIFY(m_document->design().keepEnergy);
}

void TestDesignPage::whatNoRowShowsStaysAsText() {
    const QString path = m_folder.filePath(QStringLiteral("texts.yaml"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(m_document->text() +
               "design:\n  uncertain: [bit_rock.gap=0mm:1mm, pulse.impulse=+-10%]\n"
               "  choose: ['rod.length=3m,4m', rod.diameter=36mm:40mm:3]\n  at_most: [thrust@q95=20kN]\n"
               "  samples: 512\n  seed: 5\n");
    file.close();
    QVERIFY(m_document->open(path).isEmpty());
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    const DesignStudy& study = m_page->answer()->report.study;
    QCOMPARE(study.uncertain.size(), std::size_t{2});
    QCOMPARE(study.choices.size(), std::size_t{2});
    QCOMPARE(study.limits.size(), std::size_t{1});
    QCOMPARE(study.samples, std::uint64_t{512});
    QCOMPARE(study.seed, std::uint64_t{5});
    QVERIFY(!study.keepsEnergy);
    QVERIFY(!m_document->isModified());
    QCOMPARE(rows("uncertain").rows().size(), std::size_t{1});
    rows("uncertain").findChild<QToolButton*>(QStringLiteral("removeText"))->click();
    QCOMPARE(m_document->design().uncertain.size(), std::size_t{1});
    QCOMPARE(m_document->design().atMost, std::vector<std::string>{"thrust@q95=20kN"});
}

// Without seconds to spare the first samples are the answer.
void TestDesignPage::aStudyOfAStringStopsAndOffersTheRest() {
    DesignStudy study;
    study.base = parseScenario(findExample("t38_string")->text, "").scenario;
    study.uncertain = {parseUncertain("bit_rock.gap=0mm:1mm").input};
    study.choices = {parseAxis("bit_rock.stiffness=80MN/m,100MN/m").axis};
    study.aims = {{Sense::largest, findOutput("efficiency"), {Statistic::Kind::mean}}};
    study.samples = 1024;
    const StudyFeed<DesignAnswer> feed{.stop = {}, .tell = [](auto) {}, .show = [](auto) {}};
    const DesignAnswer cut = answerDesign({study, 0.0}, feed);
    QVERIFY(cut.secondsLeft && *cut.secondsLeft > 0);
    QVERIFY(!cut.isRefined());
    study.samples = 16;
    const DesignAnswer whole = answerDesign({study, {}}, feed);
    QVERIFY(!whole.secondsLeft && whole.isRefined() && whole.hasBest());
}

void TestDesignPage::theCardHasTheMarksOfTheFiles() {
    showPage();
    const DesignReport& report = m_page->answer()->report;
    const std::optional<std::size_t> present = presentDesign(report.study);
    const std::pair<std::string_view, QString> marks[]{
        {"best_uncertain", QStringLiteral("Best for uncertain rock")},
        {"best_nominal", QStringLiteral("Best for the values entered")},
        {"equal", QStringLiteral("Equally good")},
        {"present", QStringLiteral("Present design")}};
    const QString text = m_page->card().toPlainText();
    for (const auto& [mark, words] : marks) {
        bool isThere = false;
        for (std::size_t d = 0; d < report.findings.designs.size(); ++d) {
            const auto ofDesign = marksOf(report, d, present);
            isThere |= std::ranges::find(ofDesign, mark) != ofDesign.end();
        }
        QVERIFY2(text.contains(words) == isThere, qPrintable(words + QLatin1Char('\n') + text));
    }
    QVERIFY(text.contains(QStringLiteral("Present design: 200")));
}

// The card took the sentence of the command, with keys of files and handy SI units.
void TestDesignPage::theHeadlineHasTheUnitsAndWordsOfThePage() {
    m_document->units().choose(UnitSystem::us);
    showPage();
    const DesignReport& report = m_page->answer()->report;
    const QString first = m_page->findChild<QLabel*>(QStringLiteral("answer"))->text();
    QVERIFY2(first.contains(QStringLiteral(" in 95")), qPrintable(first));
    QVERIFY2(first.contains(QStringLiteral(" ± ")), qPrintable(first));
    for (const char* plain : {"q05", "q95", "+-", " us", " mm", " kN", " m,"})
        QVERIFY2(!first.contains(QLatin1String(plain)), qPrintable(first));
    QVERIFY2(first.contains(QStringLiteral("µs")), qPrintable(first));
    QVERIFY2(headlineMessage(report).text().find(" us") != std::string::npos, "the command keeps its words");
    DesignAnswer answer = *m_page->answer();
    BestDesigns& best = answer.report.findings.best;
    best.equal.clear();
    for (std::size_t d = 0; d < answer.report.findings.designs.size(); ++d) best.equal.push_back(d);
    const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
    const DesignUnits units(answer.report.study, ShownUnits(), unit, QLocale::c());
    const QString headline = DesignCard::headline(answer.report, units);
    QVERIFY2(headline.startsWith(QStringLiteral("The choice of duration t₀ makes no difference")),
             qPrintable(headline));
}

// "Best for uncertain rock" of another design stood below "Keep", with a link that loaded it.
void TestDesignPage::whereThePresentDesignStaysNoOtherIsOffered() {
    showPage();
    DesignAnswer answer = *m_page->answer();
    DesignFindings& findings = answer.report.findings;
    const std::size_t present = presentDesign(answer.report.study).value();
    findings.best.robust = present + 1;
    const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
    const DesignUnits units(answer.report.study, ShownUnits(), unit, QLocale::c());
    for (const bool isFlat : {false, true}) {
        findings.best.equal = {present};
        for (std::size_t d = 0; isFlat && d < findings.designs.size(); ++d)
            if (d != present) findings.best.equal.push_back(d);
        findings.recommended = findings.best.chosen = present;
        DesignCard card;
        card.present(answer, units);
        const QString text = card.toPlainText();
        QVERIFY2(text.contains(QStringLiteral("Present design: 200")), qPrintable(text));
        QVERIFY2(!text.contains(QStringLiteral("Best for uncertain rock")), qPrintable(text));
        QVERIFY2(!text.contains(QStringLiteral("Load the best design for uncertain rock")), qPrintable(text));
        QCOMPARE(text.contains(QStringLiteral("Load the best design for the values entered")), !isFlat);
    }
}

QTEST_MAIN(TestDesignPage)
#include "tst_design_page.moc"

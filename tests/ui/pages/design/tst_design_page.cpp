// SPDX-License-Identifier: GPL-3.0-or-later
// The page Design: the numbers of the command, rows that say what is not known, and designs in the hand.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/study/design/constant_energy.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/design/design_card.h"
#include "ui/pages/design/design_page.h"
#include "ui/pages/design/design_plot.h"
#include "ui/pages/design/range_rows.h"
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
    void aStudyOutOfSightIsStopped();

  private:
    void open(const char* name);
    void showPage();
    bool isAnswered() const;
    void few() const;
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
    const QPointF at = m_page->designPlot().picture().series[0].aim[static_cast<qsizetype>(design)];
    const QCPGraph* graph = m_page->designPlot().graphs()[0];
    const QPointF pixel(graph->keyAxis()->coordToPixel(at.x()), graph->valueAxis()->coordToPixel(at.y()));
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
    const QString text = QStringLiteral("the robust best has %1 % less.")  // plain text has no fixed blanks
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
    QVERIFY2(low.problem().contains(QStringLiteral("upside down")), qPrintable(low.problem()));
    QCOMPARE(m_page->studies(), studies);
    // what is shown is no longer what stands there
    const auto* words = m_page->findChild<QLabel*>(QStringLiteral("words"));
    QTRY_VERIFY(words->text().contains(QStringLiteral("upside down")));
    QVERIFY(m_page->command().isEmpty());
    low.selectAll();
    QTest::keyClicks(&low, QLocale().toString(0.07));
    QTRY_VERIFY(!words->text().contains(QStringLiteral("upside down")));
    QVERIFY(low.problem().isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY(m_page->studies() > studies);
    QCOMPARE(m_page->answer()->report.study.uncertain[1].low, 0.07);
}

void TestDesignPage::whatCannotBeSolvedIsSaid() {
    showPage();
    // what is uncertain is chosen, too
    rows("choices").rows()[0]->setRange({findParameter("bit_rock.stiffness"), 50e6, 100e6, false});
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    const QString words = m_page->findChild<QLabel*>(QStringLiteral("words"))->text();
    QVERIFY2(words.contains(QStringLiteral("stiffness k is chosen")), qPrintable(words));
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
}

// Also where all of them are in the Pareto set, or none is out of it.
void TestDesignPage::theDesignsFillTheirPlot() {
    showPage();
    const DesignPicture& picture = m_page->designPlot().picture();
    const QCPAxisRect* scatter = m_page->plot()->axisRects()[1];
    for (const bool all : {false, true}) {
        DesignPicture shown = picture;
        if (all) shown.pareto.fill(true);
        m_page->findChild<DesignPlot*>()->present(shown);
        double least = shown.designs[0].x(), most = least;
        for (const QPointF& design : shown.designs) {
            least = std::min(least, design.x());
            most = std::max(most, design.x());
        }
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
    const DesignPicture& picture = m_page->designPlot().picture();
    QVERIFY(picture.map && m_page->designPlot().graphs().isEmpty());
    const DesignAim& aim = report.study.aims.front();
    const StatisticPlace place = report.study.placeOf(*aim.output, aim.statistic);
    for (std::size_t d = 0; d < 25; ++d)
        QCOMPARE(picture.map->grid().value(d % 5, d / 5),
                 report.findings.designs[d].statistics[place.output][place.statistic].value *
                     picture.value.factor);
    QVERIFY(picture.robust == placeOnMap(*picture.map, *report.findings.best.robust));

    // A click within a cell takes its design.
    constexpr std::uint64_t taken = 7;
    const QCPAxisRect* rect = m_page->plot()->axisRects()[0];
    const QPointF at = placeOnMap(*picture.map, taken);
    const QPointF pixel(rect->axis(QCPAxis::atBottom)->coordToPixel(at.x()) + 4,
                        rect->axis(QCPAxis::atLeft)->coordToPixel(at.y()) - 4);
    QVERIFY2(m_page->designPlot().mapWords(at).contains(QStringLiteral(" · ")), "no words");
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, pixel.toPoint());
    QVERIFY(std::abs(m_document->scenario().pulse.duration / report.study.choice(taken)[0] - 1) < 1e-12);
    QVERIFY(std::abs(m_document->scenario().rod.length / report.study.choice(taken)[1] - 1) < 1e-12);

    // Of one choice less there are curves again.
    choices.rows()[1]->findChild<QToolButton*>(QStringLiteral("remove"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patienceForDesigns);
    QVERIFY(!m_page->designPlot().isMap());
    QCOMPARE(m_page->designPlot().graphs().size(), 1);
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
    QCOMPARE(m_page->designPlot().graphs().size(), 1);
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

void TestDesignPage::aStudyOutOfSightIsStopped() {
    open("t38_string");
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_COMPARE(m_page->activity()->state(), StudyState::running);
    m_page->hide();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
}

QTEST_MAIN(TestDesignPage)
#include "tst_design_page.moc"

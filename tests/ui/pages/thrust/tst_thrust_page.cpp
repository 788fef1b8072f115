// SPDX-License-Identifier: GPL-3.0-or-later
// The page Thrust: the numbers of the command, the feed in the hand, and what it says where something lacks.
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "core/report/feed_words.h"
#include "core/report/thrust_report.h"
#include "core/study/thrust/thrust_study.h"
#include "core/yaml/examples.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

// For a study of a hundred points on a machine that is busy with other tests.
constexpr int patience = 60'000;

}  // namespace

class TestThrustPage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void aPageThatCannotBeSeenComputesNothing();
    void theExportIsWhatTheCopiedCommandWrites_data();
    void theExportIsWhatTheCopiedCommandWrites();
    void theCurvesAreTheNeedsOfEachPoint();
    void theTableAndTheSentenceAreThoseOfTheStudy();
    void theSentenceHasTheNumbersOfTheReader();
    void draggingTheFeedIsOneUndoStep();
    void aDragGoesOnWhileAnswersArrive();
    void aDragBesideTheLineDoesNotMoveIt();
    void theLineOfTheFeedFollowsTheScenario();
    void weightAlongTheHoleStaysWhileTheThrustIsDragged();
    void aCurvedLineIsDraggedWhereItWasTaken();
    void aClickTakesOverTheFrequencyThere();
    void whatLacksIsSaidAndCanBeEntered();
    void whatLacksIsEnteredInTheUnitsOfTheForm();
    void itIsNotThereWithoutUnitsAndKeepsItsChoice();
    void bandsEndAtTheAxes();
    void columnsOfTheTable_areNotCutInANarrowPage();
    void aStringIsToldOfItsBlowAndRigidRock();
    void aStringsExportIsWhatTheCopiedCommandWrites_data();
    void aStringsExportIsWhatTheCopiedCommandWrites();
    void theFeedOfAStringIsDragged();
    void aRodAfterAStringHasAllItsNeedsAgain();

  private:
    void openString();
    void compareWithCommand() const;
    QStringList legendNames() const;
    void showPage();
    bool isAnswered() const;
    QString words() const { return pageWords(*m_page); }
    QString wordsOf(const ThrustStudy& study) const;
    QPointF feedPixel() const;
    void drag(QPointF from, double pixels) const;
    QCPGraph* need(ThrustCase which) const;
    QCPGraph* feed() const;
    QCPAxis& x() const { return *m_page->figureFrame().graph()->keyAxis(); }
    QCPAxis& y() const { return *m_page->figureFrame().graph()->valueAxis(); }
    void chooseAxis(const char* key, double start, double stop, bool logarithmic) const;

    QTemporaryDir m_folder;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<FigurePage> m_page;
};

void TestThrustPage::initTestCase() {
    keepSettingsIn(m_folder.path());
}

void TestThrustPage::init() {
    m_page.reset();
    m_document = std::make_unique<Document>();
    QVERIFY(m_document->open(example(QStringLiteral("t38_medium_rock"))).isEmpty());
    m_page = std::make_unique<FigurePage>(thrustStudy(), *m_document);
    m_page->resize(900, 700);
}

void TestThrustPage::showPage() {
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    m_page->plot()->replot();
}

bool TestThrustPage::isAnswered() const {
    return m_page->activity()->state() == StudyState::finished && m_page->activity()->isCurrent();
}

// The known cases come first, and then the feed; nullptr of a case that is not known.
QCPGraph* TestThrustPage::need(ThrustCase which) const {
    const std::vector<FigureSeries> series = m_page->answer()->figure(0).panels.front().series;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (series[i].legend == Message(labelOf(which))) return m_page->figureFrame().graph(0, i);
    return nullptr;
}

QCPGraph* TestThrustPage::feed() const {
    return m_page->figureFrame().graph(0, m_page->answer()->figure(0).panels.front().series.size() - 1);
}

QPointF TestThrustPage::feedPixel() const {
    const QCPGraphDataContainer& line = *feed()->data();
    const QCPGraphData& middle = *line.at(line.size() / 3);
    return {x().coordToPixel(middle.key), y().coordToPixel(middle.value)};
}

void TestThrustPage::drag(QPointF from, double pixels) const {
    PlotWidget* plot = m_page->plot();
    QTest::mousePress(plot, Qt::LeftButton, {}, from.toPoint());
    for (int step = 1; step <= 4; ++step)
        QTest::mouseMove(plot, (from + QPointF(0, pixels * step / 4)).toPoint());
    QTest::mouseRelease(plot, Qt::LeftButton, {}, (from + QPointF(0, pixels)).toPoint());
}

void TestThrustPage::chooseAxis(const char* key, double start, double stop, bool logarithmic) const {
    m_page->findChild<AxisFields*>()->setRange({findParameter(key), start, stop, logarithmic});
}

void TestThrustPage::aPageThatCannotBeSeenComputesNothing() {
    m_document->assign(*findParameter("drill.thrust"), 6000, m_document->newGesture());
    QTest::qWait(0);
    QCOMPARE(m_page->studies(), 0);
    showPage();
    QCOMPARE(m_page->studies(), 1);
    m_page->hide();
    m_document->assign(*findParameter("drill.thrust"), 7000, m_document->newGesture());
    QCOMPARE(m_page->studies(), 1);
}

void TestThrustPage::theExportIsWhatTheCopiedCommandWrites_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("stop");
    QTest::addColumn<bool>("logarithmic");
    QTest::newRow("frequency") << QByteArray("drill.blow_frequency") << 31.7 << 97.3 << false;
    QTest::newRow("stiffness") << QByteArray("bit_rock.stiffness") << 3.1e7 << 2.9e8 << true;
    QTest::newRow("diameter, partly impossible") << QByteArray("rod.diameter") << 0.0127 << 0.039 << false;
}

void TestThrustPage::theExportIsWhatTheCopiedCommandWrites() {
    QFETCH(QByteArray, key);
    QFETCH(double, start);
    QFETCH(double, stop);
    QFETCH(bool, logarithmic);
    m_document->assign(*findParameter("drill.inclination"), 33.3, m_document->newGesture());
    const QString path = m_folder.filePath(QStringLiteral("drill.yaml"));
    QVERIFY(m_document->save(path).isEmpty());
    m_page->show();
    chooseAxis(key, start, stop, logarithmic);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    compareWithCommand();
}

void TestThrustPage::compareWithCommand() const {
    const QString command = m_page->command();
    QVERIFY2(command.startsWith(QStringLiteral("drillwave thrust ") + m_document->path()),
             qPrintable(command));
    QStringList typed = QProcess::splitCommand(QString(command).replace(QLatin1Char('\''), QLatin1Char('"')));
    typed.removeFirst();
    const Finished finished = run(typed);
    QVERIFY2(finished.exitCode == 0 || finished.exitCode == 6, finished.error.constData());
    const QByteArray shown = m_page->exports().first().csv();
    QCOMPARE(shown, finished.out);
    const qsizetype points = need(ThrustCase::scenario)->data()->size();
    QVERIFY(points > 2 && shown.count('\n') > points);
}

void TestThrustPage::theCurvesAreTheNeedsOfEachPoint() {
    showPage();
    const Parameter& frequency = *findParameter("drill.blow_frequency");
    for (const ThrustCase which : thrustCases) {
        const QCPGraphDataContainer& line = *need(which)->data();
        QCOMPARE(line.size(), 101);
        for (const int i : {0, 50, 100}) {
            Scenario scenario = m_document->scenario();
            frequency.assign(scenario, line.at(i)->key);  // Hz
            const double expected = studyThrust(scenario).need(which).thrust / 1000;
            QVERIFY(std::abs(line.at(i)->value / expected - 1) < 1e-14);
        }
    }
}

void TestThrustPage::theTableAndTheSentenceAreThoseOfTheStudy() {
    showPage();
    const ThrustStudy study = studyThrust(m_document->scenario());
    QCOMPARE(words(), wordsOf(study));
    auto* table = m_page->findChild<QTableWidget*>(QStringLiteral("answerTable"));
    for (const ThrustCase which : thrustCases) {
        const QString need = table->item(0, int(which))->text();
        const double shown = QLocale().toDouble(need.section(QLatin1Char(' '), 0, 0));
        QVERIFY2(std::abs(shown * 1000 / study.need(which).thrust - 1) < 1e-3, qPrintable(need));
        const QString margin = table->item(2, int(which))->text();
        QVERIFY2(margin.startsWith(QLatin1Char('+')) && margin.endsWith(QLatin1Char('%')),
                 qPrintable(margin));
    }
}

QString TestThrustPage::wordsOf(const ThrustStudy& study) const {
    QStringList sentences;
    for (const Message& sentence :
         thrustSentences(m_document->scenario(), study.feed, {}, LocalStyle::of(m_document->units())))
        sentences << QString::fromStdString(sentence.text());
    return sentences.join(QLatin1Char(' '));
}

// In the locale and the units of the window, as the table is.
void TestThrustPage::theSentenceHasTheNumbersOfTheReader() {
    const QLocale before;
    const auto restore = qScopeGuard([&] {
        QLocale::setDefault(before);
        m_document->units().choose(UnitSystem::si);
    });
    m_document->assign(*findParameter("drill.thrust"), 8250, m_document->newGesture());
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    showPage();
    QVERIFY2(words().startsWith(QStringLiteral(
                 "A feed force of 8,25 kN is enough for a single blow at any gap (7,253 kN required).")),
             qPrintable(words()));
    QVERIFY2(!words().contains(QRegularExpression(QStringLiteral("[0-9]\\.[0-9]"))), qPrintable(words()));
    QLocale::setDefault(QLocale::c());
    m_document->units().choose(UnitSystem::us);
    QVERIFY2(words().startsWith(QStringLiteral(
                 "A feed force of 1855 lbf is enough for a single blow at any gap (1631 lbf required).")),
             qPrintable(words()));
    QVERIFY2(!words().contains(QStringLiteral("kN")), qPrintable(words()));
}

void TestThrustPage::draggingTheFeedIsOneUndoStep() {
    showPage();
    const double before = *m_document->scenario().drill.thrust;
    drag(feedPixel(), 60);
    const double after = *m_document->scenario().drill.thrust;
    QVERIFY(after < before);
    const double expected = before - 1000 * (y().pixelToCoord(0) - y().pixelToCoord(60));
    // To the pixel, and no digits beyond it.
    QVERIFY2(std::abs(after - expected) < 150, qPrintable(QString::number(after)));
    QCOMPARE(m_document->undoStack().count(), 1);
    drag(feedPixel() + QPointF(0, 60), -30);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    m_document->undoStack().undo();
    while (m_document->undoStack().canUndo()) m_document->undoStack().undo();
    QCOMPARE(*m_document->scenario().drill.thrust, before);
}

// Every answer draws the line again; the drag goes on.
void TestThrustPage::aDragGoesOnWhileAnswersArrive() {
    showPage();
    const QPointF from = feedPixel();
    PlotWidget* plot = m_page->plot();
    QTest::mousePress(plot, Qt::LeftButton, {}, from.toPoint());
    double before = *m_document->scenario().drill.thrust;
    for (const double pixels : {10, 20, 30}) {
        QTest::mouseMove(plot, (from + QPointF(0, pixels)).toPoint());
        QVERIFY(*m_document->scenario().drill.thrust < before);
        before = *m_document->scenario().drill.thrust;
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    }
    QTest::mouseRelease(plot, Qt::LeftButton, {}, (from + QPointF(0, 30)).toPoint());
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TestThrustPage::aDragBesideTheLineDoesNotMoveIt() {
    showPage();
    drag(feedPixel() + QPointF(0, -40), 30);
    QCOMPARE(m_document->undoStack().count(), 0);
    // Over the thrust itself the line is where thrust is what it is.
    chooseAxis("drill.thrust", 1000, 20'000, false);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    m_page->plot()->replot();
    drag(feedPixel(), 30);
    QCOMPARE(m_document->undoStack().count(), 0);
}

void TestThrustPage::theLineOfTheFeedFollowsTheScenario() {
    showPage();
    m_document->assign(*findParameter("drill.thrust"), 5000, m_document->newGesture());
    QTRY_COMPARE(feed()->data()->at(7)->value, 5.0);
}

void TestThrustPage::weightAlongTheHoleStaysWhileTheThrustIsDragged() {
    m_document->assign(*findParameter("drill.machine_mass"), 400, m_document->newGesture());
    m_document->assign(*findParameter("drill.inclination"), 90, m_document->newGesture());
    showPage();
    const FeedForce before = *feedForceOf(m_document->scenario());
    QVERIFY(std::abs(feed()->data()->at(7)->value * 1000 / before.effective() - 1) < 1e-12);
    drag(feedPixel(), 20);
    const FeedForce after = *feedForceOf(m_document->scenario());
    QCOMPARE(*after.weight, *before.weight);
    QVERIFY(after.thrust < before.thrust && after.thrust > before.thrust - 2000);
}

// Over the inclination it is a curve: what is taken hold of stays in the hand.
void TestThrustPage::aCurvedLineIsDraggedWhereItWasTaken() {
    m_document->assign(*findParameter("drill.machine_mass"), 400, m_document->newGesture());
    m_document->assign(*findParameter("drill.inclination"), 90, m_document->newGesture());
    m_page->show();
    chooseAxis("drill.inclination", -60, 60, false);
    showPage();
    const QPointF at = feedPixel();
    const QPointF meant(x().pixelToCoord(at.x()), y().pixelToCoord(at.y() + 25));
    drag(at, 25);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    m_page->plot()->replot();  // it may be less high: the verdict above it is another
    const auto height = m_page->figureFrame().seriesDrag().heightAbove(
        {x().coordToPixel(meant.x()), y().coordToPixel(meant.y())});
    QVERIFY(height);
    QVERIFY2(std::abs(*height) <= 4, qPrintable(QString::number(*height)));  // of rounded pixels and thrusts
}

void TestThrustPage::aClickTakesOverTheFrequencyThere() {
    showPage();
    PlotWidget* plot = m_page->plot();
    const QPointF at(x().coordToPixel(80), y().coordToPixel(1));
    // Far from every line, it only gives the plot the focus.
    QTest::mouseClick(plot, Qt::LeftButton, {}, at.toPoint());
    QCOMPARE(m_document->undoStack().count(), 0);
    const QCPGraph* line = need(ThrustCase::scenario);
    const QPointF on(at.x(), y().coordToPixel(chordValue(*line->data(), 80)));
    QTest::mouseClick(plot, Qt::LeftButton, {}, on.toPoint());
    const double frequency = *m_document->scenario().drill.blowFrequency;
    QVERIFY2(std::abs(frequency - 80) < 0.5, qPrintable(QString::number(frequency)));
    QCOMPARE(formatNumber(frequency).size() <= 4, true);
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY(m_document->undoStack().undoText().contains(QStringLiteral("frequency")));
}

void TestThrustPage::whatLacksIsSaidAndCanBeEntered() {
    m_document->clear(*findParameter("drill.blow_frequency"), m_document->newGesture());
    m_document->clear(*findParameter("drill.thrust"), m_document->newGesture());
    m_page->show();
    QTRY_COMPARE(words(),
                 QStringLiteral("The feed cannot be judged: give a blow frequency and a feed force."));
    QVERIFY(m_page->command().isEmpty());
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    auto* field = m_page->findChild<QuantityField*>(QStringLiteral("missing.drill.blow_frequency"));
    QVERIFY(field->isVisible());
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("55"));
    QVERIFY(field->isVisible());  // not gone with the first digit
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(*m_document->scenario().drill.blowFrequency, 55.0);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    QVERIFY(!field->isVisible());
    QVERIFY2(words().startsWith(QStringLiteral(
                 "No feed force is given. At a blow frequency of 55 Hz, this blow requires at least ")),
             qPrintable(words()));
    QVERIFY(m_page->exports().first().obstacle().isEmpty());
    QVERIFY(feed()->data()->isEmpty());
    QVERIFY(m_page->findChild<QuantityField*>(QStringLiteral("missing.drill.thrust"))->isVisible());
}

void TestThrustPage::whatLacksIsEnteredInTheUnitsOfTheForm() {
    m_document->clear(*findParameter("drill.thrust"), m_document->newGesture());
    m_page->show();
    auto* field = m_page->findChild<QuantityField*>(QStringLiteral("missing.drill.thrust"));
    QCOMPARE(field->unit().name, std::string_view("kN"));
    m_document->units().choose(UnitSystem::us);
    QCOMPARE(field->unit().name, std::string_view("lbf"));
    m_document->units().choose(UnitKind::force, findUnit(Quantity::force, "N"));
    QCOMPARE(field->unit().name, std::string_view("N"));
    m_document->units().choose(UnitKind::force, nullptr);
    m_document->units().choose(UnitSystem::si);
    QCOMPARE(field->unit().name, std::string_view("kN"));
}

void TestThrustPage::itIsNotThereWithoutUnitsAndKeepsItsChoice() {
    QVERIFY(m_document->open(example(QStringLiteral("paper_fig4b"))).isEmpty());
    m_page = std::make_unique<FigurePage>(thrustStudy(), *m_document);
    QVERIFY(!m_page->shows(m_document->scenario()));
    QVERIFY2(m_page->elsewhere().contains(QStringLiteral("physical units")), qPrintable(m_page->elsewhere()));
    const qsizetype rig = m_page->elsewhere().indexOf(QStringLiteral("Edit ▸ Make a rig of these groups"));
    QVERIFY2(rig >= 0 && rig < m_page->elsewhere().indexOf(QStringLiteral("File ▸ New")),
             qPrintable(m_page->elsewhere()));
    QVERIFY(!m_page->leadsElsewhere());
    QCOMPARE(m_page->studies(), 0);
    // One that it begins with leaves the choice of what comes next as it was.
    QVERIFY(m_document->open(example(QStringLiteral("t38_medium_rock"))).isEmpty());
    QVERIFY(m_page->shows(m_document->scenario()));
    m_page->show();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    QVERIFY(m_page->command().contains(QStringLiteral("--along 'drill.blow_frequency=")));
}

// Files do not clip, and names are not put where there is no room.
void TestThrustPage::bandsEndAtTheAxes() {
    showPage();
    PlotWidget* plot = m_page->plot();
    const auto names = [&] {
        QStringList shown;
        for (int i = 0; i < plot->itemCount(); ++i)
            if (const auto* text = qobject_cast<QCPItemText*>(plot->item(i)); text && text->visible())
                shown << text->text();
        return shown;
    };
    QVERIFY(names().contains(QString::fromUtf8(feedWord(FeedState::belowRequired).data())));
    x().setRange(40, 70);
    y().setRange(0.5, 2);
    plot->replot();
    int bands = 0;
    for (int i = 0; i < plot->plottableCount(); ++i) {
        const auto* band = qobject_cast<QCPCurve*>(plot->plottable(i));
        if (!band || band->data()->isEmpty()) continue;
        ++bands;
        for (const QCPCurveData& point : *band->data()) {
            QVERIFY(x().range().contains(point.key));
            QVERIFY(y().range().contains(point.value));
        }
    }
    QVERIFY(bands >= 1);
    QVERIFY(!names().contains(QString::fromUtf8(feedWord(FeedState::belowRequired).data())));
}

void TestThrustPage::openString() {
    QVERIFY(m_document->open(example(QStringLiteral("t38_string"))).isEmpty());
}

QStringList TestThrustPage::legendNames() const {
    QStringList names;
    const QCPLegend& legend = *m_page->plot()->findChild<QCPLegend*>();
    for (int i = 0; i < legend.itemCount(); ++i)
        if (auto* entry = qobject_cast<QCPPlottableLegendItem*>(legend.item(i)))
            names << entry->plottable()->name();
    return names;
}

// Its gaps have no period: what counts them is not there, and the page says why.
void TestThrustPage::columnsOfTheTable_areNotCutInANarrowPage() {
    const auto* table = m_page->findChild<QTableWidget*>(QStringLiteral("answerTable"));
    showPage();
    m_page->resize(320, 700);
    QCoreApplication::processEvents();
    QHeaderView* header = table->horizontalHeader();
    QTRY_VERIFY(header->count() > 0);
    for (int column = 0; column < header->count(); ++column)
        QVERIFY2(header->sectionSize(column) >= header->sectionSizeHint(column),
                 qPrintable(QString::number(column)));
}

void TestThrustPage::aStringIsToldOfItsBlowAndRigidRock() {
    openString();
    QVERIFY(m_page->shows(m_document->scenario()));
    showPage();
    const ThrustStudy study = studyThrust(m_document->scenario());
    QCOMPARE(words(), wordsOf(study));
    QVERIFY2(words().contains(QStringLiteral("only the gap entered and rigid rock")), qPrintable(words()));
    const auto* table = m_page->findChild<QTableWidget*>(QStringLiteral("answerTable"));
    int column = 0;
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& found = study.need(which);
        QCOMPARE(need(which) != nullptr, found.known);
        if (!found.known) continue;
        QCOMPARE(need(which)->dataCount(), 101);
        const QString shown = table->item(0, column++)->text().section(QLatin1Char(' '), 0, 0);
        QVERIFY2(std::abs(QLocale().toDouble(shown) * 1000 / found.thrust - 1) < 1e-3, qPrintable(shown));
    }
    QCOMPARE(table->columnCount(), column);
    QCOMPARE(legendNames(), (QStringList{QStringLiteral("this blow"), QStringLiteral("rigid rock"),
                                         QStringLiteral("installed feed force")}));
    QVERIFY(!m_page->figureFrame().textSummary().contains(QStringLiteral("95 %")));
}

void TestThrustPage::aStringsExportIsWhatTheCopiedCommandWrites_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("stop");
    QTest::newRow("frequency") << QByteArray("drill.blow_frequency") << 31.7 << 97.3;
    QTest::newRow("a length of sections") << QByteArray("string.rod.length") << 3.0 << 4.0;
    QTest::newRow("how many rods") << QByteArray("string.repeat") << 1.0 << 5.0;
}

void TestThrustPage::aStringsExportIsWhatTheCopiedCommandWrites() {
    QFETCH(QByteArray, key);
    QFETCH(double, start);
    QFETCH(double, stop);
    openString();
    QVERIFY(m_document->save(m_folder.filePath(QStringLiteral("string.yaml"))).isEmpty());
    m_page->show();
    chooseAxis(key, start, stop, false);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    compareWithCommand();
    // Whole numbers alone have a string.
    if (key == "string.repeat") QCOMPARE(need(ThrustCase::scenario)->data()->size(), 5);
}

void TestThrustPage::theFeedOfAStringIsDragged() {
    openString();
    showPage();
    const double before = *m_document->scenario().drill.thrust;
    drag(feedPixel(), 60);
    QVERIFY(*m_document->scenario().drill.thrust < before);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TestThrustPage::aRodAfterAStringHasAllItsNeedsAgain() {
    openString();
    showPage();
    chooseAxis("string.rod.length", 3, 4, false);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    QVERIFY(m_document->open(example(QStringLiteral("t38_medium_rock"))).isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    QCOMPARE(legendNames().size(), qsizetype(thrustCaseCount + 1));
    const auto* table = m_page->findChild<QTableWidget*>(QStringLiteral("answerTable"));
    QCOMPARE(table->columnCount(), int(thrustCaseCount));
    QVERIFY2(!words().contains(QStringLiteral("have no period")), qPrintable(words()));
}

QTEST_MAIN(TestThrustPage)
#include "tst_thrust_page.moc"

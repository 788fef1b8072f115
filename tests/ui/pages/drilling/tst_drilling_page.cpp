// SPDX-License-Identifier: GPL-3.0-or-later
// The page Drilling: the blows and numbers of the command, scans, and what it says where something lacks.
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <numeric>

#include "core/report/drilling_figure.h"
#include "core/report/drilling_report.h"
#include "core/report/report_text.h"
#include "core/report/sequence_words.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "ui/form/quantity_field.h"
#include "ui/form/section_box.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/pages/drilling/drilling_table.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/label_places.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Series of the panel of the rate, and of those of blows.
enum class RateSeries { rate, bouncing, contact };
enum class BlowSeries { before, now };

// For hundreds of blows on a machine that is busy with other tests.
constexpr int patience = 120'000;

}  // namespace

class TestDrillingPage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void aPageThatCannotBeSeenComputesNothing();
    void blowsTableAndSentenceAreThoseOfTheStudy();
    void theRowsOfTheTableAreInTheLanguageOfTheWindow();
    void anAnswerThatIsKnownIsNotMarchedAgain();
    void theExportIsWhatTheCopiedCommandWrites();
    void aScanIsAsFarAsTheScenarioAndAClickTakesItsThrust();
    void aClickOnABlowOpensItAndShiftPinsItsGap();
    void pinnedRunsStandAtTheirMeans();
    void axesOfTheSamePlotHaveRoomForTheirNumbers();
    void whatLacksIsSaidAndCanBeEntered();
    void itIsNotThereWithoutUnits();

  private:
    void showPage();
    bool isAnswered() const;
    void set(const char* key, double si) const;
    QString words() const { return pageWords(*m_page); }
    template <class Series>
    QCPGraph* graph(DrillingPanel panel, Series series) const {
        return m_page->figureFrame().graph(std::size_t(panel), std::size_t(series));
    }
    QCPGraph* rate() const { return graph(DrillingPanel::rate, RateSeries::rate); }
    QCPAxisRect* rates() const { return rate()->keyAxis()->axisRect(); }
    QVector<QCPItemText*> textsOfRates() const;
    bool isScanOld() const { return rate()->layer()->name() == QLatin1String("ghost"); }

    QTemporaryDir m_folder;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<DrillingPage> m_page;
};

void TestDrillingPage::initTestCase() {
    keepSettingsIn(m_folder.path());
}

// Fewer blows than the page takes by itself: what is tested here does not depend on how many there are.
void TestDrillingPage::init() {
    m_page.reset();
    m_document = std::make_unique<Document>();
    QVERIFY(m_document->open(example(QStringLiteral("t38_medium_rock"))).isEmpty());
    set("drill.blows", 60);
    set("drill.settle", 20);
    set("drill.wave_loss", 0.1);
    m_page = std::make_unique<DrillingPage>(*m_document);
    m_page->resize(900, 800);
}

void TestDrillingPage::set(const char* key, double si) const {
    QCOMPARE(m_document->assign(*findParameter(key), si, m_document->newGesture()), QString());
}

bool TestDrillingPage::isAnswered() const {
    return m_page->activity()->state() == StudyState::finished && m_page->activity()->isCurrent();
}

void TestDrillingPage::showPage() {
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    m_page->plot()->replot();
}

void TestDrillingPage::aPageThatCannotBeSeenComputesNothing() {
    set("drill.thrust", 6000);
    QTest::qWait(0);
    QCOMPARE(m_page->marches(), 0);
    showPage();
    QCOMPARE(m_page->marches(), 1);
    m_page->hide();
    const int scans = m_page->scans();
    set("drill.thrust", 7000);
    QCOMPARE(m_page->marches(), 1);
    QCOMPARE(m_page->scans(), scans);
}

// The names of the required feeds, in their order.
QVector<QCPItemText*> TestDrillingPage::textsOfRates() const {
    QVector<QCPItemText*> found;
    for (int i = 0; i < m_page->plot()->itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(m_page->plot()->item(i)))
            if (text->clipAxisRect() == rates() && text->text().startsWith("f I₀")) found.append(text);
    return found;
}

void TestDrillingPage::blowsTableAndSentenceAreThoseOfTheStudy() {
    m_page->findChild<SectionBox*>(QStringLiteral("details"))->setOpen(true);
    showPage();
    const DrillingSettings settings{.blows = 60, .settle = 20};
    const DrillingResult expected = studyDrilling(m_document->scenario(), settings);
    const DrillingResult& found = *m_page->answer()->result;
    QCOMPARE(found.blows.size(), expected.blows.size());
    const QCPGraph* gaps = graph(DrillingPanel::gap, BlowSeries::now);
    const QCPGraph* penetrations = graph(DrillingPanel::penetration, BlowSeries::now);
    QCOMPARE(gaps->dataCount(), 60);
    const double millimetres = 1e3 * expected.units.length();
    for (int i = 0; i < 60; ++i) {
        const DrillingBlow& blow = expected.blows[std::size_t(i)];
        QCOMPARE(gaps->data()->at(i)->key, i + 1.0);
        QCOMPARE(gaps->data()->at(i)->value, blow.gap * millimetres);
        QCOMPARE(penetrations->data()->at(i)->value, blow.penetration * millimetres);
    }
    const DrillingAnswer& answer = *m_page->answer();
    const ShownSequence sequence{answer.question.scenario, settings, found.blows, &found, answer.corOverGap};
    const StudyFigure figure = drillingFigure(&sequence, nullptr);
    // A bar has four corners, two of them at its end.
    const auto sumOf = [](const std::vector<double>& ends) {
        return std::accumulate(ends.begin(), ends.end(), 0.0) / 2;
    };
    const FigureSeries& phases = figure.panels[std::size_t(DrillingPanel::phase)].series.front();
    QCOMPARE(phases.x.size(), std::size_t(4 * 20));
    QVERIFY(std::abs(sumOf(phases.y) - 100) < 1e-9);
    QVERIFY(graph(DrillingPanel::phase, 1)->dataCount() > 20);
    QCOMPARE(graph(DrillingPanel::phase, 1)->valueAxis()->axisType(), QCPAxis::atRight);
    // Energy balance is all of what was given, but for the residual of the cells.
    QVERIFY(std::abs(sumOf(figure.panels[std::size_t(DrillingPanel::energy)].series.front().x) - 100) < 1);
    const LocalStyle style = LocalStyle::of(m_document->units());
    QVERIFY(words().startsWith(QString::fromStdString(sequenceText(expected, style))));
    QVERIFY(!words().contains(QStringLiteral("Lyapunov")));
    QCOMPARE(m_page->findChild<QLabel*>(QStringLiteral("exponent"))->text(),
             withSigns(translated(exponentWords(found, style))));
    const auto* table = m_page->findChild<QTableWidget*>(QStringLiteral("statistics"));
    const double mean =
        scaleOf(DrillingMeasure::length, expected).value(expected.spread(3).mean, OutputUnits::si);
    QCOMPARE(table->verticalHeaderItem(2)->text(), QStringLiteral("penetration [mm]"));
    QCOMPARE(table->item(2, 0)->text(), QString::fromStdString(style.number(1000 * mean, 5)));
}

// Titles of the core's table of quantities were looked up where the catalogues do not have them.
void TestDrillingPage::theRowsOfTheTableAreInTheLanguageOfTheWindow() {
    speak(*findLanguage("de"));
    const DrillingTable table;
    speak(languages[0]);
    QStringList titles;
    for (int row = 0; row < table.rowCount(); ++row) titles << table.verticalHeaderItem(row)->text();
    QCOMPARE(titles.mid(0, 2), (QStringList{"Spalt beim Schlag", "Kraftstoß auf das Gestein"}));
    QCOMPARE(titles.last(), QStringLiteral("Kontakte"));
}

void TestDrillingPage::anAnswerThatIsKnownIsNotMarchedAgain() {
    showPage();
    const auto first = m_page->answer()->result;
    set("drill.thrust", 7000);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    QVERIFY(m_page->answer()->result != first);
    m_document->undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    QCOMPARE(m_page->answer()->result, first);
    // A title changes nothing of a march.
    const int marches = m_page->marches();
    m_document->setTitle(QStringLiteral("another title"));
    QTest::qWait(0);
    QCOMPARE(m_page->marches(), marches);
}

void TestDrillingPage::theExportIsWhatTheCopiedCommandWrites() {
    showPage();
    const PageExport numbers = m_page->exports().first();
    QCOMPARE(numbers.obstacle(), QString());
    const QByteArray csv = numbers.csv();
    QVERIFY(csv.contains("hole_depth"));
    QCOMPARE(csv, shell(m_page->command()).out);
}

void TestDrillingPage::aScanIsAsFarAsTheScenarioAndAClickTakesItsThrust() {
    m_page->findChild<SectionBox*>(QStringLiteral("details"))->setOpen(true);
    showPage();
    m_page->findChild<AxisFields*>()->setRange({findParameter("drill.thrust"), 4000, 8000, false});
    m_page->scan();
    QTRY_VERIFY_WITH_TIMEOUT(m_page->scanActivity().state() == StudyState::finished, patience);
    QVERIFY(rate()->dataCount() > 20);
    QVERIFY(graph(DrillingPanel::scannedGap, 0)->dataCount() >= rate()->dataCount() * 40);
    QCOMPARE(textsOfRates().size(), 3);
    // It takes room of its own, but not of other pages.
    const int tall = m_page->plot()->minimumHeight();
    m_page->hide();
    QVERIFY(m_page->plot()->minimumHeight() < tall);
    m_page->show();
    QTRY_COMPARE(m_page->plot()->minimumHeight(), tall);
    // Names are at the foot where they cover nothing, else above each other.
    m_page->plot()->resize(900, 500);
    for (const QCPRange view : {QCPRange(0, 2000), QCPRange(2, 6)}) {
        rates()->axis(QCPAxis::atBottom)->setRange(view);
        m_page->plot()->replot();
        const QVector<QCPItemText*> names = textsOfRates();
        for (int i = 0; i < 3; ++i) {
            const QRectF place = rectOf(*names[i]);
            QVERIFY(rates()->rect().contains(place.center().toPoint()));
            for (int other = 0; other < i; ++other) QVERIFY(!place.intersects(rectOf(*names[other])));
            if (view.upper > 1000) continue;
            for (const auto which : {RateSeries::rate, RateSeries::contact})
                for (const QPointF& point : pointsAlong(*graph(DrillingPanel::rate, which)))
                    QVERIFY(!place.contains(point));
        }
    }
    m_page->plot()->resize(900, 800);
    rates()->axis(QCPAxis::atBottom)->setRange(4, 8);
    QVERIFY(!isScanOld());
    m_page->plot()->replot();
    const int steps = m_document->undoStack().count();
    const QPointF pixel(rates()->axis(QCPAxis::atBottom)->coordToPixel(6),
                        rates()->axis(QCPAxis::atLeft)->coordToPixel(0.1));
    // Far from the curve, nothing is taken.
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, pixel.toPoint());
    QCOMPARE(m_document->undoStack().count(), steps);
    const double value = chordValue(*rate()->data(), 6);
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {},
                      QPointF(pixel.x(), rates()->axis(QCPAxis::atLeft)->coordToPixel(value)).toPoint());
    QTRY_VERIFY(std::abs(*m_document->scenario().drill.thrust - 6000) < 50);
    QCOMPARE(m_document->undoStack().count(), steps + 1);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), patience);
    // Another place along it is the same scan; another wave loss is not.
    QVERIFY(!isScanOld());
    // its sentence, and its command below that of the march
    QVERIFY(words().contains("Friction, rotation and buckling are not modelled."));
    QVERIFY(shell(m_page->command()).out.contains("drill.thrust [kN],start,"));
    // The rows of that command can be had from the page, too.
    const PageExport exported = m_page->exports().at(1);
    QCOMPARE(exported.obstacle(), QString());
    // Only the command looks for the Lyapunov exponents.
    const auto rows = [](const QString& csv) {
        const qsizetype begin = csv.indexOf(QStringLiteral("drill.thrust [kN],start,"));
        QStringList begins;
        for (const QString& row : csv.mid(begin).split(u'\n', Qt::SkipEmptyParts))
            begins << row.section(u',', 0, 4);
        return begins;
    };
    QCOMPARE(rows(QString::fromUtf8(exported.csv())), rows(shell(m_page->command()).out));
    // The scan of another scenario starts by itself.
    const int scans = m_page->scans();
    set("drill.wave_loss", 0.2);
    QTRY_COMPARE_WITH_TIMEOUT(m_page->scans(), scans + 1, patience);
}

void TestDrillingPage::aClickOnABlowOpensItAndShiftPinsItsGap() {
    set("drill.thrust", 3500);
    m_page->findChild<SectionBox*>(QStringLiteral("details"))->setOpen(true);
    showPage();
    const DrillingResult result = *m_page->answer()->result;
    const QSignalSpy opened(m_page.get(), &DrillingPage::blowOpened);
    const QSignalSpy pinned(m_page.get(), &Page::pinRequested);
    const auto click = [&](DrillingPanel panel, Qt::KeyboardModifiers modifiers) {
        const QCPAxisRect* rect = graph(panel, BlowSeries::now)->keyAxis()->axisRect();
        const QPointF pixel(rect->axis(QCPAxis::atBottom)->coordToPixel(40.3), rect->center().y());
        QTest::mouseClick(m_page->plot(), Qt::LeftButton, modifiers, pixel.toPoint());
    };
    const double gap = result.blows[39].gap * result.units.length();
    QVERIFY(gap > 0);
    click(DrillingPanel::gap, Qt::ShiftModifier);
    QTRY_COMPARE(pinned.count(), 1);
    QCOMPARE(pinned.first().first().value<ScenarioDocument>().scenario.bitRock.gap, gap);
    QCOMPARE(m_document->scenario().bitRock.gap, 0.0);
    QCOMPARE(opened.count(), 0);
    const int steps = m_document->undoStack().count();
    click(DrillingPanel::penetration, {});
    QTRY_COMPARE(opened.count(), 1);
    QCOMPARE(opened.first().first().value<MarchedQuestion>(), (MarchedQuestion{result.settings, 40}));
    QVERIFY(opened.first().last().toString().contains(QStringLiteral("Blow 40 of 60")));
    // which is no change of the scenario
    QCOMPARE(m_document->scenario().bitRock.gap, 0.0);
    QCOMPARE(m_document->undoStack().count(), steps);
}

void TestDrillingPage::pinnedRunsStandAtTheirMeans() {
    m_page->findChild<AxisFields*>()->setRange({findParameter("drill.thrust"), 4000, 8000, false});
    Run run;
    run.number = 2;
    run.contents = m_document->contents();
    run.contents.scenario.drill.thrust = 5000;
    const DrillingQuestion question = runQuestion(run.contents.scenario);
    QCOMPARE(question.settings.blows, 60);
    const RunMeans expected = runMeans(question, {}).value();
    Run lost = run;  // pushed back
    lost.number = 3;
    lost.contents.scenario.drill.thrust = 1000;
    m_page->setRuns(std::make_shared<const RunList>(RunList{run, lost}));
    showPage();
    const FigureFrame& frame = m_page->figureFrame();
    const auto means = [&] { return frame.runMarksIn(std::size_t(DrillingPanel::penetration)); };
    QTRY_COMPARE_WITH_TIMEOUT(means().size(), 1, patience);
    QCOMPARE(means().first().number, 2);
    QCOMPARE(means().first().at, QPointF(60, 1e3 * expected.penetration));
    QVERIFY(frame.runMarks().isEmpty());
    m_page->scan();
    QTRY_COMPARE_WITH_TIMEOUT(frame.runMarks().size(), 1, patience);
    QCOMPARE(frame.runMarks().first().at.x(), 5.0);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->scanActivity().state() == StudyState::finished, patience);
}

// A motion that repeats with every blow has one point, around which digits would not end.
void TestDrillingPage::axesOfTheSamePlotHaveRoomForTheirNumbers() {
    m_page->findChild<SectionBox*>(QStringLiteral("details"))->setOpen(true);
    showPage();
    const QCPRange range = graph(DrillingPanel::returns, 0)->keyAxis()->range();
    QVERIFY(range.size() >= 0.09 * range.upper);
    QStringList names;
    for (const QCPAxisRect* rect : m_page->plot()->axisRects())
        if (m_page->figureFrame().panelIn(rect) == std::size_t(DrillingPanel::energy))
            names = rect->axis(QCPAxis::atLeft)->tickVectorLabels();
    QCOMPARE(names.size(), 5);
    for (const QString& name : names)
        QVERIFY2(name.contains(QRegularExpression(" [0-9.,]{1,4}\u00a0%$")), qPrintable(name));
}

void TestDrillingPage::whatLacksIsSaidAndCanBeEntered() {
    m_document->clear(*findParameter("drill.thrust"), m_document->newGesture());
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    QTRY_VERIFY_WITH_TIMEOUT(words().contains(QStringLiteral("drill.thrust")), patience);
    QCOMPARE(m_page->command(), QString());
    auto* field = m_page->findChild<QuantityField*>(QStringLiteral("missing.drill.thrust"));
    QVERIFY(field->isVisible());
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("6 kN"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->answer()->isComplete() && isAnswered(), patience);
    QCOMPARE(*m_document->scenario().drill.thrust, 6000.0);
}

void TestDrillingPage::itIsNotThereWithoutUnits() {
    Scenario dimensionless;
    dimensionless.form = ScenarioForm::dimensionless;
    QVERIFY(!m_page->shows(dimensionless));
    QVERIFY(m_page->elsewhere().contains(QStringLiteral("Drilling")));
}

QTEST_MAIN(TestDrillingPage)
#include "tst_drilling_page.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the x–t picture in the window: what it shows, what can be dragged, how it plays.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/wave/field/wave_field.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/job/solve_job.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/wave_picture/picture_cursors.h"
#include "ui/pages/wave_picture/play_bar.h"
#include "ui/pages/wave_picture/rod_strip.h"
#include "ui/pages/wave_picture/wave_picture_page.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"
#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/settings.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

Scenario dimensionless(PulseShape shape, const Groups& groups) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = shape;
    scenario.groups = groups;
    return scenario;
}

}  // namespace

class TestWavePicturePage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void cleanup();
    void showsTheBlowAtThePixelsOfTheScreen();
    void asksForNothingWhileHidden();
    void zoomingBringsANewPictureOfWhatIsInView();
    void theOldPictureStaysUntilTheNewOneIsThere();
    void aStrongZoomScalesOnlyThePartOfTheOldPictureInView();
    void fittedItFollowsTheBlow();
    void forceAndVelocityCanBeChosen();
    void choicesAreRemembered();
    void draggingTheSectionMovesTheBlowsSection();
    void theTimeCursorIsShared();
    void keysMoveBothLines();
    void playingAdvancesTheTimeAndStopsWhenHidden();
    void playingEndsWithTheViewOrLoops();
    void theSpaceBarPlays();
    void thePointersPlaceIsRead();
    void theReadoutFollowsAZoom();
    void theStripIsColouredByWhatThePictureShows();
    void theColoursReachAsFarAsTheResultPanel();
    void theRangeInViewHasTheLargestForcesAtAnySize();
    void whatTheColoursDoNotReachIsMarked();
    void theDataAreTheFieldInView();
    void theMenuOffersTheDataOfThePicture();
    void theStripTellsTheStateOfTheBit();
    void extremeScenesGiveAPictureOrTheReason_data();
    void extremeScenesGiveAPictureOrTheReason();
    void unitsChangeBelowTheView();

  private:
    void open(const Scenario& scenario);
    bool settled() const;
    RasterGrid gridShown() const { return m_page->picture()->picture()->raster.grid; }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<Observation> m_observation;
    std::unique_ptr<WavePicturePage> m_page;
    std::unique_ptr<SolveJob> m_job;
    Scenario m_scenario;
    UnitSystem m_units = UnitSystem::dimensionless;
    int m_asked = 0;
};

void TestWavePicturePage::initTestCase() {
    keepSettingsIn(m_folder.path());
}

// The page with a job of its own, as in the window.
void TestWavePicturePage::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_asked = 0;
    m_units = UnitSystem::dimensionless;
    m_scenario = dimensionless(PulseShape::rectangular, {0.5, 0.1, 10, 0});
    m_observation = std::make_unique<Observation>();
    m_page = std::make_unique<WavePicturePage>(*m_observation);
    m_page->resize(700, 560);
    m_job = std::make_unique<SolveJob>();
    connect(m_job.get(), &SolveJob::solved, m_page.get(), &Page::setResult);
    connect(m_page.get(), &Page::needsChanged, this, [this] {
        ++m_asked;
        open(m_scenario);
    });
    m_page->show();
    QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
    open(m_scenario);
    QTRY_VERIFY(settled());
    m_page->plot()->replot();  // what the new labels leave of the plot may need another picture
    QTRY_VERIFY(settled());
}

void TestWavePicturePage::cleanup() {
    m_job.reset();
    m_page.reset();
}

void TestWavePicturePage::open(const Scenario& scenario) {
    m_scenario = scenario;
    SolveRequest request;
    request.scenario = scenario;
    request.units = m_units;
    request.pages = {m_page->prepare()};
    m_job->submit(request);
}

// Whether the picture on show is the one that the view needs.
bool TestWavePicturePage::settled() const {
    const SolvedBlowPtr& blow = m_page->picture()->shown();
    if (!blow || m_job->isBusy()) return false;
    return blow->page<WavePicture>()->need == m_page->picture()->need() &&
           blow->request.scenario == m_scenario;
}

void TestWavePicturePage::showsTheBlowAtThePixelsOfTheScreen() {
    const WavePicture& picture = *m_page->picture()->picture();
    const QSize axes = m_page->plot()->axisRect()->size();
    QCOMPARE(picture.raster.grid.columns, axes.width());
    QCOMPARE(picture.raster.grid.rows, axes.height());
    // From the blow to a round trip after the last separation.
    const Impact& impact = m_page->picture()->shown()->impact;
    QCOMPARE(m_page->plot()->yAxis->range().lower, 0.0);
    QCOMPARE(m_page->plot()->yAxis->range().upper, impact.separationTime + 20);
    QVERIFY(picture.limit >= impact.peakForce);
    // Compressed behind the front, undisturbed ahead of it: in the pixels themselves.
    const QImage image = m_page->plot()->toPixmap().toImage();
    const auto colourAt = [&](double xi, double t) {
        return QColor(image.pixel(int(m_page->plot()->xAxis->coordToPixel(xi)),
                                  int(m_page->plot()->yAxis->coordToPixel(t))));
    };
    QVERIFY(colourAt(0.3, 3.5).blue() > colourAt(0.3, 3.5).red() + 40);
    QVERIFY(std::abs(colourAt(0.9, 3.5).blue() - colourAt(0.9, 3.5).red()) < 10);
    QVERIFY(!m_page->plot()->accessibleDescription().isEmpty());
}

void TestWavePicturePage::asksForNothingWhileHidden() {
    MainWindow window(std::make_unique<ScriptedQuestions>(m_answers), exactSolve());
    auto* pages = window.findChild<PageTabs*>();
    auto* page = window.findChild<WavePicturePage*>();
    QVERIFY(page);
    QCOMPARE(page->title(), QStringLiteral("Wave picture"));
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(window).isBusy(), 60000);
    pages->setCurrentWidget(&part<BlowPage>(window));
    QTRY_VERIFY(window.shown()->page<BlowCurves>());
    QVERIFY(!window.shown()->page<WavePicture>());
    pages->setCurrentWidget(page);
    QTRY_VERIFY(window.shown()->page<WavePicture>());
    QTRY_COMPARE(window.shown()->page<WavePicture>()->raster.grid.columns, page->picture()->need().columns);
}

void TestWavePicturePage::zoomingBringsANewPictureOfWhatIsInView() {
    // The corner where the blow's front meets the bit.
    for (const double size : {1.0, 1e-3, 1e-6}) {
        m_page->plot()->xAxis->setRange(1 - size / 10, 1);
        m_page->plot()->yAxis->setRange(10 - size / 2, 10 + size / 2);
        m_page->plot()->replot();
        QTRY_VERIFY(settled());
        const RasterGrid grid = gridShown();
        QVERIFY(std::abs(grid.xiBegin - (1 - size / 10)) < 1e-12);
        QVERIFY(std::abs(grid.timeEnd - (10 + size / 2)) < 1e-12);
        QCOMPARE(grid.columns, m_page->plot()->axisRect()->width());
        const WavePicture& picture = *m_page->picture()->picture();
        for (int i = 0; i < 50; ++i) {
            const int column = (i * 37) % grid.columns, row = (i * 53) % grid.rows;
            const double xi = grid.xi(column), t = grid.time(row);
            const Impact& impact = m_page->picture()->shown()->impact;
            QCOMPARE(picture.raster.values[grid.index(column, row)],
                     static_cast<float>(WaveField(impact).positiveWave(xi, t) +
                                        WaveField(impact).negativeWave(xi, t)));
        }
    }
    m_page->fit();
    QTRY_VERIFY(settled());
    QCOMPARE(gridShown().timeBegin, 0.0);
    QCOMPARE(gridShown().xiBegin, 0.0);
}

void TestWavePicturePage::aStrongZoomScalesOnlyThePartOfTheOldPictureInView() {
    // Scaled to such a view, the whole picture would be millions of screens wide: Qt crashed on that.
    for (const double size : {1e-5, 1e-9, 1e-13}) {
        m_page->plot()->xAxis->setRange(0.4, 0.4 + size);
        m_page->plot()->yAxis->setRange(5, 5 + size);
        m_page->plot()->replot();  // the old picture still
        const QImage image = m_page->plot()->toPixmap().toImage();
        QVERIFY(!image.isNull());
    }
    m_page->plot()->xAxis->setRange(30, 31);  // nothing of it in view
    m_page->plot()->replot();
    m_page->fit();
    QTRY_VERIFY(settled());
}

void TestWavePicturePage::theOldPictureStaysUntilTheNewOneIsThere() {
    const SolvedBlowPtr before = m_page->picture()->shown();
    m_page->plot()->yAxis->setRange(2, 6);
    m_page->plot()->replot();
    QCOMPARE(m_page->picture()->shown(), before);
    const QImage image = m_page->plot()->toPixmap().toImage();
    QTRY_VERIFY(settled());
    QVERIFY(m_page->picture()->shown() != before);
    // An answer to an older view does not move the present one.
    m_page->setResult(before);
    QCOMPARE(m_page->plot()->yAxis->range().lower, 2.0);
    QCOMPARE(m_page->plot()->yAxis->range().upper, 6.0);
}

void TestWavePicturePage::fittedItFollowsTheBlow() {
    open(dimensionless(PulseShape::halfSine, {0.5, 0.5, 3, 0}));
    QTRY_VERIFY(settled());
    const double end = m_page->picture()->shown()->impact.separationTime + 6;
    QCOMPARE(m_page->plot()->yAxis->range().upper, end);
    // A view that was chosen stays.
    m_page->plot()->yAxis->setRange(1, 2);
    m_page->plot()->replot();
    QTRY_VERIFY(settled());
    open(dimensionless(PulseShape::halfSine, {0.6, 0.5, 3, 0}));
    QTRY_VERIFY(settled());
    QCOMPARE(m_page->plot()->yAxis->range().upper, 2.0);
}

void TestWavePicturePage::forceAndVelocityCanBeChosen() {
    auto* field = m_page->findChild<QComboBox*>(QStringLiteral("field"));
    field->setCurrentIndex(1);
    QTRY_VERIFY(settled());
    const SolvedBlowPtr blow = m_page->picture()->shown();
    QCOMPARE(blow->page<WavePicture>()->raster.quantity, WaveQuantity::velocity);
    const RasterGrid grid = gridShown();
    const double xi = grid.xi(100), t = grid.time(40);
    QCOMPARE(blow->page<WavePicture>()->raster.values[grid.index(100, 40)],
             static_cast<float>(WaveField(blow->impact).velocity(xi, t)));
    auto* fronts = m_page->findChild<QCheckBox*>(QStringLiteral("fronts"));
    fronts->click();
    QCOMPARE(m_page->picture()->frontsShown(), fronts->isChecked());
}

void TestWavePicturePage::choicesAreRemembered() {
    m_page->findChild<QComboBox*>(QStringLiteral("field"))->setCurrentIndex(1);
    m_page->findChild<QCheckBox*>(QStringLiteral("fronts"))->setChecked(false);
    m_page->findChild<QComboBox*>(QStringLiteral("speed"))->setCurrentIndex(0);
    const WavePicturePage next(*m_observation);
    QCOMPARE(next.picture()->field(), WaveQuantity::velocity);
    QVERIFY(!next.picture()->frontsShown());
    QCOMPARE(next.playBar()->secondsForSpan(), 2.0);
}

void TestWavePicturePage::draggingTheSectionMovesTheBlowsSection() {
    BlowPage blow(*m_observation);
    PlotWidget* plot = m_page->plot();
    const QRect axes = plot->axisRect()->rect();
    const QPoint on(int(std::lround(m_page->cursors()->sectionPixel())), axes.top() + axes.height() / 5);
    const QPoint to(axes.left() + axes.width() / 4, on.y());
    const QCPRange before = plot->xAxis->range();
    QTest::mousePress(plot, Qt::LeftButton, {}, on);
    QTest::mouseMove(plot, (on + to) / 2);
    QTest::mouseMove(plot, to);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
    QVERIFY(std::abs(m_observation->section() - 0.25) < 0.01);
    QCOMPARE(blow.findChild<QDoubleSpinBox*>(QStringLiteral("section"))->value(),
             std::round(m_observation->section() * 1000) / 1000);
    QCOMPARE(plot->xAxis->range(), before);
    // Let go, it stays.
    QTest::mouseMove(plot, on);
    QVERIFY(std::abs(m_observation->section() - 0.25) < 0.01);
}

void TestWavePicturePage::theTimeCursorIsShared() {
    m_observation->setTime(12.5);
    QCOMPARE(m_page->rodStrip()->time(), 12.5);
    PlotWidget* plot = m_page->plot();
    QVERIFY(std::abs(plot->yAxis->pixelToCoord(m_page->cursors()->timePixel()) - 12.5) < 0.1);
    const QRect axes = plot->axisRect()->rect();
    const QPoint on(axes.left() + axes.width() / 4, int(std::lround(m_page->cursors()->timePixel())));
    const QPoint to(on.x(), axes.top() + axes.height() / 2);
    QTest::mousePress(plot, Qt::LeftButton, {}, on);
    QTest::mouseMove(plot, to);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
    QVERIFY(std::abs(*m_observation->time() - plot->yAxis->pixelToCoord(to.y())) < 0.1);
    auto* slider = m_page->findChild<QSlider*>(QStringLiteral("timeSlider"));
    slider->setValue(slider->maximum() / 4);
    QVERIFY(std::abs(*m_observation->time() - plot->yAxis->range().upper / 4) < 1e-9);
}

void TestWavePicturePage::keysMoveBothLines() {
    m_observation->setTime(10);
    m_page->plot()->setFocus();
    QTest::keyClick(m_page->plot(), Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(std::abs(m_observation->section() - 0.51) < 1e-12);
    QTest::keyClick(m_page->plot(), Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(std::abs(m_observation->section() - 0.5) < 1e-12);
    QTest::keyClick(m_page->plot(), Qt::Key_Up, Qt::ControlModifier);
    QVERIFY(*m_observation->time() > 10);
    QTest::keyClick(m_page->plot(), Qt::Key_Down, Qt::ControlModifier);
    QVERIFY(std::abs(*m_observation->time() - 10) < 1e-12);
}

void TestWavePicturePage::playingAdvancesTheTimeAndStopsWhenHidden() {
    PlayBar& bar = *m_page->playBar();
    m_observation->setTime(1);
    const int asked = m_asked;
    bar.play();
    QTRY_VERIFY(*m_observation->time() > 1.1);
    QVERIFY(bar.isPlaying());
    QCOMPARE(m_page->rodStrip()->time(), *m_observation->time());
    QCOMPARE(m_asked, asked);  // nothing is computed again for it
    m_page->hide();
    QVERIFY(!bar.isPlaying());
    const double stopped = *m_observation->time();
    QCoreApplication::processEvents();
    QCOMPARE(*m_observation->time(), stopped);
    bar.play();  // not while it cannot be seen
    QVERIFY(!bar.isPlaying());
    m_page->show();
    bar.play();
    m_page->setWindowState(Qt::WindowMinimized);
    QTRY_VERIFY(!bar.isPlaying());
}

void TestWavePicturePage::playingEndsWithTheViewOrLoops() {
    PlayBar& bar = *m_page->playBar();
    auto* loop = m_page->findChild<QAbstractButton*>(QStringLiteral("loop"));
    const double end = m_page->picture()->timeInView().end;
    loop->setChecked(false);
    m_observation->setTime(end * (1 - 1e-9));
    bar.play();
    QTRY_VERIFY(!bar.isPlaying());
    QCOMPARE(*m_observation->time(), end);
    // Again from the beginning.
    bar.play();
    QVERIFY(*m_observation->time() < end / 2);
    loop->setChecked(true);
    m_observation->setTime(end * (1 - 1e-9));
    QTRY_VERIFY(*m_observation->time() < end / 2);
    QVERIFY(bar.isPlaying());
}

void TestWavePicturePage::theSpaceBarPlays() {
    for (QWidget* widget :
         {static_cast<QWidget*>(m_page->plot()), m_page->findChild<QWidget*>(QStringLiteral("timeSlider")),
          m_page->findChild<QWidget*>(QStringLiteral("play"))}) {
        widget->setFocus();
        QTest::keyClick(widget, Qt::Key_Space);
        QVERIFY(m_page->playBar()->isPlaying());
        QTest::keyClick(widget, Qt::Key_Space);
        QVERIFY(!m_page->playBar()->isPlaying());
    }
}

void TestWavePicturePage::thePointersPlaceIsRead() {
    PlotWidget* plot = m_page->plot();
    plot->replot();  // so that the axes are where the view has put them
    // Between the fronts, where the blow compresses with F0.
    QTest::mouseMove(plot, QPoint(int(plot->xAxis->coordToPixel(0.3)), int(plot->yAxis->coordToPixel(3.5))));
    const QString text = m_page->findChild<QLabel*>(QStringLiteral("readout"))->text();
    QVERIFY2(text.contains(QStringLiteral("N = −1")), qPrintable(text));
}

void TestWavePicturePage::theReadoutFollowsAZoom() {
    PlotWidget* plot = m_page->plot();
    plot->replot();
    const auto* readout = m_page->findChild<QLabel*>(QStringLiteral("readout"));
    const QPoint pointer = plot->axisRect()->center();
    QTest::mouseMove(plot, pointer);
    const QString before = readout->text();
    plot->xAxis->setRange(0.7, 0.8);
    plot->replot();
    QVERIFY(readout->text() != before);
    QCOMPARE(readout->text(), m_page->picture()->readout(pointer));
    // Without a pointer it says what is in view.
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(plot, &leave);
    QVERIFY(readout->text().startsWith(m_page->picture()->rangeText()));
    QVERIFY(readout->text().startsWith(QStringLiteral("N in this view: from ")));
}

void TestWavePicturePage::theStripIsColouredByWhatThePictureShows() {
    m_observation->setTime(5);
    const QString state = m_page->rodStrip()->stateText();
    QVERIFY(state.contains(QStringLiteral("stress")));
    m_page->rodStrip()->setRodEnds(10, 60);
    QCOMPARE(m_page->rodStrip()->stateText(), state);  // whatever the width
    const QImage stressed = m_page->rodStrip()->grab().toImage();
    m_page->findChild<QComboBox*>(QStringLiteral("field"))->setCurrentIndex(1);
    QTRY_VERIFY(settled());
    QVERIFY(m_page->rodStrip()->stateText().contains(QStringLiteral("velocity")));
    QVERIFY(m_page->rodStrip()->accessibleName().contains(QStringLiteral("velocity")));
    QVERIFY(m_page->rodStrip()->toolTip().contains(QStringLiteral("towards the rock")));
    // The blow on its way to the bit is compressed, and moves towards it: the other colour.
    QVERIFY(m_page->rodStrip()->grab().toImage() != stressed);
}

void TestWavePicturePage::theColoursReachAsFarAsTheResultPanel() {
    const SolvedBlowPtr& blow = m_page->picture()->shown();
    QVERIFY(blow->summary.rodForces);
    QVERIFY(m_page->picture()->picture()->limit >= blow->summary.rodForces->compression.size);
    QVERIFY(m_page->picture()->picture()->limit >= blow->summary.rodForces->tension.size);
}

// They are narrower than the cells of a small window.
void TestWavePicturePage::theRangeInViewHasTheLargestForcesAtAnySize() {
    const SolvedBlowPtr& blow = m_page->picture()->shown();
    const RodForces& forces = *blow->summary.rodForces;
    for (const int cells : {20, 300}) {
        const WavePicture picture = wavePicture(*blow, blow->units, {WaveQuantity::force, {}, cells, cells});
        QVERIFY(picture.least <= -float(forces.compression.size));
        QVERIFY(picture.largest >= float(forces.tension.size));
    }
    // A view without them has smaller ones.
    const PictureWindow early{0, 1, {0, 0.5 * forces.tension.time}};
    const WavePicture part = wavePicture(*blow, blow->units, {WaveQuantity::force, early, 300, 300});
    QVERIFY(part.largest < float(forces.tension.size));
}

void TestWavePicturePage::whatTheColoursDoNotReachIsMarked() {
    WavePicture picture;
    picture.limit = 2;
    picture.least = -1;
    picture.largest = 2;
    QVERIFY(!isClippedBelow(picture) && !isClippedAbove(picture));
    picture.largest = 2.1F;
    QVERIFY(!isClippedBelow(picture) && isClippedAbove(picture));
    // On screen: an arrow head beyond that end of the bar, and the limit in words.
    auto blow = std::make_shared<SolvedBlow>(*m_page->picture()->shown());
    auto shown = *blow->page<WavePicture>();
    const auto draw = [&](float largest) {
        shown.largest = largest;
        blow->pages = {PageData::of(WavePicture(shown))};
        m_page->picture()->present(blow);
        return m_page->plot()->toPixmap().toImage();
    };
    const QImage within = draw(0.5F * float(shown.limit));
    QVERIFY(!m_page->picture()->rangeText().contains(QStringLiteral("colours end")));
    const QImage beyond = draw(1.5F * float(shown.limit));
    QVERIFY(within != beyond);
    QVERIFY(m_page->picture()->rangeText().contains(QStringLiteral("colours end at ±")));
    // The heads at both ends are alike, and stand on the line around the bar.
    shown.least = -1.5F * float(shown.limit);
    const QImage both = draw(1.5F * float(shown.limit));
    const auto* scale = m_page->plot()->findChild<QCPColorScale*>();
    const auto rects = m_page->plot()->axisRects();
    QVERIFY(scale || rects.size() > 1);
    const QRect bar = scale ? scale->axis()->axisRect()->rect() : rects.last()->rect();
    const int sum = 2 * bar.top() + bar.height() - 2;  // of rows that mirror each other
    int dark = 0;
    for (int y = bar.top() - 8; y < bar.top() - 2; ++y)
        for (int x = bar.left() - 2; x < bar.left() + bar.width() + 2; ++x) {
            const int above = qGray(both.pixel(x, y)), below = qGray(both.pixel(x, sum - y));
            const int beside = qGray(both.pixel(2 * bar.left() + bar.width() - x, y));
            constexpr int rounding = 8;  // of what is smoothed
            QVERIFY(std::abs(above - below) <= rounding && std::abs(above - beside) <= rounding);
            dark += above < 128;
        }
    QVERIFY(dark > bar.width());
}

void TestWavePicturePage::theDataAreTheFieldInView() {
    PlotWidget* plot = m_page->plot();
    plot->xAxis->setRange(0.25, 0.5);
    plot->yAxis->setRange(3, 4);
    const QList<QByteArray> lines = plot->csv().trimmed().split('\n');
    QCOMPARE(lines.size(), 1 + 101 * 201);
    QCOMPARE(lines.first().split(',').size(), 3);
    const QList<QByteArray> first = lines.at(1).split(',');
    QCOMPARE(first.at(0).toDouble(), 0.25);
    QCOMPARE(first.at(1).toDouble(), 3.0);
    QCOMPARE(lines.last().split(',').at(0).toDouble(), 0.5);
    QCOMPARE(lines.last().split(',').at(1).toDouble(), 4.0);
    // The blow of Fig. 4 as it passes: it compresses with F0 from t = x τ/L to t0 later.
    QCOMPARE(first.at(2).toDouble(), -1.0);
    QCOMPARE(lines.last().split(',').at(2).toDouble(), 0.0);
}

// A picture has no curves, and its numbers are data all the same.
void TestWavePicturePage::theMenuOffersTheDataOfThePicture() {
    const std::unique_ptr<QMenu> menu(new PlotMenu(*m_page->plot(), {100, 100}));
    int offered = 0;
    for (const QAction* action : menu->actions())
        if (QString(action->text()).remove(QLatin1Char('&')).contains(QStringLiteral(" data"))) {
            QVERIFY2(action->isEnabled(), qPrintable(action->text()));
            ++offered;
        }
    QCOMPARE(offered, 2);
}

void TestWavePicturePage::theStripTellsTheStateOfTheBit() {
    m_observation->setTime(5);
    QVERIFY(m_page->rodStrip()->stateText().contains(QStringLiteral("bit at the rock, no force")));
    m_observation->setTime(10.5);
    QVERIFY(m_page->rodStrip()->stateText().contains(QStringLiteral("contact, penetration")));
    QCOMPARE(m_page->rodStrip()->accessibleDescription(), m_page->rodStrip()->stateText());
    QVERIFY(!m_page->rodStrip()->grab().isNull());
}

void TestWavePicturePage::extremeScenesGiveAPictureOrTheReason_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("beta");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("tau");
    QTest::addColumn<double>("delta");
    const auto row = [](const char* name, PulseShape shape, Groups g) {
        QTest::newRow(name) << static_cast<int>(shape) << g.beta << g.gamma << g.tau << g.delta;
    };
    row("reference case", PulseShape::rigidBody, {0.5, 0.3, 10, 0});
    row("half sine", PulseShape::halfSine, {0.5, 0.3, 3, 0});
    row("piston", PulseShape::piston, {0.5, 0.3, 6, 0});
    row("rigid hammer", PulseShape::exponential, {0.5, 0.3, 5, 0});
    row("short rod", PulseShape::rectangular, {0.5, 0.3, 0.3, 0});
    row("stiff", PulseShape::rectangular, {1e6, 0.01, 10, 0});
    row("stiffest", PulseShape::rectangular, {1e9, 1e-6, 10, 0});
    row("soft", PulseShape::rectangular, {1e-5, 1, 5, 0});
    row("gap", PulseShape::rectangular, {0.5, 0.3, 5, 0.5});
    row("gap of a million", PulseShape::rectangular, {0.5, 0.3, 5, 1e6});
    row("beyond solving", PulseShape::rectangular, {1e-300, 1, 0.05, 0});
}

void TestWavePicturePage::extremeScenesGiveAPictureOrTheReason() {
    QFETCH(int, shape);
    QFETCH(double, beta);
    QFETCH(double, gamma);
    QFETCH(double, tau);
    QFETCH(double, delta);
    const Scenario scenario = dimensionless(static_cast<PulseShape>(shape), {beta, gamma, tau, delta});
    open(scenario);
    QTRY_VERIFY_WITH_TIMEOUT(!m_job->isBusy(), 30000);
    const SolvedBlowPtr blow = m_page->picture()->shown();
    if (!blow) {
        QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("Nothing to show")));
        return;
    }
    QTRY_VERIFY(settled());
    const WavePicture& picture = *m_page->picture()->picture();
    const Impact& impact = m_page->picture()->shown()->impact;
    // The first contact is in view, and the view is not so long that nothing can be seen in it.
    QVERIFY(picture.interesting.begin < impact.firstContactTime || impact.frontArrival == 0);
    QVERIFY(picture.interesting.end > impact.firstContactTime);
    QVERIFY(picture.interesting.end - picture.interesting.begin <= 12.0001 * impact.roundTrip);
    QVERIFY(picture.limit > 0 && picture.limit < 10);
    QVERIFY(picture.raster.steps < 100 * static_cast<long>(picture.raster.values.size()));
    QVERIFY(!m_page->grab().isNull());
}

void TestWavePicturePage::unitsChangeBelowTheView() {
    m_units = UnitSystem::si;
    open(Scenario());
    QTRY_VERIFY(settled());
    const SolvedBlowPtr blow = m_page->picture()->shown();
    QCOMPARE(m_page->plot()->xAxis->label(), QStringLiteral("position x from the struck end [m]"));
    QCOMPARE(m_page->plot()->xAxis->range().upper, blow->scales.length);
    // A wave of F0 moves the particles with F0/Z and stresses with F0/A.
    const RodProperties rod = propertiesOf(Scenario().rod);
    QVERIFY(std::abs(blow->page<WavePicture>()->units.velocity.factor * rod.impedance / blow->scales.force -
                     1) < 1e-12);
    QVERIFY(std::abs(blow->page<WavePicture>()->units.stress.factor * 1e6 * rod.area / blow->scales.force -
                     1) < 1e-12);
    m_page->plot()->yAxis->setRange(0.2, 0.4);
    m_page->plot()->replot();
    QTRY_VERIFY(settled());
    const TimeSpan view = m_page->picture()->timeInView();
    m_units = UnitSystem::dimensionless;
    open(Scenario());
    QTRY_VERIFY(settled() && m_page->picture()->shown()->request.units == m_units);
    QCOMPARE(m_page->picture()->timeInView(), view);
    QCOMPARE(m_page->plot()->yAxis->range().lower, view.begin);
    // v0 = I0/m = F0/(Zτ): the unit of velocities.
    QCOMPARE(m_page->picture()->picture()->units.velocity.factor, blow->problem.transitTime());
}

QTEST_MAIN(TestWavePicturePage)
#include "tst_wave_picture_page.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of hammer and string: its sections, readouts, numbers, and rods in turn.
#include <QBuffer>
#include <QLabel>
#include <QSvgGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/pinned_run.h"
#include "tests/support/svg_texts.h"
#include "ui/pages/wave_picture/joint_marks.h"
#include "ui/pages/wave_picture/picture_cursors.h"
#include "ui/pages/wave_picture/play_bar.h"
#include "ui/pages/wave_picture/rod_profile.h"
#include "ui/pages/wave_picture/rod_strip.h"
#include "ui/pages/wave_picture/wave_picture_page.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"

using namespace drillwave;
using namespace drillwave::test;

class TestStringPicture : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void hammerAndAllSectionsAreInView();
    void everyPixelHasTheForceThere();
    void jointsAreMarkedAndNamed();
    void namesThatHaveNoRoomComeWithAZoom();
    void numbersOfContactsDoNotOverlap();
    void theReadoutNamesTheSection();
    void theReadoutTellsOfTheHammer();
    void laterThanTheBlowWasFollowedNothingIsTold();
    void theDataReachFromTheHammerToTheBit();
    void theStripHasTheStressOfEverySection();
    void theProfileIsThereWithoutRuns();
    void runsOfStringsLieOverStrings();
    void rodsAndStringsTakeTurns();
    void aZoomOfTheOneKindIsNoneOfTheOther();
    void wavesThatWereNotKeptAreSaidToBeMissing();
    void theSectionOfThePagesStaysInTheString();
    void dimensionlessVelocitiesAreInThatOfTheHammer();
    void darkAndLightAreFollowed();

  private:
    SolvedBlowPtr solved(const char* example, UnitSystem units = UnitSystem::si) const;
    void present(const SolvedBlowPtr& blow);
    const WavePicture& picture() const { return *m_page->picture()->picture(); }
    /// In metres and milliseconds.
    QPoint pixel(double x, double t) const;
    void hover(QPoint at);
    QString readout() const;
    QString textOf(double value, const ShownUnit& unit) const {
        return quantityText(value, unit, QLocale::c()).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Observation> m_observation;
    std::unique_ptr<WavePicturePage> m_page;
};

void TestStringPicture::initTestCase() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
}

void TestStringPicture::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_page.reset();
    m_observation = std::make_unique<Observation>();
    m_page = std::make_unique<WavePicturePage>(*m_observation);
    m_page->resize(900, 700);
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
}

SolvedBlowPtr TestStringPicture::solved(const char* example, UnitSystem units) const {
    SolveRequest request;
    request.scenario = parseScenario(findExample(example)->text, example).scenario;
    request.units = units;
    request.pages = {m_page->prepare()};
    MethodSolver solver;
    return solveBlow(request, solver);
}

// Lays the page out, so that it has places.
void TestStringPicture::present(const SolvedBlowPtr& blow) {
    m_page->setResult(blow);
    m_page->plot()->replot();
}

QPoint TestStringPicture::pixel(double x, double t) const {
    return {static_cast<int>(std::lround(m_page->plot()->xAxis->coordToPixel(x))),
            static_cast<int>(std::lround(m_page->plot()->yAxis->coordToPixel(t)))};
}

void TestStringPicture::hover(QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, m_page->plot()->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(m_page->plot(), &move);
}

QString TestStringPicture::readout() const {
    QString text = m_page->findChild<QLabel*>(QStringLiteral("readout"))->text();
    return text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

void TestStringPicture::hammerAndAllSectionsAreInView() {
    const SolvedBlowPtr blow = solved("r32_string");
    QVERIFY(m_page->shows(blow->scenario));
    present(blow);
    QVERIFY(picture().string);
    QCOMPARE(picture().string->rod.stretches.size(), allSections(blow->scenario.drillString).size());
    const QCPRange x = m_page->plot()->xAxis->range(), t = m_page->plot()->yAxis->range();
    QVERIFY(std::abs(x.lower + 0.45) < 1e-9 && std::abs(x.upper - 4.3) < 1e-9);
    QCOMPARE(t.lower, 0.0);
    QVERIFY(t.upper > blow->impact.separationTime * blow->units.time.factor);
    QVERIFY(m_page->plot()->xAxis->label().contains(QStringLiteral("struck end")));
    // The colours go as far as the largest force, alike on both sides.
    double largest = 0;
    for (const SectionForces& section : blow->impact.sections)
        largest = std::max({largest, section.compression.force, section.tension.force});
    QCOMPARE(picture().limit, largest);
    QVERIFY(double(std::max(-picture().least, picture().largest)) <= largest * (1 + 1e-6));
    QVERIFY(!m_page->plot()->accessibleDescription().isEmpty());
}

void TestStringPicture::everyPixelHasTheForceThere() {
    const SolvedBlowPtr blow = solved("r32_string");
    present(blow);
    const RasterGrid& grid = picture().raster.grid;
    QVERIFY(grid.columns > 300 && grid.rows > 200);
    int compared = 0;
    for (int column = 20; column < grid.columns; column += 53) {
        if (grid.xi(column) < 0) continue;
        const StringHistory history(blow->impact, blow->problem,
                                    stringPlace(blow->scenario.drillString, grid.xi(column)));
        for (int row = 0; row < grid.rows; row += 41, ++compared)
            QVERIFY(std::abs(double(picture().raster.values[grid.index(column, row)]) -
                             history.at(grid.time(row)).normalForce) < 1e-6);
    }
    QVERIFY(compared > 40);
    // In the pixels themselves: compressed behind the front, at rest ahead of it.
    const QImage image = m_page->plot()->toPixmap().toImage();
    const QColor behind(image.pixel(pixel(1.5, 0.4))), ahead(image.pixel(pixel(3.5, 0.4)));
    QVERIFY(behind.blue() > behind.red() + 40);
    QVERIFY(std::abs(ahead.blue() - ahead.red()) < 10);
}

void TestStringPicture::jointsAreMarkedAndNamed() {
    present(solved("r32_string"));
    const JointMarksItem& joints = m_page->picture()->joints();
    const QVector<double> lines = joints.lines();
    QVector<double> expected;  // the sections of the example [m]
    for (const double x : {-0.2, 0.0, 0.35, 0.5, 4.2, 4.25})
        expected.append(m_page->plot()->xAxis->coordToPixel(x));
    QCOMPARE(lines.size(), expected.size());
    for (qsizetype i = 0; i < lines.size(); ++i) QVERIFY(std::abs(lines[i] - expected[i]) < 1e-6);
    QStringList names;
    const QRectF picture = m_page->plot()->rect();
    for (const JointMarksItem::Name& name : joints.names()) {
        names << name.text;
        QVERIFY2(picture.contains(name.box), qPrintable(name.text));
        for (const JointMarksItem::Name& other : joints.names())
            QVERIFY(name.text == other.text || !name.box.intersects(other.box));
    }
    for (const char* there : {"hammer", "adapter", "coupling", "rod"})
        QVERIFY2(names.contains(QLatin1String(there)), there);
    present(solved("t38_medium_rock"));
    QVERIFY(joints.lines().isEmpty() && joints.names().isEmpty());
}

void TestStringPicture::namesThatHaveNoRoomComeWithAZoom() {
    present(solved("t38_string"));
    const auto has = [&](const char* text) {
        const QVector<JointMarksItem::Name> names = m_page->picture()->joints().names();
        return std::ranges::any_of(names, [&](const auto& name) { return name.text == QLatin1String(text); });
    };
    QVERIFY(has("rod") && has("hammer"));
    QVERIFY(!has("bit skirt") || !has("bit head"));
    const double length = picture().units.position.factor;
    m_page->plot()->xAxis->setRange(length - 0.3, length);
    QVERIFY(has("bit skirt") && has("bit head"));
    QVERIFY(!has("hammer"));
}

// The first three of four contacts are close together.
void TestStringPicture::numbersOfContactsDoNotOverlap() {
    present(solved("t38_string"));
    const auto numbers = [&](int height) {
        QBuffer file;
        QSvgGenerator svg;
        svg.setOutputDevice(&file);
        QCPPainter painter(&svg);
        m_page->plot()->toPainter(&painter, 600, height);
        painter.end();
        QStringList found;
        for (const QString& text : svgTexts(file.data()))
            if (QStringLiteral("1234").contains(text)) found << text;
        return found.join(QString());
    };
    QCOMPARE(numbers(900), QStringLiteral("1234"));
    const QString low = numbers(300);
    QVERIFY2(low.startsWith(u'1') && low.endsWith(u'4') && low.size() == 3, qPrintable(low));
}

void TestStringPicture::theReadoutNamesTheSection() {
    const SolvedBlowPtr blow = solved("r32_string");
    present(blow);
    // On its way through the coupling, 0.35 … 0.5 m, to the rod.
    const QPoint at = pixel(0.42, 0.12);
    hover(at);
    const double x = m_page->plot()->xAxis->pixelToCoord(at.x());
    const double t = m_page->plot()->yAxis->pixelToCoord(at.y()) / blow->units.time.factor;
    const StringHistory history(blow->impact, blow->problem,
                                stringPlace(blow->scenario.drillString, x / 4.3));
    const RodState now = history.at(t);
    QVERIFY(now.normalForce < -0.5);
    QVERIFY2(
        readout().startsWith(textOf((x - 0.35) / 4.3, picture().units.position) + " into coupling · t = "),
        qPrintable(readout()));
    const double area = propertiesOf(*allSections(blow->scenario.drillString)[3], Material()).area;
    const double newtons = now.normalForce * blow->scales.force;
    for (const QString& text : {"N = " + textOf(now.normalForce, blow->units.force),
                                "σ = " + textOf(newtons / area / blow->scales.stress, blow->units.stress),
                                "v = " + textOf(now.velocity * 2, picture().units.velocity)})
        QVERIFY2(readout().contains(text), qPrintable(readout() + " lacks " + text));
    // v0 of the hammer, which has not been reached by anything yet
    hover(pixel(-0.4, 0.01));
    QVERIFY2(readout().contains(QStringLiteral("v = 9.5 m/s")), qPrintable(readout()));
}

void TestStringPicture::theReadoutTellsOfTheHammer() {
    present(solved("r32_string"));
    hover(pixel(-0.1, 1));
    QVERIFY2(readout().contains(QStringLiteral("into hammer 2 · ")), qPrintable(readout()));
    hover(pixel(-0.4, 1));
    QVERIFY2(readout().contains(QStringLiteral("into hammer 1 · ")), qPrintable(readout()));
    hover({2, 2});
    QVERIFY2(readout().startsWith(QStringLiteral("N in this view: from ")), qPrintable(readout()));
}

void TestStringPicture::laterThanTheBlowWasFollowedNothingIsTold() {
    const SolvedBlowPtr blow = solved("r32_string");
    present(blow);
    const double end = picture().string->end;
    m_page->plot()->yAxis->setRange(0, 2 * end * blow->units.time.factor);
    present(solved("r32_string"));
    const RasterGrid& grid = picture().raster.grid;
    for (int row = 0; row < grid.rows; ++row)
        QCOMPARE(std::isnan(picture().raster.values[grid.index(50, row)]), grid.time(row) > end);
    hover(pixel(2, 1.5 * end * blow->units.time.factor));
    QVERIFY2(readout().endsWith(QStringLiteral("after the computed time")), qPrintable(readout()));
    m_observation->setTime(1.5 * end);
    QVERIFY2(m_page->rodStrip()->stateText().contains(QStringLiteral("computed time")),
             qPrintable(m_page->rodStrip()->stateText()));
    QVERIFY(m_page->rodProfile()->lines().first().points.isEmpty());
    QVERIFY(!m_page->grab().isNull());
    const QByteArray last = m_page->plot()->csv().trimmed().split('\n').last();
    QVERIFY(std::abs(last.split(',').at(1).toDouble() - end * blow->units.time.factor) < 1e-9);
}

void TestStringPicture::theDataReachFromTheHammerToTheBit() {
    const SolvedBlowPtr blow = solved("r32_string");
    present(blow);
    const QList<QByteArray> rows = m_page->plot()->csv().trimmed().split('\n');
    QCOMPARE(rows.first(), QByteArray("\"position x from the struck end, hammer at x < 0 [m]\",time t [ms],"
                                      "force N (tension positive) [kN]"));
    QCOMPARE(rows.size(), 1 + 101 * 201);
    QVERIFY(std::abs(rows.at(1).split(',').first().toDouble() + 0.45) < 1e-12);
    QVERIFY(std::abs(rows.last().split(',').first().toDouble() - 4.3) < 1e-12);
    for (int i = 1; i < rows.size(); i += 331) {
        const QList<QByteArray> cells = rows.at(i).split(',');
        const double x = cells.at(0).toDouble() / blow->units.length.factor;
        const double t = cells.at(1).toDouble() / blow->units.time.factor;
        const double force =
            BlowWaves(*blow).value(WaveQuantity::force, std::clamp(x, picture().rear, 1.0), t);
        // a rounded place may lie on the other side of a front
        if (std::abs(cells.at(2).toDouble() - force * blow->units.force.factor) > 1e-6)
            QVERIFY(std::abs(cells.at(2).toDouble() -
                             BlowWaves(*blow).value(WaveQuantity::force, std::clamp(x, picture().rear, 1.0),
                                                    t - 1e-9) *
                                 blow->units.force.factor) < 1e-6);
    }
}

void TestStringPicture::theStripHasTheStressOfEverySection() {
    const SolvedBlowPtr blow = solved("r32_string");
    present(blow);
    m_observation->setTime(3.2);
    const StringRod& rod = picture().string->rod;
    const BlowWaves waves(*blow);
    double least = 0, most = 0;
    const int columns = m_page->plot()->axisRect()->width();
    for (int i = 0; i < columns; ++i) {
        const double x = std::lerp(picture().rear, 1.0, (i + 0.5) / columns);
        const double area =
            propertiesOf(*allSections(blow->scenario.drillString)[rod.sectionAt(x)], Material()).area;
        const double stress =
            waves.value(WaveQuantity::force, x, 3.2) * blow->scales.force / area / blow->scales.stress;
        least = std::min(least, stress);
        most = std::max(most, stress);
    }
    QVERIFY(least < -0.5);
    const QString text = m_page->rodStrip()->stateText().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    QVERIFY2(text.endsWith("stress " + textOf(double(float(least)), blow->units.stress) + " … " +
                           textOf(double(float(most)), blow->units.stress)),
             qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("hammer not in contact")), qPrintable(text));
    QCOMPARE(picture().string->largestStress,
             std::max(*blow->summary.largest.compression, *blow->summary.largest.tension));
    m_observation->setTime(1);
    QVERIFY(m_page->rodStrip()->stateText().contains(QStringLiteral("hammer pushes")));
    m_observation->setTime((blow->impact.events[0].time + blow->impact.events[1].time) / 2);
    QVERIFY(m_page->rodStrip()->stateText().contains(QStringLiteral("contact, penetration")));
}

void TestStringPicture::theProfileIsThereWithoutRuns() {
    present(solved("r32_string"));
    m_observation->setTime(3);
    QVERIFY(m_page->rodProfile()->isVisible());
    const QVector<RodProfile::Line>& lines = m_page->rodProfile()->lines();
    QCOMPARE(lines.size(), 1);
    QVERIFY(lines[0].points.first().x() < -0.4 && lines[0].points.last().x() > 4.2);
    present(solved("t38_medium_rock"));
    QVERIFY(m_page->rodProfile()->isHidden());
}

void TestStringPicture::runsOfStringsLieOverStrings() {
    const SolvedBlowPtr rod = solved("t38_medium_rock"), string = solved("t38_string");
    auto unkept = std::make_shared<SolvedBlow>(*string);
    unkept->impact.waves.reset();
    unkept->impact.incident = {};
    m_page->setRuns(std::make_shared<const RunList>(
        RunList{pinnedRun(0, rod), pinnedRun(1, string), pinnedRun(2, unkept)}));
    for (const char* example : {"r32_string", "t38_medium_rock", "r32_string"}) {
        const SolvedBlowPtr now = solved(example);
        present(now);
        QCOMPARE(picture().runs.size(), std::size_t{1});
        QCOMPARE(picture().runs.front().number, now->isOfString() ? 1 : 0);
        m_observation->setTime(3);
        const QVector<RodProfile::Line>& lines = m_page->rodProfile()->lines();
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[1].points.size() > 200);
        // the same place and instant, each by its own scales
        const SolvedBlow& run = now->isOfString() ? *string : *rod;
        const QPointF point = lines[1].points[lines[1].points.size() / 2];
        const double force = BlowWaves(run).value(WaveQuantity::force, point.x() / run.scales.length,
                                                  3 * now->scales.time / run.scales.time) *
                             run.scales.force / 1e3;
        QVERIFY(std::abs(point.y() - force) <= 1e-6 * run.scales.force / 1e3);
    }
}

void TestStringPicture::rodsAndStringsTakeTurns() {
    for (const char* example :
         {"t38_medium_rock", "t38_string", "paper_fig4b", "t51_string", "r32_string", "t38_medium_rock"}) {
        const SolvedBlowPtr blow = solved(example);
        present(blow);
        const double length = picture().units.position.factor;
        QCOMPARE(m_page->plot()->xAxis->range().lower, picture().rear * length);
        QCOMPARE(m_page->plot()->xAxis->range().upper, length);
        QCOMPARE(picture().string.has_value(), blow->isOfString());
        QVERIFY(picture().rear < 0 || !blow->isOfString());
        hover(m_page->plot()->axisRect()->center());
        QCOMPARE(readout().contains(QStringLiteral("σ = ")), blow->isOfString());
        QVERIFY(!m_page->grab().isNull());
        m_page->setResult(failedBlow(blow->request, "out of rock"));
        QVERIFY(!m_page->grab().isNull());
    }
}

void TestStringPicture::aZoomOfTheOneKindIsNoneOfTheOther() {
    const SolvedBlowPtr rod = solved("t38_medium_rock");
    present(rod);
    m_page->plot()->xAxis->setRange(1, 1.2);
    QVERIFY(m_page->picture()->need().window.has_value());
    present(solved("r32_string"));
    QVERIFY(std::abs(m_page->plot()->xAxis->range().lower + 0.45) < 1e-9);
    QVERIFY(!m_page->picture()->need().window.has_value());
    m_page->plot()->xAxis->setRange(-2, 1);  // from beyond the hammer: moved there
    QVERIFY(std::abs(m_page->plot()->xAxis->range().lower + 0.45) < 1e-9);
    QVERIFY(std::abs(m_page->picture()->need().window->xiEnd - 2.55 / 4.3) < 1e-9);
    present(solved("r32_string"));  // as when a value changes
    QVERIFY(std::abs(m_page->plot()->xAxis->range().upper - 2.55) < 1e-9);
    m_page->fit();
    QVERIFY(std::abs(m_page->plot()->xAxis->range().upper - 4.3) < 1e-9);
}

void TestStringPicture::wavesThatWereNotKeptAreSaidToBeMissing() {
    auto blow = std::make_shared<SolvedBlow>(*solved("r32_string"));
    blow->impact.waves.reset();
    blow->impact.incident = {};
    blow->request.pages = {m_page->prepare()};
    blow->pages = {m_page->prepare()(*blow)};
    present(blow);
    QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("too many waves")));
    QVERIFY(m_page->plot()->csv().isEmpty());
    m_observation->setTime(2);
    m_observation->setSection(0.3);
    QVERIFY(m_page->rodProfile()->isHidden());
    QVERIFY(!m_page->grab().isNull());
    present(solved("r32_string"));
    QVERIFY(m_page->picture()->shown());
}

void TestStringPicture::theSectionOfThePagesStaysInTheString() {
    present(solved("r32_string"));
    const auto* cursors = m_page->cursors();
    const int y = m_page->plot()->axisRect()->top() + 40;
    const QPoint from(static_cast<int>(cursors->sectionPixel()), y), to = pixel(-0.3, 1);
    QTest::mousePress(m_page->plot(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, QPoint(to.x(), y), m_page->plot()->mapToGlobal(QPoint(to.x(), y)),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_page->plot(), &move);
    QTest::mouseRelease(m_page->plot(), Qt::LeftButton, {}, {to.x(), y});
    QCOMPARE(m_observation->section(), 0.0);
    QVERIFY(std::abs(cursors->sectionPixel() - m_page->plot()->xAxis->coordToPixel(0)) < 1e-6);
}

void TestStringPicture::dimensionlessVelocitiesAreInThatOfTheHammer() {
    present(solved("r32_string", UnitSystem::dimensionless));
    QCOMPARE(m_page->plot()->xAxis->range().upper, 1.0);
    hover(pixel(-0.09, 0.02));  // before the first wave gets there
    QVERIFY2(readout().contains(QStringLiteral("v = 1 v₀")), qPrintable(readout()));
}

void TestStringPicture::darkAndLightAreFollowed() {
    present(solved("r32_string"));
    const auto corner = [&] { return QColor(m_page->plot()->toPixmap().toImage().pixel(3, 3)); };
    const QColor before = corner();
    QPalette dark;
    dark.setColor(QPalette::Base, QColor(30, 30, 30));
    dark.setColor(QPalette::Text, Qt::white);
    m_page->setPalette(dark);
    QTRY_VERIFY(corner().lightness() < 60 && before.lightness() > 200);
    QVERIFY(!m_page->grab().isNull());
}

QTEST_MAIN(TestStringPicture)
#include "tst_string_picture.moc"

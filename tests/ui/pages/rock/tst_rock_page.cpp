// SPDX-License-Identifier: GPL-3.0-or-later
// The page Rock: its path, the point of the time cursor, the reason where there is none.
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>

#include "ui/pages/rock/rock_curve.h"
#include "ui/pages/rock/rock_page.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;

class TestRockPage : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void askedForThePathTheWorkerBuildsIt();
    void thePathIsThereForEyesAndEars();
    void theTimeCursorMovesThePointAlongThePath();
    void withoutATimeThereIsNoPoint();
    void anUnsolvedBlowSaysWhy();
    void anAnswerToAnotherPageChangesNothing();
    void aGhostStaysUntilItIsTakenAway();
    void zoomedItIsFittedAgainByTheButton();
    void darkAndLightAreFollowed();

  private:
    SolvedBlowPtr solved(double stiffness = 105e6) const;
    QString instant() const {
        QString text = m_page->findChild<QLabel*>(QStringLiteral("instant"))->text();
        return text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    }
    QCPItemTracer* point() const;

    std::unique_ptr<Observation> m_observation;
    std::unique_ptr<RockPage> m_page;
};

void TestRockPage::init() {
    QLocale::setDefault(QLocale::c());
    m_page.reset();
    m_observation = std::make_unique<Observation>();
    m_page = std::make_unique<RockPage>(*m_observation);
    m_page->resize(600, 450);
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
}

SolvedBlowPtr TestRockPage::solved(double stiffness) const {
    SolveRequest request;
    request.scenario.bitRock.stiffness = stiffness;
    request.units = UnitSystem::si;
    request.pages = {m_page->prepare()};
    MethodSolver solver;
    return solveBlow(request, solver);
}

// The only mark on the layer that is redrawn without the rest.
QCPItemTracer* TestRockPage::point() const {
    for (QCPLayerable* each : m_page->plot()->layer(QStringLiteral("overlay"))->children())
        if (auto* tracer = qobject_cast<QCPItemTracer*>(each); tracer && tracer->size() == 10) return tracer;
    return nullptr;
}

void TestRockPage::askedForThePathTheWorkerBuildsIt() {
    SolveRequest request;
    MethodSolver solver;
    QVERIFY(!solveBlow(request, solver)->page<RockCurve>());
    request.pages = {m_page->prepare()};
    const SolvedBlowPtr blow = solveBlow(request, solver);
    QVERIFY(blow->page<RockCurve>());
    QCOMPARE(blow->pages.size(), std::size_t{1});  // nothing of what other pages show
}

void TestRockPage::thePathIsThereForEyesAndEars() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    QCOMPARE(m_page->plot()->plottableCount(), 1);
    const QString description = m_page->plot()->accessibleDescription();
    for (const char* text : {"Fₘ = ", "Uₘ = ", "Uᵣ = ", "energy left in the rock", "J", "% of the blow"})
        QVERIFY2(description.contains(QString::fromUtf8(text)), qPrintable(description));
    QVERIFY(!m_page->plot()->accessibleName().isEmpty());
}

void TestRockPage::theTimeCursorMovesThePointAlongThePath() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    const double unloading = blow->impact.events.at(1).time;
    QCOMPARE(blow->impact.events.at(1).kind, ContactEvent::unloading);
    m_observation->setTime(unloading);
    QVERIFY(point()->visible());
    const QPointF peak = rockPoint(*blow->page<RockCurve>(), unloading * blow->units.time.factor);
    QCOMPARE(point()->position->coords(), peak);
    QVERIFY(instant().contains(QStringLiteral("U = ")) && instant().contains(QStringLiteral(" mm")));
    const QString before = instant();
    m_observation->setTime(unloading + 0.3);
    QVERIFY(point()->position->coords().y() < peak.y());
    QVERIFY(instant() != before);
    // Another blow at the same time.
    m_page->setResult(solved(50e6));
    QVERIFY(point()->visible());
}

void TestRockPage::withoutATimeThereIsNoPoint() {
    m_page->setResult(solved());
    QVERIFY(!point()->visible());
    QVERIFY(instant().contains(QStringLiteral("To mark a time")));
    m_observation->setTime(8.0);
    QVERIFY(point()->visible());
    m_observation->setTime({});
    QVERIFY(!point()->visible());
}

void TestRockPage::anUnsolvedBlowSaysWhy() {
    m_page->setResult(solved());
    m_observation->setTime(8.0);
    m_page->setResult(failedBlow({}, QStringLiteral("The rock has left.")));
    QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("The rock has left.")));
    QVERIFY(!point()->visible());
    m_page->setResult(solved());
    QVERIFY(point()->visible());
}

void TestRockPage::anAnswerToAnotherPageChangesNothing() {
    m_page->setResult(solved());
    const QString before = m_page->plot()->accessibleDescription();
    SolveRequest request;
    MethodSolver solver;
    m_page->setResult(solveBlow(request, solver));
    QCOMPARE(m_page->plot()->accessibleDescription(), before);
}

void TestRockPage::aGhostStaysUntilItIsTakenAway() {
    const SolvedBlowPtr before = solved();
    m_page->setResult(before);
    m_page->setGhost(before);
    m_page->setResult(solved(50e6));
    QCOMPARE(m_page->plot()->plottableCount(), 2);
    m_page->setGhost(nullptr);
    QCOMPARE(m_page->plot()->plottableCount(), 1);
    m_page->setGhost(failedBlow({}, QStringLiteral("nothing was shown before")));
    QCOMPARE(m_page->plot()->plottableCount(), 1);
}

void TestRockPage::zoomedItIsFittedAgainByTheButton() {
    m_page->setResult(solved());
    const QCPRange fitted = m_page->plot()->xAxis->range();
    m_page->plot()->replot();
    const QPoint at = m_page->plot()->axisRect()->center();
    QWheelEvent wheel(at, m_page->plot()->mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton,
                      Qt::ControlModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(m_page->plot(), &wheel);
    QVERIFY(m_page->plot()->xAxis->range().size() < fitted.size());
    QTest::mouseClick(m_page->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(m_page->plot()->xAxis->range(), fitted);
}

void TestRockPage::darkAndLightAreFollowed() {
    m_page->setResult(solved());
    QPalette palette = m_page->palette();
    palette.setColor(QPalette::Base, QColor(30, 30, 32));
    palette.setColor(QPalette::Text, QColor(225, 225, 225));
    m_page->setPalette(palette);
    QCoreApplication::processEvents();
    QCOMPARE(m_page->plot()->grab().toImage().pixelColor(5, 5), QColor(30, 30, 32));
    QVERIFY(m_page->plot()->plottable(0)->pen().color().lightness() > 128);
}

QTEST_MAIN(TestRockPage)
#include "tst_rock_page.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// One of many blows on the pages of a single one: opened, carried from page to page, and left again.
#include <QPushButton>
#include <QTest>

#include "core/yaml/examples.h"
#include "tests/support/window_fixture.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/pages/rock/rock_page.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/pages/rod/rod_page.h"
#include "ui/pages/wave_picture/wave_picture_page.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"
#include "ui/plot/plot_widget.h"
#include "ui/window/page_notices.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;
using namespace drillwave::test;

class TestMarchedNotice : public QObject, private WindowFixture {
    Q_OBJECT

  private slots:
    void cleanup() { m_window.reset(); }
    void aBlowIsOpenedAsItBegan_data();
    void aBlowIsOpenedAsItBegan();
    void anotherScenarioEndsIt();

  private:
    void open(const char* example, long number);
    void choose(Page& page) {
        part<PageTabs>(window()).setCurrentWidget(&page);
        settle();
    }
    Page& current() { return part<PageTabs>(window()).current(); }
};

void TestMarchedNotice::open(const char* example, long number) {
    start();
    window().openExample(*findExample(example));
    settle();
    choose(part<DrillingPage>(window()));
    emit part<DrillingPage>(window()).blowOpened({{.blows = 20, .settle = 5, .cells = 20}, number},
                                                 QStringLiteral("Blow %1").arg(number));
    settle();
}

void TestMarchedNotice::aBlowIsOpenedAsItBegan_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::newRow("rod") << QByteArray("t38_medium_rock");
    QTest::newRow("string") << QByteArray("r32_string");
}

void TestMarchedNotice::aBlowIsOpenedAsItBegan() {
    QFETCH(QByteArray, example);
    open(example.constData(), 7);
    auto& notice = part<MarchedNotice>(window());
    auto& blow = part<BlowPage>(window());
    QCOMPARE(&current(), &blow);
    QVERIFY(notice.isVisible());
    QCOMPARE(notice.text(), QStringLiteral("Blow 7"));
    const auto forces = [&] { return *blow.plots()->forceGraph()->data(); };
    QTRY_VERIFY(window().shown()->marchedBlow);
    const SolvedBlowPtr marched = window().shown()->marchedBlow;
    QVERIFY2(marched->fault.isEmpty(), qPrintable(marched->fault));
    QCOMPARE(marched->marched->number, 7L);
    bool isFound = false;
    const double drawn = forces().valueRange(isFound).upper;
    QVERIFY(std::abs(drawn / (marched->summary.peakForce * marched->units.force.factor) - 1) < 1e-3);
    // the numbers stay those of the single blow
    const double single = window().shown()->summary.peakForce;
    QVERIFY(std::abs(marched->summary.peakForce / single - 1) > 1e-6);

    choose(part<RockPage>(window()));
    QVERIFY(notice.isVisible());
    QCOMPARE(window().shown()->marchedBlow->marched->number, 7L);
    QVERIFY(part<RockPage>(window()).plot()->plottableCount() > 0);
    choose(part<WavePicturePage>(window()));
    QVERIFY(notice.isVisible());
    const auto* picture = part<WavePicturePage>(window()).findChild<PlotWidget*>();
    QVERIFY(picture);
    choose(part<RodPage>(window()));  // which is of the single one
    QVERIFY(!notice.isVisible());
    QVERIFY(!window().shown()->marchedBlow);
    choose(blow);
    QVERIFY(notice.isVisible());

    notice.findChild<QPushButton*>(QStringLiteral("singleBlow"))->click();
    settle();
    QVERIFY(!notice.isVisible());
    QVERIFY(!window().shown()->marchedBlow);
    const double again = forces().valueRange(isFound).upper;
    QVERIFY(std::abs(again / (single * window().shown()->units.force.factor) - 1) < 1e-3);
}

void TestMarchedNotice::anotherScenarioEndsIt() {
    open("t38_medium_rock", 3);
    QVERIFY(part<MarchedNotice>(window()).isVisible());
    type(field("beta"), QStringLiteral("0.25"));
    settle();
    QVERIFY(!part<MarchedNotice>(window()).isVisible());
    QVERIFY(!window().shown()->marchedBlow);
}

QTEST_MAIN(TestMarchedNotice)
#include "tst_marched_notice.moc"

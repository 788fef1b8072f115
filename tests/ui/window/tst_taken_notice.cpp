// SPDX-License-Identifier: GPL-3.0-or-later
// The strip about a value that a click took from a plot, and its Undo.
#include <QPushButton>
#include <QTest>

#include "tests/support/window_fixture.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/plot_widget.h"
#include "ui/window/page_notices.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;
using namespace drillwave::test;

class TestTakenNotice : public QObject, private WindowFixture {
    Q_OBJECT

  private slots:
    void cleanup() { m_window.reset(); }
    void aTakenValueIsSaidAndTakenBack();
};

void TestTakenNotice::aTakenValueIsSaidAndTakenBack() {
    start();
    auto& page = studyPage(window(), "gap");
    part<PageTabs>(window()).setCurrentWidget(&page);
    QTRY_VERIFY_WITH_TIMEOUT(page.activity()->state() == StudyState::finished, 60000);
    auto& notice = part<TakenNotice>(window());
    Document& document = window().document();
    const Scenario before = document.scenario();
    const QCPGraph* curve = page.figureFrame().graph();
    const auto click = [&](double above) {
        page.plot()->replot();
        const QPointF on(curve->keyAxis()->coordToPixel(1),
                         curve->valueAxis()->coordToPixel(chordValue(*curve->data(), 1)) - above);
        QTest::mouseClick(page.plot(), Qt::LeftButton, {}, on.toPoint());
    };
    click(25);
    QVERIFY(notice.isHidden());
    QCOMPARE(document.scenario(), before);
    click(0);
    QVERIFY(!notice.isHidden());
    QVERIFY2(
        notice.text().contains(QStringLiteral("set to")) && notice.text().contains(QStringLiteral(" mm")),
        qPrintable(notice.text()));
    QVERIFY(document.scenario().bitRock.gap > 0);
    notice.findChild<QPushButton*>(QStringLiteral("undoTaken"))->click();
    QCOMPARE(document.scenario(), before);
    QVERIFY(notice.isHidden());
    // Another change of the scenario sends it away, so that Undo never takes back something else.
    click(0);
    QVERIFY(!notice.isHidden());
    document.assign(*findParameter("bit_rock.gamma"), 0.4, document.newGesture());
    QVERIFY(notice.isHidden());
}

QTEST_MAIN(TestTakenNotice)
#include "tst_taken_notice.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and keys in a plot: its view, its legend, its menu.
#include <QAction>
#include <QContextMenuEvent>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/support/plot_scene.h"
#include "ui/plot/axis_view.h"
#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

class TestPlotWidget : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void aBurstOfTheWheelIsOneStepBack();
    void draggingPansAndTheBackButtonGoesBack();
    void shiftAndDragZoomsToTheBox();
    void theRightButtonDrawsABoxOrOpensTheMenu();
    void aDoubleClickFitsAndCanBeTakenBack();
    void keysPanZoomAndFit();
    void noWheelEverBreaksTheRange();
    void viewsInOtherUnitsAreForgotten();
    void aClickOnALegendEntryHidesItsCurveAndStrikesItOut();
    void theMenuListsTheCurvesOfAllLegends();
    void logarithmicAxesNeedPositiveValues();
    void stackedTimeAxesTurnLogarithmicTogether();
    void theNearestPointIsReadUnderThePointer();
    void hoveringOverAMillionPointsIsQuick();
    void theKeyboardOpensTheMenu();
    void replotsArePaintedTogetherWithTheWindow();
    void labelIsElidedBeforeItsUnitWhenTheAxisIsShort();
    void labelIsElidedOnlyWhileItIsDrawn();
    void labelHasOneLineAgainWhenTheAxisIsLongEnough();
    void shortAxesHaveFewTicks();

  private:
    std::unique_ptr<PlotScene> m;
};

void TestPlotWidget::init() {
    QLocale::setDefault(QLocale::c());
    QCursor::setPos(-100, -100);
    m = std::make_unique<PlotScene>();
    QVERIFY(QTest::qWaitForWindowExposed(&m->plot));
    m->plot.replot();
}

void TestPlotWidget::aBurstOfTheWheelIsOneStepBack() {
    QVERIFY(!m->plot.view().canGoBack());
    for (int i = 0; i < 5; ++i) m->wheel(m->upper->center(), 1);
    QVERIFY(m->x(m->upper)->range().size() < 5);
    QCOMPARE(m->x(m->lower)->range(), m->x(m->upper)->range());
    m->plot.view().goBack();
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
    QCOMPARE(m->y(m->upper)->range(), QCPRange(-10, 110));
    QVERIFY(!m->plot.view().canGoBack());
}

void TestPlotWidget::draggingPansAndTheBackButtonGoesBack() {
    m->drag(Qt::LeftButton, {}, m->at(5, 60), m->at(3, 60));
    QVERIFY(near(m->x(m->upper)->range().lower, 2, 0.05));
    QVERIFY(near(m->x(m->lower)->range().upper, 12, 0.05));
    QCOMPARE(m->y(m->upper)->range(), QCPRange(-10, 110));
    QTest::mouseClick(&m->plot, Qt::BackButton, {}, m->upper->center());
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
}

void TestPlotWidget::shiftAndDragZoomsToTheBox() {
    m->drag(Qt::LeftButton, Qt::ShiftModifier, m->at(2, 80), m->at(6, 20));
    QVERIFY(near(m->x(m->upper)->range().lower, 2, 0.05));
    QVERIFY(near(m->x(m->upper)->range().upper, 6, 0.05));
    QVERIFY(near(m->y(m->upper)->range().lower, 20, 1));
    QVERIFY(near(m->y(m->upper)->range().upper, 80, 1));
    QTest::keyClick(&m->plot, Qt::Key_Backspace);
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
}

void TestPlotWidget::theRightButtonDrawsABoxOrOpensTheMenu() {
    m->drag(Qt::RightButton, {}, m->at(2, 80), m->at(6, 20));
    QVERIFY(near(m->x(m->upper)->range().size(), 4, 0.1));
    QVERIFY(!m->plot.findChild<QMenu*>(QStringLiteral("plotMenu")));
    QTest::mouseClick(&m->plot, Qt::RightButton, {}, m->upper->center());
    auto* menu = m->plot.findChild<QMenu*>(QStringLiteral("plotMenu"));
    QVERIFY(menu);
    menu->close();
    QVERIFY(near(m->x(m->upper)->range().size(), 4, 0.1));
}

void TestPlotWidget::aDoubleClickFitsAndCanBeTakenBack() {
    m->x(m->upper)->setRange(2, 3);
    QSignalSpy asked(&m->plot, &PlotWidget::fitRequested);
    QTest::mouseDClick(&m->plot, Qt::LeftButton, {}, m->upper->center());
    QCOMPARE(asked.count(), 1);
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
    QTest::keyClick(&m->plot, Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(m->x(m->upper)->range(), QCPRange(2, 3));
}

void TestPlotWidget::keysPanZoomAndFit() {
    QTest::keyClick(&m->plot, Qt::Key_Right);
    QVERIFY(near(m->x(m->upper)->range().lower, 1, 1e-9));
    QTest::keyClick(&m->plot, Qt::Key_Up);
    QVERIFY(near(m->y(m->upper)->range().lower, 2, 1e-9));
    QTest::keyClick(&m->plot, Qt::Key_Plus);
    QVERIFY(near(m->x(m->upper)->range().size(), 7.5, 1e-9));
    QTest::keyClick(&m->plot, Qt::Key_Minus);
    QVERIFY(near(m->x(m->upper)->range().size(), 10, 1e-9));
    QTest::keyClick(&m->plot, Qt::Key_Home);
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
}

void TestPlotWidget::noWheelEverBreaksTheRange() {
    for (const int notches : {30, -60}) {
        for (int i = 0; i < 60; ++i) m->wheel(m->upper->center() + QPoint(7, 3), notches);
        const QCPRange range = m->x(m->upper)->range();
        QVERIFY(std::isfinite(range.lower) && std::isfinite(range.upper));
        QVERIFY(range.size() >= 1e-12 * std::max(std::abs(range.lower), std::abs(range.upper)));
        m->plot.replot();
        QVERIFY(m->x(m->upper)->tickVector().size() < 100);
    }
}

// Milliseconds ago: the numbers of that view mean something else now.
void TestPlotWidget::viewsInOtherUnitsAreForgotten() {
    m->wheel(m->upper->center(), 1);
    QVERIFY(m->plot.view().canGoBack());
    m->x(m->lower)->setLabel(QStringLiteral("time t / t₀"));
    QVERIFY(!m->plot.view().canGoBack());
    const QCPRange range = m->x(m->upper)->range();
    m->plot.view().goBack();
    QCOMPARE(m->x(m->upper)->range(), range);
}

void TestPlotWidget::aClickOnALegendEntryHidesItsCurveAndStrikesItOut() {
    m->clickLegend(1, 1);
    QVERIFY(!m->line->visible());
    QVERIFY(m->step->visible());
    m->plot.replot();
    QVERIFY(m->legends[1]->item(1)->font().strikeOut());
    QVERIFY(!m->legends[1]->item(0)->font().strikeOut());
    QVERIFY(m->legends[1]->item(1)->textColor() != m->legends[1]->item(0)->textColor());
    m->clickLegend(1, 1);
    m->plot.replot();
    QVERIFY(m->line->visible());
    QVERIFY(!m->legends[1]->item(1)->font().strikeOut());
}

void TestPlotWidget::theMenuListsTheCurvesOfAllLegends() {
    QVERIFY(m->action(QStringLiteral("parabola")));
    QAction* line = m->action(QStringLiteral("line, falling"));
    QVERIFY(line->isCheckable() && line->isChecked());
    line->trigger();
    QVERIFY(!m->line->visible());
}

void TestPlotWidget::logarithmicAxesNeedPositiveValues() {
    QAction* vertical = m->action(QStringLiteral("Logarithmic vertical"));
    QVERIFY(vertical->isEnabled());
    vertical->trigger();
    QCOMPARE(m->y(m->upper)->scaleType(), QCPAxis::stLogarithmic);
    QVERIFY(m->y(m->upper)->range().lower > 0);
    QVERIFY(m->y(m->upper)->range().contains(100));
    m->plot.replot();
    m->wheel(m->upper->center(), 3);
    QVERIFY(m->y(m->upper)->range().lower > 0);
    m->menu = std::make_unique<PlotMenu>(m->plot, m->lower->center());
    for (const QAction* action : m->menu->actions()) {
        if (!action->text().contains(QStringLiteral("vertical"))) continue;
        QVERIFY(!action->isEnabled());
        QVERIFY(action->toolTip().contains(QStringLiteral("negative")));
    }
    m->action(QStringLiteral("Logarithmic vertical"))->trigger();
    QCOMPARE(m->y(m->upper)->scaleType(), QCPAxis::stLinear);
    QCOMPARE(m->y(m->upper)->range(), QCPRange(-10, 110));
}

void TestPlotWidget::stackedTimeAxesTurnLogarithmicTogether() {
    m->action(QStringLiteral("Logarithmic horizontal"))->trigger();
    QCOMPARE(m->x(m->upper)->scaleType(), QCPAxis::stLogarithmic);
    QCOMPARE(m->x(m->lower)->scaleType(), QCPAxis::stLogarithmic);
    QCOMPARE(m->x(m->lower)->range(), m->x(m->upper)->range());
    m->plot.view().goBack();
    QCOMPARE(m->x(m->lower)->scaleType(), QCPAxis::stLinear);
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
}

void TestPlotWidget::theNearestPointIsReadUnderThePointer() {
    m->hover(m->at(8, 64));  // the first mark of all is made then
    QSignalSpy replots(&m->plot, &QCustomPlot::afterReplot);
    m->hover(m->at(8, 64) + QPoint(0, -3));
    const QStringList lines = m->plot.hoverText().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines[0], QStringLiteral("parabola"));
    QVERIFY(lines[1].endsWith(QStringLiteral("ms")));
    // On the step's jump, where it has all values from 1 to 3.
    m->hover(m->at(4, 2, true) + QPoint(4, 0));
    QVERIFY(m->plot.hoverText().startsWith(QStringLiteral("step\ntime t = 4")));
    m->hover(m->at(5, 100));
    QCOMPARE(m->plot.hoverText(), QString());
    m->plot.setCurveVisible(m->step, false);
    m->hover(m->at(4, 2, true));
    QCOMPARE(m->plot.hoverText(), QString());
    QCOMPARE(replots.count(), 0);
}

// Bounded by what it looks at, not by how long the curve is.
void TestPlotWidget::hoveringOverAMillionPointsIsQuick() {
    QVector<QCPGraphData> points;
    for (int i = 0; i < 1'000'000; ++i) points.append({i * 1e-5, 50 + 20 * std::sin(i * 1e-3)});
    m->parabola->data()->set(points, true);
    QBENCHMARK {
        nearestCurvePoint(m->plot, m->at(5, 50), 12);
    }
    QVERIFY(nearestCurvePoint(m->plot, m->at(5, 50), 500));
}

void TestPlotWidget::theKeyboardOpensTheMenu() {
    QTest::keyClick(&m->plot, Qt::Key_F10, Qt::ShiftModifier);
    auto* menu = m->plot.findChild<QMenu*>(QStringLiteral("plotMenu"));
    QVERIFY(menu && menu->isVisible());
    for (const QAction* action : menu->actions())
        if (!action->isSeparator() && !action->menu()) QVERIFY(action->toolTip() != action->text());
    menu->close();
    QTRY_VERIFY(!m->plot.findChild<QMenu*>(QStringLiteral("plotMenu")));
    QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
    QCoreApplication::sendEvent(&m->plot, &key);
    QVERIFY(m->plot.findChild<QMenu*>(QStringLiteral("plotMenu")));
}

void TestPlotWidget::replotsArePaintedTogetherWithTheWindow() {
    class PaintCount : public QObject {
      public:
        int paints = 0;

      protected:
        bool eventFilter(QObject* /*plot*/, QEvent* event) override {
            paints += event->type() == QEvent::Paint;
            return false;
        }
    };
    QTest::qWait(50);  // what is still to be painted of before
    PaintCount count;
    m->plot.installEventFilter(&count);
    for (int i = 0; i < 3; ++i) m->plot.replot();
    QCOMPARE(count.paints, 0);
    QTRY_COMPARE(count.paints, 1);
    QTest::qWait(50);
    QCOMPARE(count.paints, 1);
}

void TestPlotWidget::labelIsElidedBeforeItsUnitWhenTheAxisIsShort() {
    QCPAxis& axis = *m->y(m->upper);
    axis.setLabel(QStringLiteral("stress (tension positive) [MPa]"));
    m->plot.resize(640, 900);
    m->plot.replot();
    QCOMPARE(labelThatFits(axis), axis.label());
    m->plot.resize(640, 380);
    m->plot.replot();
    QCOMPARE(labelThatFits(axis), QStringLiteral("stress (tension\npositive) [MPa]"));
    QString label;
    for (int height = 370; height > 150 && !label.contains(QChar(0x2026)); height -= 10) {
        m->plot.resize(640, height);
        m->plot.replot();
        label = labelThatFits(axis);
    }
    QVERIFY2(label.startsWith(QStringLiteral("str")) && label.endsWith(QStringLiteral("… [MPa]")),
             qPrintable(label));
    m->plot.resize(640, 150);
    m->plot.replot();
    QCOMPARE(labelThatFits(axis), QStringLiteral("[MPa]"));
    QCPAxis& across = *m->x(m->lower);
    m->plot.resize(300, 300);
    m->plot.replot();
    across.setLabel(QStringLiteral("share of the scatter\n(filled: without interactions)"));
    QCOMPARE(labelThatFits(across), across.label());
}

void TestPlotWidget::labelIsElidedOnlyWhileItIsDrawn() {
    QCPAxis& axis = *m->y(m->upper);
    const QString whole = QStringLiteral("stress_of_which_tension_is_positive [MPa]");
    axis.setLabel(whole);
    m->plot.resize(640, 380);
    m->plot.replot();
    QCOMPARE(axis.label(), whole);
    const QImage shown = m->plot.toPixmap().toImage();
    QVERIFY(labelThatFits(axis) != whole);
    axis.setLabel(labelThatFits(axis));
    m->plot.replot();
    QCOMPARE(m->plot.toPixmap().toImage(), shown);
}

void TestPlotWidget::labelHasOneLineAgainWhenTheAxisIsLongEnough() {
    QCPAxis& axis = *m->y(m->upper);
    axis.setLabel(QStringLiteral("stress (tension positive) [MPa]"));
    const auto settled = [&](int height) {
        m->plot.resize(640, height);
        m->plot.replot();
        QCoreApplication::processEvents();
        return m->plot.toPixmap().toImage();
    };
    const int padding = axis.labelPadding();
    const QImage first = settled(900);
    settled(380);
    m->plot.replot();
    QVERIFY(secondLine(axis) > 0);
    QCOMPARE(axis.labelPadding(), padding + secondLine(axis));
    QCOMPARE(settled(900), first);
    QCOMPARE(axis.labelPadding(), padding);
}

void TestPlotWidget::shortAxesHaveFewTicks() {
    const auto count = [&](QCPAxis* axis) {
        m->plot.replot();
        return axis->ticker()->tickCount();
    };
    QCOMPARE(count(m->x(m->upper)), 5);
    m->plot.resize(160, 520);
    QVERIFY(count(m->x(m->upper)) < 5);
    QVERIFY(count(m->x(m->upper)) >= 2);
}

QTEST_MAIN(TestPlotWidget)
#include "tst_plot_widget.moc"

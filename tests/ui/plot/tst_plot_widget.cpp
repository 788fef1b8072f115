// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, keys, cursors, legend and drawings of a plot.
#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/plot/curve_graph.h"
#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;

namespace {

// A plot of two axis rects with linked x axes and a legend each, as pages make them: a parabola above, a step
// and a negative line below; x in ms, y in kN.
struct Scene {
    PlotWidget plot;
    QCPAxisRect* upper;
    QCPAxisRect* lower;
    QCPGraph* parabola;
    QCPGraph* step;
    QCPGraph* line;
    QCPLegend* legends[2];

    Scene() {
        plot.setAutoAddPlottableToLegend(false);
        plot.plotLayout()->clear();
        upper = addRect(0);
        lower = addRect(1);
        for (auto [from, to] : {std::pair(upper, lower), std::pair(lower, upper)})
            QObject::connect(x(from), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), x(to),
                             qOverload<const QCPRange&>(&QCPAxis::setRange));
        parabola = addGraph(0, QStringLiteral("parabola"));
        step = addGraph(1, QStringLiteral("step"));
        line = addGraph(1, QStringLiteral("line, falling"));
        for (int i = 0; i <= 100; ++i) parabola->addData(i * 0.1, i * i * 0.01);
        step->setData({0, 4, 4, 10}, {1, 1, 3, 3}, true);
        line->setData({0, 10}, {0, -2}, true);
        x(lower)->setLabel(QStringLiteral("time t [ms]"));
        plot.followPalette([this](const PlotStyle& style) {
            plot.setBackground(style.background);
            for (QCPAxisRect* rect : {upper, lower}) style.applyTo(*rect);
            for (QCPLegend* legend : legends) style.applyTo(*legend);
            for (int i = 0; i < plot.graphCount(); ++i) plot.graph(i)->setPen(style.linePen(i));
        });
        QObject::connect(&plot, &PlotWidget::fitRequested, &plot, [this] { fit(); });
        fit();
        plot.resize(640, 520);
        plot.show();
        plot.setFocus();
    }

    QCPAxisRect* addRect(int index) {
        auto* rect = new QCPAxisRect(&plot);
        legends[index] = new QCPLegend;
        plot.plotLayout()->addElement(2 * index, 0, legends[index]);
        plot.plotLayout()->setRowStretchFactor(2 * index, 1e-3);
        plot.plotLayout()->addElement(2 * index + 1, 0, rect);
        legends[index]->setLayer(QStringLiteral("legend"));
        for (QCPAxis* axis : rect->axes()) axis->setLayer(QStringLiteral("axes"));
        return rect;
    }
    QCPGraph* addGraph(int rect, const QString& name) {
        QCPAxisRect* on = rect == 0 ? upper : lower;
        QCPGraph* graph = addCurve(x(on), y(on));
        graph->setName(name);
        graph->addToLegend(legends[rect]);
        CurveMeaning meaning;
        meaning.xUnit = QStringLiteral("ms");
        meaning.yUnit = QStringLiteral("kN");
        meaning.integralUnit = QStringLiteral("N s");
        plot.setMeaning(graph, meaning);
        return graph;
    }
    static QCPAxis* x(QCPAxisRect* rect) { return rect->axis(QCPAxis::atBottom); }
    static QCPAxis* y(QCPAxisRect* rect) { return rect->axis(QCPAxis::atLeft); }
    void fit() {
        x(upper)->setRange(0, 10);
        y(upper)->setRange(-10, 110);
        y(lower)->setRange(-3, 4);
    }
    // A pixel of the upper (or lower) plot.
    QPoint at(double time, double value, bool inLower = false) const {
        QCPAxisRect* rect = inLower ? lower : upper;
        return {qRound(x(rect)->coordToPixel(time)), qRound(y(rect)->coordToPixel(value))};
    }
    void wheel(QPoint point, int notches) {
        QWheelEvent event(point, plot.mapToGlobal(point), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&plot, &event);
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint from, QPoint to) {
        QTest::mousePress(&plot, button, keys, from);
        for (const QPoint point : {(2 * from + to) / 3, to}) {
            QMouseEvent move(QEvent::MouseMove, point, plot.mapToGlobal(point), Qt::NoButton, button, keys);
            QCoreApplication::sendEvent(&plot, &move);
        }
        QTest::mouseRelease(&plot, button, keys, to);
    }
    void hover(QPoint point) {
        QMouseEvent move(QEvent::MouseMove, point, plot.mapToGlobal(point), Qt::NoButton, Qt::NoButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&plot, &move);
    }
    void clickLegend(int legend, int entry) {
        QTest::mouseClick(&plot, Qt::LeftButton, {}, legends[legend]->item(entry)->rect().center());
    }
    QAction* action(const QString& text) {
        menu = std::make_unique<PlotMenu>(plot, upper->center());
        for (QAction* action : menu->findChildren<QAction*>())
            if (action->text().remove(QLatin1Char('&')).startsWith(text)) return action;
        return nullptr;
    }
    std::unique_ptr<QMenu> menu;
};

bool near(double value, double wanted, double tolerance) {
    return std::abs(value - wanted) <= tolerance;
}

}  // namespace

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
    void cursorsArePlacedByKeysAndReadTheFirstCurve();
    void cursorsAreDraggedWithoutDrawingTheCurvesAgain();
    void aClickOnACurveHasItRead();
    void exactIntegralsComeFromTheMeaning();
    void theTableSaysWhatItReads();
    void newDataAreReadAtTheSameCursors();
    void cursorsComeAndGoWithoutMovingThePlot();
    void withoutCursorsTheTableReadsWhatIsInView();
    void aCursorTakesTheCurveUnderThePointer();
    void theTableIsCopiedWithAllDigits();
    void theTableCanBeHidden();
    void linesAreAsThickWhereManyPointsMeet();
    void dashesStayDashesOnLongTables();
    void theTimeCursorIsDraggedAndTold();
    void theNearestPointIsReadUnderThePointer();
    void hoveringOverAMillionPointsIsQuick();
    void crowdedPointsLeaveNoHoleInTheirCurve();
    void drawingsAreWhiteAndTheSameEveryTime();
    void drawingsShowThePresentView();
    void curvesThatLeaveTheAxesAreCutInSvg();
    void theWidgetLooksTheSameAfterADrawing();
    void dataAreCopiedWithTheirUnits();
    void theKeyboardOpensTheMenu();

  private:
    std::unique_ptr<Scene> m;
};

void TestPlotWidget::init() {
    QLocale::setDefault(QLocale::c());
    QCursor::setPos(-100, -100);
    m = std::make_unique<Scene>();
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

void TestPlotWidget::cursorsArePlacedByKeysAndReadTheFirstCurve() {
    QVERIFY(!m->plot.reader().reading());
    QTest::keyClick(&m->plot, Qt::Key_A);
    QVERIFY(near(*m->plot.reader().position(PlotCursor::a), 5, 0.02));
    m->plot.reader().place(PlotCursor::a, 2);
    QTest::keyClick(&m->plot, Qt::Key_B);
    m->plot.reader().place(PlotCursor::b, 8);
    const CursorReading reading = *m->plot.reader().reading();
    QCOMPARE(reading.yA, 4.0);
    QCOMPARE(reading.yB, 64.0);
    QCOMPARE(reading.slope, 10.0);
    // The chords of x² with steps of h overestimate by (b − a) h²/6.
    QVERIFY(near(reading.integral, (512 - 8) / 3.0 + 6 * 0.01 / 6, 1e-9));
    QVERIFY(near(reading.mean, reading.integral / 6, 1e-12));
    QTest::keyClick(&m->plot, Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(*m->plot.reader().position(PlotCursor::b) > 8);
}

void TestPlotWidget::cursorsAreDraggedWithoutDrawingTheCurvesAgain() {
    m->plot.reader().place(PlotCursor::a, 2);
    m->plot.reader().place(PlotCursor::b, 8);
    m->hover(m->at(5, 25));  // the first mark of all is made then
    // With numbers as long as they get, so that the strip has grown already.
    m->plot.reader().place(PlotCursor::a, 2.34567);
    m->plot.reader().place(PlotCursor::b, 7.98765);
    QTest::qWait(20);
    QSignalSpy replots(&m->plot, &QCustomPlot::afterReplot);
    QSignalSpy read(&m->plot.reader(), &CurveReader::changed);
    // Grabbed in the lower plot, three pixels beside the line.
    m->drag(Qt::LeftButton, {}, m->at(7.98765, 3, true) + QPoint(3, 0), m->at(6, 3, true));
    m->hover(m->at(3, 9));
    QVERIFY(!m->plot.hoverText().isEmpty());
    QCoreApplication::processEvents();
    QVERIFY(near(*m->plot.reader().position(PlotCursor::b), 6, 0.02));
    QCOMPARE(m->x(m->upper)->range(), QCPRange(0, 10));
    QCOMPARE(replots.count(), 0);
    QVERIFY(read.count() >= 1);
}

void TestPlotWidget::aClickOnACurveHasItRead() {
    m->plot.reader().place(PlotCursor::a, 1);
    m->plot.reader().place(PlotCursor::b, 5);
    m->plot.replot();
    QCOMPARE(m->plot.reader().graph(), m->parabola);
    QTest::mouseClick(&m->plot, Qt::LeftButton, {}, m->at(7, 3, true));
    QCOMPARE(m->plot.reader().graph(), m->step);
    QCOMPARE(m->plot.reader().reading()->integral, 3.0 + 3.0);
    auto* choice = m->plot.findChild<QComboBox*>(QStringLiteral("readCurve"));
    QCOMPARE(choice->currentText(), QStringLiteral("step"));
    m->plot.setCurveVisible(m->step, false);
    m->plot.replot();
    QCOMPARE(m->plot.reader().graph(), m->parabola);
    QCOMPARE(choice->count(), 2);
}

void TestPlotWidget::exactIntegralsComeFromTheMeaning() {
    CurveMeaning meaning;
    meaning.integral = [](double a, double b) { return (b * b * b - a * a * a) / 3; };
    meaning.integralFactor = 1e-3;
    m->plot.setMeaning(m->parabola, meaning);
    m->plot.reader().place(PlotCursor::a, 0);
    m->plot.reader().place(PlotCursor::b, 9);
    QCOMPARE(m->plot.reader().reading()->integral, 0.243);
}

void TestPlotWidget::theTableSaysWhatItReads() {
    m->y(m->lower)->setLabel(QStringLiteral("F [kN]"));
    m->plot.reader().setGraph(m->step);
    m->plot.reader().place(PlotCursor::a, 1);
    m->plot.reader().place(PlotCursor::b, 5.5);
    const QString text = m->plot.reader().text().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    QCOMPARE(text, QStringLiteral("time t at A 1 ms · F at A 1 kN · time t at B 5.5 ms · F at B 3 kN · "
                                  "time t from A to B 4.5 ms · F from A to B 2 kN · mean 1.66667 kN · "
                                  "slope 0.444444 kN/ms · integral 7.5 N s"));
    auto* bar = m->plot.findChild<QWidget*>(QStringLiteral("cursorReadout"));
    QVERIFY(bar->accessibleName().contains(m->plot.reader().text()));
    QVERIFY(bar->isVisible());
    // The table covers nothing of the plot, and nothing in it covers anything else.
    QVERIFY(m->plot.viewport().bottom() < bar->mapTo(&m->plot, QPoint()).y());
    const QList<QWidget*> cells = bar->findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    for (const QWidget* cell : cells) {
        QVERIFY(bar->rect().contains(cell->geometry()));
        for (const QWidget* other : cells)
            QVERIFY(cell == other || !cell->geometry().intersects(other->geometry()));
    }
}

void TestPlotWidget::newDataAreReadAtTheSameCursors() {
    m->plot.reader().place(PlotCursor::a, 0);
    m->plot.reader().place(PlotCursor::b, 10);
    m->parabola->setData({0, 10}, {5, 5}, true);
    m->plot.replot();
    QVERIFY(
        m->plot.reader().text().contains(QStringLiteral("mean") + QChar(QChar::Nbsp) + QStringLiteral("5")));
}

void TestPlotWidget::cursorsComeAndGoWithoutMovingThePlot() {
    m->plot.replot();
    const QRect place = m->plot.viewport();
    QVERIFY(place.height() < m->plot.height());
    for (const double width : {0.5, 1.23456789e-5}) {
        m->plot.reader().place(PlotCursor::a, 1);
        QCOMPARE(m->plot.viewport(), place);
        m->plot.reader().place(PlotCursor::b, 1 + width);
        QCOMPARE(m->plot.viewport(), place);
    }
    m->action(QStringLiteral("Remove cursors"))->trigger();
    QVERIFY(!m->plot.reader().position(PlotCursor::a));
    QCOMPARE(m->plot.viewport(), place);
}

void TestPlotWidget::withoutCursorsTheTableReadsWhatIsInView() {
    m->plot.reader().setGraph(m->step);
    m->x(m->lower)->setRange(2, 12);
    m->plot.replot();
    const QString text = m->plot.reader().text().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    QVERIFY2(text.contains(QStringLiteral("least y in view 1 kN")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("largest y in view 3 kN · time t of the largest 4 ms")),
             qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("mean in view 2.5 kN")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("integral in view 20 N s")), qPrintable(text));
}

void TestPlotWidget::aCursorTakesTheCurveUnderThePointer() {
    const auto press = [this](PlotCursor cursor, QPoint at) { m->plot.mover().placeAt(cursor, at); };
    press(PlotCursor::a, m->at(8, -1.6, true));
    QCOMPARE(m->plot.reader().graph(), m->line);
    // The other cursor reads the same curve, unless it is put to other axes.
    press(PlotCursor::b, m->at(8, 3, true));
    QCOMPARE(m->plot.reader().graph(), m->line);
    press(PlotCursor::b, m->at(8, 64));
    QCOMPARE(m->plot.reader().graph(), m->parabola);
    m->plot.reader().clear();
    // Far from any curve it is one of those axes.
    press(PlotCursor::a, m->at(1, -2.9, true));
    QCOMPARE(m->plot.reader().graph(), m->step);
}

void TestPlotWidget::theTableIsCopiedWithAllDigits() {
    m->plot.setLocale(QLocale(QLocale::German));
    m->plot.reader().setGraph(m->step);
    m->plot.reader().place(PlotCursor::a, 1.123456789);
    m->plot.reader().place(PlotCursor::b, 5.5);
    m->plot.findChild<QAbstractButton*>(QStringLiteral("copyReadout"))->click();
    const QString copied = QGuiApplication::clipboard()->text();
    QVERIFY2(copied.startsWith(QStringLiteral("step\ntime t at A\t1.123456789\tms\n")), qPrintable(copied));
    QCOMPARE(copied.count(QLatin1Char('\n')), 10);
    QGuiApplication::clipboard()->clear();
    m->action(QStringLiteral("Copy the table"))->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(), copied);
}

void TestPlotWidget::theTableCanBeHidden() {
    m->plot.reader().setTableShown(false);
    QCOMPARE(m->plot.viewport(), m->plot.rect());
    QCOMPARE(m->plot.reader().text(), QString());
    m->plot.reader().place(PlotCursor::a, 1);
    QVERIFY(m->plot.viewport().height() < m->plot.height());
}

// Begins with the mechanism: the plot draws a solid line of many points piece by piece, each piece over the
// end of the one before.
void TestPlotWidget::linesAreAsThickWhereManyPointsMeet() {
    QVERIFY(m->plot.plottingHints().testFlag(QCP::phFastPolylines));
    for (QCPGraph* graph : {m->parabola, m->step, m->line}) graph->setVisible(false);
    CurveGraph* few = addCurve(m->x(m->upper), m->y(m->upper));
    CurveGraph* many = addCurve(m->x(m->lower), m->y(m->lower));
    for (CurveGraph* each : {few, many}) each->setPen(QPen(Qt::black, 1.6));
    m->y(m->upper)->setRange(-1, 1);
    m->y(m->lower)->setRange(-1, 1);
    few->setData({0, 10}, {0.3, 0.3}, true);
    for (int i = 0; i <= 20000; ++i) many->addData(i * 5e-4, 0.3);
    many->setAdaptiveSampling(false);
    for (QCPAxisRect* rect : {m->upper, m->lower})
        for (QCPAxis* axis : rect->axes()) axis->grid()->setVisible(false);
    m->plot.replot();
    const QImage image = m->plot.toPixmap().toImage();
    const auto darkness = [&](QCPAxisRect* rect, double time) {
        const int column = qRound(m->x(rect)->coordToPixel(time));
        int sum = 0;
        for (int row = rect->top() + 6; row < rect->bottom() - 6; ++row)
            sum += 255 - qGray(image.pixel(column, row));
        return sum;
    };
    for (const double time : {1.7, 5.1, 8.9}) {
        QVERIFY(darkness(m->upper, time) > 255);
        // The two lie differently between the rows of pixels: a tenth of a pixel.
        QVERIFY(std::abs(darkness(m->upper, time) - darkness(m->lower, time)) <= 26);
    }
}

// Counted along the line: as many gaps from two thousand points, or two hundred thousand, as from two.
void TestPlotWidget::dashesStayDashesOnLongTables() {
    for (QCPGraph* graph : {m->parabola, m->step, m->line}) graph->setVisible(false);
    CurveGraph* curve = addCurve(m->x(m->upper), m->y(m->upper));
    QPen pen(Qt::black, 1.6, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({6, 3});
    curve->setPen(pen);
    for (QCPAxis* axis : m->upper->axes()) axis->grid()->setVisible(false);
    m->y(m->upper)->setRange(-1, 1);
    const auto gaps = [&](int points) {
        QVector<QCPGraphData> data;
        for (int i = 0; i <= points; ++i) data.append({10.0 * i / points, 0.3});
        curve->data()->set(data, true);
        m->plot.replot();
        const QImage image = m->plot.toPixmap().toImage();
        const int row = qRound(m->y(m->upper)->coordToPixel(0.3));
        int count = 0;
        bool wasDark = true;
        for (int column = m->upper->left() + 8; column < m->upper->right() - 8; ++column) {
            const int least = std::min(qGray(image.pixel(column, row)), qGray(image.pixel(column, row - 1)));
            const bool isDark = least < 160;
            if (wasDark && !isDark) ++count;
            wasDark = isDark;
        }
        return count;
    };
    const int few = gaps(1);
    QVERIFY2(few > 20, qPrintable(QString::number(few)));
    for (const int points : {2000, 200'000}) QVERIFY(std::abs(gaps(points) - few) <= 1);
}

void TestPlotWidget::theTimeCursorIsDraggedAndTold() {
    QVERIFY(!m->action(QStringLiteral("Time cursor")));
    QSignalSpy told(&m->plot, &PlotWidget::timeCursorDragged);
    QVERIFY(m->action(QStringLiteral("Time cursor")));
    m->plot.reader().place(PlotCursor::time, 4);
    QCOMPARE(told.count(), 0);
    m->drag(Qt::LeftButton, {}, m->at(4, 80), m->at(7, 80));
    QVERIFY(told.count() >= 1);
    QVERIFY(near(told.last().first().toDouble(), 7, 0.02));
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

void TestPlotWidget::crowdedPointsLeaveNoHoleInTheirCurve() {
    // Fewer points than pixels are drawn as they are: here 600 of them within four pixels.
    m->parabola->setData({0}, {50});
    const double pixel = m->x(m->upper)->range().size() / m->upper->width();
    for (int i = 0; i <= 600; ++i) m->parabola->addData(5 + 4 * pixel * i / 600, 50);
    m->parabola->addData(10, 50);
    m->plot.replot();
    const QImage image = m->plot.grab().toImage();
    const int middle = static_cast<int>(m->x(m->upper)->coordToPixel(5));
    const int height = static_cast<int>(m->y(m->upper)->coordToPixel(50));
    for (int column = middle - 2; column <= middle + 6; ++column) {
        int darkest = 255;
        for (int row = height - 2; row <= height + 2; ++row)
            darkest = std::min(darkest, qRed(image.pixel(column, row)));
        QVERIFY2(darkest < 128, qPrintable(QString::number(column - middle)));
    }
}

void TestPlotWidget::drawingsAreWhiteAndTheSameEveryTime() {
    QPalette dark = m->plot.palette();
    dark.setColor(QPalette::Base, QColor(30, 30, 32));
    dark.setColor(QPalette::Text, QColor(225, 225, 225));
    const QByteArray light = m->plot.drawing(QStringLiteral("png"), {120, 90}, 300);
    const QByteArray svg = m->plot.drawing(QStringLiteral("svg"), {120, 90});
    m->plot.setPalette(dark);
    m->plot.setLocale(QLocale(QLocale::German));
    m->hover(m->at(8, 64));
    QCOMPARE(m->plot.drawing(QStringLiteral("png"), {120, 90}, 300), light);
    QCOMPARE(m->plot.drawing(QStringLiteral("svg"), {120, 90}), svg);
    const QImage image = QImage::fromData(light);
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
    QVERIFY(near(image.width(), 120 / 25.4 * 300, 2));
    QCOMPARE(image.dotsPerMeterX(), 11811);
    QVERIFY(m->plot.drawing(QStringLiteral("pdf"), {120, 90}).startsWith("%PDF-"));
    QCOMPARE(m->plot.locale().language(), QLocale::German);
}

void TestPlotWidget::drawingsShowThePresentView() {
    const QByteArray whole = m->plot.drawing(QStringLiteral("svg"), {120, 90});
    m->plot.setCurveVisible(m->step, false);
    const QByteArray hidden = m->plot.drawing(QStringLiteral("svg"), {120, 90});
    QVERIFY(hidden != whole);
    QVERIFY(whole.contains(">step<"));
    QVERIFY(!hidden.contains(">step<"));
    m->plot.reader().place(PlotCursor::a, 4);
    QVERIFY(m->plot.drawing(QStringLiteral("svg"), {120, 90}) != hidden);
}

void TestPlotWidget::curvesThatLeaveTheAxesAreCutInSvg() {
    m->x(m->upper)->setRange(4, 6);
    m->y(m->upper)->setRange(20, 30);
    const QString svg = QString::fromUtf8(m->plot.drawing(QStringLiteral("svg"), {120, 90}));
    const double height = 90 / 25.4 * 96;
    const double width = 120 / 25.4 * 96;
    static const QRegularExpression lines(QStringLiteral("<polyline[^>]*points=\"([^\"]*)\""));
    int points = 0;
    for (auto match = lines.globalMatch(svg); match.hasNext();)
        for (const QString& point : match.next().captured(1).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const QStringList xy = point.split(QLatin1Char(','));
            QVERIFY(xy[0].toDouble() >= -1 && xy[0].toDouble() <= width + 1);
            QVERIFY(xy[1].toDouble() >= -1 && xy[1].toDouble() <= height + 1);
            ++points;
        }
    QVERIFY(points > 5);
    QCOMPARE(m->parabola->data()->size(), 101);
}

void TestPlotWidget::theWidgetLooksTheSameAfterADrawing() {
    m->wheel(m->upper->center(), 2);
    m->plot.replot();
    const QImage before = m->plot.grab().toImage();
    m->plot.drawing(QStringLiteral("svg"), {300, 60});
    QCOMPARE(m->plot.grab().toImage(), before);
}

void TestPlotWidget::dataAreCopiedWithTheirUnits() {
    m->plot.setLocale(QLocale(QLocale::German));
    m->plot.setCurveVisible(m->parabola, false);
    const QByteArray csv = m->plot.csv();
    QCOMPARE(csv, QByteArray("time t [ms],step [kN],time t [ms],\"line, falling [kN]\"\n"
                             "0,1,0,0\n4,1,10,-2\n4,3,,\n10,3,,\n"));
    m->action(QStringLiteral("Copy data"))->trigger();
    const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
    QCOMPARE(copied->data(QStringLiteral("text/csv")), csv);
    QVERIFY(copied->text().startsWith(QStringLiteral("time t [ms]\tstep [kN]\t")));
    m->action(QStringLiteral("Copy picture"))->trigger();
    QVERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
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

QTEST_MAIN(TestPlotWidget)
#include "tst_plot_widget.moc"

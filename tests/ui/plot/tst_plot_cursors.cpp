// SPDX-License-Identifier: GPL-3.0-or-later
// The cursors of a plot, and the table below it that reads at them.
#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/plot_scene.h"
#include "ui/plot/cursor_bar.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

class TestPlotCursors : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cursorsArePlacedByKeysAndReadTheFirstCurve();
    void cursorsAreDraggedWithoutDrawingTheCurvesAgain();
    void aClickOnACurveHasItRead();
    void aCurveThatIsGoneIsNotRead();
    void aLongNameOfACurveIsWidenedWrappedOrElided();
    void exactIntegralsComeFromTheMeaning();
    void theTableSaysWhatItReads();
    void newDataAreReadAtTheSameCursors();
    void cursorsComeAndGoWithoutMovingThePlot();
    void withoutCursorsTheTableReadsWhatIsInView();
    void aCursorTakesTheCurveUnderThePointer();
    void theTableIsCopiedWithAllDigits();
    void theTableCanBeHidden();
    void theTimeCursorIsDraggedAndTold();

  private:
    std::unique_ptr<PlotScene> m;
};

void TestPlotCursors::init() {
    QLocale::setDefault(QLocale::c());
    QCursor::setPos(-100, -100);
    m = std::make_unique<PlotScene>();
    QVERIFY(QTest::qWaitForWindowExposed(&m->plot));
    m->plot.replot();
}

void TestPlotCursors::cursorsArePlacedByKeysAndReadTheFirstCurve() {
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

void TestPlotCursors::cursorsAreDraggedWithoutDrawingTheCurvesAgain() {
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

void TestPlotCursors::aClickOnACurveHasItRead() {
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

// Between two drawings, as where an answer arrives while the list is open.
void TestPlotCursors::aCurveThatIsGoneIsNotRead() {
    m->plot.reader().place(PlotCursor::a, 2);
    auto* bar = m->plot.findChild<CursorBar*>();
    auto* choice = bar->findChild<QComboBox*>(QStringLiteral("readCurve"));
    QVERIFY(choice->count() > 1);
    QSignalSpy chosen(bar, &CursorBar::curveChosen);
    QTest::keyClick(choice, Qt::Key_Down);
    QCOMPARE(chosen.size(), 1);
    for (QCPLegend* legend : m->legends) legend->clearItems();
    m->plot.clearGraphs();
    QTest::keyClick(choice, Qt::Key_Up);
    QCOMPARE(chosen.size(), 1);
    m->plot.replot();
    QCOMPARE(choice->count(), 0);
}

void TestPlotCursors::aLongNameOfACurveIsWidenedWrappedOrElided() {
    const auto pictureOf = [this](const QString& name, int width) {
        m->step->setName(name);
        m->plot.resize(width, m->plot.height());
        m->plot.reader().setGraph(m->step);
        m->plot.replot();
        QCoreApplication::processEvents();
        return m->plot.findChild<QComboBox*>(QStringLiteral("readCurve"))->grab().toImage();
    };
    auto* choice = m->plot.findChild<QComboBox*>(QStringLiteral("readCurve"));
    const QString name = QStringLiteral("largest compression of all sections");
    const int oneLine = choice->sizeHint().height();
    int width = 900;
    while (width > 400 && choice->height() == oneLine) pictureOf(name, width -= 20);
    QVERIFY(choice->fontMetrics().horizontalAdvance(name) > choice->width() - choice->height());
    QCOMPARE(choice->height(), oneLine + choice->fontMetrics().lineSpacing());
    const QString veryLong = QStringLiteral("largest compression of all sections with all residual waves");
    const QImage elided = pictureOf(veryLong, 400);
    QCOMPARE(choice->height(), oneLine);
    const int narrow = choice->width();
    QCOMPARE(choice->toolTip(), veryLong);
    QVERIFY(choice->fontMetrics().horizontalAdvance(veryLong) > narrow);
    // As a combo box draws it: cut off, without the dots.
    QComboBox usual;
    usual.addItem(veryLong);
    usual.setFont(choice->font());
    usual.resize(choice->size());
    QVERIFY(usual.grab().toImage() != elided);
    pictureOf(name, 1600);
    QVERIFY(choice->width() > narrow);
}

void TestPlotCursors::exactIntegralsComeFromTheMeaning() {
    CurveMeaning meaning;
    meaning.integral = [](double a, double b) { return (b * b * b - a * a * a) / 3; };
    meaning.integralFactor = 1e-3;
    m->plot.setMeaning(m->parabola, meaning);
    m->plot.reader().place(PlotCursor::a, 0);
    m->plot.reader().place(PlotCursor::b, 9);
    QCOMPARE(m->plot.reader().reading()->integral, 0.243);
}

void TestPlotCursors::theTableSaysWhatItReads() {
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

void TestPlotCursors::newDataAreReadAtTheSameCursors() {
    m->plot.reader().place(PlotCursor::a, 0);
    m->plot.reader().place(PlotCursor::b, 10);
    m->parabola->setData({0, 10}, {5, 5}, true);
    m->plot.replot();
    QVERIFY(
        m->plot.reader().text().contains(QStringLiteral("mean") + QChar(QChar::Nbsp) + QStringLiteral("5")));
}

void TestPlotCursors::cursorsComeAndGoWithoutMovingThePlot() {
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

void TestPlotCursors::withoutCursorsTheTableReadsWhatIsInView() {
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

void TestPlotCursors::aCursorTakesTheCurveUnderThePointer() {
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

void TestPlotCursors::theTableIsCopiedWithAllDigits() {
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

void TestPlotCursors::theTableCanBeHidden() {
    m->plot.reader().setTableShown(false);
    QCOMPARE(m->plot.viewport(), m->plot.rect());
    QCOMPARE(m->plot.reader().text(), QString());
    m->plot.reader().place(PlotCursor::a, 1);
    QVERIFY(m->plot.viewport().height() < m->plot.height());
}

void TestPlotCursors::theTimeCursorIsDraggedAndTold() {
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

QTEST_MAIN(TestPlotCursors)
#include "tst_plot_cursors.moc"

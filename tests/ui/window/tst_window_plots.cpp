// SPDX-License-Identifier: GPL-3.0-or-later
// Plots in the window: their menu, cursors, ghosts and keys.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>
#include <QWheelEvent>

#include "core/yaml/preset_file.h"
#include "tests/support/window_fixture.h"
#include "tests/support/window_parts.h"
#include "ui/form/scenario_panel.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/settings.h"
#include "ui/window/page_tabs.h"
#include "ui/window/view_menu.h"

using namespace drillwave;
using namespace drillwave::test;

class TestWindowPlots : public QObject, private WindowFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() { m_window.reset(); }
    void theViewMenuHasWhatThePlotOffers();
    void theTimeCursorMovesNoPlot();
    void theSectionOfTheWavesCanBeMoved();
    void aPresetLeavesAGhostUntilTheNextChange();
    void keysAimAtThePlotBelowThePointer();
    void theWheelScrollsThePageAndChangesNoFieldWithoutFocus();
    void theReasonOfAnUnsolvedCaseStaysInThePlot();
};

void TestWindowPlots::theViewMenuHasWhatThePlotOffers() {
    auto& menu = part<PlotViewMenu>(window());
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    emit menu.aboutToShow();
    const auto action = [&menu](const QString& text) {
        for (QAction* each : menu.actions())
            if (each->text().remove(QLatin1Char('&')).startsWith(text)) return each;
        return static_cast<QAction*>(nullptr);
    };
    for (const QString& text :
         {QStringLiteral("Fit"), QStringLiteral("Zoom back"), QStringLiteral("Logarithmic vertical"),
          QStringLiteral("Curves shown"), QStringLiteral("Cursor A")})
        QVERIFY2(action(text), qPrintable(text));
    action(QStringLiteral("Cursor A"))->trigger();
    QVERIFY(plot.reader().position(PlotCursor::a));
    plot.view().zoom(0.5);
    const QCPRange zoomed = plot.axisRect(0)->axis(QCPAxis::atLeft)->range();
    emit menu.aboutToShow();
    action(QStringLiteral("Zoom back"))->trigger();
    QVERIFY(plot.axisRect(0)->axis(QCPAxis::atLeft)->range() != zoomed);
    // The table below the plots goes and comes, and is remembered.
    plot.reader().clear();
    QVERIFY(plot.viewport().height() < plot.height());
    menu.tableAction()->trigger();
    QCOMPARE(plot.viewport().height(), plot.height());
    QVERIFY(!Settings().value(tableShownKey, true).toBool());
    menu.tableAction()->trigger();
    QVERIFY(plot.viewport().height() < plot.height());
}

void TestWindowPlots::theTimeCursorMovesNoPlot() {
    settle();
    const PlotWidget& plot = *part<BlowPage>(window()).plot();
    const QRect place(plot.mapTo(&window(), QPoint()), plot.size());
    auto& observation = part<Observation>(window());
    for (const double time : {0.5, 12.3456789, 1e-9}) {
        observation.setTime(time);
        QCoreApplication::processEvents();
        QCOMPARE(QRect(plot.mapTo(&window(), QPoint()), plot.size()), place);
    }
}

void TestWindowPlots::theSectionOfTheWavesCanBeMoved() {
    part<BlowPage>(window()).findChild<QDoubleSpinBox*>(QStringLiteral("section"))->setValue(0.25);
    QTRY_COMPARE(window().shown()->page<BlowCurves>()->section, 0.25);
}

void TestWindowPlots::aPresetLeavesAGhostUntilTheNextChange() {
    const int graphs = part<BlowPage>(window()).plot()->graphCount();
    const auto hard = std::ranges::find(builtInPresets(), std::string("hard rock"), &Preset::name);
    QCOMPARE(window().document().applyPreset(*hard), QString());
    settle();
    QVERIFY(part<BlowPage>(window()).plot()->graphCount() > graphs);
    window().document().assign(*findParameter("rod.length"), 4, 1);
    settle();
    QCOMPARE(part<BlowPage>(window()).plot()->graphCount(), graphs);
}

void TestWindowPlots::keysAimAtThePlotBelowThePointer() {
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    const QPointF middle = plot.axisRect(0)->center();
    QEnterEvent enter(middle, middle, plot.mapToGlobal(middle));
    QCoreApplication::sendEvent(&plot, &enter);
    auto* button = part<BlowPage>(window()).findChild<QPushButton*>();
    button->setFocus();
    QTest::keyClick(button, Qt::Key_A);
    QVERIFY(plot.reader().position(PlotCursor::a));
    // Text is typed where the focus is.
    auto* title = part<ScenarioPanel>(window()).findChild<QLineEdit*>(QStringLiteral("title"));
    title->setFocus();
    title->clear();
    QTest::keyClicks(title, QStringLiteral("b"));
    QCOMPARE(title->text(), QStringLiteral("b"));
    QVERIFY(!plot.reader().position(PlotCursor::b));
    // The wheel with Ctrl takes the focus, so that Backspace brings the view back.
    QWheelEvent wheel(middle, plot.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::ControlModifier,
                      Qt::NoScrollPhase, false);
    const QCPRange before = plot.xAxis->range();
    QCoreApplication::sendEvent(&plot, &wheel);
    QVERIFY(plot.hasFocus());
    QTest::keyClick(window().focusWidget(), Qt::Key_Backspace);
    QCOMPARE(plot.xAxis->range().upper, before.upper);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&plot, &leave);
}

void TestWindowPlots::theWheelScrollsThePageAndChangesNoFieldWithoutFocus() {
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    auto& scroll = part<PageScroll>(window());
    window().resize(1000, 500);
    QCoreApplication::processEvents();
    QVERIFY(scroll.verticalScrollBar()->maximum() > 0);
    const auto turn = [&](QWidget& widget, Qt::KeyboardModifiers keys) {
        const QPointF middle = QRectF(&widget == &plot ? plot.axisRect()->rect() : widget.rect()).center();
        QWheelEvent wheel(middle, widget.mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, keys,
                          Qt::NoScrollPhase, false);
        // As from the hand: only such events go on to the parent.
        QSpontaneKeyEvent::setSpontaneous(&wheel);
        qApp->notify(&widget, &wheel);
    };
    const QCPRange range = plot.xAxis->range();
    turn(plot, Qt::NoModifier);
    QCOMPARE(plot.xAxis->range(), range);
    const int scrolled = scroll.verticalScrollBar()->value();
    QVERIFY(scrolled > 0);
    turn(plot, Qt::ControlModifier);
    QVERIFY(plot.xAxis->range() != range);
    QCOMPARE(scroll.verticalScrollBar()->value(), scrolled);
    for (auto* field : window().findChildren<QComboBox*>()) {
        if (!field->isVisible() || field->hasFocus()) continue;
        const int before = field->currentIndex();
        turn(*field, Qt::NoModifier);
        QVERIFY2(field->currentIndex() == before, qPrintable(field->objectName()));
        QVERIFY(!field->hasFocus());
    }
}

void TestWindowPlots::theReasonOfAnUnsolvedCaseStaysInThePlot() {
    makeWindow([](const SolveRequest& request) {
        return failedBlow(request,
                          QString("The histories have more than 4 million polynomial pieces. ").repeated(5));
    });
    PlotWidget& plot = *part<BlowPage>(window()).plot();
    plot.replot();
    const QCPItemText* message = nullptr;
    for (int i = 0; i < plot.itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(plot.item(i)); text && text->text().contains("million"))
            message = text;
    QVERIFY(message && message->visible());
    QVERIFY(message->brush().style() != Qt::NoBrush);
    QVERIFY(message->left->pixelPosition().x() >= 0);
    QVERIFY(message->right->pixelPosition().x() <= plot.width());
    QVERIFY(message->top->pixelPosition().y() >= 0);
}

QTEST_MAIN(TestWindowPlots)
#include "tst_window_plots.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The point of a plot that keys move, and what Enter does there.
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "ui/plot/curve_graph.h"
#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;

namespace {

// A line that rises from 0 to 10 and a level at 20, over 0 to 10, in a view that goes beyond both.
struct Scene {
    PlotWidget plot;
    QCPGraph* rising;
    QCPGraph* level;
    QVector<QPointF> marks{{2, 2}, {7, 7}};
    std::optional<QPointF> start = QPointF(5, 6);
    QVector<QPair<QPointF, Qt::KeyboardModifiers>> clicks;
    QVector<QPointF> taken;

    explicit Scene(KeyPlaces::On on = KeyPlaces::On::curves) {
        plot.legend->setVisible(true);
        rising = addGraph(QStringLiteral("rising"));
        level = addGraph(QStringLiteral("level"));
        rising->setData({0, 4, 10}, {0, 4, 10}, true);
        level->setData({0, 10}, {20, 20}, true);
        plot.xAxis->setRange(-1, 11);
        plot.yAxis->setRange(-5, 30);
        KeyPlaces places;
        places.rect = plot.axisRect();
        places.on = on;
        places.start = [this] { return start; };
        places.marks = [this] { return marks; };
        plot.keyPoint().offer(places);
        plot.followPalette([this](const PlotStyle& style) { plot.setBackground(style.background); });
        QObject::connect(&plot, &PlotWidget::placeTaken, &plot,
                         [this](const QCPAxisRect*, QPointF at) { taken.append(at); });
        QObject::connect(&plot, &PlotWidget::clicked, &plot,
                         [this](const QCPAxisRect*, QPointF at, Qt::KeyboardModifiers keys) {
                             clicks.append({at, keys});
                         });
        plot.resize(640, 520);
        plot.show();
        plot.replot();
    }
    QCPGraph* addGraph(const QString& name) {
        QCPGraph* graph = addCurve(plot.xAxis, plot.yAxis);
        graph->setName(name);
        graph->addToLegend();
        plot.setMeaning(graph, CurveMeaning());
        return graph;
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&plot, key, modifiers); }
    QPointF place() { return plot.keyPoint().place().value_or(QPointF(NAN, NAN)); }
    QString text() { return plot.keyPoint().text(); }
    double pixelWidth() const { return plot.xAxis->pixelToCoord(1) - plot.xAxis->pixelToCoord(0); }
};

constexpr double rounding = 1e-9;  // of pixels and back

bool isNear(QPointF a, QPointF b) {
    return std::abs(a.x() - b.x()) < rounding && std::abs(a.y() - b.y()) < rounding;
}

}  // namespace

class TestKeyPoint : public QObject {
    Q_OBJECT

  private slots:
    void aClickTakesOnlyWhatIsWithinTenPixels();
    void init();
    void enterPutsItOnTheCurveNextToWhereThePageBegins();
    void withoutItKeysDoWhatTheyDid();
    void arrowsGoAlongTheCurveAndFromOneToTheOther();
    void homeAndEndAreTheEndsInView();
    void nGoesFromMarkToMark();
    void enterIsAClickAndShiftIsOneWithShift();
    void escapeAndTheMouseTakeItAway();
    void itStaysOnItsCurveWhenThatChanges();
    void aHiddenCurveLeavesItToTheNext();
    void cursorsArePlacedThere();
    void pointsAreWalkedOneByOne();
    void anAreaIsFree();
    void drawingsAreWithoutIt();
    void theMenuPutsItThere();

  private:
    std::unique_ptr<Scene> m;
};

void TestKeyPoint::init() {
    QLocale::setDefault(QLocale::c());
    QCursor::setPos(-100, -100);
    m = std::make_unique<Scene>();
}

void TestKeyPoint::enterPutsItOnTheCurveNextToWhereThePageBegins() {
    m->press(Qt::Key_Return);
    QVERIFY(isNear(m->place(), {5, 5}));
    QCOMPARE(m->text().section(QLatin1Char('\n'), 0, 0), QStringLiteral("rising"));
    QVERIFY(m->clicks.isEmpty());
    m->press(Qt::Key_Escape);
    m->start.reset();  // the middle of the view
    m->press(Qt::Key_Enter);
    QVERIFY(std::abs(m->place().x() - 5) < 2 * m->pixelWidth());
}

void TestKeyPoint::withoutItKeysDoWhatTheyDid() {
    QSignalSpy fitted(&m->plot, &PlotWidget::fitRequested);
    m->press(Qt::Key_Home);
    QCOMPARE(fitted.count(), 1);
    const QCPRange before = m->plot.xAxis->range();
    m->press(Qt::Key_Right);
    QVERIFY(m->plot.xAxis->range() != before);
    m->plot.keyPoint().offer({});
    m->press(Qt::Key_Return);
    QVERIFY(!m->plot.keyPoint().place());
}

void TestKeyPoint::arrowsGoAlongTheCurveAndFromOneToTheOther() {
    m->press(Qt::Key_Return);
    const QCPRange view = m->plot.xAxis->range();
    m->press(Qt::Key_Right);
    QVERIFY(isNear(m->place(), QPointF(1, 1) * (5 + m->pixelWidth())));
    m->press(Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(isNear(m->place(), QPointF(1, 1) * (5 - 9 * m->pixelWidth())));
    const double x = m->place().x();
    m->press(Qt::Key_Up);
    QVERIFY(isNear(m->place(), {x, 20}));
    m->press(Qt::Key_Up);
    QVERIFY(isNear(m->place(), {x, 20}));
    m->press(Qt::Key_Down);
    QVERIFY(isNear(m->place(), {x, x}));
    QCOMPARE(m->plot.xAxis->range(), view);
}

void TestKeyPoint::homeAndEndAreTheEndsInView() {
    m->press(Qt::Key_Return);
    m->press(Qt::Key_Home);
    QCOMPARE(m->place(), QPointF(0, 0));
    m->press(Qt::Key_End);
    QCOMPARE(m->place(), QPointF(10, 10));
    m->plot.xAxis->setRange(3, 8);
    m->press(Qt::Key_Home);
    QVERIFY(isNear(m->place(), {3, 3}));
}

void TestKeyPoint::nGoesFromMarkToMark() {
    m->press(Qt::Key_Return);
    m->press(Qt::Key_N);
    QCOMPARE(m->place(), QPointF(7, 7));
    m->press(Qt::Key_N);
    QCOMPARE(m->place(), QPointF(2, 2));
    m->press(Qt::Key_N, Qt::ShiftModifier);
    QCOMPARE(m->place(), QPointF(7, 7));
    m->press(Qt::Key_N, Qt::ShiftModifier);
    QCOMPARE(m->place(), QPointF(2, 2));
    m->plot.xAxis->setRange(5, 8);  // the other one is out of view
    m->press(Qt::Key_N);
    m->press(Qt::Key_N);
    QCOMPARE(m->place(), QPointF(7, 7));
}

void TestKeyPoint::enterIsAClickAndShiftIsOneWithShift() {
    m->press(Qt::Key_Return);
    m->press(Qt::Key_N);
    m->press(Qt::Key_Return);
    QCOMPARE(m->clicks.size(), 1);
    QCOMPARE(m->clicks[0].first, QPointF(7, 7));
    QCOMPARE(m->clicks[0].second, Qt::KeyboardModifiers());
    m->press(Qt::Key_Enter, Qt::ShiftModifier | Qt::KeypadModifier);
    QCOMPARE(m->clicks.size(), 2);
    QCOMPARE(m->clicks[1].second, Qt::KeyboardModifiers(Qt::ShiftModifier));
    QCOMPARE(m->place(), QPointF(7, 7));
}

void TestKeyPoint::escapeAndTheMouseTakeItAway() {
    m->press(Qt::Key_Return);
    m->press(Qt::Key_Escape);
    QVERIFY(!m->plot.keyPoint().place());
    QCOMPARE(m->text(), QString());
    m->press(Qt::Key_Return);
    QVERIFY(!m->text().isEmpty());
    QTest::mouseClick(&m->plot, Qt::LeftButton, {}, m->plot.axisRect()->center());
    QVERIFY(!m->plot.keyPoint().place());
    QCOMPARE(m->text(), QString());
}

void TestKeyPoint::itStaysOnItsCurveWhenThatChanges() {
    m->press(Qt::Key_Return);
    m->rising->setData({0, 10}, {0, 20}, true);
    m->plot.replot();
    QVERIFY(isNear(m->place(), {5, 10}));
    m->rising->setData({6, 10}, {12, 20}, true);
    m->plot.replot();
    QVERIFY(isNear(m->place(), {6, 12}));
    m->plot.removeGraph(m->rising);
    m->plot.replot();
    QVERIFY(isNear(m->place(), {6, 20}));
    m->plot.removeGraph(m->level);
    m->plot.replot();
    QVERIFY(!m->plot.keyPoint().place());
}

void TestKeyPoint::aHiddenCurveLeavesItToTheNext() {
    m->press(Qt::Key_Return);
    m->rising->setVisible(false);
    m->plot.replot();
    QVERIFY(isNear(m->place(), {5, 20}));
    QVERIFY(m->text().startsWith(QStringLiteral("level")));
}

void TestKeyPoint::cursorsArePlacedThere() {
    m->press(Qt::Key_Return);
    m->press(Qt::Key_N);
    m->press(Qt::Key_A);
    const std::optional<double> a = m->plot.reader().position(PlotCursor::a);
    QVERIFY(a && std::abs(*a - 7) <= m->pixelWidth());
}

void TestKeyPoint::pointsAreWalkedOneByOne() {
    m = std::make_unique<Scene>(KeyPlaces::On::points);
    m->level->setData({4, 4, 8}, {20, 4, 25}, true);  // one of them where the other curve has one
    m->plot.replot();
    m->press(Qt::Key_Return);
    QCOMPARE(m->place(), QPointF(4, 4));
    QVector<QPointF> right;
    for (int i = 0; i < 4; ++i) {
        m->press(Qt::Key_Right);
        right.append(m->place());
    }
    QCOMPARE(right, (QVector<QPointF>{{4, 20}, {8, 25}, {10, 10}, {10, 10}}));
    m->press(Qt::Key_Home);
    QCOMPARE(m->place(), QPointF(0, 0));
    QVector<QPointF> up;
    for (int i = 0; i < 4; ++i) {
        m->press(Qt::Key_Up);
        up.append(m->place());
    }
    QCOMPARE(up, (QVector<QPointF>{{4, 4}, {10, 10}, {4, 20}, {8, 25}}));
    m->press(Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(m->place(), QPointF(0, 0));
    m->plot.xAxis->setRange(3, 11);  // and what is out of view is not gone to
    m->press(Qt::Key_Home);
    QCOMPARE(m->place(), QPointF(4, 4));
}

void TestKeyPoint::anAreaIsFree() {
    m = std::make_unique<Scene>(KeyPlaces::On::area);
    m->press(Qt::Key_Return);
    QCOMPARE(m->place(), QPointF(5, 6));
    m->press(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(m->place().x(), 5.0);
    QVERIFY(m->place().y() > 6);
    m->press(Qt::Key_End);
    QVERIFY(std::abs(m->place().x() - 11) <= m->pixelWidth());
    for (int i = 0; i < 100; ++i) m->press(Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(m->place().y() <= 30 + rounding);
    QCOMPARE(m->text(), QString());
}

void TestKeyPoint::drawingsAreWithoutIt() {
    const QByteArray before = m->plot.drawing(QStringLiteral("svg"), {160, 120});
    m->press(Qt::Key_Return);
    QCOMPARE(m->plot.drawing(QStringLiteral("svg"), {160, 120}), before);
    QVERIFY(!m->text().isEmpty());
}

void TestKeyPoint::theMenuPutsItThere() {
    QMenu menu;
    fillPlotMenu(menu, m->plot, m->plot.axisRect()->center());
    const auto entry = [&menu] {
        for (QAction* action : menu.actions())
            if (action->text().contains(QStringLiteral("for keys"))) return action;
        return static_cast<QAction*>(nullptr);
    };
    QVERIFY(entry());
    entry()->trigger();
    QVERIFY(isNear(m->place(), {5, 5}));
    m->plot.keyPoint().offer({});
    fillPlotMenu(menu, m->plot, m->plot.axisRect()->center());
    QVERIFY(!entry());
}

// A click that only gives the plot the focus changes nothing.
void TestKeyPoint::aClickTakesOnlyWhatIsWithinTenPixels() {
    Scene scene(KeyPlaces::On::curves);
    scene.marks = {{2, 15}};
    const auto pixel = [&](double x, double y) {
        return QPoint(qRound(scene.plot.xAxis->coordToPixel(x)), qRound(scene.plot.yAxis->coordToPixel(y)));
    };
    const auto takes = [&](QPoint at) {
        scene.taken.clear();
        const qsizetype clicks = scene.clicks.size();
        QTest::mouseClick(&scene.plot, Qt::LeftButton, {}, at);
        return scene.clicks.size() == clicks + 1 && scene.taken.size() == 1;
    };
    QVERIFY(!takes(pixel(8, 13)));
    QVERIFY(scene.plot.hasFocus() || QGuiApplication::focusWindow() == nullptr);
    QVERIFY(takes(pixel(5, 20) + QPoint(0, 9)));
    QVERIFY(!takes(pixel(5, 20) + QPoint(0, 12)));
    QVERIFY(takes(pixel(2, 15) + QPoint(6, 6)));
    QVERIFY(!takes(pixel(2, 15) + QPoint(9, 9)));
    scene.level->setVisible(false);
    QVERIFY(!takes(pixel(5, 20)));
}

QTEST_MAIN(TestKeyPoint)
#include "tst_key_point.moc"

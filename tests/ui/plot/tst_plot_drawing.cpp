// SPDX-License-Identifier: GPL-3.0-or-later
// How a plot is drawn, on screen and in files, and what is copied of it.
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/support/plot_scene.h"
#include "ui/plot/axis_view.h"
#include "ui/plot/curve_graph.h"

using namespace drillwave;
using namespace drillwave::test;

class TestPlotDrawing : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void numbersOfALowAxisKeepApart();
    void numbersOfAnAxisAreReadInOneWay_data();
    void numbersOfAnAxisAreReadInOneWay();
    void linesAreAsThickWhereManyPointsMeet();
    void dashesStayDashesOnLongTables();
    void crowdedPointsLeaveNoHoleInTheirCurve();
    void drawingsAreWhiteAndTheSameEveryTime();
    void drawingsShowThePresentView();
    void curvesThatLeaveTheAxesAreCutInSvg();
    void theWidgetLooksTheSameAfterADrawing();
    void dataAreCopiedWithTheirUnits();

  private:
    std::unique_ptr<PlotScene> m;
};

void TestPlotDrawing::init() {
    QLocale::setDefault(QLocale::c());
    QCursor::setPos(-100, -100);
    m = std::make_unique<PlotScene>();
    QVERIFY(QTest::qWaitForWindowExposed(&m->plot));
    m->plot.replot();
}

/// As many ticks as on a high one stood over each other.
void TestPlotDrawing::numbersOfALowAxisKeepApart() {
    for (const int height : {600, 400, 600}) {
        m->plot.resize(500, height);
        QCoreApplication::processEvents();
        m->plot.replot();
        m->plot.replot();  // by the heights of the layout before
        for (QCPAxisRect* rect : {m->upper, m->lower}) {
            const QCPAxis* axis = m->y(rect);
            const QVector<double> ticks = axis->tickVector();
            QVERIFY(height < 600 || ticks.size() >= 4);
            const double line = QFontMetricsF(axis->tickLabelFont()).height();
            for (int i = 1; i < ticks.size(); ++i) {
                const double apart =
                    std::abs(axis->coordToPixel(ticks[i]) - axis->coordToPixel(ticks[i - 1]));
                QVERIFY2(apart > line, qPrintable(QStringLiteral("%1 ticks on %2 pixels, %3 apart")
                                                      .arg(ticks.size())
                                                      .arg(rect->height())
                                                      .arg(apart)));
            }
        }
    }
}

void TestPlotDrawing::numbersOfAnAxisAreReadInOneWay_data() {
    QTest::addColumn<QString>("locale");
    for (const char* name : {"C", "en_US", "de_DE", "sv_SE"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

/// "1.000" of a German axis is 1 to who reads it in English, and a hyphen no minus.
void TestPlotDrawing::numbersOfAnAxisAreReadInOneWay() {
    QFETCH(const QString, locale);
    m->plot.setLocale(QLocale(locale));
    QCPAxis* axis = m->y(m->upper);
    for (const auto scale : {QCPAxis::stLinear, QCPAxis::stLogarithmic, QCPAxis::stLinear}) {
        setScale(*axis, scale);
        axis->setRange(scale == QCPAxis::stLinear ? -2000 : 1, 2000);
        m->plot.replot();
        const QVector<QString> labels = axis->tickVectorLabels();
        const QString shown = labels.join(u' ');
        QVERIFY2(labels.contains(QStringLiteral("1000")), qPrintable(shown));
        QCOMPARE(labels.contains(QStringLiteral("−1000")), scale == QCPAxis::stLinear);
        QVERIFY2(!shown.contains(u'-'), qPrintable(shown));
    }
    // QCustomPlot writes powers of ten as superscripts.
    axis->setRange(-1e-6, 1e-6);
    m->plot.replot();
    const QVector<QString> powers = axis->tickVectorLabels();
    QVERIFY2(powers.contains(QStringLiteral("−1e-06")) || powers.contains(QStringLiteral("−5e-07")),
             qPrintable(powers.join(u' ')));
}

// Begins with the mechanism: the plot draws a solid line of many points piece by piece, each piece over the
// end of the one before.
void TestPlotDrawing::linesAreAsThickWhereManyPointsMeet() {
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
void TestPlotDrawing::dashesStayDashesOnLongTables() {
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

void TestPlotDrawing::crowdedPointsLeaveNoHoleInTheirCurve() {
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

void TestPlotDrawing::drawingsAreWhiteAndTheSameEveryTime() {
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

void TestPlotDrawing::drawingsShowThePresentView() {
    const QByteArray whole = m->plot.drawing(QStringLiteral("svg"), {120, 90});
    m->plot.setCurveVisible(m->step, false);
    const QByteArray hidden = m->plot.drawing(QStringLiteral("svg"), {120, 90});
    QVERIFY(hidden != whole);
    QVERIFY(whole.contains(">step<"));
    QVERIFY(!hidden.contains(">step<"));
    m->plot.reader().place(PlotCursor::a, 4);
    QVERIFY(m->plot.drawing(QStringLiteral("svg"), {120, 90}) != hidden);
}

void TestPlotDrawing::curvesThatLeaveTheAxesAreCutInSvg() {
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

void TestPlotDrawing::theWidgetLooksTheSameAfterADrawing() {
    m->wheel(m->upper->center(), 2);
    m->plot.replot();
    const QImage before = m->plot.grab().toImage();
    m->plot.drawing(QStringLiteral("svg"), {300, 60});
    QCOMPARE(m->plot.grab().toImage(), before);
}

void TestPlotDrawing::dataAreCopiedWithTheirUnits() {
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

QTEST_MAIN(TestPlotDrawing)
#include "tst_plot_drawing.moc"

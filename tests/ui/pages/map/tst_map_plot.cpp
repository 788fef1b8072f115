// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of a map: the colour of every point where it belongs, hatches where there is none.
#include <qcustomplot.h>

#include <QTest>

#include "core/report/map_figure.h"
#include "tests/support/map.h"
#include "tests/support/scenario.h"
#include "ui/plot/figure_frame.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const MapStudy twoByTwo = mapOf(dimensionless(), "beta=1:2:2", "delta=0:1:2");

/// Values row after row; NaN is a point that was not solved.
std::shared_ptr<const MapReport> reportOf(std::vector<double> values, const char* output = "cor") {
    MapStudy study = twoByTwo;
    study.output = chooseOutputs(output, OutputUnits::dimensionless).columns.front();
    MapGrid grid({1, 2}, {0, 1});
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (std::isnan(values[n]))
            grid.fail(n % 2, n / 2, "too long a blow");
        else
            grid.set(n % 2, n / 2, values[n]);
    }
    return std::make_shared<const MapReport>(
        MapReport{.study = study, .grid = grid, .contours = {}, .scenarioText = {}});
}

/// A plot of one map, drawn.
struct Drawn {
    explicit Drawn(const std::shared_ptr<const MapReport>& report) : plot(&widget) {
        widget.resize(500, 400);
        plot.setStyle(PlotStyle::forPaper());
        present(report, std::nullopt);
        image = widget.toPixmap().toImage();
    }
    void present(const std::shared_ptr<const MapReport>& report, const std::optional<FigurePoint>& here) {
        const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
        plot.present({mapFigure(report, mapSectionAt(*report, here), {}), {{}, unit}});
    }
    const QCPAxisRect* rect() const { return plot.graph()->keyAxis()->axisRect(); }
    QPoint pixelOf(double x, double y) const {
        return {qRound(rect()->axis(QCPAxis::atBottom)->coordToPixel(x)),
                qRound(rect()->axis(QCPAxis::atLeft)->coordToPixel(y))};
    }
    const FieldColours& colours() const { return plot.field()->colours(); }
    QRgb at(double x, double y) const { return image.pixel(pixelOf(x, y)); }

    QCustomPlot widget;
    FigureFrame plot;
    QImage image;
};

double lightness(QRgb colour) {
    return 0.299 * qRed(colour) + 0.587 * qGreen(colour) + 0.114 * qBlue(colour);
}

}  // namespace

class TestMapPlot : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }  // numbers of the plot follow it
    void everyPointHasItsColour();
    void largerValuesAreLighterOnBothScales();
    void coloursAreAboutTheLevelThatDecides();
    void pointsWithoutASolutionAreHatchedAndSayWhy();
    void whatIsNotThereYetHasTheColourOfItsNeighbour();
    void aMapOfOneValueIsDrawn();
    void nothingIsShownWithItsReason();
    void cutsSayWhereTheyAreNotThroughTheScenario();
    void namesOfRunsKeepClearOfEachOtherAndOfPresets();
};

void TestMapPlot::everyPointHasItsColour() {
    const Drawn drawn(reportOf({0.2, 0.6, 1.1, 1.4}));
    const FieldColours& colours = drawn.colours();
    const auto expected = [&](double value) { return colours.scale().colour(colours.share(value)); };
    QCOMPARE(drawn.at(1.25, 0.25), expected(0.2));
    QCOMPARE(drawn.at(1.75, 0.25), expected(0.6));
    QCOMPARE(drawn.at(1.25, 0.75), expected(1.1));
    QCOMPARE(drawn.at(1.75, 0.75), expected(1.4));
}

// In grey, too.
void TestMapPlot::largerValuesAreLighterOnBothScales() {
    for (const char* output : {"cor", "peak_force"}) {
        const Drawn drawn(reportOf({0.2, 0.6, 1.1, 1.4}, output));
        QVERIFY(lightness(drawn.at(1.25, 0.25)) < lightness(drawn.at(1.75, 0.25)) - 20);
        QVERIFY(lightness(drawn.at(1.75, 0.25)) < lightness(drawn.at(1.25, 0.75)) - 20);
        QVERIFY(lightness(drawn.at(1.25, 0.75)) < lightness(drawn.at(1.75, 0.75)) - 20);
    }
}

void TestMapPlot::coloursAreAboutTheLevelThatDecides() {
    const Drawn drawn(reportOf({0.2, 0.8, 1.05, 1.4}));
    QCOMPARE(drawn.colours().level, std::optional(1.0));
    QCOMPARE(drawn.colours().share(1), 0.0);
    const QRgb below = drawn.at(1.75, 0.25), above = drawn.at(1.75, 0.75);
    QVERIFY(qBlue(below) > qRed(below));
    QVERIFY(qRed(above) > qBlue(above));
    QVERIFY(!Drawn(reportOf({1, 2, 3, 4}, "peak_force")).colours().level);
    // A value that hardly passes the level does not look far from it.
    QVERIFY(FieldColours({.least = 0, .largest = 1.001, .level = 1}).share(1.001) < 0.05);
}

void TestMapPlot::pointsWithoutASolutionAreHatchedAndSayWhy() {
    const Drawn drawn(reportOf({0.2, 0.6, std::nan(""), 1.4}));
    const PlotStyle style = PlotStyle::forPaper();
    int hatches = 0, gaps = 0;
    const QPoint middle = drawn.pixelOf(1.25, 0.75);
    for (int x = -10; x <= 10; ++x) {
        const QRgb colour = drawn.image.pixel(middle + QPoint(x, 0));
        hatches += colour == style.zeroLine.rgb() ? 1 : 0;
        gaps += colour == style.background.rgb() ? 1 : 0;
    }
    QVERIFY(hatches > 2 && gaps > 2);
    QCOMPARE(hatches + gaps, 21);
    QVERIFY(drawn.plot.fieldWords({1.25, 0.75}).contains(QStringLiteral("not solved: too long a blow")));
    QVERIFY(drawn.plot.textSummary().contains(QStringLiteral("1 of 4 points not solved (hatched)")));
    QVERIFY(drawn.plot.fieldWords({1.25, 0.25}).endsWith(QStringLiteral("COR e = 0.2")));
    QVERIFY(drawn.plot.fieldWords({0, 0.5}).isEmpty());
}

void TestMapPlot::whatIsNotThereYetHasTheColourOfItsNeighbour() {
    MapStudy study = twoByTwo;
    study.x.count = study.y.count = 100;
    std::vector<double> xs, ys;
    for (std::uint64_t i = 0; i < 100; ++i) {
        xs.push_back(study.x.value(i));
        ys.push_back(study.y.value(i));
    }
    MapGrid grid(xs, ys);
    for (std::size_t row = 0; row < 100; row += grid.coarsestStride())
        for (std::size_t column = 0; column < 100; column += grid.coarsestStride())
            grid.set(column, row, column < 50 ? 0.5 : 1.2);
    const Drawn drawn(std::make_shared<const MapReport>(
        MapReport{.study = study, .grid = grid, .contours = {}, .scenarioText = {}}));
    const FieldColours& colours = drawn.colours();
    QCOMPARE(drawn.at(1.2, 0.37), colours.scale().colour(colours.share(0.5)));
    QCOMPARE(drawn.at(1.8, 0.37), colours.scale().colour(colours.share(1.2)));
}

void TestMapPlot::aMapOfOneValueIsDrawn() {
    const Drawn drawn(reportOf({0.5, 0.5, 0.5, 0.5}));
    QVERIFY(drawn.colours().largest > drawn.colours().least);
    QCOMPARE(qAlpha(drawn.at(1.3, 0.3)), 255);
}

void TestMapPlot::cutsSayWhereTheyAreNotThroughTheScenario() {
    const auto report = reportOf({0.2, 0.6, 1.1, 1.4});
    Drawn drawn(report);
    const auto name = [&] {
        const QCPGraph* section = drawn.plot.graph(std::size_t(MapPanel::alongX));
        return section->keyAxis()->axisRect()->axis(QCPAxis::atTop)->label();
    };
    drawn.present(report, FigurePoint{1, 1});
    QVERIFY2(!name().startsWith("at ") && name().endsWith('1'), qPrintable(name()));
    drawn.present(report, FigurePoint{1, 0.9});
    QVERIFY2(name().startsWith("at ") && name().endsWith('1'), qPrintable(name()));
    drawn.present(report, FigurePoint{1, 0});
    QVERIFY2(!name().startsWith("at ") && name().endsWith('0'), qPrintable(name()));
}

// Two runs one above the other beside a preset, one in the upper right corner.
void TestMapPlot::namesOfRunsKeepClearOfEachOtherAndOfPresets() {
    Drawn drawn(reportOf({0.2, 0.6, 1.1, 1.4}));
    StudyFigure figure = drawn.plot.figure();
    figure.panels[0].series[0].x = {1.45};
    figure.panels[0].series[0].y = {0.55};
    figure.panels[0].series[0].texts = {{"medium rock"}};
    const auto unit = [](const Parameter& parameter) -> const Unit& { return parameter.displayUnit(); };
    drawn.plot.present({figure, {{}, unit}});
    drawn.plot.setRuns({{0, "A  T38 rod, medium rock", {1.5, 0.5}},
                        {1, "B  k 300 MN/m", {1.51, 0.52}},
                        {2, "C  T38 rod, hard rock", {1.98, 0.98}}});
    drawn.widget.replot();
    QVector<QRectF> names;
    QStringList texts;
    for (int i = 0; i < drawn.widget.itemCount(); ++i)
        if (const auto* text = qobject_cast<QCPItemText*>(drawn.widget.item(i)); text && text->visible()) {
            const QRectF box(text->topLeft->pixelPosition(), text->bottomRight->pixelPosition());
            names << box.adjusted(6, 2, -6, -2);  // the letters, without the room about them
            texts << text->text();
        }
    QCOMPARE(names.size(), 4);
    for (qsizetype i = 0; i < names.size(); ++i) {
        QVERIFY2(QRectF(drawn.rect()->rect()).contains(names[i]), qPrintable(texts[i]));
        for (qsizetype j = 0; j < i; ++j)
            QVERIFY2(!names[i].intersects(names[j]), qPrintable(texts[i] + " over " + texts[j]));
    }
    // Alone each has its name.
    QVERIFY(texts.contains("C  T38 rod, hard rock"));
}

void TestMapPlot::nothingIsShownWithItsReason() {
    Drawn drawn(reportOf({0.2, 0.6, 1.1, 1.4}));
    drawn.plot.showNothing(QStringLiteral("two axes of one thing"));
    QVERIFY(!drawn.plot.field());
    QCOMPARE(drawn.plot.textSummary(), QStringLiteral("two axes of one thing"));
    QVERIFY(drawn.plot.fieldWords({1.25, 0.25}).isEmpty());
    const QRgb paper = PlotStyle::forPaper().background.rgb();
    QCOMPARE(drawn.widget.toPixmap().toImage().pixel(drawn.pixelOf(1.1, 0.1)), paper);
}

QTEST_MAIN(TestMapPlot)
#include "tst_map_plot.moc"

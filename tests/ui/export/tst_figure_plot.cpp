// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as files: every curve in view, named, and the same bytes every time.
#include <QImage>
#include <QTest>

#include "core/study/paper/figures.h"
#include "tests/support/svg_texts.h"
#include "ui/export/figure_plot.h"
#include "ui/plot/plot_style.h"

using namespace drillwave;

namespace {

int count(const QImage& image, QColor color) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y) == color) ++found;
    return found;
}

/// Two panels, the second on a logarithmic axis with a curve that is not drawn.
Figure sample() {
    FigurePanel waves{.name = "a",
                      .title = "(a) gamma = 1",
                      .xKey = "time",
                      .xLabel = "time t/t0",
                      .yKey = "force",
                      .yLabel = "force F/F0",
                      .curves = {}};
    waves.curves = {{.key = "N0p", .label = "N0p", .x = {0, 1}, .y = {0, 1}},
                    {.key = "N1n", .label = "N1n", .x = {1, 2}, .y = {-1, 0}, .colour = 1}};
    FigurePanel stiffness = waves;
    stiffness.title = "";
    stiffness.xLabel = "stiffness beta";
    stiffness.logarithmicX = true;
    stiffness.curves = {
        {.key = "e", .label = "exact", .x = {0.1, 1, 10}, .y = {1.1, 1.4, 1}},
        {.key = "n", .label = "not drawn", .x = {0.1, 10}, .y = {900, 900}, .line = FigureCurve::Line::none}};
    return {.number = 9, .caption = "", .panels = {waves, stiffness}};
}

}  // namespace

class TestFigurePlot : public QObject {
    Q_OBJECT

  private slots:
    void axesAndCurvesAreNamedInSymbols();
    void theAxesCoverWhatIsDrawnAndNoMore();
    void everyCurveOfThePaperHasItsColour();
    void theBytesAreTheSameEveryTime();
    void textIsInTheCLocale();
};

void TestFigurePlot::axesAndCurvesAreNamedInSymbols() {
    // SVG cuts a text where its script changes.
    const QString texts =
        test::svgTexts(drawFigure(sample(), QStringLiteral("svg"))).join(QString()).remove(' ');
    for (const char* text : {"(a) γ = 1", "time t/t0", "force F/F0", "N0p", "N1n", "stiffness β", "exact"})
        QVERIFY2(texts.contains(QString::fromUtf8(text).remove(' ')), text);
    QVERIFY(!texts.contains(QStringLiteral("notdrawn")));
}

void TestFigurePlot::theAxesCoverWhatIsDrawnAndNoMore() {
    const QStringList texts = test::svgTexts(drawFigure(sample(), QStringLiteral("svg")));
    for (const char* tick : {"0.1", "10", "1.4", "−1"})
        QVERIFY2(texts.contains(QString::fromUtf8(tick)), tick);
    // The default range of an axis ends at 5; the curve that is not drawn lies at 900.
    for (const char* tick : {"5", "100", "900"}) QVERIFY2(!texts.contains(QLatin1String(tick)), tick);
}

void TestFigurePlot::everyCurveOfThePaperHasItsColour() {
    const PlotStyle style = PlotStyle::forPaper();
    for (const Figure& figure : paperFigures()) {
        const QImage image = QImage::fromData(drawFigure(figure, QStringLiteral("png")));
        QVERIFY(image.width() > 1000);
        QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
        int colours = 0;
        for (const FigureCurve& curve : figure.panels.front().curves)
            colours = std::max(colours, curve.colour + 1);
        QVERIFY(colours >= 2);
        // Legend samples alone have a few hundred pixels.
        for (int i = 0; i < colours; ++i)
            QVERIFY2(count(image, style.lines[i]) > 400,
                     qPrintable(QStringLiteral("Fig. %1").arg(figure.number)));
    }
}

void TestFigurePlot::theBytesAreTheSameEveryTime() {
    for (const char* format : {"png", "svg"}) {
        const QByteArray first = drawFigure(sample(), QString::fromLatin1(format));
        QVERIFY(first.size() > 2000);
        QCOMPARE(drawFigure(sample(), QString::fromLatin1(format)), first);
    }
}

void TestFigurePlot::textIsInTheCLocale() {
    const QByteArray c = drawFigure(sample(), QStringLiteral("svg"));
    QLocale::setDefault(QLocale(QLocale::German));
    const QByteArray german = drawFigure(sample(), QStringLiteral("svg"));
    QLocale::setDefault(QLocale::c());
    QCOMPARE(german, c);
}

QTEST_MAIN(TestFigurePlot)
#include "tst_figure_plot.moc"

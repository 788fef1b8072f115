#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "core/wave/exact_solver.h"
#include "ui/plots/blow_plots.h"
#include "ui/plots/plot_widget.h"

using namespace drillwave;

namespace {

BlowCurves curvesFor(double beta) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups.beta = beta;
    const PulseForce pulse = pulseForceOf(scenario);
    const Impact impact = ExactSolver().solve(pulse, scenario.groups, Detail::histories);
    const ShownUnits units = shownUnits(UnitSystem::dimensionless, {});
    BlowCurves curves = blowCurves(impact, pulse, units, 0.5);
    curves.closedForm = closedFormCurve(pulse, scenario.groups, units, curves.timeEnd);
    return curves;
}

void turnWheel(QWidget& widget, QPoint at) {
    QWheelEvent wheel(at, widget.mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &wheel);
}

}  // namespace

class TestBlowPlots : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void allCurvesAreInView();
    void timeAxesAreLinked();
    void theWheelZoomsBothAxesAtThePointer();
    void theWheelOverAnAxisZoomsThatAxisAlone();
    void aZoomedViewStaysWhileTheResultChanges();
    void draggingPans();
    void aDoubleClickAsksToFit();
    void linesHaveTheContrastThatReadersNeed_data();
    void linesHaveTheContrastThatReadersNeed();
    void aDarkPaletteIsFollowed();
    void withoutCurvesTheReasonIsShown();

  private:
    QCPAxis* timeAxis(int plot) { return m_plots->axisRect(plot)->axis(QCPAxis::atBottom); }
    QCPAxis* valueAxis(int plot) { return m_plots->axisRect(plot)->axis(QCPAxis::atLeft); }

    std::unique_ptr<PlotWidget> m_widget;
    BlowPlots* m_plots = nullptr;
};

void TestBlowPlots::init() {
    m_widget = std::make_unique<PlotWidget>();
    m_plots = new BlowPlots(m_widget.get());
    m_widget->followPalette([this](const PlotStyle& style) { m_plots->setStyle(style); });
    m_widget->resize(700, 800);
    m_plots->show(curvesFor(0.5));
    m_widget->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_widget.get()));
    m_widget->replot();
}

void TestBlowPlots::allCurvesAreInView() {
    QCOMPARE(m_widget->graphCount(), 8);
    for (int i = 0; i < m_widget->graphCount(); ++i) {
        bool found = false;
        const QCPRange range = m_widget->graph(i)->getValueRange(found);
        QVERIFY(found);
        QVERIFY(m_widget->graph(i)->valueAxis()->range().contains(range.lower));
        QVERIFY(m_widget->graph(i)->valueAxis()->range().contains(range.upper));
    }
    QCOMPARE(timeAxis(0)->range().lower, 0.0);
}

void TestBlowPlots::timeAxesAreLinked() {
    for (int from = 0; from < BlowPlots::plotCount; ++from) {
        timeAxis(from)->setRange(from + 1, from + 5);
        for (int to = 0; to < BlowPlots::plotCount; ++to)
            QCOMPARE(timeAxis(to)->range(), QCPRange(from + 1, from + 5));
    }
}

void TestBlowPlots::theWheelZoomsBothAxesAtThePointer() {
    const QPoint pointer = m_plots->axisRect(1)->center();
    const double time = timeAxis(1)->pixelToCoord(pointer.x());
    const double timeSize = timeAxis(1)->range().size();
    const double valueSize = valueAxis(1)->range().size();
    turnWheel(*m_widget, pointer);
    QVERIFY(timeAxis(1)->range().size() < timeSize);
    QVERIFY(valueAxis(1)->range().size() < valueSize);
    QVERIFY(std::abs(timeAxis(1)->pixelToCoord(pointer.x()) - time) < 1e-6 * timeSize);
    QCOMPARE(timeAxis(3)->range(), timeAxis(1)->range());
}

void TestBlowPlots::theWheelOverAnAxisZoomsThatAxisAlone() {
    const QCPRange time = timeAxis(2)->range();
    const QCPRange value = valueAxis(2)->range();
    const QRect rect = m_plots->axisRect(2)->rect();
    turnWheel(*m_widget, QPoint(rect.left() - 12, rect.center().y()));
    QCOMPARE(timeAxis(2)->range(), time);
    QVERIFY(valueAxis(2)->range() != value);
    m_plots->fit();
    const QRect lowest = m_plots->axisRect(3)->rect();
    turnWheel(*m_widget, QPoint(lowest.center().x(), lowest.bottom() + 12));
    QVERIFY(timeAxis(2)->range() != time);
    QCOMPARE(valueAxis(2)->range(), value);
}

void TestBlowPlots::aZoomedViewStaysWhileTheResultChanges() {
    timeAxis(0)->setRange(10, 20);
    m_plots->show(curvesFor(0.6));
    QCOMPARE(timeAxis(0)->range(), QCPRange(10, 20));
    m_plots->fit();
    m_plots->show(curvesFor(50));
    // Fitted again, the view follows: a stiff rock gives a larger force.
    QVERIFY(valueAxis(1)->range().upper > 1.9);
    QCOMPARE(timeAxis(0)->range().lower, 0.0);
}

void TestBlowPlots::draggingPans() {
    const QPoint start = m_plots->axisRect(1)->center();
    const double before = timeAxis(1)->range().lower;
    const double size = timeAxis(1)->range().size();
    QTest::mousePress(m_widget.get(), Qt::LeftButton, {}, start);
    QTest::mouseMove(m_widget.get(), start + QPoint(60, 0));
    QTest::mouseRelease(m_widget.get(), Qt::LeftButton, {}, start + QPoint(60, 0));
    QVERIFY(timeAxis(1)->range().lower < before);
    QVERIFY(std::abs(timeAxis(1)->range().size() - size) < 1e-9 * size);
}

void TestBlowPlots::aDoubleClickAsksToFit() {
    QSignalSpy asked(m_widget.get(), &PlotWidget::fitRequested);
    QTest::mouseDClick(m_widget.get(), Qt::LeftButton, {}, m_plots->axisRect(1)->center());
    QCOMPARE(asked.count(), 1);
}

void TestBlowPlots::linesHaveTheContrastThatReadersNeed_data() {
    QTest::addColumn<QColor>("base");
    QTest::addColumn<QColor>("text");
    QTest::newRow("light") << QColor(Qt::white) << QColor(Qt::black);
    QTest::newRow("dark") << QColor(30, 30, 32) << QColor(225, 225, 225);
}

// Relative luminance and contrast as WCAG 2 defines them.
static double luminance(const QColor& color) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

void TestBlowPlots::linesHaveTheContrastThatReadersNeed() {
    QFETCH(QColor, base);
    QFETCH(QColor, text);
    QPalette palette;
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::Text, text);
    const PlotStyle style = PlotStyle::forScreen(palette, QFont());
    for (int line = 0; line < PlotStyle::lineKinds; ++line) {
        const double a = luminance(style.lines[line]) + 0.05;
        const double b = luminance(style.background) + 0.05;
        QVERIFY(std::max(a, b) / std::min(a, b) >= 4.5);
        for (int other = 0; other < line; ++other)
            QVERIFY(style.linePen(line).dashPattern() != style.linePen(other).dashPattern());
    }
}

void TestBlowPlots::aDarkPaletteIsFollowed() {
    QPalette palette = m_widget->palette();
    palette.setColor(QPalette::Base, QColor(30, 30, 32));
    palette.setColor(QPalette::Text, QColor(225, 225, 225));
    m_widget->setPalette(palette);
    QCoreApplication::processEvents();
    QCOMPARE(m_widget->grab().toImage().pixelColor(1, 1), QColor(30, 30, 32));
    QVERIFY(m_widget->graph(0)->pen().color().lightness() > 128);
}

void TestBlowPlots::withoutCurvesTheReasonIsShown() {
    m_plots->showNothing(QStringLiteral("no rod"));
    QCOMPARE(m_plots->textSummary(), QStringLiteral("no rod"));
    for (int i = 0; i < m_widget->graphCount(); ++i) QVERIFY(m_widget->graph(i)->data()->isEmpty());
    m_plots->show(curvesFor(0.5));
    QVERIFY(m_plots->textSummary().contains(QStringLiteral("Impact force")));
}

QTEST_MAIN(TestBlowPlots)
#include "tst_blow_plots.moc"

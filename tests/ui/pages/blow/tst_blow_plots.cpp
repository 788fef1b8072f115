// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the page Blow: views, linked axes, colours, closed form, ghosts.
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "core/wave/exact/exact_solver.h"
#include "tests/support/contrast.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;

namespace {

BlowCurves curvesFor(double beta, double gamma = 1) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups.beta = beta;
    scenario.groups.gamma = gamma;
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    const ShownUnits units = shownUnits(UnitSystem::dimensionless, {});
    BlowCurves curves = blowCurves(blow, units, 0.5);
    curves.closedForm = closedFormCurve(blow.problem, units, curves.timeEnd);
    return curves;
}

double largestValue(const QCPGraphDataContainer& data) {
    double largest = 0;
    for (auto point = data.constBegin(); point != data.constEnd(); ++point)
        largest = std::max(largest, point->value);
    return largest;
}

void turnWheel(QWidget& widget, QPoint at) {
    QWheelEvent wheel(at, widget.mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::ControlModifier,
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
    void theClosedFormStatesItsError();
    void theClosedFormIsThereOnlyWhereItHolds();
    void aHiddenClosedFormStaysHidden();
    void aGhostStaysBehindInNoLegend();
    void aGhostInOtherUnitsGoes();
    void aSectionIsNamedAsExactlyAsItWasChosen();
    void laterWavesAreNamedWhereThereAreSuch();
    void theLegendTakesMoreLinesWhereOneHasNoRoom();

  private:
    QList<QCPLegend*> legends() const;
    QCPAxis* timeAxis(int plot) { return m_plots->axisRect(plot)->axis(QCPAxis::atBottom); }
    QCPAxis* valueAxis(int plot) { return m_plots->axisRect(plot)->axis(QCPAxis::atLeft); }

    std::unique_ptr<PlotWidget> m_widget;
    BlowPlots* m_plots = nullptr;
};

QList<QCPLegend*> TestBlowPlots::legends() const {
    QList<QCPLegend*> found;
    for (QCPLayerable* each : m_widget->layer(QStringLiteral("legend"))->children())
        if (auto* legend = qobject_cast<QCPLegend*>(each)) found.append(legend);
    return found;
}

void TestBlowPlots::init() {
    QLocale::setDefault(QLocale::c());
    m_widget = std::make_unique<PlotWidget>();
    m_plots = new BlowPlots(m_widget.get());
    m_widget->followPalette([this](const PlotStyle& style) { m_plots->setStyle(style); });
    m_widget->resize(700, 800);
    m_plots->present(curvesFor(0.5));
    m_widget->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_widget.get()));
    m_widget->replot();
}

void TestBlowPlots::allCurvesAreInView() {
    QCOMPARE(m_widget->graphCount(), 12);
    for (int i = 0; i < m_widget->graphCount(); ++i) {
        bool found = false;
        const QCPRange range = m_widget->graph(i)->getValueRange(found);
        // N5n begins where the plot ends, and a prescribed blow has no hammer to show the force of.
        QCOMPARE(found, m_widget->graph(i) != m_plots->laterGraph(1) &&
                            m_widget->graph(i) != m_plots->faceForceGraph());
        if (!found) continue;
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
    m_plots->present(curvesFor(0.6));
    QCOMPARE(timeAxis(0)->range(), QCPRange(10, 20));
    m_plots->fit();
    m_plots->present(curvesFor(50));
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

void TestBlowPlots::linesHaveTheContrastThatReadersNeed() {
    QFETCH(QColor, base);
    QFETCH(QColor, text);
    QPalette palette;
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::Text, text);
    const PlotStyle style = PlotStyle::forScreen(palette, QFont());
    for (int line = 0; line < PlotStyle::lineKinds; ++line) {
        QVERIFY(test::contrast(style.lines[line], style.background) >= test::leastContrast);
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
    QCOMPARE(m_widget->grab().toImage().pixelColor(5, 5), QColor(30, 30, 32));
    QVERIFY(m_widget->graph(0)->pen().color().lightness() > 128);
}

void TestBlowPlots::withoutCurvesTheReasonIsShown() {
    m_plots->showNothing(QStringLiteral("no rod"));
    QCOMPARE(m_plots->textSummary(), QStringLiteral("no rod"));
    for (int i = 0; i < m_widget->graphCount(); ++i) QVERIFY(m_widget->graph(i)->data()->isEmpty());
    m_plots->present(curvesFor(0.5));
    QVERIFY(m_plots->textSummary().contains(QStringLiteral("Impact force")));
}

void TestBlowPlots::theClosedFormStatesItsError() {
    // (2/β)(1 − e^(−β)) e^(−β(2τ + ts − 1)), ts = 1/(1 − e^(−β)) − 1/(2β), at β = 1/2 and τ = 10
    const double q = 1 - std::exp(-0.5);
    const double error = 4 * q * std::exp(-0.5 * (20 + 1 / q - 1 - 1));
    QVERIFY(error > 5e-5 && error < 6e-5);
    QVERIFY2(m_plots->closedFormGraph()->name().contains(QStringLiteral("error of e < 6·10⁻⁵")),
             qPrintable(m_plots->closedFormGraph()->name()));
    QVERIFY(!m_plots->closedFormGraph()->data()->isEmpty());
    QVERIFY(m_plots->closedFormGraph()->pen().dashPattern() != m_plots->forceGraph()->pen().dashPattern());
    // It leaves out the tail of the first pulse, less than e^(−β(2τ − 1)).
    for (auto point = m_plots->closedFormGraph()->data()->constBegin();
         point != m_plots->closedFormGraph()->data()->constEnd(); ++point) {
        const auto exact = m_plots->forceGraph()->data()->findBegin(point->key, false);
        if (exact == m_plots->forceGraph()->data()->constEnd() || exact->key != point->key) continue;
        QVERIFY(std::abs(exact->value - point->value) < 2e-4);
    }
}

void TestBlowPlots::theClosedFormIsThereOnlyWhereItHolds() {
    const auto inLegends = [this] {
        int found = 0;
        for (QCPLegend* each : legends()) found += each->hasItemWithPlottable(m_plots->closedFormGraph());
        return found;
    };
    QCOMPARE(inLegends(), 1);
    m_plots->present(curvesFor(0.5, 0.5));
    QCOMPARE(inLegends(), 0);
    QVERIFY(m_plots->closedFormGraph()->data()->isEmpty());
    m_plots->present(curvesFor(0.6));
    QCOMPARE(inLegends(), 1);
    m_plots->present(curvesFor(1e-3));  // the reflections overlap
    QCOMPARE(inLegends(), 0);
}

void TestBlowPlots::aHiddenClosedFormStaysHidden() {
    m_plots->closedFormGraph()->setVisible(false);
    m_plots->present(curvesFor(0.6));
    m_plots->present(curvesFor(0.6, 0.5));
    m_plots->present(curvesFor(0.6));
    QVERIFY(!m_plots->closedFormGraph()->visible());
}

void TestBlowPlots::aGhostStaysBehindInNoLegend() {
    int entries = 0;
    for (QCPLegend* legend : legends()) entries += legend->itemCount();
    const BlowCurves before = curvesFor(0.5, 0.5);
    m_plots->present(before);
    m_plots->setGhost(&before);
    m_plots->present(curvesFor(50, 0.5));
    int drawn = 0;
    for (int i = 0; i < m_widget->graphCount(); ++i) {
        const QCPGraph* graph = m_widget->graph(i);
        if (graph->layer()->index() >= m_plots->forceGraph()->layer()->index()) continue;
        ++drawn;
        QVERIFY(graph->pen().color().alpha() < 255);
        QVERIFY(graph->pen().widthF() < m_plots->forceGraph()->pen().widthF());
        QVERIFY(graph->pen().dashPattern() != m_plots->forceGraph()->pen().dashPattern());
    }
    QCOMPARE(drawn, 7);
    for (QCPLegend* legend : legends()) entries -= legend->itemCount();
    QCOMPARE(entries, 1);  // the closed form of the elastic rock shown before
    // The data are shared with the blow they come from, and both stay in view.
    QCOMPARE(m_widget->graph(12)->data().get(), before.waves[0].get());
    m_plots->present(curvesFor(0.01, 0.5));
    QVERIFY(valueAxis(1)->range().upper > largestValue(*before.force));
    m_plots->setGhost(nullptr);
    QCOMPARE(m_widget->graphCount(), 12);
    QVERIFY(valueAxis(1)->range().upper < largestValue(*before.force));
}

void TestBlowPlots::aGhostInOtherUnitsGoes() {
    const BlowCurves before = curvesFor(0.5);
    m_plots->setGhost(&before);
    QCOMPARE(m_widget->graphCount(), 19);
    BlowCurves shown = curvesFor(0.5);
    shown.units.force = {3, QStringLiteral("kN"), false};
    m_plots->present(shown);
    QCOMPARE(m_widget->graphCount(), 12);
    // Another factor of the same unit is another blow in the same units.
    m_plots->setGhost(&shown);
    timeAxis(0)->setRange(10, 20);
    shown.units.force.factor = 4;
    m_plots->present(shown);
    QCOMPARE(m_widget->graphCount(), 19);
    QCOMPARE(timeAxis(0)->range(), QCPRange(10, 20));
}

void TestBlowPlots::aSectionIsNamedAsExactlyAsItWasChosen() {
    BlowCurves curves = curvesFor(0.5);
    curves.section = 0.125;
    m_plots->present(curves);
    QVERIFY(m_plots->textSummary().contains(QStringLiteral("x/L = 0.125")));
    curves.section = 0.25;
    m_plots->present(curves);
    QVERIFY(m_plots->textSummary().contains(QStringLiteral("x/L = 0.25:")));
}

void TestBlowPlots::laterWavesAreNamedWhereThereAreSuch() {
    const auto isNamed = [this](QCPGraph* graph) {
        for (QCPLegend* each : legends())
            if (each->hasItemWithPlottable(graph)) return true;
        return false;
    };
    QVERIFY(isNamed(m_plots->sectionForceGraph()));
    QVERIFY(m_plots->sectionForceGraph()->visible());
    QVERIFY(isNamed(m_plots->laterGraph(0)));
    QVERIFY(!isNamed(m_plots->laterGraph(1)));  // N5n begins where the plot ends
    BlowCurves few = curvesFor(0.5);
    few.laterWaves.fill(GraphData::create());
    m_plots->present(few);
    QVERIFY(!isNamed(m_plots->laterGraph(0)));
    QVERIFY(isNamed(m_plots->waveGraph(3)));
    m_plots->present(curvesFor(0.5));
    QVERIFY(isNamed(m_plots->laterGraph(0)));
}

// Begins with the mechanism: one line of entries, of which the last were cut at the edge.
void TestBlowPlots::theLegendTakesMoreLinesWhereOneHasNoRoom() {
    for (const QString& name : {QStringLiteral("shpb_steel945_0"), QStringLiteral("shpb_steel945_1")})
        m_plots->addOverlay(BlowPlots::Kind::waves, name);
    const auto right = [&] {
        double most = 0;
        for (const QCPLegend* legend : legends())
            for (int i = 0; i < legend->itemCount(); ++i)
                if (auto* entry = qobject_cast<QCPPlottableLegendItem*>(legend->item(i))) {
                    const QRect place = entry->rect();
                    const QFontMetricsF metrics(entry->font());
                    const double words = metrics.horizontalAdvance(entry->plottable()->name());
                    most = std::max(
                        most, place.left() + legend->iconSize().width() + legend->iconTextPadding() + words);
                }
        return most;
    };
    for (const int width : {1200, 700, 420}) {
        m_widget->resize(width, 800);
        m_widget->replot();
        m_widget->replot();  // by the widths of the layout before
        QVERIFY2(right() <= width, qPrintable(QStringLiteral("%1 of %2").arg(right()).arg(width)));
    }
    // As before where there is room again.
    m_widget->resize(1200, 800);
    m_widget->replot();
    m_widget->replot();
    for (const QCPLegend* legend : legends()) QCOMPARE(legend->rowCount(), 1);
}

QTEST_MAIN(TestBlowPlots)
#include "tst_blow_plots.moc"

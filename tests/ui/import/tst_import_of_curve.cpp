// SPDX-License-Identifier: GPL-3.0-or-later
// Measured signals over the page Blow: in their place, shifted, removed.
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/model/scales.h"
#include "core/wave/field/wave_field.h"
#include "core/yaml/examples.h"
#include "tests/support/import_fixture.h"
#include "tests/support/window_parts.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/import/import_dialog.h"
#include "ui/job/solve_job.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/blow/measured_curves.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;
using namespace drillwave::test;

class TestImportOfCurve : public QObject, private ImportFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void cleanup() { m_window.reset(); }
    void aMeasuredForceLiesOnTheComputedOneOfTheSameBlow_data();
    void aMeasuredForceLiesOnTheComputedOneOfTheSameBlow();
    void anExportedCurveIsReadBack();
    void measuredCurvesAreShiftedAndRemoved();
    void theMeasuredRowFollowsTheUnits();
};

void TestImportOfCurve::aMeasuredForceLiesOnTheComputedOneOfTheSameBlow_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<bool>("atBit");
    QTest::addRow("N, 50 points") << 50 << false;
    QTest::addRow("N, 1000 points") << 1000 << false;
    QTest::addRow("F, 200 points") << 200 << true;
}

// N(t) of the example at mid-rod, or its impact force, written as a recorder would, comes back through the
// dialog, and its curve on the page is no further from the computed one than the dialog has said.
void TestImportOfCurve::aMeasuredForceLiesOnTheComputedOneOfTheSameBlow() {
    QFETCH(int, points);
    QFETCH(bool, atBit);
    const SolvedBlowPtr blow = m_window->shown();
    const WaveField field(blow->impact);
    const Scales scales = scalesOf(blow->request.scenario);
    QByteArray bytes("t [us];force [kN]\n");
    constexpr int samples = 20000;
    for (int i = 0; i <= samples; ++i) {
        const double t = 15.0 * i / samples;
        const double force = atBit ? field.impactForce(t) : field.force(0.5, t);
        bytes += QByteArray::number(1e6 * t * scales.time, 'g', 17) + ';' +
                 QByteArray::number(1e-3 * force * scales.force, 'g', 17) + '\n';
    }
    ImportDialog& dialog =
        open(write("computed.csv", bytes), atBit ? ImportUse::impactForce : ImportUse::normalForce);
    control<QSpinBox>(dialog, "points").setValue(points);
    if (!atBit) type(dialog, "place", QString::number(blow->request.scenario.rod.length / 2) + " m");
    if (atBit) choose(dialog, "positive", QStringLiteral("compression"));
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    const double deviation = dialog.result()->deviation;
    control<QPushButton>(dialog, "take").click();
    auto* page = m_window->findChild<BlowPage*>();
    QCOMPARE(page->measuredCurves()->graphs().size(), 1);
    const QCPGraph* graph = page->measuredCurves()->graphs().first();
    QVERIFY(graph->data()->size() <= points);
    // Moved away it is put back where it fits.
    type(*page, "measuredShift", QStringLiteral("130 us"));
    page->findChild<QPushButton*>(QStringLiteral("alignMeasured"))->click();
    const std::optional<double> shift =
        page->findChild<QuantityField*>(QStringLiteral("measuredShift"))->value();
    QVERIFY2(std::abs(*shift) < 2e-6, qPrintable(QString::number(*shift)));
    type(*page, "measuredShift", QStringLiteral("0"));
    const ShownUnits& units = blow->units;
    double largest = 0;
    auto next = graph->data()->constBegin();
    for (int i = 0; i <= samples; ++i) {
        const double t = 15.0 * i / samples;
        const double shownTime = t * units.time.factor;
        while (next + 1 != graph->data()->constEnd() && (next + 1)->key < shownTime) ++next;
        if (next + 1 == graph->data()->constEnd()) break;
        const auto &a = *next, &b = *(next + 1);
        const double line = a.value + (b.value - a.value) * (shownTime - a.key) / (b.key - a.key);
        const double force = atBit ? field.impactForce(t) : field.force(0.5, t);
        largest = std::max(largest, std::abs(line / units.force.factor - force) * scales.force);
    }
    // Beside it nothing but the rounding of times where the force jumps.
    QVERIFY2(largest <= deviation * (1 + 1e-6) + 1e-3,
             qPrintable(QStringLiteral("%1 N, said %2 N").arg(largest).arg(deviation)));
    QVERIFY(deviation > 0);
}

// The data of the page, exported and imported again: jumps, blank cells and other columns included.
void TestImportOfCurve::anExportedCurveIsReadBack() {
    auto* page = m_window->findChild<BlowPage*>();
    ImportDialog& dialog = open(write("exported.csv", page->plot()->csv()), ImportUse::impactForce);
    choose(dialog, "valueColumn", QStringLiteral("impact force"));
    auto& time = control<ChoiceBox>(dialog, "timeColumn");
    time.setCurrentIndex(control<ChoiceBox>(dialog, "valueColumn").currentIndex() - 1);
    choose(dialog, "wrongRows", QStringLiteral("skip"));
    choose(dialog, "positive", QStringLiteral("compression"));
    control<QSpinBox>(dialog, "points").setValue(100'000);
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    const QCPGraph* drawn = page->plots()->forceGraph();
    const double peak = std::max_element(drawn->data()->constBegin(), drawn->data()->constEnd(),
                                         [](const auto& a, const auto& b) { return a.value < b.value; })
                            ->value;
    QVERIFY(std::abs(dialog.result()->peak / 1e3 / peak - 1) < 1e-12);
    const SolvedBlow& blow = *m_window->shown();
    const double impulse = blow.summary.impulse * scalesOf(blow.request.scenario).impulse;
    // The drawn chords of a curve that is drawn as straight lines between exact points.
    QVERIFY2(std::abs(dialog.result()->impulse / impulse - 1) < 1e-3,
             qPrintable(QString::number(dialog.result()->impulse / impulse, 'g', 9)));
}

void TestImportOfCurve::measuredCurvesAreShiftedAndRemoved() {
    auto* page = m_window->findChild<BlowPage*>();
    auto* bar = m_window->findChild<QWidget*>(QStringLiteral("measured"));
    QVERIFY(!bar->isVisible());
    for (int i = 0; i < 2; ++i) {
        ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
        type(dialog, "place", QStringLiteral("1 m"));
        QVERIFY(settle(dialog));
        control<QPushButton>(dialog, "take").click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY(bar->isVisible());
    const auto graph = [page](int i) { return page->measuredCurves()->graphs().at(i); };
    QCOMPARE(page->measuredCurves()->graphs().size(), 2);
    QCOMPARE(graph(1)->name(), QStringLiteral("record (2)"));
    QVERIFY(graph(0)->pen().color() != graph(1)->pen().color());
    QVERIFY(graph(0)->pen().dashPattern() != graph(1)->pen().dashPattern());
    // 1 m of 3.66 m: the section that is on show now.
    QVERIFY(std::abs(m_window->findChild<QDoubleSpinBox*>(QStringLiteral("section"))->value() - 0.273) <
            1e-9);
    const double before = graph(1)->data()->at(0)->key;
    QUndoStack& history = m_window->document().undoStack();
    const int steps = history.count();
    type(*bar, "measuredShift", QStringLiteral("250 us"));
    QCOMPARE(history.count(), steps + 1);
    QCOMPARE(history.undoText(), QStringLiteral("shift the measured curve record (2)"));
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(std::abs(graph(1)->data()->at(0)->key - before - 0.25) < 1e-9);
    QVERIFY(graph(0)->data()->at(0)->key == before);
    // It outlives a blow that cannot be solved, and one without units.
    page->setResult(failedBlow(m_window->shown()->request, QStringLiteral("too stiff")));
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    m_window->document().startFrom(findExample("paper_fig4b")->text, QStringLiteral("paper"));
    QTRY_VERIFY(!part<SolveJob>(*m_window).isBusy());
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    QVERIFY(bar->isVisible());
    m_window->document().startFrom(defaultExample().text, QStringLiteral("rod"));
    QTRY_COMPARE(page->measuredCurves()->graphs().size(), 2);
    // It stays where it is when the scenario changes, and other units show the same.
    Document& document = m_window->document();
    document.assign(*findParameter("pulse.duration"), 150e-6, document.newGesture());
    QTRY_VERIFY(!part<SolveJob>(*m_window).isBusy());
    QVERIFY(std::abs(graph(0)->data()->at(0)->key - before) < 1e-9);
    control<QToolButton>(*bar, "removeMeasured").click();
    QCOMPARE(page->measuredCurves()->graphs().size(), 1);
    history.undo();
    QCOMPARE(page->measuredCurves()->graphs().size(), 2);
    QCOMPARE(graph(1)->name(), QStringLiteral("record (2)"));
    history.redo();
    QCOMPARE(page->measuredCurves()->graphs().size(), 1);
    control<QToolButton>(*bar, "removeMeasured").click();
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    QVERIFY(!bar->isVisible());
}

void TestImportOfCurve::theMeasuredRowFollowsTheUnits() {
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    type(dialog, "place", QStringLiteral("1.5 m"));
    QVERIFY(settle(dialog));
    control<QPushButton>(dialog, "take").click();
    const auto& place = control<QPushButton>(*m_window, "measuredPlace");
    const auto& box = control<ChoiceBox>(*m_window, "measuredSignal");
    const QString before = place.text() + box.toolTip();
    QVERIFY2(place.text().endsWith(QStringLiteral("m")), qPrintable(place.text()));
    UnitChoice& units = m_window->document().units();
    units.choose(UnitSystem::us);
    const QString after = place.text(), toolTip = box.toolTip();
    units.choose(UnitSystem::si);
    QVERIFY2(after.endsWith(QStringLiteral("ft")) || after.endsWith(QStringLiteral("in")), qPrintable(after));
    QVERIFY2(toolTip.contains(QStringLiteral("lbf")) || toolTip.contains(QStringLiteral("kip")),
             qPrintable(toolTip));
    QCOMPARE(place.text() + box.toolTip(), before);
}

QTEST_MAIN(TestImportOfCurve)
#include "tst_import_of_curve.moc"

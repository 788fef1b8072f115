// SPDX-License-Identifier: GPL-3.0-or-later
// Measured signals over the page Blow: in their place, shifted, removed.
#include <QComboBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/model/scales.h"
#include "core/wave/field/wave_field.h"
#include "core/yaml/examples.h"
#include "core/yaml/recorder_file.h"
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
    void aGaugeLiesOverADrillString_data();
    void aGaugeLiesOverADrillString();
    void aStrainOfAStringTakesTheSectionOfTheGauge();
    void settingsOfARecorderAreKeptByNameAndOffered();
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
    QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(*m_window).isBusy(), 60000);
    QVERIFY(page->measuredCurves()->graphs().isEmpty());
    QVERIFY(bar->isVisible());
    m_window->document().startFrom(defaultExample().text, QStringLiteral("rod"));
    QTRY_COMPARE(page->measuredCurves()->graphs().size(), 2);
    // It stays where it is when the scenario changes, and other units show the same.
    Document& document = m_window->document();
    document.assign(*findParameter("pulse.duration"), 150e-6, document.newGesture());
    QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(*m_window).isBusy(), 60000);
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

void TestImportOfCurve::aGaugeLiesOverADrillString_data() {
    QTest::addColumn<double>("place");
    QTest::addRow("in a rod") << 2.5;
    QTest::addRow("in a coupling") << 4.4;
    QTest::addRow("in the hammer") << -0.2;
    QTest::addRow("at the bit") << 12.13;
}

// N(t) at a place of the string, nine tenths of it and 130 µs late, comes back through the dialog: it lies
// over the waves of that section, what is read beside it is what was done to it, and Align takes the delay
// away.
void TestImportOfCurve::aGaugeLiesOverADrillString() {
    QFETCH(double, place);
    constexpr double late = 130e-6, factor = 0.9;
    m_window->document().startFrom(findExample("t38_string")->text, QStringLiteral("string"));
    QTRY_VERIFY(m_window->shown()->isOfString() && !part<SolveJob>(*m_window).isBusy());
    const SolvedBlowPtr blow = m_window->shown();
    const BlowWaves waves(*blow);
    const Scales scales = scalesOf(blow->request.scenario);
    const double length = chainProperties(blow->request.scenario).length;
    QByteArray bytes("t [us];N [kN]\n");
    constexpr int samples = 8000;
    for (int i = 0; i <= samples; ++i) {
        const double t = waves.end() * i / samples;
        const double force = factor * waves.value(WaveQuantity::force, place / length, t);
        bytes += QByteArray::number(1e6 * (t * scales.time + late), 'g', 17) + ';' +
                 QByteArray::number(1e-3 * force * scales.force, 'g', 17) + '\n';
    }
    ImportDialog& dialog = open(write("gauge.csv", bytes), ImportUse::normalForce);
    type(dialog, "place", QStringLiteral("12.2 m"));
    QVERIFY(settle(dialog));
    QVERIFY2(message(dialog).contains(QStringLiteral("the length of the string")),
             qPrintable(message(dialog)));
    control<QSpinBox>(dialog, "points").setValue(samples + 1);
    type(dialog, "place", QString::number(place) + " m");
    QVERIFY(settle(dialog));
    QVERIFY2(dialog.result() != nullptr, qPrintable(message(dialog)));
    control<QPushButton>(dialog, "take").click();
    auto* page = m_window->findChild<BlowPage*>();
    QCOMPARE(page->measuredCurves()->graphs().size(), 1);
    QVERIFY(page->measuredCurves()->graphs().first()->data()->size() > 1000);
    // The section of the gauge is the one on show.
    const double section = m_window->findChild<QDoubleSpinBox*>(QStringLiteral("section"))->value();
    QVERIFY2(std::abs(section - place / length) < 6e-4, qPrintable(QString::number(section)));
    const auto& misfit = control<QLabel>(*page, "measuredMisfit");
    QVERIFY(misfit.isVisibleTo(page));
    QVERIFY2(misfit.text().contains(QStringLiteral("lag 0.13\u00a0ms")), qPrintable(misfit.text()));
    const QString apart = misfit.text();
    page->findChild<QPushButton*>(QStringLiteral("alignMeasured"))->click();
    const double shift = *page->findChild<QuantityField*>(QStringLiteral("measuredShift"))->value();
    QVERIFY2(std::abs(shift + late) < 2e-6, qPrintable(QString::number(shift)));
    QVERIFY(misfit.text() != apart);
    type(*page, "measuredShift", QStringLiteral("-130 us"));
    // The largest force in size is a tenth less; samples pass an exact peak by a little.
    const QRegularExpression percent(QStringLiteral("\\(([-\u2212]?[0-9.,]+) %\\)"));
    const QRegularExpressionMatch match = percent.match(misfit.text());
    QVERIFY2(match.hasMatch(), qPrintable(misfit.text()));
    QString shown = match.captured(1);
    const double peaks =
        shown.replace(QChar(0x2212), QLatin1Char('-')).replace(QLatin1Char(','), QLatin1Char('.')).toDouble();
    QVERIFY2(std::abs(peaks + 10) < 0.5, qPrintable(misfit.text()));
}

// The same strain is a larger force in a coupling than in a rod, by their areas, and the dialog knows both.
void TestImportOfCurve::aStrainOfAStringTakesTheSectionOfTheGauge() {
    m_window->document().startFrom(findExample("t38_string")->text, QStringLiteral("string"));
    QTRY_VERIFY(m_window->shown()->isOfString() && !part<SolveJob>(*m_window).isBusy());
    ImportDialog& dialog = open(write("record.csv", gaugeRecord()), ImportUse::normalForce);
    choose(dialog, "bar", QStringLiteral("string"));
    const auto peakAt = [&](const char* place) {
        type(dialog, "place", QLatin1String(place));
        return settle(dialog) && dialog.result() ? dialog.result()->peak : 0;
    };
    const double inRod = peakAt("2.5 m"), inCoupling = peakAt("4.4 m");
    // 56 mm and 39 mm, both with the hole of 14.5 mm.
    const double areas = (56.0 * 56 - 14.5 * 14.5) / (39.0 * 39 - 14.5 * 14.5);
    QVERIFY(inRod != 0);
    QVERIFY2(std::abs(inCoupling / inRod / areas - 1) < 1e-6,
             qPrintable(QString::number(inCoupling / inRod)));
}

void TestImportOfCurve::settingsOfARecorderAreKeptByNameAndOffered() {
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
    QByteArray bytes("n;t;A;B\n");  // neither column has a unit
    for (int i = 0; i <= 400; ++i)
        bytes += QByteArray::number(i) + ';' + QByteArray::number(0.5 * i) + ';' +
                 QByteArray::number(-2 * std::sin(M_PI * std::clamp((i - 100) / 100.0, 0.0, 1.0)), 'f', 4) +
                 ";0.5\n";
    const auto next = [&](const QString& name) -> ImportDialog& {
        return open(write(name, bytes), ImportUse::impactForce);
    };
    ImportDialog& first = next("first.csv");
    QVERIFY(settle(first));
    QVERIFY(first.result() == nullptr);
    choose(first, "timeColumn", "column 2");
    choose(first, "timeUnit", QStringLiteral("µs"));
    choose(first, "valueColumn", "column 3");
    choose(first, "kind", "voltage");
    choose(first, "valueUnit", "V");
    type(first, "forcePerVolt", "50");
    QVERIFY(settle(first));
    QVERIFY2(first.result(), qPrintable(message(first)));
    const double peak = first.result()->peak;
    QVERIFY(std::abs(std::abs(peak) / 100e3 - 1) < 1e-3);
    QVERIFY(!control<QPushButton>(first, "keepRecorder").isEnabled());
    control<QComboBox>(first, "recorder").setEditText("rig A");
    control<QPushButton>(first, "keepRecorder").click();
    control<QPushButton>(first, "take").click();
    const RecorderFile kept = loadRecorders(m_folder.filePath("drillwave/recorders.yaml").toStdString());
    QVERIFY(kept.problems.empty());
    QVERIFY(findRecorder(kept.recorders, "rig A"));

    for (const QString& name : {QStringLiteral("rig A"), QStringLiteral("as in the last import")}) {
        ImportDialog& again = next("again.csv");
        QVERIFY(settle(again));
        QVERIFY(again.result() == nullptr);  // nothing is taken over unasked
        auto& box = control<QComboBox>(again, "recorder");
        const int index = box.findText(name);
        QVERIFY2(index >= 0, qPrintable(name));
        box.setCurrentIndex(index);
        emit box.activated(index);
        QVERIFY(settle(again));
        QVERIFY2(again.result(), qPrintable(message(again)));
        QCOMPARE(again.result()->peak, peak);
        again.reject();
    }
}

QTEST_MAIN(TestImportOfCurve)
#include "tst_import_of_curve.moc"

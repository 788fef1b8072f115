// SPDX-License-Identifier: GPL-3.0-or-later
// Presets in the panel: chosen, recognised, undone, and those of the user's own files.
#include <QDir>
#include <QMenu>

#include "tests/support/panel_fixture.h"

using namespace drillwave;

namespace {

const QByteArray mine =
    "drillwave_presets: 1\nrods:\n  - name: my & rod\n    diameter: [41 mm, measured]\n    bore: [13 mm, "
    "measured]\n";

QAction* action(PresetBox& box, const QString& text) {
    for (QAction* each : box.menu()->actions())
        if (each->text().contains(text)) return each;
    return nullptr;
}

}  // namespace

class TestPresetBox : public QObject {
    Q_OBJECT

  private slots:
    void init() { m = std::make_unique<PanelFixture>(); }
    void cleanup() { m.reset(); }
    void thePresetOfTheExampleIsRecognised();
    void aPresetIsOneNamedStepAndUndoRestoresTheBytes();
    void everyPresetOfTheMenuSaysWhereItIsFrom();
    void anEditMakesItCustom();
    void groupsAloneTakeNoPresetsAndSayWhy();
    void aPresetThatDoesNotFitIsReported();
    void anOpenMenuDoesNothingToGroups();
    void theUsersOwnFileIsOffered();
    void anAddedFileIsOfferedNowAndLater();
    void aBadFileIsExplainedAndNotAdded();
    void aFileThatWentBadIsExplainedAndCanBeTakenOff();

  private:
    PresetBox& rods() { return m->find<PresetBox>("preset.0"); }
    PresetBox& hammers() { return m->find<PresetBox>("preset.1"); }
    PresetBox& rocks() { return m->find<PresetBox>("preset.2"); }

    std::unique_ptr<PanelFixture> m;
};

void TestPresetBox::thePresetOfTheExampleIsRecognised() {
    QCOMPARE(rods().currentText(), QStringLiteral("T38, round 38 mm"));
    QCOMPARE(hammers().currentText(), QStringLiteral("medium drifter"));
    QCOMPARE(rocks().currentText(), QStringLiteral("medium rock"));
    QVERIFY(rods().toolTip().contains(QStringLiteral("14.5 mm")));
    QVERIFY(rods().accessibleDescription().contains(QStringLiteral("Epiroc catalogue 9866 0424")));
}

void TestPresetBox::aPresetIsOneNamedStepAndUndoRestoresTheBytes() {
    const QByteArray before = m->document.text();
    action(rods(), QStringLiteral("T45, round 46 mm"))->trigger();
    QCOMPARE(m->document.undoStack().count(), 1);
    QCOMPARE(m->document.undoStack().undoText(), QStringLiteral("take the preset T45, round 46 mm"));
    QCOMPARE(m->document.scenario().rod.diameter, 0.046);
    QCOMPARE(rods().currentText(), QStringLiteral("T45, round 46 mm"));
    action(hammers(), QStringLiteral("heavy drifter"))->trigger();
    action(rocks(), QStringLiteral("hard rock"))->trigger();
    QCOMPARE(m->document.undoStack().count(), 3);
    QVERIFY(m->document.scenario().pulse.shape == PulseShape::piston);
    QVERIFY(action(rods(), QStringLiteral("T45, round 46 mm"))->isChecked());
    // The same once more is no step.
    action(rocks(), QStringLiteral("hard rock"))->trigger();
    QCOMPARE(m->document.undoStack().count(), 3);
    m->undoAll();
    QCOMPARE(m->document.text(), before);
    QCOMPARE(rods().currentText(), QStringLiteral("T38, round 38 mm"));
}

void TestPresetBox::everyPresetOfTheMenuSaysWhereItIsFrom() {
    int presets = 0;
    for (const QAction* each : rods().menu()->actions()) {
        if (!each->isCheckable()) continue;
        QVERIFY2(each->toolTip().contains(QStringLiteral("—")), qPrintable(each->text()));
        ++presets;
    }
    QVERIFY(presets >= 6);
}

void TestPresetBox::anEditMakesItCustom() {
    m->document.assign(*findParameter("rod.bore"), 0.012, 1);
    QCOMPARE(rods().currentText(), QStringLiteral("custom"));
    m->document.undoStack().undo();
    QCOMPARE(rods().currentText(), QStringLiteral("T38, round 38 mm"));
}

void TestPresetBox::groupsAloneTakeNoPresetsAndSayWhy() {
    m->document.startFrom(findExample("paper_fig4a")->text, QStringLiteral("paper"));
    QVERIFY(!hammers().isEnabled());
    QVERIFY(hammers().toolTip().contains(QStringLiteral("dimensionless groups")));
}

void TestPresetBox::aPresetThatDoesNotFitIsReported() {
    // The hammer would be two million times as stiff as this wire.
    m->document.assign(*findParameter("rod.area"), 1e-9, 1);
    const QByteArray before = m->document.text();
    action(hammers(), QStringLiteral("heavy drifter"))->trigger();
    QCOMPARE(m->answers.told.size(), 1);
    QVERIFY(m->answers.told.first().contains(QStringLiteral("too many steps to follow")));
    QCOMPARE(m->document.text(), before);
    QCOMPARE(hammers().currentText(), QStringLiteral("medium drifter"));
}

void TestPresetBox::anOpenMenuDoesNothingToGroups() {
    QAction* chosen = action(hammers(), QStringLiteral("heavy drifter"));
    m->document.startFrom(findExample("paper_fig4a")->text, QStringLiteral("example"));
    const QByteArray before = m->document.text();
    chosen->trigger();
    QCOMPARE(m->answers.told.size(), 1);
    QVERIFY(m->answers.told.first().contains(QStringLiteral("physical units")));
    QCOMPARE(m->document.text(), before);
}

void TestPresetBox::theUsersOwnFileIsOffered() {
    QVERIFY(!action(rods(), QStringLiteral("my && rod")));
    QVERIFY(QDir().mkpath(PresetLibrary::folder()));
    m->write(QStringLiteral("config/drillwave/presets.yaml"), mine);
    action(rods(), QStringLiteral("my && rod"))->trigger();
    QCOMPARE(m->document.scenario().rod.diameter, 0.041);
    QCOMPARE(rods().currentText(), QStringLiteral("my & rod"));
    QVERIFY(action(rods(), QStringLiteral("T38, round 38 mm")));
}

void TestPresetBox::anAddedFileIsOfferedNowAndLater() {
    m->answers.import = m->write(QStringLiteral("added.yaml"), mine);
    action(rods(), QStringLiteral("Add file"))->trigger();
    QVERIFY(action(rods(), QStringLiteral("my && rod")));
    m->makePanel();
    action(rods(), QStringLiteral("my && rod"))->trigger();
    QCOMPARE(rods().currentText(), QStringLiteral("my & rod"));
    action(rods(), QStringLiteral("Remove these"))->trigger();
    QVERIFY(!action(rods(), QStringLiteral("my && rod")));
    QCOMPARE(rods().currentText(), QStringLiteral("custom"));
    QVERIFY(m->answers.told.isEmpty());
}

void TestPresetBox::aBadFileIsExplainedAndNotAdded() {
    m->answers.import =
        m->write(QStringLiteral("bad.yaml"),
                 "drillwave_presets: 1\nrods:\n  - name: bad\n    diameter: [41, measured]\n");
    action(rods(), QStringLiteral("Add file"))->trigger();
    QCOMPARE(m->answers.told.size(), 1);
    QVERIFY2(
        m->answers.told.first().contains(QStringLiteral("bad.yaml:4:16: rod.diameter = 41 (has no unit")),
        qPrintable(m->answers.told.first()));
    QVERIFY(!action(rods(), QStringLiteral("bad")));
    QVERIFY(action(rods(), QStringLiteral("T38, round 38 mm")));
}

void TestPresetBox::aFileThatWentBadIsExplainedAndCanBeTakenOff() {
    m->answers.import = m->write(QStringLiteral("added.yaml"), mine);
    action(rods(), QStringLiteral("Add file"))->trigger();
    QVERIFY(QFile::remove(m->answers.import));
    QVERIFY(action(rods(), QStringLiteral("T38, round 38 mm")));
    m->answers.confirm = true;
    action(rods(), QStringLiteral("added.yaml is not used"))->trigger();
    QCOMPARE(m->answers.confirmed.size(), 1);
    QVERIFY(m->answers.confirmed.first().contains(QStringLiteral("cannot be opened")));
    QVERIFY(!action(rods(), QStringLiteral("added.yaml")));
}

QTEST_MAIN(TestPresetBox)
#include "tst_preset_box.moc"

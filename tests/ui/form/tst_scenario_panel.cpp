// SPDX-License-Identifier: GPL-3.0-or-later
// The form of a scenario: the hammer blow with its drawing and tables, sliders, folding, and that undo takes
// everything back.
#include <QLineEdit>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalSpy>

#include "core/model/scales.h"
#include "tests/support/panel_fixture.h"
#include "ui/form/pulse_preview.h"
#include "ui/text/shown_text.h"

using namespace drillwave;

namespace {

const QByteArray table = "time [us],force [kN]\n0,0\n50,300\n150,300\n200,0\n";

int coloured(const QImage& image) {
    const QRgb background = image.pixel(3, image.height() / 2);
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) != background;
    return count;
}

}  // namespace

class TestScenarioPanel : public QObject {
    Q_OBJECT

  private slots:
    void init() { m = std::make_unique<PanelFixture>(); }
    void cleanup() { m.reset(); }
    void theDrawingFollowsTheBlow();
    void everyShapeIsDrawn_data();
    void everyShapeIsDrawn();
    void aLongTableIsDrawnWithItsPeak();
    void aTableIsChosenThroughTheMenuOfShapes();
    void givingUpAFileKeepsTheShape();
    void aBadTableIsExplainedAndTheOldBlowKept_data();
    void aBadTableIsExplainedAndTheOldBlowKept();
    void aChangedTableIsReloaded();
    void pointsOfTheScenarioItselfAreCountedAndKept();
    void aTableIsNamedRelativeToItsScenario();
    void aDragEndsEvenWhenThePanelIsHidden();
    void keysOnASliderAreOneStepUntilItIsLeft();
    void aValueBeyondTheSliderIsMarked();
    void tipsTellRangesInTheUnitThatIsShown();
    void aSliderSaysWhyItStopsAndGoesBack();
    void aClickInTheGrooveBringsTheHandleThere();
    void shiftDragsTenTimesFiner();
    void aDoubleClickGoesBackToTheFilesValue();
    void wrongTextMovesNoOtherRow();
    void anotherImpulseScalesAMeasuredBlow();
    void foldedSectionsStayFolded();
    void groupsAreLastAndFoldedWhereTheyFollow();
    void wrongTextForTheDiameterBringsTheAreaBack();
    void undoTakesBackFiveHundredRandomEdits();

  private:
    QComboBox& shape() { return m->find<QComboBox>("pulse.shape"); }
    PulsePreview& preview() { return m->find<PulsePreview>("pulsePreview"); }
    QuantitySlider& slider(const char* key) { return m->find<QuantitySlider>(key); }
    bool takeTable(const QByteArray& bytes) {
        m->answers.import = m->write(QStringLiteral("blow.csv"), bytes);
        return PanelFixture::choose(shape(), QStringLiteral("table from a file…"));
    }

    std::unique_ptr<PanelFixture> m;
};

void TestScenarioPanel::theDrawingFollowsTheBlow() {
    QCOMPARE(preview().words(), QStringLiteral("rectangular, 200\u00a0µs, 255\u00a0kN"));
    QCOMPARE(preview().accessibleDescription(), preview().words());
    const QImage before = preview().grab().toImage();
    QVERIFY(PanelFixture::choose(shape(), QStringLiteral("half sine")));
    // The impulse stays, so that the peak of a half sine is π/2 times the mean.
    QCOMPARE(preview().words(), QStringLiteral("half sine, 200\u00a0µs, 401\u00a0kN"));
    QVERIFY(preview().grab().toImage() != before);
    m->document.assign(*findParameter("pulse.duration"), 400e-6, 1);
    QCOMPARE(preview().words(), QStringLiteral("half sine, 400\u00a0µs, 200\u00a0kN"));
    m->undoAll();
    QCOMPARE(preview().grab().toImage(), before);
    m->document.startFrom(findExample("paper_fig4a")->text, QStringLiteral("paper"));
    QCOMPARE(preview().words(), QStringLiteral("rectangular, t₀, F₀"));
}

void TestScenarioPanel::everyShapeIsDrawn_data() {
    QTest::addColumn<QString>("name");
    for (const std::string_view each : pulseShapeNames()) {
        const QString text = fromView(each);
        if (text != QLatin1String("table")) QTest::newRow(qPrintable(text)) << text;
    }
}

void TestScenarioPanel::everyShapeIsDrawn() {
    QFETCH(QString, name);
    QVERIFY(PanelFixture::choose(shape(), QString(name).replace(u'_', u' ')));
    QVERIFY(m->document.scenario().pulse.shape == *findPulseShape(name.toStdString()));
    QVERIFY(!preview().words().isEmpty());
    QVERIFY(coloured(preview().grab().toImage()) > 200);
    m->undoAll();
    QVERIFY(!m->document.isModified());
}

void TestScenarioPanel::aLongTableIsDrawnWithItsPeak() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::table;
    std::vector<TablePoint> points;
    for (int i = 0; i < 100000; ++i) points.push_back({i * 1e-8, i == 4711 ? 9e5 : 1e5});
    scenario.pulse.tablePoints = std::move(points);
    const PulseCurve curve(pulseForceOf(scenario));
    QVERIFY(curve.points.size() < 5000);
    double highest = 0;
    for (const QPointF& point : curve.points) highest = std::max(highest, point.y());
    QCOMPARE(highest, 1.0);
}

void TestScenarioPanel::aTableIsChosenThroughTheMenuOfShapes() {
    const QByteArray before = m->document.text();
    QVERIFY(takeTable(table));
    QVERIFY(m->document.scenario().pulse.shape == PulseShape::table);
    QCOMPARE(m->document.scenario().pulse.tablePoints.size(), std::size_t(4));
    QCOMPARE(shape().currentText(), QStringLiteral("table"));
    auto& text = m->find<QLabel>("tableText");
    QVERIFY(text.isVisible());
    QVERIFY2(text.text().contains(QStringLiteral("4 points")) &&
                 text.text().contains(QStringLiteral("200\u00a0µs")) &&
                 text.text().contains(QStringLiteral("45")) &&
                 text.text().contains(QStringLiteral("blow.csv")),
             qPrintable(text.text()));
    QCOMPARE(preview().words(), QStringLiteral("table, 200\u00a0µs, 300\u00a0kN"));
    QCOMPARE(m->document.undoStack().count(), 1);
    m->undoAll();
    QCOMPARE(m->document.text(), before);
    QVERIFY(!text.isVisible());
}

void TestScenarioPanel::givingUpAFileKeepsTheShape() {
    QVERIFY(PanelFixture::choose(shape(), QStringLiteral("table from a file…")));
    QCOMPARE(m->answers.importAsked, 1);
    QCOMPARE(shape().currentText(), QStringLiteral("rectangular"));
    QVERIFY(!m->document.isModified());
    QVERIFY(m->answers.told.isEmpty());
}

void TestScenarioPanel::aBadTableIsExplainedAndTheOldBlowKept_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no units") << QByteArray("time,force\n0,0\n1,1\n") << "blow.csv:1:1: `time` (needs a unit";
    QTest::newRow("time goes back") << QByteArray("time [us],force [kN]\n0,0\n20,3\n10,3\n")
                                    << "blow.csv:4:1";
    QTest::newRow("no number") << QByteArray("time [us],force [kN]\n0,0\n20,x\n")
                               << "blow.csv:2:1: needs at least two rows of numbers";
    QTest::newRow("not text") << QByteArray("\x00\x01", 2) << "is not text";
    QTest::newRow("empty") << QByteArray() << "holds no header";
}

void TestScenarioPanel::aBadTableIsExplainedAndTheOldBlowKept() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, reason);
    QVERIFY(takeTable(bytes));
    QCOMPARE(m->answers.told.size(), 1);
    QVERIFY2(m->answers.told.first().contains(reason), qPrintable(m->answers.told.first()));
    QVERIFY(!m->document.isModified());
    QCOMPARE(shape().currentText(), QStringLiteral("rectangular"));
}

void TestScenarioPanel::aChangedTableIsReloaded() {
    QVERIFY(takeTable(table));
    m->write(QStringLiteral("blow.csv"), QByteArray(table).replace("300", "400"));
    m->find<QPushButton>("reloadTable").click();
    QCOMPARE(preview().words(), QStringLiteral("table, 200\u00a0µs, 400\u00a0kN"));
    QCOMPARE(m->document.undoStack().count(), 2);
    m->write(QStringLiteral("blow.csv"), "time [us],force [kN]\n0,-1\n");
    m->find<QPushButton>("reloadTable").click();
    QCOMPARE(m->answers.told.size(), 1);
    QCOMPARE(preview().words(), QStringLiteral("table, 200\u00a0µs, 400\u00a0kN"));
    // The shape can be left and taken up again without the file.
    QVERIFY(PanelFixture::choose(shape(), QStringLiteral("rectangular")));
    QVERIFY(PanelFixture::choose(shape(), QStringLiteral("table")));
    QCOMPARE(m->answers.importAsked, 1);
}

void TestScenarioPanel::pointsOfTheScenarioItselfAreCountedAndKept() {
    Scenario scenario = m->document.scenario();
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tablePoints = {{0, 0}, {1e-4, 3e5}, {2e-4, 0}};
    const std::string text = writeScenario({scenario, {}, {}});
    QCOMPARE(m->document.startFrom(text, QStringLiteral("inline")), QString());
    QVERIFY(m->find<QLabel>("tableText").text().contains(QStringLiteral("3 points")));
    QVERIFY(m->find<QLabel>("tableText").text().contains(QStringLiteral("kept in the scenario itself")));
    QVERIFY(!m->find<QPushButton>("reloadTable").isVisible());
    m->find<QPushButton>("chooseTable").click();  // and give up
    QCOMPARE(m->document.text(), QByteArray::fromStdString(text));
}

void TestScenarioPanel::aTableIsNamedRelativeToItsScenario() {
    QCOMPARE(m->document.save(m->folder.filePath(QStringLiteral("rod.yaml"))), QString());
    QVERIFY(takeTable(table));
    QCOMPARE(m->document.scenario().pulse.tableFile, std::string("blow.csv"));
    QCOMPARE(m->document.tablePath(), m->folder.filePath(QStringLiteral("blow.csv")));
    m->find<QPushButton>("reloadTable").click();
    QVERIFY(m->answers.told.isEmpty());
    QCOMPARE(m->document.undoStack().count(), 1);  // the same again is no step
}

void TestScenarioPanel::aDragEndsEvenWhenThePanelIsHidden() {
    QSignalSpy started(m->panel.get(), &ScenarioPanel::dragStarted);
    QSignalSpy ended(m->panel.get(), &ScenarioPanel::dragEnded);
    m->find<SectionBox>("groups").setOpen(true);
    QuantitySlider& beta = slider("beta.slider");
    beta.setSliderDown(true);
    beta.setValue(700);
    m->panel->hide();
    QCOMPARE(started.count(), 1);
    QCOMPARE(ended.count(), 1);
    m->panel->show();
    // An undo in mid-drag leaves the hand the handle; let go, it stands where the value is.
    const int stands = beta.value();
    beta.setSliderDown(true);
    beta.setValue(300);
    m->document.undoStack().undo();
    QCOMPARE(beta.value(), 300);
    beta.setSliderDown(false);
    QCOMPARE(beta.value(), stands);
    QCOMPARE(started.count(), 2);
    QCOMPARE(ended.count(), 2);
}

void TestScenarioPanel::keysOnASliderAreOneStepUntilItIsLeft() {
    QuantitySlider& gamma = slider("gamma.slider");
    QVERIFY(QTest::qWaitForWindowActive(m->panel.get()));
    gamma.setFocus();
    for (int i = 0; i < 4; ++i) QTest::keyClick(&gamma, Qt::Key_Right);
    QCOMPARE(m->document.undoStack().count(), 1);
    m->find<QLineEdit>("title").setFocus();
    gamma.setFocus();
    QTest::keyClick(&gamma, Qt::Key_Left);
    QCOMPARE(m->document.undoStack().count(), 2);
}

void TestScenarioPanel::tipsTellRangesInTheUnitThatIsShown() {
    auto& gamma = m->find<QuantityField>("bit_rock.gamma");
    QVERIFY(gamma.toolTip().contains(QStringLiteral("<b>elasticity γ</b>")));
    QVERIFY(gamma.toolTip().contains(QStringLiteral("Range: above 0 to 1; usual: 0.01 – 1.")));
    QVERIFY(gamma.toolTip().contains(QStringLiteral("F1")));
    QVERIFY(gamma.accessibleDescription().startsWith(QStringLiteral("Elasticity parameter")));
    auto& bore = m->find<QuantityField>("rod.bore");
    QVERIFY(bore.toolTip().contains(QStringLiteral("at least 0; usual: 0 – 50\u00a0mm")));
    m->document.units().choose(UnitSystem::us);
    QVERIFY2(bore.toolTip().contains(QStringLiteral("usual: 0 – 1.9685\u00a0in")),
             qPrintable(bore.toolTip()));
    m->document.units().choose(UnitSystem::si);
    // The fault comes first; the tip comes back with the value.
    bore.setFocus();
    bore.selectAll();
    QTest::keyClicks(&bore, QStringLiteral("x\r"));
    QCOMPARE(bore.toolTip(), bore.problem());
    QTest::keyClick(&bore, Qt::Key_Escape);
    QVERIFY(bore.accessibleDescription().startsWith(QStringLiteral("Diameter of the flushing hole")));
    for (const Parameter& parameter : parameters())
        if (const auto* each = m->panel->findChild<QuantityField*>(fromView(parameter.key)))
            QVERIFY2(each->toolTip().contains(QStringLiteral("usual")), parameter.key.data());
}

void TestScenarioPanel::aValueBeyondTheSliderIsMarked() {
    QuantitySlider& length = slider("rod.length.slider");
    QCOMPARE(length.beyond(), 0);
    m->document.assign(*findParameter("rod.length"), 100, 1);
    QCOMPARE(length.value(), length.maximum());
    QCOMPARE(length.beyond(), 1);
    QVERIFY(length.toolTip().contains(QStringLiteral("outside the range of the slider")));
    m->document.assign(*findParameter("rod.length"), 0.1, 2);
    QCOMPARE(length.beyond(), -1);
    const QImage marked = length.grab().toImage();
    m->document.assign(*findParameter("rod.length"), 0.5, 3);
    QCOMPARE(length.value(), length.minimum());
    QCOMPARE(length.beyond(), 0);
    QVERIFY(length.grab().toImage() != marked);
}

void TestScenarioPanel::aSliderSaysWhyItStopsAndGoesBack() {
    QuantitySlider& bore = slider("rod.bore.slider");
    const int stands = bore.value();
    bore.setSliderDown(true);
    bore.setValue(bore.maximum());  // 50 mm in a rod of 38 mm
    const auto said = [this] {
        const QList<QLabel*> labels = m->panel->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() &&
                   label->text().startsWith(QStringLiteral("⚠ bore: must be less than the diameter of "));
        });
    };
    QVERIFY(said());
    bore.setSliderDown(false);
    QVERIFY(!said());
    QCOMPARE(bore.value(), stands);
    QVERIFY(!m->document.isModified());
}

void TestScenarioPanel::aClickInTheGrooveBringsTheHandleThere() {
    QuantitySlider& gamma = slider("bit_rock.gamma.slider");
    const QPoint at(gamma.width() * 3 / 4, gamma.height() / 2);
    QTest::mousePress(&gamma, Qt::LeftButton, {}, at);
    QVERIFY(gamma.isSliderDown());
    const double share = double(gamma.value()) / gamma.maximum();
    QVERIFY2(share > 0.7 && share < 0.85, qPrintable(QString::number(share)));
    QTest::mouseRelease(&gamma, Qt::LeftButton, {}, at);
    QVERIFY(!gamma.isSliderDown());
    QCOMPARE(m->document.undoStack().count(), 1);
    QVERIFY(m->document.scenario().bitRock.gamma > 0.7);
}

void TestScenarioPanel::shiftDragsTenTimesFiner() {
    const auto dragged = [this](Qt::KeyboardModifiers keys) {
        QuantitySlider& gamma = slider("bit_rock.gamma.slider");
        gamma.setSliderPosition(gamma.maximum() / 2);
        const int before = gamma.value();
        const QPoint from(gamma.width() / 2, gamma.height() / 2);
        const QPoint to = from + QPoint(10, 0);
        QTest::mousePress(&gamma, Qt::LeftButton, keys, from);
        const int pressed = gamma.value();
        QMouseEvent move(QEvent::MouseMove, to, gamma.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, keys);
        QCoreApplication::sendEvent(&gamma, &move);
        const int after = gamma.value();
        QTest::mouseRelease(&gamma, Qt::LeftButton, keys, to);
        return pressed == before ? after - before : 0;
    };
    const int coarse = dragged({});
    const int fine = dragged(Qt::ShiftModifier);
    QVERIFY(coarse > 0);
    QVERIFY2(std::abs(10 * fine - coarse) <= 10, qPrintable(QStringLiteral("%1 %2").arg(coarse).arg(fine)));
}

void TestScenarioPanel::aDoubleClickGoesBackToTheFilesValue() {
    QuantitySlider& gamma = slider("bit_rock.gamma.slider");
    const double file = m->document.scenario().bitRock.gamma;
    m->document.assign(*findParameter("bit_rock.gamma"), 0.77, 1);
    QTest::mouseDClick(&gamma, Qt::LeftButton, {}, gamma.rect().center());
    QCOMPARE(m->document.scenario().bitRock.gamma, file);
    m->document.undoStack().undo();
    QVERIFY(m->document.scenario().bitRock.gamma != file);
    // A group goes back with what it follows from, a value that is not given to none.
    const double stiffness = m->document.source().scenario.bitRock.stiffness;
    m->document.assign(*findParameter("bit_rock.stiffness"), 2 * stiffness, 2);
    m->find<SectionBox>("groups").setOpen(true);
    QTest::mouseDClick(&slider("beta.slider"), Qt::LeftButton, {}, QPoint(3, 3));
    QVERIFY(std::abs(m->document.scenario().bitRock.stiffness / stiffness - 1) < 1e-14);
    m->document.assign(*findParameter("drill.machine_mass"), 100, 3);
    QTest::mouseDClick(&slider("drill.machine_mass.slider"), Qt::LeftButton, {}, QPoint(3, 3));
    QCOMPARE(m->document.scenario().drill.machineMass, m->document.source().scenario.drill.machineMass);
    m->document.assign(*findParameter("drill.inclination"), 10, 4);
    QTest::mouseDClick(&slider("drill.inclination.slider"), Qt::LeftButton, {}, QPoint(3, 3));
    QVERIFY(!m->document.scenario().drill.inclination);
}

void TestScenarioPanel::wrongTextMovesNoOtherRow() {
    QVERIFY(QTest::qWaitForWindowActive(m->panel.get()));
    auto& length = m->find<QuantityField>("rod.length");
    auto& below = m->find<QuantityField>("rod.diameter");
    const QPoint place = below.mapTo(m->panel.get(), QPoint());
    length.setFocus();
    length.selectAll();
    QTest::keyClicks(&length, QStringLiteral("abc"));
    QTest::keyClick(&length, Qt::Key_Return);
    const auto plateOf = [this] {
        for (QWidget* plate : m->panel->findChildren<QWidget*>(QStringLiteral("problemPlate")))
            if (plate->isVisible()) return plate;
        return static_cast<QWidget*>(nullptr);
    };
    QVERIFY(plateOf());
    QVERIFY(plateOf()->grab().width() > 100);
    QCOMPARE(below.mapTo(m->panel.get(), QPoint()), place);
    // It is out of the way of whoever goes on to the next field, and comes back with the focus.
    below.setFocus();
    QVERIFY(!plateOf());
    QCOMPARE(length.toolTip(), length.problem());
    length.setFocus();
    QVERIFY(plateOf());
    QTest::keyClick(&length, Qt::Key_Escape);
    QVERIFY(!plateOf());
}

void TestScenarioPanel::anotherImpulseScalesAMeasuredBlow() {
    QVERIFY(takeTable(table));
    const double measured = pulseImpulse(m->document.scenario());
    QCOMPARE(measured, 45.0);  // a trapezoid of 300 kN, 200 µs below and 100 µs above
    auto& impulse = m->find<QuantityField>("table.impulse");
    QVERIFY(impulse.isVisible());
    QCOMPARE(impulse.value(), measured);
    const int steps = m->document.undoStack().count();
    impulse.setFocus();
    impulse.selectAll();
    QTest::keyClicks(&impulse, QStringLiteral("2*45 N s"));
    QTest::keyClick(&impulse, Qt::Key_Return);
    QCOMPARE(m->document.undoStack().count(), steps + 1);
    const Pulse& pulse = m->document.scenario().pulse;
    QCOMPARE(pulseImpulse(m->document.scenario()), 90.0);
    QCOMPARE(pulse.tablePoints[1].force, 600e3);
    QCOMPARE(pulse.tablePoints[1].time, 50e-6);
    // In the form that files have for it: points of the scenario itself.
    QVERIFY(pulse.tableFile.empty());
    QVERIFY(m->document.text().contains("points:"));
    m->document.undoStack().undo();
    QCOMPARE(impulse.value(), measured);
    QVERIFY(!m->document.scenario().pulse.tableFile.empty());
}

void TestScenarioPanel::foldedSectionsStayFolded() {
    auto& rod = m->find<SectionBox>("rod");
    QVERIFY(rod.isOpen());
    QTest::mouseClick(rod.findChild<QToolButton*>(), Qt::LeftButton);
    QVERIFY(!rod.isOpen());
    m->makePanel();
    QVERIFY(!m->find<SectionBox>("rod").isOpen());
    QVERIFY(m->find<SectionBox>("drill").isOpen());
}

void TestScenarioPanel::groupsAreLastAndFoldedWhereTheyFollow() {
    const auto below = [this](const char* upper, const char* lower) {
        QCoreApplication::processEvents();
        return m->find<SectionBox>(upper).y() < m->find<SectionBox>(lower).y();
    };
    auto& groups = m->find<SectionBox>("groups");
    for (const auto& [upper, lower] : {std::pair("rod", "pulse"), std::pair("pulse", "bit_rock"),
                                       std::pair("bit_rock", "drill"), std::pair("drill", "groups")})
        QVERIFY2(below(upper, lower), lower);
    QVERIFY(!groups.isOpen());
    // All that a scenario without units is given by.
    m->document.startFrom(findExample("paper_fig4b")->text, QStringLiteral("example"));
    QVERIFY(below("groups", "pulse"));
    QVERIFY(groups.isOpen());
    QWidget* next = m->find<QLineEdit>("title").nextInFocusChain();
    while (!(next->focusPolicy() & Qt::TabFocus) || !next->isVisible()) next = next->nextInFocusChain();
    QVERIFY(groups.isAncestorOf(next));
    // Each is left as it was.
    QTest::mouseClick(groups.findChild<QToolButton*>(), Qt::LeftButton);
    m->document.startFrom(defaultExample().text, QStringLiteral("example"));
    QVERIFY(below("drill", "groups"));
    QVERIFY(!groups.isOpen());
    QTest::mouseClick(groups.findChild<QToolButton*>(), Qt::LeftButton);
    m->makePanel();
    QVERIFY(m->find<SectionBox>("groups").isOpen());
}

// The first digits are a diameter, which takes the place of the area; the whole text is none.
void TestScenarioPanel::wrongTextForTheDiameterBringsTheAreaBack() {
    m->document.assign(*findParameter("rod.area"), 8e-4, 1);
    const Scenario before = m->document.scenario();
    auto& diameter = m->find<QuantityField>("rod.diameter");
    QVERIFY(diameter.isVisible() && !diameter.value());
    QTest::keyClicks(&diameter, QStringLiteral("38"));
    QCOMPARE(m->document.scenario().rod.diameter, 0.038);
    QVERIFY(!m->document.scenario().rod.area);
    QTest::keyClicks(&diameter, QStringLiteral(" kN"));
    QVERIFY(m->document.scenario() == before);
    QCOMPARE(m->document.undoStack().count(), 1);
    QVERIFY(!diameter.problem().isEmpty());
}

void TestScenarioPanel::undoTakesBackFiveHundredRandomEdits() {
    const QByteArray before = m->document.text();
    m->answers.import = m->write(QStringLiteral("blow.csv"), table);
    static const char* const typed[] = {"3,2", "38 mm", "1.5 in", "0.25",  "1e3",
                                        "abc", "",      "200 us", "12 ft", "-1"};
    QRandomGenerator random(20260101);
    for (int edit = 0; edit < 500; ++edit) {
        switch (random.bounded(4)) {
            case 0: {
                const auto fields = m->panel->findChildren<QuantityField*>();
                QuantityField* field = fields[random.bounded(int(fields.size()))];
                if (!field->isVisible()) break;
                field->selectAll();
                QTest::keyClick(field, Qt::Key_Backspace);
                QTest::keyClicks(field, QLatin1String(typed[random.bounded(int(std::size(typed)))]));
                QTest::keyClick(field, Qt::Key_Return);
                break;
            }
            case 1: {
                const auto sliders = m->panel->findChildren<QuantitySlider*>();
                QuantitySlider* moved = sliders[random.bounded(int(sliders.size()))];
                if (!moved->isVisible()) break;
                moved->setSliderDown(true);
                for (int i = 0; i < 3; ++i) moved->setValue(random.bounded(1001));
                moved->setSliderDown(false);
                break;
            }
            case 2:
                PanelFixture::choose(shape(), shape().itemText(random.bounded(shape().count())));
                break;
            default: {
                const auto boxes = m->panel->findChildren<PresetBox*>();
                PresetBox* box = boxes[random.bounded(int(boxes.size()))];
                QList<QAction*> presets;
                for (QAction* action : box->menu()->actions())
                    if (action->isCheckable()) presets.append(action);
                presets[random.bounded(int(presets.size()))]->trigger();
            }
        }
        QVERIFY(validate(m->document.scenario()).empty());
    }
    QVERIFY(m->document.undoStack().count() > 200);
    m->undoAll();
    QCOMPARE(m->document.text(), before);
    while (m->document.undoStack().canRedo()) m->document.undoStack().redo();
    m->undoAll();
    QCOMPARE(m->document.text(), before);
}

QTEST_MAIN(TestScenarioPanel)
#include "tst_scenario_panel.moc"

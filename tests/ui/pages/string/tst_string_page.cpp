// SPDX-License-Identifier: GPL-3.0-or-later
// The page String in the window: opened, edited, undone by name, saved and read again.
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include "core/blow/blow_waves.h"
#include "core/model/section_parameter.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/lossless_string.h"
#include "tests/support/window_fixture.h"
#include "tests/support/without_strengths.h"
#include "ui/export/export_menu.h"
#include "ui/export/report_writer.h"
#include "ui/form/problem_plate.h"
#include "ui/form/quantity_field.h"
#include "ui/form/section_box.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/place_field.h"
#include "ui/pages/rock/rock_page.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/pages/string/string_drawing.h"
#include "ui/pages/string/string_edits.h"
#include "ui/pages/string/string_model.h"
#include "ui/pages/string/string_page.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/energy_bar.h"
#include "ui/result/result_panel.h"
#include "ui/window/document_notices.h"
#include "ui/window/page_notices.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/study_menu.h"
#include "ui/window/tab_strip.h"

using namespace drillwave;
using namespace drillwave::test;

class TestStringPage : public QObject, private WindowFixture {
    Q_OBJECT

  private slots:
    void init();
    void typingOnASelectedCellReplacesItsNumber();
    void aStringIsOpenedOnThePageOnShow();
    void blowAndRockShowAString();
    void runsOfEitherKindLieOverBlowAndRock();
    void theBlowIsReadWhereOneLooks();
    void pagesOfRodsHaveNoTab();
    void studiesOfStringsAreOfferedByTheirNames();
    void aRodBringsItsPagesBack();
    void theTableShowsTheSectionsAsTheyStandInTheFile();
    void theResultsAreThoseOfTheBlow();
    void aCellIsEditedUndoneByNameSavedAndReadAgain();
    void wrongTextStaysOutWithItsReason();
    void anOpenCellDoesNotReachAnotherFile();
    void unitsOfAllKindsAreTaken();
    void columnsThatFewSectionsHaveAreShownWhereTheyAreUsed();
    void numbersFollowTheLocale();
    void aNewcomerBuildsTheStringFromOneSection();
    void aNewcomerBuildsTheStringFromPresets();
    void adaptersGoToTheShankAndBitsToTheRock();
    void aSectionIsReplacedByAPreset();
    void thePageSaysWhatTheStringIsAndWhatBreaksFirst();
    void aPageOfThinnedWavesOffersToRoundTheLengths();
    void aRowIsDraggedToItsPlace();
    void aClickInTheDrawingSelectsTheRow();
    void theDrawingIsToScale();
    void theKeysGoThroughTheDrawing();
    void theResultPanelShowsWhatAStringHas();
    void theFormShowsWhatAppliesToAString();
    void theHammerMayBeWithdrawn();
    void aRockPresetIsTaken();
    void aStringIsPinnedAndRevertedTo();
    void anAlertLeadsToItsSection();
    void switchingBetweenRodAndStringDoesNoHarm();

  private:
    void openExample(const char* name) {
        QCOMPARE(window().document().startFrom(findExample(name)->text, QLatin1String(name)), QString());
        settle();
    }
    StringPage& page() { return part<StringPage>(window()); }
    StringModel& model() { return *page().model(); }
    Document& document() { return window().document(); }
    QString text(int row, int column) { return model().index(row, column).data().toString(); }
    QString answer() { return page().findChild<QLabel*>(QStringLiteral("answer"))->text(); }
    QString words() { return page().findChild<QLabel*>(QStringLiteral("words"))->text(); }
    QString undoText() { return document().undoStack().undoText(); }
    void select(int row) { page().edits()->select(model().rows()[std::size_t(row)].spot); }
    void trigger(const char* action) {
        auto* found = page().findChild<QAction*>(QStringLiteral("string.") + QLatin1String(action));
        QVERIFY(found);
        QVERIFY2(found->isEnabled(), action);
        found->trigger();
    }
    /// From a menu of Add.
    void choose(const QString& menu, const QString& name) {
        QMenu* add = page().edits()->addMenu();
        emit add->aboutToShow();
        for (const QAction* each : add->actions())
            if (each->menu() && each->text() == menu)
                for (QAction* choice : each->menu()->actions())
                    if (choice->text() == name) {
                        QVERIFY(menu != QStringLiteral("Couplings") ||
                                choice->toolTip().contains(QStringLiteral("190 mm × 56 mm")));
                        return choice->trigger();
                    }
        QFAIL(qPrintable(menu + u' ' + name));
    }
    /// Types into a cell as a user would; the editor stays open where it refuses the text.
    void typeIntoCell(int row, int column, const QString& typed);
    bool isRowThere(const QString& label) {
        for (const QLabel* each : part<ResultPanel>(window()).findChildren<QLabel*>())
            if (each->text() == label && !each->isHidden()) return true;
        return false;
    }
};

void TestStringPage::init() {
    start();
    openExample("t38_string");
    part<PageTabs>(window()).setCurrentWidget(&page());
    settle();
}

void TestStringPage::typeIntoCell(int row, int column, const QString& typed) {
    const QModelIndex index = model().index(row, column);
    page().table()->setCurrentIndex(index);
    page().table()->edit(index);
    QWidget* target = page().table()->indexWidget(index);
    QVERIFY(target);
    QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(target, typed);
    QTest::keyClick(target, Qt::Key_Return);
    QCoreApplication::processEvents();
}

// The digits were put behind the number of the cell, and the reason stood above the table for good.
void TestStringPage::typingOnASelectedCellReplacesItsNumber() {
    const auto loss = [&] { return document().scenario().drillString.parts[1].sections[0].loss; };
    QCOMPARE(QString::fromStdString(document().scenario().drillString.parts[1].sections[0].name),
             QStringLiteral("coupling"));
    typeIntoCell(3, StringModel::loss, QStringLiteral("6"));
    QCOMPARE(loss(), 0.06);
    QTableView& table = *page().table();
    const QModelIndex cell = model().index(3, StringModel::loss);
    table.setCurrentIndex(cell);
    QTest::keyClick(&table, Qt::Key_1);
    auto* field = qobject_cast<QuantityField*>(table.indexWidget(cell));
    QVERIFY(field);
    QTest::keyClick(field, Qt::Key_0);
    QCOMPARE(field->text(), QStringLiteral("10"));
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::processEvents();
    QCOMPARE(loss(), 0.1);
    settle();
    const QString sentence = words();
    table.edit(cell);
    field = qobject_cast<QuantityField*>(table.indexWidget(cell));
    QTest::keyClicks(field, QStringLiteral("610"));
    QVERIFY2(field->problem().contains(QStringLiteral("[0, 100) %")), qPrintable(field->problem()));
    table.setCurrentIndex(model().index(2, StringModel::length));
    QCoreApplication::processEvents();
    QCOMPARE(loss(), 0.1);
    QCOMPARE(words(), sentence);
}

void TestStringPage::aStringIsOpenedOnThePageOnShow() {
    openExample("t38_medium_rock");
    PageTabs& pages = part<PageTabs>(window());
    QCOMPARE(&pages.current(), static_cast<Page*>(&part<BlowPage>(window())));
    openExample("t38_string");
    QCOMPARE(&pages.current(), static_cast<Page*>(&part<BlowPage>(window())));
    pages.setCurrentWidget(&page());
    settle();
    QVERIFY(window().shown()->isOfString());
    QCOMPARE(window().shown()->fault, QString());
    QVERIFY2(answer().contains(QStringLiteral("3rd rod")), qPrintable(answer()));
    // Its examples are on the menu, and so is a file of one.
    const QString path = m_folder.filePath(QStringLiteral("a.yaml"));
    QCOMPARE(document().save(path), QString());
    openExample("t38_medium_rock");
    QVERIFY(window().openFile(path));
    settle();
    QVERIFY(isString(document().scenario()));
    QCOMPARE(document().path(), path);
}

void TestStringPage::pagesOfRodsHaveNoTab() {
    PageTabs& pages = part<PageTabs>(window());
    const TabStrip& strip = *pages.strip();
    for (int index = 0; index < pages.count(); ++index) {
        const int tab = strip.indexOf(&pages.page(index));
        QCOMPARE(strip.isTabEnabled(tab), pages.page(index).shows(document().scenario()));
        QCOMPARE(strip.isTabVisible(tab), strip.isTabEnabled(tab));
    }
    QVERIFY(part<ReportWriter>(window()).action()->isEnabled());
    QTest::keyClick(&window(), Qt::Key_Tab, Qt::ControlModifier);
    QVERIFY(part<PageTabs>(window()).current().shows(document().scenario()));
}

void TestStringPage::studiesOfStringsAreOfferedByTheirNames() {
    const auto names = [&] {
        QStringList enabled;
        emit part<StudyMenu>(window()).aboutToShow();
        for (const QAction* action : part<StudyMenu>(window()).actions())
            if (action->isEnabled()) enabled << action->text();
        return enabled;
    };
    QVERIFY2(names().contains(QStringLiteral("Efficiency–stiffness")), qPrintable(names().join(u',')));
    QVERIFY(names().contains(QStringLiteral("Map")));
    openExample("t38_medium_rock");
    QVERIFY2(names().contains(QStringLiteral("COR–stiffness")), qPrintable(names().join(u',')));
    QVERIFY(!names().contains(QStringLiteral("Efficiency–stiffness")));
}

void TestStringPage::blowAndRockShowAString() {
    auto& blow = part<BlowPage>(window());
    part<PageTabs>(window()).setCurrentWidget(&blow);
    settle();
    const BlowPlots& plots = *blow.plots();
    const auto shown = window().shown();
    const StringHistory history(shown->impact, shown->problem,
                                stringPlace(document().scenario().drillString, 0.5));
    double largest = 0;
    for (const RodState& now : history.sampled()) largest = std::max(largest, now.impactForce);
    const auto range = [](const QCPGraph* graph) {
        bool found = false;
        return graph->getValueRange(found);
    };
    const double unit = shown->units.force.factor;
    QVERIFY(std::abs(range(plots.forceGraph()).upper - largest * unit) < 1e-9 * largest * unit);
    QVERIFY(range(plots.faceForceGraph()).upper > range(plots.forceGraph()).upper);
    QVERIFY(plots.closedFormGraph()->data()->isEmpty());
    QVERIFY(plots.waveGraph(2)->data()->isEmpty());
    QVERIFY(plots.textSummary().contains(QStringLiteral("coupling")) ||
            plots.textSummary().contains(QStringLiteral("rod")));
    const auto last = plots.momentumGraph()->data()->constEnd() - 1;
    // without what losses in joints take
    const double momentum = -shown->summary.cor * shown->impact.faceImpulse / shown->impact.hammerImpulse *
                            shown->units.impulse.factor;
    QVERIFY(std::abs(last->value - momentum) < 1e-5 * std::abs(momentum));

    auto& rock = part<RockPage>(window());
    part<PageTabs>(window()).setCurrentWidget(&rock);
    settle();
    QVERIFY(rock.rockPlot()->path()->data()->size() > 100);
    QVERIFY(rock.rockPlot()->textSummary().contains(QStringLiteral("energy left in the rock")));
}

void TestStringPage::runsOfEitherKindLieOverBlowAndRock() {
    auto& blow = part<BlowPage>(window());
    part<PageTabs>(window()).setCurrentWidget(&blow);
    settle();
    part<PinnedRuns>(window()).pinAction()->trigger();
    openExample("t38_medium_rock");
    part<PinnedRuns>(window()).pinAction()->trigger();
    settle();
    for (const char* present : {"t38_medium_rock", "r32_string"}) {
        openExample(present);
        QCOMPARE(blow.plots()->forcesOfRuns().size(), 2);
        for (const QCPGraph* run : blow.plots()->forcesOfRuns()) QVERIFY(!run->data()->isEmpty());
    }
}

// Near the bit what comes down comes later than near the shank.
void TestStringPage::theBlowIsReadWhereOneLooks() {
    auto& blow = part<BlowPage>(window());
    part<PageTabs>(window()).setCurrentWidget(&blow);
    const auto arrival = [&](double section) {
        blow.findChild<PlaceField*>()->setValue(section);
        settle();
        for (const QCPGraphData& point : *blow.plots()->waveGraph(0)->data())
            if (point.value < -1) return point.key;
        return -1.0;
    };
    const double early = arrival(0.1), late = arrival(0.9);
    QVERIFY(early > 0 && late > early);
    const QString place = blow.findChild<QLabel*>(QStringLiteral("place"))->text();
    QVERIFY2(place.contains(QStringLiteral("struck end")), qPrintable(place));
}

void TestStringPage::aRodBringsItsPagesBack() {
    openExample("t38_medium_rock");
    PageTabs& pages = part<PageTabs>(window());
    QCOMPARE(&pages.current(), static_cast<Page*>(&part<BlowPage>(window())));
    for (int index = 0; index < pages.count(); ++index)
        QCOMPARE(pages.isOffered(index), &pages.page(index) != &page());
    QVERIFY(!part<BlowPage>(window()).plot()->graph(0)->data()->isEmpty());
    QVERIFY(part<ReportWriter>(window()).action()->isEnabled());
}

void TestStringPage::adaptersGoToTheShankAndBitsToTheRock() {
    openExample("t38_medium_rock");
    part<FormNotice>(window()).toString()->trigger();
    settle();
    page().edits()->addMenu();
    emit page().edits()->addMenu()->aboutToShow();
    const auto addFirstOf = [&](const char* menu) {
        for (const QAction* each : page().edits()->addMenu()->actions())
            if (each->menu() && each->text() == QLatin1String(menu))
                return each->menu()->actions()[0]->trigger();
        QFAIL(menu);
    };
    const std::size_t rods = document().scenario().drillString.parts.size();
    select(1);  // the rod, whose place is not where they go
    addFirstOf("Bits");
    select(1);
    addFirstOf("Adapters");
    const std::vector<StringPart>& parts = document().scenario().drillString.parts;
    QVERIFY(parts.size() > rods + 1);
    QVERIFY(parts.front().sections[0].name.starts_with("adapter") || parts.front().sections[0].name != "rod");
    QVERIFY(parts.back().sections[0].name.starts_with("bit"));
    QCOMPARE(parts[1].sections[0].name, std::string("rod"));
}

void TestStringPage::theTableShowsTheSectionsAsTheyStandInTheFile() {
    QCOMPARE(model().rowCount(), 7);
    QCOMPARE(text(0, StringModel::sectionName), QStringLiteral("hammer 1"));
    QCOMPARE(text(2, StringModel::sectionName), QStringLiteral("adapter"));
    QCOMPARE(text(4, StringModel::length), QStringLiteral("3660"));
    QCOMPARE(text(4, StringModel::bore), QStringLiteral("14.5"));
    QVERIFY(text(3, StringModel::repeat).startsWith(QStringLiteral("3 ×")));
    QVERIFY(!text(4, StringModel::repeat).isEmpty());
    QVERIFY(text(5, StringModel::repeat).isEmpty());
    QVERIFY(!(model().flags(model().index(0, StringModel::loss)) & Qt::ItemIsEditable));
    QVERIFY(model().flags(model().index(3, StringModel::loss)) & Qt::ItemIsEditable);
    QCOMPARE(text(5, StringModel::sectionName), QStringLiteral("bit skirt"));
    QCOMPARE(model().headerData(5, Qt::Vertical).toString(), QStringLiteral("8"));
    QCOMPARE(model().headerData(1, Qt::Vertical).toString(), QStringLiteral("H2"));
}

void TestStringPage::theResultsAreThoseOfTheBlow() {
    const SolvedBlow& blow = *window().shown();
    double largest = 0;
    for (const SectionStress& stress : sectionStresses(blow.scenario, blow.impact))
        largest = std::max(largest, stress.tension.stress);
    QCOMPARE(model().results()->rows[4].tension.size, largest);
    QCOMPARE(model().results()->rows[4].tension.section, std::uint64_t(7));
    QCOMPARE(QLocale().toDouble(text(4, StringModel::tension)), std::round(largest / 1e5) / 10);
    QCOMPARE(model().results()->rows[3].reflected->size, blow.impact.jointReflection[1]);
    QCOMPARE(findOutput("peak_tension")->value({blow.summary, blow.scenario}).value() * blow.scales.stress,
             largest);
}

void TestStringPage::aCellIsEditedUndoneByNameSavedAndReadAgain() {
    const QByteArray before = document().text();
    typeIntoCell(3, StringModel::diameter, QStringLiteral("50 mm"));
    QCOMPARE(document().scenario().drillString.parts[1].sections[0].diameter, 0.05);
    QVERIFY2(undoText().contains(QStringLiteral("diameter of 1st to 3rd coupling")), qPrintable(undoText()));
    QVERIFY(window().isWindowModified());
    settle();
    const double efficiency = window().shown()->summary.energy.rockWork;
    QVERIFY(efficiency > 0.32);
    const QString path = m_folder.filePath(QStringLiteral("thin.yaml"));
    QCOMPARE(document().save(path), QString());
    QVERIFY(!window().isWindowModified());
    document().undoStack().undo();
    QCOMPARE(document().text(), before);
    QVERIFY(window().openFile(path));
    settle();
    QCOMPARE(document().scenario().drillString.parts[1].sections[0].diameter, 0.05);
    QCOMPARE(window().shown()->summary.energy.rockWork, efficiency);
    QVERIFY(document().text().contains("12 ft rod"));  // comments stay
}

void TestStringPage::wrongTextStaysOutWithItsReason() {
    const Scenario before = document().scenario();
    typeIntoCell(3, StringModel::bore, QStringLiteral("60"));
    auto* field = page().table()->viewport()->findChild<QuantityField*>();
    QVERIFY(field);  // it stays, with its text
    QVERIFY(field->problem().contains(QStringLiteral("must be less than the diameter")));
    QCOMPARE(document().scenario(), before);
    // Both can be read: the text in the field, the reason below it and not over it.
    QVERIFY(field->width() > 2 * field->fontMetrics().horizontalAdvance(QStringLiteral("-5 xx")));
    const auto* plate = page().table()->viewport()->findChild<ProblemPlate*>();
    QVERIFY(plate && plate->isVisible());
    QCOMPARE(plate->parentWidget(), page().table()->viewport());
    QVERIFY(!plate->geometry().intersects(field->geometry()));
    page().drawing()->setFocus();
    QCoreApplication::processEvents();
    // the cell has its value again, and the page its sentence
    QVERIFY2(words().startsWith(QStringLiteral("3 rods")), qPrintable(words()));
    QCOMPARE(document().scenario(), before);
    QCOMPARE(document().undoStack().count(), 0);
}

void TestStringPage::anOpenCellDoesNotReachAnotherFile() {
    for (const int column : {int(StringModel::sectionName), int(StringModel::diameter)}) {
        openExample("t38_string");
        page().table()->setFocus();
        page().table()->edit(model().index(6, column));
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("9"));
        openExample("t38_medium_rock");
        const Scenario rod = document().scenario();
        QVERIFY(!isString(rod));
        QCOMPARE(document().undoStack().count(), 0);
        openExample("t38_string");
        QCOMPARE(document().scenario(), parseScenario(findExample("t38_string")->text, "").scenario);
    }
}

void TestStringPage::unitsOfAllKindsAreTaken() {
    page().findChild<QToolButton*>(QStringLiteral("allColumns"))->click();
    typeIntoCell(2, StringModel::length, QStringLiteral("1.5 ft"));
    QCOMPARE(document().scenario().drillString.parts[0].sections[0].length, 0.4572);
    typeIntoCell(4, StringModel::attenuation, QStringLiteral("0.002 1/m"));
    QCOMPARE(document().scenario().drillString.parts[1].sections[1].attenuation, 0.002);
    typeIntoCell(3, StringModel::loss, QStringLiteral("2 %"));
    QCOMPARE(document().scenario().drillString.parts[1].sections[0].loss, 0.02);
    typeIntoCell(6, StringModel::massAfter, QStringLiteral("300 g"));
    QCOMPARE(document().scenario().drillString.parts[3].sections[0].massAfter, 0.3);
    settle();
    QCOMPARE(window().shown()->fault, QString());
    QVERIFY(window().shown()->summary.jointLoss > 0);
    QVERIFY(isRowThere(QStringLiteral("lost in joints")));
}

void TestStringPage::columnsThatFewSectionsHaveAreShownWhereTheyAreUsed() {
    QCOMPARE(document().useScenario(test::withoutStrengths(document().scenario()), QStringLiteral("weak")),
             QString());
    const QTableView& table = *page().table();
    std::vector<int> few;
    for (const char* field : {"area", "end_diameter", "end_area", "youngs_modulus", "density",
                              "yield_strength", "fatigue_strength"})
        few.push_back(StringModel::columnOf(field));
    for (const int column : few) QVERIFY(table.isColumnHidden(column));
    auto& all = *page().findChild<QToolButton*>(QStringLiteral("allColumns"));
    QTest::mouseClick(&all, Qt::LeftButton);
    for (const int column : few) QVERIFY(!table.isColumnHidden(column));
    typeIntoCell(4, StringModel::columnOf("yield_strength"), QStringLiteral("300 MPa"));
    typeIntoCell(4, StringModel::columnOf("youngs_modulus"), QStringLiteral("205"));
    typeIntoCell(3, StringModel::columnOf("area"), QStringLiteral("2300 mm^2"));
    typeIntoCell(2, StringModel::columnOf("end_diameter"), QStringLiteral("52 mm"));
    const DrillString& drill = document().scenario().drillString;
    const Section& rod = drill.parts[1].sections[1];
    QCOMPARE(rod.yieldStrength, std::optional(300e6));
    QCOMPARE(drill.parts[0].sections[0].endDiameter, std::optional(0.052));
    QCOMPARE(rod.youngsModulus, std::optional(205e9));
    QCOMPARE(drill.parts[1].sections[0].area, std::optional(2300e-6));
    settle();
    // The strength has a use: this alert.
    const auto isTold = [](const Alert& alert) { return alert.code == AlertCode::stressAboveYield; };
    QVERIFY(std::ranges::any_of(window().shown()->alerts, isTold));
    // A used column stays, and goes with its last number, once that cell is emptied.
    QTest::mouseClick(&all, Qt::LeftButton);
    QVERIFY(!table.isColumnHidden(StringModel::columnOf("youngs_modulus")));
    QVERIFY(table.isColumnHidden(StringModel::columnOf("yield_strength")));
    QVERIFY(!table.isColumnHidden(StringModel::columnOf("area")));
    QVERIFY(table.isColumnHidden(StringModel::columnOf("density")));
    QVERIFY(table.isColumnHidden(StringModel::massAfter));
    const QModelIndex cell = model().index(4, StringModel::columnOf("youngs_modulus"));
    page().table()->setCurrentIndex(cell);
    page().table()->edit(cell);
    QWidget* editor = page().table()->indexWidget(cell);
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(editor, Qt::Key_Backspace);
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();
    QVERIFY(!document().scenario().drillString.parts[1].sections[1].youngsModulus);
    QVERIFY(table.isColumnHidden(StringModel::columnOf("youngs_modulus")));
    // A diameter takes the place of a cross-section.
    typeIntoCell(3, StringModel::diameter, QStringLiteral("56 mm"));
    QVERIFY(!document().scenario().drillString.parts[1].sections[0].area);
    QVERIFY(table.isColumnHidden(StringModel::columnOf("area")));
}

void TestStringPage::numbersFollowTheLocale() {
    const QLocale german(QLocale::German, QLocale::Germany);
    QLocale::setDefault(german);
    m_window.reset();
    makeWindow(exactSolve());
    openExample("t38_string");
    part<PageTabs>(window()).setCurrentWidget(&page());
    settle();
    QCOMPARE(text(4, StringModel::bore), QStringLiteral("14,5"));
    QVERIFY(text(4, StringModel::compression).contains(QLatin1Char(',')));
    typeIntoCell(4, StringModel::diameter, QStringLiteral("39,5"));
    QCOMPARE(document().scenario().drillString.parts[1].sections[1].diameter, 0.0395);
    const QByteArray csv = page().exports().first().csv();
    QVERIFY(csv.contains(",39.5,14.5,"));
    QCOMPARE(QLocale(), german);
    QLocale::setDefault(QLocale::c());
}

void TestStringPage::aNewcomerBuildsTheStringFromOneSection() {
    const DrillString wanted = test::withoutStrengths(test::losslessString()).drillString;
    const char* bare =
        "drillwave: 2\n"
        "hammer: {velocity: 10 m/s, sections: [{length: 300 mm, diameter: 50 mm}]}\n"
        "string:\n  - {length: 1 m, diameter: 40 mm}\n"
        "bit_rock: {stiffness: 100 MN/m, gamma: 0.1}\n";
    QCOMPARE(document().startFrom(bare, QStringLiteral("bare")), QString());
    QCOMPARE(model().rowCount(), 2);
    const auto fill = [&](int row, const char* name, double length, double diameter, double bore) {
        if (*name) typeIntoCell(row, StringModel::sectionName, QLatin1String(name));
        typeIntoCell(row, StringModel::length, QString::number(length) + QStringLiteral(" mm"));
        typeIntoCell(row, StringModel::diameter, QString::number(diameter));
        typeIntoCell(row, StringModel::bore, QString::number(bore));
    };
    select(0);
    trigger("duplicate");
    fill(1, "", 250, 38, 0);
    fill(2, "adapter", 450, 45, 12);
    select(2);
    for (int i = 0; i < 4; ++i) trigger("duplicate");
    QCOMPARE(undoText(), QStringLiteral("duplicate adapter"));
    fill(3, "coupling", 190, 56, 14.5);
    fill(4, "rod", 3660, 39, 14.5);
    fill(5, "bit head", 60, 76, 0);
    fill(6, "bit skirt", 70, 56, 14.5);
    select(6);
    trigger("up");
    QCOMPARE(undoText(), QStringLiteral("move bit skirt towards the hammer"));
    page().table()->selectionModel()->select(QItemSelection(model().index(3, 0), model().index(4, 0)),
                                             QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    trigger("repeat");
    QVERIFY(text(3, StringModel::repeat).startsWith(QStringLiteral("2 ×")));
    QVERIFY(model().setData(model().index(3, StringModel::repeat), 3));
    QCOMPARE(document().scenario().drillString.hammer.sections, wanted.hammer.sections);
    QCOMPARE(document().scenario().drillString.parts, wanted.parts);
    settle();
    QVERIFY(std::abs(window().shown()->summary.energy.rockWork - 0.501587377477) < 1e-9);
    const QString path = m_folder.filePath(QStringLiteral("built.yaml"));
    QCOMPARE(document().save(path), QString());
    QVERIFY(window().openFile(path));
    QCOMPARE(document().scenario().drillString.parts, wanted.parts);
    while (document().undoStack().canUndo()) document().undoStack().undo();
}

void TestStringPage::aNewcomerBuildsTheStringFromPresets() {
    openExample("t38_medium_rock");
    part<FormNotice>(window()).toString()->trigger();
    settle();
    QCOMPARE(model().rowCount(), 2);
    choose(QStringLiteral("Hammer, instead of this one"), QStringLiteral("T38 drifter, 50 and 38 mm"));
    QCOMPARE(model().rowCount(), 3);
    QVERIFY(undoText().contains(QStringLiteral("T38 drifter")));
    select(2);
    choose(QStringLiteral("Adapters"), QStringLiteral("T38 shank, 450 mm"));
    select(3);  // the rod, before which the adapter has gone
    trigger("remove");
    choose(QStringLiteral("Couplings"), QStringLiteral("T38, 190 mm"));
    QVERIFY(undoText().contains(QStringLiteral("coupling")));
    choose(QStringLiteral("Rods"), QStringLiteral("T38, round 39 mm"));
    choose(QStringLiteral("Bits"), QStringLiteral("T38, 76 mm"));
    QCOMPARE(model().rowCount(), 7);
    Scenario scenario = document().scenario();
    repeatSections(scenario.drillString, {model().rows()[3].spot, model().rows()[4].spot}, 3);
    scenario.drillString.hammer.restrike = true;
    scenario.bitRock.stiffness = 100e6;
    QCOMPARE(document().useScenario(scenario, QStringLiteral("repeat")), QString());
    settle();
    QCOMPARE(window().shown()->fault, QString());
    QVERIFY(std::abs(window().shown()->summary.energy.rockWork - 0.501587377477) < 1e-9);
}

void TestStringPage::aSectionIsReplacedByAPreset() {
    // Rows: two of the hammer, adapter, coupling and rod in a repeat, skirt, head.
    select(3);
    QMenu* menu = page().edits()->replaceMenu();
    emit menu->aboutToShow();
    QAction* worn = nullptr;
    for (const QAction* each : menu->actions())
        for (QAction* choice : each->menu()->actions())
            if (choice->text() == QStringLiteral("T38, 190 mm, worn")) worn = choice;
    QVERIFY(worn);
    worn->trigger();
    settle();
    QCOMPARE(model().rowCount(), 7);
    QCOMPARE(undoText(), QStringLiteral("replace coupling by T38, 190 mm, worn"));
    QCOMPARE(document().scenario().drillString.parts[1].sections[0].loss, 0.06);
    QCOMPARE(text(3, StringModel::presetName), QStringLiteral("T38, 190 mm, worn"));
    QVERIFY(!page().table()->isColumnHidden(StringModel::presetName));
    QVERIFY(writeScenario(document().contents()).find("preset: \"T38, 190 mm, worn\"") != std::string::npos);
    document().undoStack().undo();
    settle();
    QVERIFY(page().table()->isColumnHidden(StringModel::presetName));
    // A preset of a rod says nothing of the length.
    select(4);
    const double length = document().scenario().drillString.parts[1].sections[1].length;
    emit menu->aboutToShow();
    for (const QAction* each : menu->actions())
        if (each->text() == QStringLiteral("Rods")) each->menu()->actions().last()->trigger();
    QCOMPARE(document().scenario().drillString.parts[1].sections[1].length, length);
    QVERIFY(!document().scenario().drillString.parts[1].sections[1].preset.empty());
    // No preset takes the place of a part of the hammer.
    select(0);
    QVERIFY(!page().findChild<QAction*>(QStringLiteral("string.replace"))->isEnabled());
}

void TestStringPage::thePageSaysWhatTheStringIsAndWhatBreaksFirst() {
    QVERIFY2(answer().startsWith(
                 QStringLiteral("During the blow, the most heavily loaded section (3rd rod) has ")),
             qPrintable(answer()));
    QCOMPARE(document().useScenario(test::withoutStrengths(document().scenario()), QStringLiteral("weak")),
             QString());
    settle();
    QVERIFY2(words().startsWith(QStringLiteral("3 rods, 3 couplings, 3 other sections, ")),
             qPrintable(words()));
    QVERIFY2(words().contains(QStringLiteral("No section has a strength")), qPrintable(words()));
    QVERIFY2(answer().startsWith(QStringLiteral("Largest tension in ")), qPrintable(answer()));
    QCOMPARE(text(4, StringModel::strengthShare), noNumber);
    Scenario scenario = document().scenario();
    for (StringPart& part : scenario.drillString.parts)
        for (Section& section : part.sections) section.fatigueStrength = 400e6;
    QCOMPARE(document().useScenario(scenario, QStringLiteral("strengths")), QString());
    settle();
    QVERIFY2(answer().startsWith(QStringLiteral("During the blow, the most heavily loaded section (")),
             qPrintable(answer()));
    QVERIFY2(words().contains(QStringLiteral("Largest tension in ")), qPrintable(words()));
    page().findChild<QPushButton*>(QStringLiteral("copyAnswer"))->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), answer() + QLatin1Char('\n') + words());
    QCOMPARE(text(4, StringModel::sectionName), QStringLiteral("1st to 3rd rod"));
    QCOMPARE(text(2, StringModel::sectionName), QStringLiteral("adapter"));
    const QString share = text(4, StringModel::strengthShare);
    QVERIFY2(QLocale().toDouble(share) > 1, qPrintable(share));
    // After the repeat, not within it.
    select(4);
    page().edits()->add({sectionAt(document().scenario().drillString, model().rows()[4].spot)});
    settle();
    QVERIFY2(words().startsWith(QStringLiteral("4 rods, 3 couplings, ")), qPrintable(words()));
}

void TestStringPage::aPageOfThinnedWavesOffersToRoundTheLengths() {
    part<PageTabs>(window()).setCurrentWidget(&part<BlowPage>(window()));
    settle();
    auto& notice = part<WavesNotice>(window());
    QVERIFY(notice.isHidden());
    Scenario scenario = document().scenario();
    scenario.drillString.hammer.sections.front().length = 0.517;
    scenario.drillString.parts[1].repeat = 5;
    QCOMPARE(document().useScenario(scenario, QStringLiteral("odd")), QString());
    settle();
    QVERIFY(window().shown()->impact.waves);
    QVERIFY(window().shown()->impact.wavesDifference);
    QVERIFY(!notice.isHidden());
    QVERIFY2(notice.text().contains(QStringLiteral("hammer 1: 0.517")), qPrintable(notice.text()));
    notice.findChild<QPushButton*>(QStringLiteral("roundLengths"))->click();
    settle();
    QVERIFY(notice.isHidden());
    QVERIFY(!window().shown()->impact.wavesDifference);
    QCOMPARE(undoText(), QStringLiteral("round the lengths"));
}

void TestStringPage::aRowIsDraggedToItsPlace() {
    // Rows: two of the hammer, adapter, coupling and rod in a repeat, skirt, head.
    const auto drag = [&](int from, int to) {
        QHeaderView* header = page().table()->verticalHeader();
        const auto middle = [&](int row) {
            return QPoint(header->width() / 2,
                          header->sectionViewportPosition(row) + header->sectionSize(row) / 2);
        };
        QTest::mousePress(header->viewport(), Qt::LeftButton, {}, middle(from));
        QTest::mouseMove(header->viewport(), (middle(from) + middle(to)) / 2);
        const QPoint beyond(0, to > from ? 6 : -6);
        QTest::mouseMove(header->viewport(), middle(to) + beyond);
        QTest::mouseRelease(header->viewport(), Qt::LeftButton, {}, middle(to) + beyond);
        QCoreApplication::processEvents();
    };
    QStringList before;
    for (int row = 0; row < model().rowCount(); ++row) before << model().rows()[std::size_t(row)].name();
    drag(6, 2);
    QCOMPARE(model().rows()[2].name(), QStringLiteral("bit head"));
    QCOMPARE(undoText(), QStringLiteral("move bit head"));
    document().undoStack().undo();
    QCoreApplication::processEvents();
    for (int row = 0; row < model().rowCount(); ++row)
        QCOMPARE(model().rows()[std::size_t(row)].name(), before[row]);
    const int steps = document().undoStack().index();
    drag(2, 0);
    QCOMPARE(document().undoStack().index(), steps);
    QVERIFY2(words().contains(QStringLiteral("stay in the hammer")), qPrintable(words()));
}

void TestStringPage::aClickInTheDrawingSelectsTheRow() {
    StringDrawing& drawing = *page().drawing();
    int clicked = 0;
    for (std::size_t i = 0; i < model().chain().size(); ++i) {
        const QRectF rect = drawing.sectionRect(i);
        if (rect.width() < 4) continue;
        QTest::mouseClick(&drawing, Qt::LeftButton, {}, rect.center().toPoint());
        QCOMPARE(page().table()->currentIndex().row(), int(model().chain()[i].row));
        ++clicked;
    }
    QVERIFY(clicked >= 8);
    QVERIFY(drawing.textOf(8).contains(QStringLiteral("3rd rod")));
    QVERIFY(drawing.textOf(8).contains(QStringLiteral("ms")));
    QVERIFY(!drawing.sectionAt(QPointF(1, 1)));
}

void TestStringPage::theDrawingIsToScale() {
    StringDrawing& drawing = *page().drawing();
    const QRectF rod = drawing.sectionRect(4), coupling = drawing.sectionRect(3);
    QVERIFY(std::abs(rod.width() / coupling.width() - 3660.0 / 190) < 1e-9);
    QVERIFY(std::abs(rod.height() / coupling.height() - 39.0 / 56) < 1e-9);
    QVERIFY(std::abs(rod.height() / rod.width() / (39.0 / 3660) - drawing.exaggeration()) <
            1e-9 * drawing.exaggeration());
    QCOMPARE(coupling.right(), rod.left());
}

void TestStringPage::theKeysGoThroughTheDrawing() {
    StringDrawing& drawing = *page().drawing();
    QTest::keyClick(&drawing, Qt::Key_Home);
    QTest::keyClick(&drawing, Qt::Key_Right);
    QCOMPARE(page().table()->currentIndex().row(), 1);
    QTest::keyClick(&drawing, Qt::Key_End);
    QCOMPARE(page().table()->currentIndex().row(), 6);
    drawing.setFocus();
    QTest::keyClick(&drawing, Qt::Key_Delete);
    QCOMPARE(undoText(), QStringLiteral("remove bit head"));
    QCOMPARE(model().rowCount(), 6);
}

void TestStringPage::theResultPanelShowsWhatAStringHas() {
    for (const char* ofString : {"hammer rebound", "into the hammer", "hammer separates", "lost in joints"})
        QVERIFY2(isRowThere(QLatin1String(ofString)), ofString);
    QVERIFY(isRowThere(QStringLiteral("tension, after")));
    for (const char* ofRod : {"at every gap", "force peaks"})
        QVERIFY2(!isRowThere(QLatin1String(ofRod)), ofRod);
    QVERIFY(isRowThere(QStringLiteral("margin, this blow")));
    // A velocity has a unit.
    QVERIFY(part<ResultPanel>(window()).text().contains(
        QRegularExpression(QStringLiteral("hammer rebound\t[0-9.,]+.m/s"))));
    // All of the energy is in the bar.
    double sum = 0;
    for (const EnergyPart part : energyParts) sum += energyShare(window().shown()->summary, part);
    QVERIFY(std::abs(sum - 1) < 1e-9);
    openExample("t38_medium_rock");
    for (const char* ofString : {"hammer rebound", "into the hammer", "hammer separates", "lost in joints"})
        QVERIFY2(!isRowThere(QLatin1String(ofString)), ofString);
    QVERIFY(isRowThere(QStringLiteral("tension, after")));
}

void TestStringPage::theFormShowsWhatAppliesToAString() {
    const ScenarioPanel& panel = part<ScenarioPanel>(window());
    for (const char* there : {"string", "hammer", "bit_rock", "drill"})
        QVERIFY2(!panel.findChild<SectionBox*>(QLatin1String(there))->isHidden(), there);
    for (const char* gone : {"rod", "pulse", "groups"})
        QVERIFY2(panel.findChild<SectionBox*>(QLatin1String(gone))->isHidden(), gone);
    type(field("hammer.velocity"), QStringLiteral("12"));
    QCOMPARE(document().scenario().drillString.hammer.velocity, 12.0);
    type(field("hammer.face_stiffness"), QStringLiteral("10 GN/m"));
    type(field("end_time"), QStringLiteral("5"));
    settle();
    QCOMPARE(window().shown()->fault, QString());
    QVERIFY(window().shown()->problem.hammer().face.stiffness.has_value());
    while (document().undoStack().canUndo()) document().undoStack().undo();
    openExample("t38_medium_rock");
    for (const char* gone : {"string", "hammer"})
        QVERIFY2(panel.findChild<SectionBox*>(QLatin1String(gone))->isHidden(), gone);
    QVERIFY(!panel.findChild<SectionBox*>(QStringLiteral("groups"))->isHidden());
}

void TestStringPage::theHammerMayBeWithdrawn() {
    auto* box = part<ScenarioPanel>(window()).findChild<QCheckBox*>(QStringLiteral("hammer.restrike"));
    QVERIFY(box && box->isChecked());
    box->click();
    QVERIFY(!document().scenario().drillString.hammer.restrike);
    QCOMPARE(undoText(), QStringLiteral("withdraw the hammer"));
    document().undoStack().undo();
    QVERIFY(box->isChecked());
}

void TestStringPage::aRockPresetIsTaken() {
    const PresetLibrary library;
    for (const PresetSource& source : library.sources())
        for (const Preset& preset : source.presets) {
            const QString problem = document().applyPreset(preset);
            QCOMPARE(problem.isEmpty(), preset.kind == PresetKind::rock);
        }
    QVERIFY(document().undoStack().canUndo());
    const QByteArray text = document().text();
    QVERIFY(isString(parseScenario(text.toStdString(), "t").scenario));
}

void TestStringPage::aStringIsPinnedAndRevertedTo() {
    part<PinnedRuns>(window()).pinAction()->trigger();
    openExample("t38_medium_rock");
    part<PinnedRuns>(window()).pinAction()->trigger();
    // A page of rods lays the run of a rod alone over its plot.
    PageTabs& pages = part<PageTabs>(window());
    for (int index = 0; index < pages.count(); ++index) {
        if (!pages.isOffered(index)) continue;
        pages.setCurrentIndex(index);
        settle();
        QCOMPARE(window().shown()->fault, QString());
    }
    part<PinnedRuns>(window()).revertTo(0);
    settle();
    QVERIFY(isString(document().scenario()));
    QCOMPARE(model().rowCount(), 7);
    document().undoStack().undo();
    settle();
    QVERIFY(!isString(document().scenario()));
}

void TestStringPage::anAlertLeadsToItsSection() {
    QCOMPARE(document().assign(*findParameter("string.3.yield_strength"), 200e6, document().newGesture()),
             QString());
    settle();
    QVERIFY(!window().shown()->alerts.empty());
    select(0);
    emit part<ResultPanel>(window()).parameterChosen(QStringLiteral("string.7.yield_strength"));
    QCOMPARE(page().table()->currentIndex().row(), 4);
}

void TestStringPage::switchingBetweenRodAndStringDoesNoHarm() {
    QRandomGenerator random(11);
    const char* const examples[] = {"t38_string", "t38_medium_rock", "r32_string", "paper_fig4a",
                                    "t51_string"};
    int strings = 0;
    for (int i = 0; i < 60; ++i) {
        const char* name = examples[random.bounded(int(std::size(examples)))];
        QCOMPARE(document().startFrom(findExample(name)->text, QLatin1String(name)), QString());
        for (int edit = 0; edit < 6; ++edit) {
            if (isString(document().scenario())) {
                ++strings;
                select(random.bounded(model().rowCount()));
                const QList<QAction*>& actions = page().edits()->actions();
                QAction* action = actions[random.bounded(int(actions.size()))];
                if (action->isEnabled() && !action->menu()) action->trigger();
                const std::vector<KeptParameter> numbers = sectionParameters(document().scenario());
                const Parameter& number = *numbers[std::size_t(random.bounded(int(numbers.size())))];
                if (const auto si = number.value(document().scenario()))
                    document().assign(number, *si * (0.8 + 0.4 * random.generateDouble()),
                                      document().newGesture());
            } else {
                const auto all = parameters();
                const Parameter& number = all[std::size_t(random.bounded(int(all.size())))];
                if (number.applies(document().scenario()))
                    if (const auto si = number.value(document().scenario()))
                        document().assign(number, *si * 1.1, document().newGesture());
                PageTabs& pages = part<PageTabs>(window());
                const int index = random.bounded(pages.count());
                if (pages.isOffered(index)) pages.setCurrentIndex(index);
            }
            if (random.bounded(3) == 0) document().undoStack().undo();
            QCoreApplication::processEvents();
            QVERIFY(part<PageTabs>(window()).current().shows(document().scenario()));
            QVERIFY(validate(document().scenario()).empty());
        }
    }
    QVERIFY(strings > 50);
    QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(window()).isBusy(), 60000);
    QCOMPARE(window().shown()->request.scenario, document().scenario());
}

QTEST_MAIN(TestStringPage)
#include "tst_string_page.moc"

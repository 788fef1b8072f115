// SPDX-License-Identifier: GPL-3.0-or-later
// Runs side by side: the numbers of the command line, and their differences.
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "core/blow/blow.h"
#include "core/blow/feed_estimate.h"
#include "core/model/form_conversion.h"
#include "core/study/thrust/thrust_study.h"
#include "core/yaml/examples.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "ui/document/document.h"
#include "ui/pages/compare/compare_page.h"
#include "ui/runs/runs.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

// From the SI number of the command to the one on show and back: a product and a quotient.
constexpr double rounding = 1e-14;

const CompareRow* rowOf(const CompareTable& table, const QString& name) {
    for (const CompareRow& row : table.rows)
        if (row.name == name) return &row;
    return nullptr;
}

void compare(double shown, double expected) {
    const double error = std::abs(shown - expected);
    QVERIFY2(
        error <= rounding * std::abs(expected),
        qPrintable(QStringLiteral("%1 in place of %2").arg(shown, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

}  // namespace

class TestComparePage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void withoutRunsItSaysHowToPin();
    void beforeAnyResultNothingIsCopied();
    void changedParametersComeFirst();
    void theNumbersAreThoseOfTheCommandLine_data();
    void theNumbersAreThoseOfTheCommandLine();
    void theCsvHasWhatIsOnShowWithAllDigits();
    void theReferenceIsChosen();
    void aRunIsRevertedToByItsColumn();
    void theChosenRunStaysChosen();
    void longNamesAreBrokenIntoLines();
    void whatIsNotSolvedHasNoNumbers();
    void withoutUnitsARunHasNoForces();
    void aRodBesideAStringHasOneMaterialAndResultsFirst();
    void stringsHaveTheirResults_data();
    void stringsHaveTheirResults();
    void shapesOfTheWavesOnStringsAreCompared();
    void multiplesOfOtherScalesAreNotCompared();
    void marginsOfTheThrustAreCompared();
    void stringsHaveNoMarginAtEveryGap();
    void whatRoundingMakesIsNoDifference();

  private:
    void pin(const char* key, double si);
    SolvedBlowPtr solve(UnitSystem units) {
        SolveJob job;
        return job.solveNow(
            {.scenario = m_document->scenario(), .units = units, .chosenUnits = {}, .pages = {}});
    }
    void show(UnitSystem units = UnitSystem::si) {
        m_page->setResult(solve(units));
        m_page->resize(900, 600);
        m_page->show();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<ComparePage> m_page;
    std::unique_ptr<RunSolver> m_solver;
    std::unique_ptr<Runs> m_runs;
};

void TestComparePage::initTestCase() {
    keepSettingsIn(m_folder.path());
    QLocale::setDefault(QLocale::c());
}

void TestComparePage::init() {
    m_page.reset();
    m_solver.reset();
    m_document = std::make_unique<Document>();
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
    m_runs = std::make_unique<Runs>(m_document->units());
    m_solver = std::make_unique<RunSolver>(*m_runs);
    m_page = std::make_unique<ComparePage>(*m_runs, m_document->units());
}

void TestComparePage::pin(const char* key, double si) {
    m_document->assign(*findParameter(key), si, m_document->newGesture());
    ScenarioDocument contents = m_document->contents();
    contents.text = m_document->text().toStdString();
    QCOMPARE(m_runs->pin(std::move(contents), nullptr, "first"), QString());
    QTRY_VERIFY(m_runs->list()->back().isSolved());
}

void TestComparePage::stringsHaveTheirResults_data() {
    QTest::addColumn<UnitSystem>("units");
    QTest::newRow("SI") << UnitSystem::si;
    QTest::newRow("US") << UnitSystem::us;
    QTest::newRow("dimensionless") << UnitSystem::dimensionless;
}

void TestComparePage::stringsHaveTheirResults() {
    QFETCH(UnitSystem, units);
    m_document->startFrom(findExample("t38_string")->text, "string");
    pin("string.coupling.diameter", 0.039);
    m_document->undoStack().undo();
    show(units);
    const CompareTable& table = m_page->table();
    const auto results = std::ranges::count(table.rows, CompareRow::Kind::result, &CompareRow::kind);
    QVERIFY2(results > 20, qPrintable(QString::number(results)));
    QVERIFY(rowOf(table, "diameter of 1st to 3rd coupling"));
    for (const char* name : {"peak force", "tension, blow", "tension, after", "into the rock"}) {
        const CompareRow* row = rowOf(table, name);
        QVERIFY2(row, name);
        QVERIFY2(row->difference(0, 1).has_value(), name);
    }
    QVERIFY(compareText(table, ',').contains("peak force"));
}

void TestComparePage::shapesOfTheWavesOnStringsAreCompared() {
    m_document->startFrom(findExample("t38_string")->text, "string");
    Scenario scenario = forcedStringOf(m_document->scenario()).scenario;
    QCOMPARE(m_document->useScenario(scenario, QStringLiteral("force")), QString());
    pin("bit_rock.gamma", 0.2);
    show();
    QVERIFY(!rowOf(m_page->table(), "hammer blow"));
    scenario.pulse.shape = PulseShape::halfSine;
    QCOMPARE(m_document->useScenario(scenario, QStringLiteral("shape")), QString());
    show();
    QVERIFY(rowOf(m_page->table(), "hammer blow"));
}

void TestComparePage::multiplesOfOtherScalesAreNotCompared() {
    pin("rod.length", 3.0);
    m_document->startFrom(findExample("t38_string")->text, "string");
    for (const UnitSystem units : {UnitSystem::si, UnitSystem::dimensionless}) {
        show(units);
        const CompareTable& table = m_page->table();
        QVERIFY(rowOf(table, "peak force")->numbers[0] && rowOf(table, "peak force")->numbers[1]);
        QCOMPARE(rowOf(table, "peak force")->difference(0, 1).has_value(), units == UnitSystem::si);
    }
}

// "210 –" above "– 210", and dozens of rows of sections before the first result.
void TestComparePage::aRodBesideAStringHasOneMaterialAndResultsFirst() {
    pin("rod.length", 3.0);
    m_document->startFrom(findExample("t38_string")->text, "string");
    show();
    const CompareTable& table = m_page->table();
    QVERIFY(!rowOf(table, "Young's modulus E"));
    QVERIFY(!rowOf(table, "density ρ"));
    const auto placeOf = [&](const QString& name) { return rowOf(table, name) - table.rows.data(); };
    QVERIFY(rowOf(table, "sections that differ") && rowOf(table, "results"));
    QVERIFY(placeOf("differences") < placeOf("results"));
    QVERIFY(placeOf("results") < placeOf("sections that differ"));
    QVERIFY(placeOf("peak force") < placeOf("sections that differ"));
    QCOMPARE(placeOf("differences"), std::ptrdiff_t(0));
}

void TestComparePage::withoutRunsItSaysHowToPin() {
    show();
    const auto* empty = m_page->findChild<QLabel*>("empty");
    QVERIFY(empty->isVisible());
    QVERIFY(empty->text().contains("F7"));
    QCOMPARE(m_page->title(), QString("Compare"));
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    QSignalSpy titles(m_page.get(), &Page::titleChanged);
    pin("bit_rock.stiffness", 1.05e8);
    QVERIFY(!empty->isVisible());
    QVERIFY(titles.count() > 0);
    QCOMPARE(m_page->title(), QString("Compare (1)"));
}

void TestComparePage::changedParametersComeFirst() {
    pin("bit_rock.stiffness", 1e8);
    pin("rod.length", 3);
    show();
    const CompareTable& table = m_page->table();
    QCOMPARE(table.titles, QStringList({"now", "A  first", "B  L 3 m"}));
    QVERIFY(table.rows[0].kind == CompareRow::Kind::heading);
    QCOMPARE(table.rows[1].name, QString("length L"));
    QCOMPARE(table.rows[1].unit, QString("m"));
    QCOMPARE(table.rows[1].numbers[1], std::optional(3.66));
    QCOMPARE(table.rows[1].numbers[2], std::optional(3.0));
    QVERIFY(table.rows[2].kind == CompareRow::Kind::heading);
    QVERIFY(table.rows[3].kind == CompareRow::Kind::result);
}

void TestComparePage::beforeAnyResultNothingIsCopied() {
    QVERIFY(m_page->table().titles.isEmpty());
    QVERIFY(compareText(m_page->table(), ',').isEmpty());
}

void TestComparePage::theNumbersAreThoseOfTheCommandLine_data() {
    QTest::addColumn<QString>("row");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("perSi");
    QTest::newRow("e") << "COR e"
                       << ""
                       << "cor" << 1.0;
    QTest::newRow("impulse") << "impulse on the rock"
                             << "N s"
                             << "impulse" << 1.0;
    QTest::newRow("force") << "peak force"
                           << "kN"
                           << "peak_force" << 1e-3;
    QTest::newRow("penetration") << "penetration per blow"
                                 << "mm"
                                 << "residual_penetration" << 1e3;
    QTest::newRow("share") << "into the rock"
                           << "%"
                           << "efficiency" << 100.0;
    QTest::newRow("power") << "percussion power"
                           << "kW"
                           << "percussion_power" << 1e-3;
    QTest::newRow("stress") << "tension, blow"
                            << "MPa"
                            << "peak_tension" << 1e-6;
    QTest::newRow("time") << "last separation"
                          << "ms"
                          << "separation_time" << 1e3;
}

void TestComparePage::theNumbersAreThoseOfTheCommandLine() {
    QFETCH(QString, row);
    QFETCH(QString, unit);
    QFETCH(QString, key);
    QFETCH(double, perSi);
    pin("bit_rock.stiffness", 1e8);
    pin("bit_rock.stiffness", 3e8);
    pin("rod.length", 3);
    show();
    const auto ofCommand = [&](const QStringList& words) {
        const QJsonObject object = json(QStringList{"run", "t38_medium_rock", "--set"} + words);
        return object["si"].toObject()[key].toDouble() * perSi;
    };
    const double a = ofCommand({"bit_rock.stiffness=100 MN/m"});
    const double b = ofCommand({"bit_rock.stiffness=300 MN/m"});
    const double c = ofCommand({"bit_rock.stiffness=300 MN/m", "rod.length=3 m"});
    const CompareRow* found = rowOf(m_page->table(), row);
    QVERIFY2(found, qPrintable(row));
    QCOMPARE(found->unit, unit);
    compare(*found->numbers[1], a);
    compare(*found->numbers[2], b);
    compare(*found->numbers[3], c);
    compare(*found->numbers[0], c);  // the present result is that of the last run
    // Differences of numbers that are right to some units in their last place.
    const double size = rounding * std::max(std::abs(a), std::abs(b));
    QVERIFY(std::abs(*found->difference(2, 1) - (b - a)) <= 4 * size);
    QVERIFY(std::abs(*found->relative(2, 1) - (b - a) / std::abs(a)) <= 4 * rounding * (1 + std::abs(b / a)));
}

void TestComparePage::theCsvHasWhatIsOnShowWithAllDigits() {
    pin("bit_rock.stiffness", 1e8);
    pin("bit_rock.gamma", 0.3);
    show();
    const QByteArray csv = m_page->exports().first().csv();
    const QList<QList<QByteArray>> rows = rowsOf(csv);
    QCOMPARE(rows[0].mid(0, 5), QList<QByteArray>({"quantity", "unit", "now", "A  first", "B  γ 0.3"}));
    QCOMPARE(rows[0][5], QByteArray("(now) − (A  first)"));
    QCOMPARE(rows[0][6], QByteArray("((now) − (A  first)) / |A  first| [%]"));
    QCOMPARE(rows[1].mid(0, 7), QList<QByteArray>({"elasticity γ", "", "0.3", "0.1", "0.3",
                                                   "0.19999999999999998", "199.99999999999997"}));
    const CompareRow* cor = rowOf(m_page->table(), "COR e");
    for (const QList<QByteArray>& row : rows) {
        const bool hasComma = row[0].startsWith('"');  // "compression, blow", which rowsOf() cuts
        QCOMPARE(row.size(), rows[0].size() + (hasComma ? 1 : 0));
        if (row[0] == "COR e") QCOMPARE(row[4].toDouble(), *cor->numbers[2]);
    }
    m_page->findChild<QPushButton*>("copy")->click();
    const QString copied = QGuiApplication::clipboard()->text();
    QCOMPARE(copied.count('\t') % (rows[0].size() - 1), 0);
    QVERIFY(copied.startsWith("quantity\tunit\tnow\t"));
}

void TestComparePage::theReferenceIsChosen() {
    pin("bit_rock.stiffness", 1e8);
    pin("bit_rock.gamma", 0.3);
    show();
    QCOMPARE(m_page->table().reference, std::size_t{1});
    auto* box = m_page->findChild<QComboBox*>("reference");
    QCOMPARE(box->currentText(), QString("A  first"));
    box->setCurrentIndex(2);
    emit box->activated(2);
    QCOMPARE(m_page->table().reference, std::size_t{2});
    QCOMPARE(m_runs->reference()->number, 1);
    box->setCurrentIndex(0);
    emit box->activated(0);
    QCOMPARE(m_page->table().reference, std::size_t{0});
    QVERIFY(!m_runs->reference());
    QCOMPARE(box->currentIndex(), 0);
}

void TestComparePage::aRunIsRevertedToByItsColumn() {
    pin("bit_rock.stiffness", 1e8);
    pin("bit_rock.gamma", 0.3);
    show();
    QSignalSpy reverts(m_page.get(), &ComparePage::revertRequested);
    auto* button = m_page->findChild<QPushButton*>("revert");
    auto* view = m_page->findChild<QTableView*>("comparison");
    QVERIFY(!button->isEnabled());
    view->setCurrentIndex(view->model()->index(3, 0));
    QVERIFY(!button->isEnabled());  // that is the present result
    view->setCurrentIndex(view->model()->index(3, 2));
    QCOMPARE(button->text(), QString("Revert to B"));
    button->click();
    QCOMPARE(reverts.count(), 1);
    QCOMPARE(reverts[0][0].toInt(), 1);
}

// Another scenario differs in other parameters: the table has other rows.
void TestComparePage::theChosenRunStaysChosen() {
    pin("bit_rock.stiffness", 1e8);
    pin("bit_rock.gamma", 0.3);
    show();
    auto* view = m_page->findChild<QTableView*>("comparison");
    auto* button = m_page->findChild<QPushButton*>("revert");
    view->setCurrentIndex(view->model()->index(3, 2));
    const int rows = view->model()->rowCount();
    m_document->assign(*findParameter("rod.length"), 2, m_document->newGesture());
    show();
    QVERIFY(view->model()->rowCount() != rows);
    QCOMPARE(view->currentIndex().column(), 2);
    QCOMPARE(button->text(), QString("Revert to B"));
    m_runs->remove(0);
    show();
    QCOMPARE(view->currentIndex().column(), 1);
    QCOMPARE(button->text(), QString("Revert to B"));
    m_runs->remove(1);
    pin("bit_rock.gamma", 0.4);
    show();
    QVERIFY(!button->isEnabled());
}

void TestComparePage::longNamesAreBrokenIntoLines() {
    pin("bit_rock.stiffness", 1e8);
    show();
    auto* view = m_page->findChild<QTableView*>("comparison");
    const int width = view->columnWidth(1), height = view->horizontalHeader()->height();
    m_runs->rename(0, "medium rock with a rod of twelve feet and a worn bit");
    show();
    QCOMPARE(view->columnWidth(1), width);
    QVERIFY(view->horizontalHeader()->height() >= height + 2 * view->fontMetrics().lineSpacing());
    const QAbstractItemView& cells = *view;
    QVERIFY(view->columnWidth(1) >= cells.sizeHintForColumn(1));
}

void TestComparePage::whatIsNotSolvedHasNoNumbers() {
    pin("bit_rock.stiffness", 1e8);
    m_page->setResult(failedBlow(
        {.scenario = m_document->scenario(), .units = UnitSystem::si, .chosenUnits = {}, .pages = {}},
        "out of rock"));
    m_page->show();
    const CompareRow* force = rowOf(m_page->table(), "peak force");
    QVERIFY(force);
    QVERIFY(!force->numbers[0]);
    QVERIFY(force->numbers[1]);
    QVERIFY(!force->difference(0, 1));
}

void TestComparePage::withoutUnitsARunHasNoForces() {
    pin("bit_rock.stiffness", 1e8);
    m_document->startFrom(findExample("paper_fig4b")->text, "example");
    pin("beta", 0.6);
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
    show();
    const CompareRow* force = rowOf(m_page->table(), "peak force");
    QVERIFY(force->numbers[1]);
    QVERIFY(!force->numbers[2]);
    QVERIFY(rowOf(m_page->table(), "COR e")->numbers[2]);
    // In the units of its groups it has them.
    show(UnitSystem::dimensionless);
    force = rowOf(m_page->table(), "peak force");
    QCOMPARE(force->unit, QString("F₀"));
    QCOMPARE(*force->numbers[2], m_runs->list()->back().blow->summary.peakForce);
}

// That at every gap is found beside the blow, as soon as it is known.
void TestComparePage::marginsOfTheThrustAreCompared() {
    pin("bit_rock.stiffness", 1e8);
    pin("rod.length", 3);
    show();
    const auto margins = [&](const char* name) {
        const CompareRow* row = rowOf(m_page->table(), name);
        return row ? row->numbers : std::vector<std::optional<double>>(3);
    };
    const auto isThere = [](const std::optional<double>& number) { return number.has_value(); };
    QTRY_VERIFY_WITH_TIMEOUT(std::ranges::all_of(margins("feed force margin at every gap"), isThere), 60000);
    Scenario first = m_document->scenario();
    findParameter("rod.length")->assign(first, 3.66);
    for (const auto& [column, scenario] : {std::pair(std::size_t{1}, first), {2, m_document->scenario()}}) {
        const double installed = *scenario.drill.thrust;
        const Blow blow = solveBlow(scenario, {}, Detail::cor);
        const double needed = *thrustNeeded(scenario, blow.summary.cor, blow.summary.transferred);
        const double everywhere = studyThrust(scenario).largestNeed().thrust;
        const auto isShown = [&](const char* name, double newton) {
            return std::abs(*margins(name)[column] - newton / 1e3) < 1e-9;
        };
        QVERIFY(isShown("feed force margin, this blow", installed - needed));
        QVERIFY(isShown("feed force required at every gap", everywhere));
        QVERIFY(isShown("feed force margin at every gap", installed - everywhere));
    }
    const CompareRow* margin = rowOf(m_page->table(), "feed force margin at every gap");
    QVERIFY(*margin->numbers[1] > 0);  // and shown with its sign
    QCOMPARE(margin->text(1, QLocale::c()).front(), QChar('+'));
    m_page->setResult(solve(UnitSystem::dimensionless));
    QVERIFY(!rowOf(m_page->table(), "feed force margin, this blow"));
}

// For a string only this blow and rigid rock are known, whatever its largest need is called elsewhere.
void TestComparePage::stringsHaveNoMarginAtEveryGap() {
    m_document->startFrom(findExample("r32_string")->text, "example");
    const Blow blow = solveBlow(m_document->scenario(), {}, Detail::cor);
    SolvedBlow solved;
    static_cast<Blow&>(solved) = blow;
    QVERIFY(blow.feed);
    CompareColumn column{.title = "A", .scenario = &solved.scenario, .blow = &solved};
    const UnitChoice units;
    const auto names = [&](bool isOfAllGaps) {
        column.ofAllGaps = blow.feed;
        for (ThrustNeed& need : column.ofAllGaps->needs) need.known = need.known || isOfAllGaps;
        QStringList all;
        for (const CompareRow& row : compareTable({column}, 0, UnitSystem::si, {}, units).rows)
            all << row.name;
        return all;
    };
    QVERIFY(names(true).contains("feed force required at every gap"));
    QVERIFY(!names(false).contains("feed force required at every gap"));
}

void TestComparePage::whatRoundingMakesIsNoDifference() {
    CompareTable table;
    table.titles = QStringList{"now", "A"};
    table.rows.push_back({.kind = CompareRow::Kind::result,
                          .name = "COR e",
                          .unit = {},
                          .numbers = {0.4, 0.4 + 0x1p-53},
                          .words = {}});
    CompareModel model;
    model.present(table, {});
    const QString text = model.index(0, 1).data().toString();
    QVERIFY2(text.contains(QStringLiteral("\n±0 ")), qPrintable(text));
}

QTEST_MAIN(TestComparePage)
#include "tst_compare_page.moc"

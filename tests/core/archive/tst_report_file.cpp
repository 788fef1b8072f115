// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a scenario: inputs with their sources, the numbers of the JSON, and a page that can be run
// again.
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/archive/report_file.h"
#include "core/archive/result_scenario.h"
#include "core/report/blow_json.h"
#include "core/report/feed_words.h"
#include "core/report/html_text.h"
#include "core/report/report_html.h"
#include "core/study/thrust/thrust_margins.h"
#include "core/text/printed_text.h"
#include "core/yaml/examples.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/scenario_text.h"
#include "tests/support/without_strengths.h"

using namespace drillwave;

namespace {

BlowReport reportOfExample(const char* name) {
    return reportOn(parseScenario(findExample(name)->text, name));
}

std::string pageOf(const BlowReport& report) {
    return reportHtml(report, {}, ReportMedium::screen);
}

/// The row of a table of the page.
QString rowOf(const std::string& page, const QString& key) {
    const QRegularExpression row("<tr data-key=\"" + QRegularExpression::escape(key) + "\">.*?</tr>",
                                 QRegularExpression::DotMatchesEverythingOption);
    return row.match(QString::fromStdString(page)).captured();
}

/// The whole numbers behind the cells of a row.
QList<double> numbersOf(const QString& row) {
    QList<double> numbers;
    auto found = QRegularExpression("data-value=\"([^\"]*)\"").globalMatch(row);
    while (found.hasNext()) numbers << found.next().captured(1).toDouble();
    return numbers;
}

ReportInput inputOf(const std::vector<ReportInput>& inputs, std::string_view key) {
    for (const ReportInput& input : inputs)
        if (input.key == key) return input;
    return {};
}

std::vector<ReportInput> inputsOfText(const std::string& text) {
    return inputsOf(parseScenario(text, "here").scenario, text);
}

/// The default example without comments.
std::string bareText() {
    std::string text;
    for (const QString& line :
         QString::fromStdString(std::string(defaultExample().text)).split(QLatin1Char('\n')))
        if (!line.startsWith(QLatin1Char('#')))
            text += line.section(QStringLiteral(" #"), 0, 0).trimmed().isEmpty()
                        ? std::string()
                        : line.section(QStringLiteral(" #"), 0, 0).toStdString() + "\n";
    return text;
}

}  // namespace

class TestReportFile : public QObject {
    Q_OBJECT

  private slots:
    void aCommentIsTheSourceOfTheValueBeforeIt();
    void aCommentBehindBracesIsAboutAllValuesInThem();
    void aPresetThatIsFollowedIsTheSource();
    void whatTheFileLeavesOutIsAssumedByTheProgram();
    void everyExampleHasASourceForEveryInput();
    void numbersHaveTheQuantityOfTheForm();
    void wordsAreCalledWhatTheyAre();
    void sectionsStandOnceWithTheirSources();
    void aStringIsReportedWithItsSections();
    void theNumbersAreThoseOfTheJson_data();
    void theNumbersAreThoseOfTheJson();
    void thePageRunsAgainToTheSameDigits_data();
    void thePageRunsAgainToTheSameDigits();
    void whatUsersTypeIsNoMarkup();
    void theEstimateIsThatOfTheThrustStudy();
    void aScenarioWithoutFrequencySaysWhyThereIsNoThrust();
    void aBlowOfManyPiecesIsReportedWithoutStudies();
    void progressTellsOfEveryStudy();
    void thePaperCutsALongScenarioShort();
    void aPageWithoutARecordIsRefused();
};

void TestReportFile::aCommentIsTheSourceOfTheValueBeforeIt() {
    const std::vector<ReportInput> inputs = inputsOfText(std::string(defaultExample().text));
    const ReportInput bore = inputOf(inputs, "rod.bore");
    QCOMPARE(bore.value, std::string("14.5 mm"));
    QCOMPARE(bore.si, std::optional(0.0145));
    QCOMPARE(bore.source.text(), std::string("flushing hole, assumed typical"));
    QCOMPARE(inputOf(inputs, "bit_rock.gap").source.text(), std::string("not stated"));
    QCOMPARE(inputs.front().key, std::string("rod.length"));
    QCOMPARE(inputs.back().key, std::string("drill.wave_loss"));
}

void TestReportFile::aCommentBehindBracesIsAboutAllValuesInThem() {
    const std::vector<ReportInput> inputs = inputsOfText(
        "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 1, tau: 10, delta: 0}  # Fig. 4 (a)\n"
        "pulse: {shape: rectangular}\n");
    for (const char* key : {"beta", "gamma", "tau", "delta"})
        QCOMPARE(inputOf(inputs, key).source.text(), std::string("Fig. 4 (a)"));
    QCOMPARE(inputOf(inputs, "pulse.shape").source.text(), std::string("not stated"));
}

void TestReportFile::aPresetThatIsFollowedIsTheSource() {
    const std::string bare = bareText();
    QVERIFY(bare.find('#') == std::string::npos);
    const auto preset = std::ranges::find(builtInPresets(), PresetKind::rock, &Preset::kind);
    const Scenario scenario = withPreset(parseScenario(bare, "here").scenario, *preset);
    const std::vector<ReportInput> inputs = inputsOf(scenario, scenarioText(scenario));
    QCOMPARE(inputOf(inputs, "bit_rock.stiffness").source.text(),
             "preset " + preset->name + ": " + preset->values.front().source);
    QCOMPARE(inputOf(inputs, "drill.thrust").source.text(), std::string("not stated"));
}

void TestReportFile::whatTheFileLeavesOutIsAssumedByTheProgram() {
    std::string bare = bareText();
    const std::size_t gap = bare.find("  gap: 0 mm\n");
    QVERIFY(gap != std::string::npos);
    bare.erase(gap, std::string("  gap: 0 mm\n").size());
    const ReportInput input = inputOf(inputsOfText(bare), "bit_rock.gap");
    QCOMPARE(input.value, std::string("0 mm"));
    QCOMPARE(input.source.text(), std::string("assumed by the program"));
}

void TestReportFile::everyExampleHasASourceForEveryInput() {
    for (const Example& example : builtInExamples()) {
        if (example.ofString) continue;  // a report is of a uniform rod
        const std::vector<ReportInput> inputs = inputsOfText(std::string(example.text));
        QVERIFY(inputs.size() >= 2);
        for (const ReportInput& input : inputs)
            QVERIFY2(!input.source.isEmpty() && !input.label.isEmpty() && !input.value.empty(),
                     input.key.c_str());
    }
}

// The loading curve of a dimensionless rock has forces in F0 and penetrations in d0.
void TestReportFile::numbersHaveTheQuantityOfTheForm() {
    const std::string drive = "pulse: {shape: rectangular}\n";
    const std::string groups =
        "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}\n" + drive;
    const std::string power = groups + "bit_rock: {law: power, exponent: 1.5, reference_penetration: 0.5}\n";
    const ReportInput reference = inputOf(inputsOfText(power), "bit_rock.reference_penetration");
    QCOMPARE(reference.value, std::string("0.5"));
    QCOMPARE(reference.quantity, std::optional(Quantity::ratio));
    const std::string corners = groups + "bit_rock: {law: corners, corners: [{force: 0.5, slope: 0.3}]}\n";
    QCOMPARE(inputOf(inputsOfText(corners), "bit_rock.corner.1.force").quantity,
             std::optional(Quantity::ratio));
    const std::string inSi = bareText();
    QCOMPARE(inputOf(inputsOfText(inSi), "rod.bore").quantity, std::optional(Quantity::length));
}

void TestReportFile::wordsAreCalledWhatTheyAre() {
    Scenario scenario = parseScenario(bareText(), "here").scenario;
    scenario.drill.indexing = RockIndexing::same;
    const ReportInput indexing = inputOf(inputsOf(scenario, scenarioText(scenario)), "drill.indexing");
    QCOMPARE(indexing.value, std::string("same"));
    QCOMPARE(indexing.label.text(), std::string("rock at the next blow"));
    QCOMPARE(indexing.source.text(), std::string("not stated"));
}

void TestReportFile::sectionsStandOnceWithTheirSources() {
    const Example& example = *findExample("t38_string");
    const std::vector<ReportSection> sections =
        sectionsOf(parseScenario(example.text, "here").scenario, example.text);
    QCOMPARE(sections.size(), std::size_t{7});  // those of the repeat once
    // Behind the list that they are in.
    QCOMPARE(sections[0].place.text(), std::string("hammer 1"));
    QCOMPARE(sections[0].source.text(), std::string("assumed: 6.9 kg, 342 J"));
    const ReportSection& rod = sections[4];
    QCOMPARE(rod.key, std::string("string.3"));
    QCOMPARE(rod.times, 3);
    QCOMPARE(rod.source.text(), std::string("a 12 ft rod, bore typical"));
    QCOMPARE(inputOf(rod.values, "length").value, std::string("3660 mm"));
    QCOMPARE(inputOf(rod.values, "length").si, std::optional(3.66));
    QCOMPARE(sections.back().place.text(), std::string("9"));
    // Each line of a block has a remark of its own; without any, the preset is the source.
    const SectionPreset& preset = builtInSectionPresets().back();
    Scenario scenario = parseScenario(example.text, "here").scenario;
    scenario.drillString.parts = {{.repeat = 1, .group = false, .sections = {preset.sections.front()}}};
    const std::vector<ReportSection> bare = sectionsOf(scenario, scenarioText(scenario));
    QCOMPARE(bare.back().source.text(), "preset " + preset.name + ": " + preset.source);
    const std::string block =
        "drillwave: 2\nhammer:\n  velocity: 10 m/s\n  sections:\n    - length: 0.5 m   # drawing 7\n"
        "      diameter: 50 mm   # measured\nstring:\n  - {length: 3 m, diameter: 38 mm}\n"
        "bit_rock: {stiffness: 100 MN/m, gamma: 0.1, gap: 0 mm}\n";
    const std::vector<ReportSection> own = sectionsOf(parseScenario(block, "here").scenario, block);
    QCOMPARE(own.front().source.text(), std::string("drawing 7; measured"));
    QCOMPARE(own.back().source.text(), std::string("not stated"));
}

// Against its strengths where it has them.
void TestReportFile::aStringIsReportedWithItsSections() {
    ScenarioDocument weak = parseScenario(std::string(findExample("t38_string")->text), "here");
    weak.scenario = test::withoutStrengths(weak.scenario);
    const BlowReport plain = reportOn(weak);
    QVERIFY(!plain.gap && plain.gapProblem.isEmpty() && plain.thrust);
    const std::string page = pageOf(plain);
    for (const char* heading : {"Hammer and string", "Energy balance", "Largest stresses of every section",
                                "Required feed force", "Required feed"})
        QVERIFY2(page.find("<h2>" + std::string(heading) + "</h2>") != std::string::npos, heading);
    QVERIFY(page.find("All gaps") == std::string::npos);
    QVERIFY(page.find("of yield") == std::string::npos);
    QCOMPARE(numbersOf(rowOf(page, QStringLiteral("string.3"))), (QList<double>{3.66, 0.039, 0.0145, 0.05}));
    ScenarioDocument document = parseScenario(test::losslessText("t38_string"), "here");
    findParameter("string.rod.yield_strength")->assign(document.scenario, 300e6);
    const std::string strong = pageOf(reportOn(document));
    QVERIFY(strong.find("of yield") != std::string::npos);
    QVERIFY(strong.find("<td class=\"whole\">121\u00a0%") !=
            std::string::npos);  // 362.2 MPa of tension in the last rod
    QVERIFY(strong.find("class=\"warning\"") != std::string::npos);
}

void TestReportFile::theNumbersAreThoseOfTheJson_data() {
    QTest::addColumn<QByteArray>("name");
    for (const Example& example : builtInExamples())
        QTest::newRow(example.name.c_str()) << QByteArray::fromStdString(example.name);
}

void TestReportFile::theNumbersAreThoseOfTheJson() {
    QFETCH(QByteArray, name);
    const std::string page = pageOf(reportOfExample(name.constData()));
    const Scenario scenario = parseScenario(findExample(name.toStdString())->text, "here").scenario;
    Blow blow = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
    addThrustMargin(blow);
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(blowJson(blow, "x"))).object();
    int compared = 0;
    for (const char* part : {"dimensionless", "si"}) {
        const QJsonObject object = json[QLatin1String(part)].toObject();
        for (const QString& key : object.keys()) {
            if (object[key].isNull()) continue;
            QVERIFY2(numbersOf(rowOf(page, key)).contains(object[key].toDouble()), qPrintable(key));
            ++compared;
        }
    }
    QVERIFY(compared >= (hasUnits(scenario) ? 40 : 20));
}

void TestReportFile::thePageRunsAgainToTheSameDigits_data() {
    theNumbersAreThoseOfTheJson_data();
}

void TestReportFile::thePageRunsAgainToTheSameDigits() {
    QFETCH(QByteArray, name);
    const std::string page = pageOf(reportOfExample(name.constData()));
    const ScenarioInput again = parseInput(page, "report.html");
    QVERIFY(again.isResult);
    QCOMPARE(again.document.text, std::string(findExample(name.toStdString())->text));
    // A string knows no other method.
    QVERIFY(isString(again.document.scenario) || (again.method && again.method->method == Method::exact));
    QCOMPARE(pageOf(reportOn(again.document)), page);
}

void TestReportFile::whatUsersTypeIsNoMarkup() {
    ScenarioDocument document = parseScenario(defaultExample().text, "here");
    document.scenario.title = "</script><script>alert(\"R&D\")</script>";
    const std::string page = pageOf(reportOn(document));
    QVERIFY(page.find("<script>") == std::string::npos);
    QVERIFY(page.find("<title>&lt;/script&gt;&lt;script&gt;alert(&quot;R&amp;D&quot;)") != std::string::npos);
    QCOMPARE(QString::fromStdString(page).count(QStringLiteral("</script>")), 1);
    QCOMPARE(parseInput(page, "report.html").document.scenario.title, document.scenario.title);
}

void TestReportFile::theEstimateIsThatOfTheThrustStudy() {
    const BlowReport report = reportOfExample("t38_medium_rock");
    QVERIFY(report.thrust && report.gap);
    QVERIFY(report.blow.feed == report.thrust->study.feed);
    const PrintedStyle style(plainStyle());
    for (const Message& sentence : thrustSentences(report.blow.scenario, report.thrust->study.feed,
                                                   report.thrust->study.shareFull, style))
        QVERIFY2(pageOf(report).find(escapedHtml(style.said(sentence))) != std::string::npos,
                 sentence.text().c_str());
}

void TestReportFile::aScenarioWithoutFrequencySaysWhyThereIsNoThrust() {
    const BlowReport report = reportOfExample("paper_fig4a");
    QVERIFY(!report.thrust);
    QVERIFY(!report.thrustProblem.isEmpty());
    QVERIFY(pageOf(report).find("<p>The " + report.thrustProblem.text().substr(4) + ".</p>") !=
            std::string::npos);
}

void TestReportFile::aBlowOfManyPiecesIsReportedWithoutStudies() {
    ScenarioDocument document = parseScenario(defaultExample().text, "here");
    std::vector<TablePoint> points;
    for (int i = 0; i <= 6000; ++i) points.push_back({i * 5e-8, i % 2 == 0 ? 2e5 : 2.1e5});
    document.scenario.pulse.shape = PulseShape::table;
    document.scenario.pulse.tablePoints = points;
    const BlowReport report = reportOn(document);
    QVERIFY(report.blow.isSolved() && report.blow.impact.pieces > 10'000);
    QVERIFY(!report.gap && !report.thrust && !report.blow.thrustMargin());
    const std::string page = pageOf(report);
    for (const std::string& words : {report.gapProblem.text(), report.thrustProblem.text()})
        QVERIFY2(page.find("<p>" + words + "</p>") != std::string::npos, words.c_str());
    const std::string estimate =
        estimateText(report.blow.scenario, report.blow.feed, PrintedStyle(plainStyle()));
    QVERIFY(page.find("</h1>\n<p class=\"decision\">" + escapedHtml(estimate) + "</p>") != std::string::npos);
    QVERIFY(inputOf(report.inputs, "pulse.points").value == "6001");
}

void TestReportFile::progressTellsOfEveryStudy() {
    std::vector<double> shares;
    const BlowReport report = reportOn(parseScenario(defaultExample().text, "here"), {},
                                       [&](double share) { shares.push_back(share); });
    QVERIFY(report.thrust && report.gap);
    QVERIFY(std::ranges::is_sorted(shares));
    QVERIFY(std::ranges::any_of(shares, [](double share) { return share > 0 && share < 0.5; }));
    QVERIFY(std::ranges::any_of(shares, [](double share) { return share > 0.5; }));
    QVERIFY(shares.back() <= 1);
}

void TestReportFile::thePaperCutsALongScenarioShort() {
    BlowReport report = reportOfExample("paper_fig4a");
    for (int i = 0; i < 1000; ++i) report.scenarioText += "# line " + std::to_string(i) + "\n";
    const std::string paper = reportHtml(report, {}, ReportMedium::paper);
    QVERIFY(paper.find("# line 100\n") != std::string::npos);
    QVERIFY(paper.find("# line 200\n") == std::string::npos);
    QVERIFY(paper.find("The rest of the scenario is in the file attached to the PDF.") != std::string::npos);
    QVERIFY(pageOf(report).find("# line 999\n") != std::string::npos);
}

void TestReportFile::aPageWithoutARecordIsRefused() {
    for (const char* page :
         {"<!DOCTYPE html>\n<html><body>beta: 0.5</body></html>\n", "drillwave: 1\n", ""}) {
        try {
            parseInput(page, "page.html");
            QFAIL("was taken");
        } catch (const ScenarioError& error) {
            QCOMPARE(error.kind(), ScenarioError::Kind::unreadable);
            QVERIFY(error.lines().front().find("drillwave report") != std::string::npos);
        }
    }
}

QTEST_GUILESS_MAIN(TestReportFile)
#include "tests/support/lossless_string.h"
#include "tst_report_file.moc"

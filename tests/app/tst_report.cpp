// SPDX-License-Identifier: GPL-3.0-or-later
// `drillwave report` as a shell runs it: pages that can be run again, and what becomes of bad names.
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"
#include "tests/support/tries.h"

using namespace drillwave::test;

namespace {

QStringList contents(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

/// Adds few blows and few designs to a scenario.
QByteArray withStudies(QByteArray scenario) {
    return scenario.replace("\ndrill:", "\ndrill:\n  blows: 60\n  settle: 20") +
           "\ndesign:\n  uncertain: [\"bit_rock.gap=0mm:1mm\"]\n  choose: "
           "[\"pulse.duration=150us:250us:3\"]\n  aims: [\"max:efficiency@q05\"]\n  samples: 64\n";
}

/// The table of that name in a page, with blanks that break.
QString tableOf(const QByteArray& html, const char* name) {
    const qsizetype begin = html.indexOf("<table id=\"" + QByteArray(name) + "-table\">");
    const QByteArray table = html.mid(begin, html.indexOf("</table>", begin) - begin);
    return QString::fromUtf8(table).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

qsizetype pagesOf(const QByteArray& pdf) {
    return pdf.count("/Type /Page\n");
}

}  // namespace

class TestReport : public QObject {
    Q_OBJECT

  private slots:
    void everyExampleMakesAPageAndTwoToFiveSheets_data();
    void everyExampleMakesAPageAndTwoToFiveSheets();
    void textsOfAnyLengthMakeTwoToEightSheets_data();
    void textsOfAnyLengthMakeTwoToEightSheets();
    void thePageRunsAgainToTheSameNumbers();
    void theSameReportIsTheSameBytes();
    void standardOutputGetsThePage();
    void settingsAndPresetsAreReportedAsTheyAreSolved();
    void theHeadSaysWhoseItIs();
    void whatIsToBeDoneStandsFirstAndTheSolverLast();
    void studiesHaveTheNumbersOfTheirCommands();
    void studiesWithoutSettingsLeaveNothing_data();
    void studiesWithoutSettingsLeaveNothing();
    void badPlacesAreRefused_data();
    void badPlacesAreRefused();
    void existingFilesAreOverwrittenOnlyOnRequest();
    void whatCannotBeSolvedLeavesNothing();
    void reportsWithoutPlotsNeedNoWindow();
    void withoutFontsPicturesAreRefused();
};

void TestReport::everyExampleMakesAPageAndTwoToFiveSheets_data() {
    QTest::addColumn<QString>("name");
    int number = 0;
    for (const char* name :
         {"paper_fig4a", "paper_fig4b", "paper_fig8_minimum", "reference_case", "r32_hard_rock",
          "t38_medium_rock", "t51_soft_rock", "r32_string", "t38_string", "t51_string"})
        if (isChosen(number++, 5)) QTest::newRow(name) << name;
}

void TestReport::everyExampleMakesAPageAndTwoToFiveSheets() {
    QFETCH(QString, name);
    const QTemporaryDir place;
    output({"report", name, "-o", place.filePath("out")});
    QCOMPARE(contents(place.filePath("out")), (QStringList{"report.html", "report.pdf"}));
    const QByteArray html = read(place.filePath("out/report.html"));
    QVERIFY(html.startsWith("<!DOCTYPE html>"));
    // Nothing is fetched from anywhere.
    QCOMPARE(html.count("src=\""), html.count("src=\"data:image/svg+xml;base64,"));
    QVERIFY(!html.contains("href="));
    QVERIFY(html.count("<img ") >= (name == "reference_case" ? 3 : 4));
    const QByteArray pdf = read(place.filePath("out/report.pdf"));
    QVERIFY(pdf.startsWith("%PDF-"));
    const qsizetype pages = pagesOf(pdf);
    QVERIFY2(pages >= 2 && pages <= 5, qPrintable(QString::number(pages)));
    QVERIFY(pdf.contains("scenario.yaml") || pdf.contains(QByteArray("\0s\0c\0e\0n", 8)));
}

void TestReport::textsOfAnyLengthMakeTwoToEightSheets_data() {
    constexpr int length = 50'000;
    const QByteArray text = read(example(QStringLiteral("t38_medium_rock"))), word(length, 'W');
    const auto with = [&](const QByteArray& before, const QByteArray& after) {
        return QByteArray(text).replace(before, after);
    };
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("a line of words") << text + "# " + QByteArray("measured ").repeated(length / 9) + '\n';
    QTest::newRow("a line without a blank") << text + "# " + word + '\n';
    QTest::newRow("tabs") << text + "#" + QByteArray(length, '\t') + "x\n";
    QTest::newRow("wide characters") << text + "# " + QByteArray("測").repeated(length) + '\n';
    QTest::newRow("a long source") << with("assumed", QByteArray("by drilling ").repeated(length / 12));
    QTest::newRow("sources without a blank") << with("assumed", word);
    QTest::newRow("sources on every line") << with("\n  ", " # " + word.left(5000) + "\n  ");
    // A column of fatigue strengths would narrow that of the sources.
    const QByteArray string = read(example(QStringLiteral("t38_string")))
                                  .replace(", fatigue_strength: 250 MPa", "")
                                  .replace(", fatigue_strength: 400 MPa", "");
    const QByteArray section =
        "  - {name: tube, length: 60 mm, diameter: 76 mm, yield_strength: 900 MPa}   # " + word.left(200) +
        "\n";
    QTest::newRow("a string of many sections")
        << QByteArray(string).replace("bit_rock:", section.repeated(300) + "bit_rock:");
    QTest::newRow("a long title") << with("title: ", "title: " + word);
}

void TestReport::textsOfAnyLengthMakeTwoToEightSheets() {
    QFETCH(QByteArray, text);
    const QTemporaryDir place;
    write(place.filePath("a.yaml"), text);
    output({"report", place.filePath("a.yaml"), "-o", place.filePath("a.pdf")});
    const qsizetype pages = pagesOf(read(place.filePath("a.pdf")));
    // Eight where type of a fixed width is as wide as that of DejaVu; with others seven.
    QVERIFY2(pages >= 2 && pages <= 8, qPrintable(QString::number(pages)));
}

void TestReport::thePageRunsAgainToTheSameNumbers() {
    const QTemporaryDir place;
    for (const char* name : {"t38_medium_rock", "t38_string"}) {
        const QString page = place.filePath(QLatin1String(name) + QLatin1String(".html"));
        output({"report", name, "-o", page});
        const QJsonObject before = json({"run", name});
        const QJsonObject again = json({"run", page});
        for (const char* part : {"dimensionless", "si", "groups", "scenario", "sections"})
            QCOMPARE(again[QLatin1String(part)], before[QLatin1String(part)]);
    }
}

void TestReport::theSameReportIsTheSameBytes() {
    const QTemporaryDir place;
    int number = 0;
    for (const char* scenario : {"r32_hard_rock", "t38_string", "paper_fig4b"}) {
        if (!isChosen(number++, 3)) continue;
        for (const char* name : {"a.html", "b.html", "a.pdf", "b.pdf"})
            output({"report", scenario, "-o", place.filePath(name), "--force"});
        QCOMPARE(read(place.filePath("b.html")), read(place.filePath("a.html")));
        QCOMPARE(read(place.filePath("b.pdf")), read(place.filePath("a.pdf")));
    }
}

void TestReport::standardOutputGetsThePage() {
    const QTemporaryDir place;
    output({"report", "paper_fig4a", "-o", place.filePath("a.html")});
    QCOMPARE(output({"report", "paper_fig4a", "-o", "-"}), read(place.filePath("a.html")));
}

void TestReport::settingsAndPresetsAreReportedAsTheyAreSolved() {
    const QByteArray page = output(
        {"report", "t38_medium_rock", "--set", "bit_rock.stiffness=300MN/m", "title=<b>R&D</b>", "-o", "-"});
    QVERIFY(page.contains("<h1>&lt;b&gt;R&amp;D&lt;/b&gt;</h1>"));
    QVERIFY(page.contains("<td data-value=\"3e+08\">300 MN/m</td><td>not stated</td>"));
}

void TestReport::theHeadSaysWhoseItIs() {
    const QByteArray page = output({"report", "t38_medium_rock", "--project", "North <adit>", "--author",
                                    "A. Bohrer", "--date", "2 May", "-o", "-"});
    const qsizetype title = page.indexOf("<h1>"), decision = page.indexOf("class=\"decision\"");
    const QByteArray head = page.mid(title, decision - title);
    QVERIFY2(head.contains("<tr data-key=\"project\"><th>Project</th><td>North &lt;adit&gt;</td></tr>"),
             head);
    QVERIFY(head.contains("A. Bohrer") && head.contains("2 May"));
    QVERIFY(!head.contains("Customer"));  // not given
    const QByteArray german = output({"report", "t38_medium_rock", "--language", "de", "-o", "-"});
    QVERIFY(german.contains("<html lang=\"de\">") && german.contains("<h2>Erforderlicher Andruck</h2>"));
    QVERIFY(german.contains("data-value=\"0.4297") && german.contains("0,429738"));
    QVERIFY(!output({"report", "t38_medium_rock", "-o", "-"}).contains("head-table"));
}

void TestReport::whatIsToBeDoneStandsFirstAndTheSolverLast() {
    for (const char* name : {"t38_medium_rock", "t38_string", "paper_fig4b"}) {
        const QByteArray page = output({"report", name, "-o", "-"});
        const char* order[] = {"class=\"decision\"",
                               "<img ",
                               "<h2>Required feed",
                               "<h2>Results",
                               "<h2>Inputs",
                               "<h2>Plots",
                               "<h2>Scenario",
                               "<h2>Numerical error",
                               "error of the momentum balance"};
        qsizetype before = 0;
        for (const char* part : order) {
            const qsizetype at = page.indexOf(part);
            QVERIFY2(at > before, part);
            before = at;
        }
        QCOMPARE(page.count("<h2>"), page.left(page.indexOf("<h2>Numerical error")).count("<h2>") + 1);
    }
}

void TestReport::studiesHaveTheNumbersOfTheirCommands() {
    const QTemporaryDir place;
    const QString file = place.filePath("a.yaml");
    write(file, withStudies(read(example("t38_medium_rock"))));
    output({"report", file, "--with", "design,drill", "-o", place.filePath("out")});
    const QByteArray html = read(place.filePath("out/report.html"));
    for (const char* picture : {"drilling", "design"})
        QCOMPARE(html.count("<figure id=\"" + QByteArray(picture) + "\">"), 1);

    const QString table = tableOf(html, "drilling");
    const QStringList lines = QString::fromUtf8(output({"drill", file})).split(QLatin1Char('\n'));
    const QStringList penetrations = lines.filter(QRegularExpression("^ +penetration  "));
    QCOMPARE(penetrations.size(), 1);
    for (QString cell : penetrations.first().split("  ", Qt::SkipEmptyParts)) {
        cell = cell.trimmed().replace("um", "µm");
        QVERIFY2(table.contains(">" + cell + "<"), qPrintable(cell + "\n" + table));
    }
    const QJsonObject drill = json({"drill", file});
    const QByteArray share = QByteArray::number(100 * drill["contact_share"].toDouble(), 'g', 3);
    QVERIFY(html.contains("In " + share +
                          " % of the blows, the bit is in contact with the rock when the blow arrives."));

    const QJsonObject design = json({"design", file});
    const QString designs = tableOf(html, "design");
    const QJsonArray all = design["designs"].toArray();
    QCOMPARE(designs.count("<tr>"), all.size() + 1);
    for (const auto& each : all) {
        const QJsonObject statistics = each.toObject()["statistics"].toObject();
        const double q05 = statistics["efficiency_q05"].toObject()["value"].toDouble();
        QVERIFY2(designs.contains(">" + QString::number(q05, 'g', 5) + " ± "), qPrintable(designs));
    }
    QVERIFY(designs.contains("present design"));

    const QByteArray plain = output({"report", file, "-o", "-"});
    QVERIFY(!plain.contains("id=\"drilling") && !plain.contains("id=\"design"));
    QVERIFY(pagesOf(read(place.filePath("out/report.pdf"))) <= 7);
}

void TestReport::studiesWithoutSettingsLeaveNothing_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no such study") << QStringList{"t38_medium_rock", "--with", "drill,gap"} << 2
                                   << "--with drill,gap: `gap` is not a study of reports; choose from drill, "
                                      "design";
    QTest::newRow("no block") << QStringList{"t38_medium_rock", "--with", "design"} << 5
                              << "--with design needs a block `design`";
    QTest::newRow("no feed") << QStringList{"paper_fig4a", "--with", "drill"} << 5 << "paper_fig4a: ";
    QTest::newRow("too many blows") << QStringList{"t38_medium_rock", "--with", "drill", "--set",
                                                   "drill.blows=1000000"}
                                    << 6 << "--with drill: 1000000 blows take about ";
}

void TestReport::studiesWithoutSettingsLeaveNothing() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, reason);
    const QTemporaryDir place;
    const Finished finished = run(QStringList{"report"} + words + QStringList{"-o", place.filePath("out")});
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY2(finished.error.contains(reason.toUtf8()), finished.error);
    QCOMPARE(contents(place.path()), QStringList());
}

void TestReport::badPlacesAreRefused_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("reason");
    QTest::newRow("none") << QStringList() << 2 << "needs -o DIR, -o FILE.html or -o FILE.pdf";
    QTest::newRow("empty") << QStringList{"-o", ""} << 2 << "-o needs a name";
    QTest::newRow("another ending") << QStringList{"-o", "out.docx"} << 2
                                    << "a report is FILE.html or FILE.pdf";
    QTest::newRow("no folder above") << QStringList{"-o", "none/there/a.html"} << 4 << "none/there/a.html";
    QTest::newRow("a file is no folder") << QStringList{"-o", "file"} << 4 << "file";
    QTest::newRow("a folder is no file") << QStringList{"-o", "folder.pdf"} << 4 << "is a folder";
    QTest::newRow("a head of two lines")
        << QStringList{"-o", "a.html", "--project", "a\nb"} << 2 << "--project: must be one line";
    QTest::newRow("no such language")
        << QStringList{"-o", "a.html", "--language", "tlh"} << 2 << "`tlh` is not one of en, de, sv";
    QTest::newRow("the input") << QStringList{"-o", "input.html", "--force"} << 2 << "is also the input";
}

void TestReport::badPlacesAreRefused() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, reason);
    const QTemporaryDir place;
    write(place.filePath("file"), "mine");
    QDir(place.path()).mkdir("folder.pdf");
    output({"report", "paper_fig4a", "-o", place.filePath("input.html")});
    const QStringList before = contents(place.path());
    for (QString& word : words)
        if (!word.isEmpty() && !word.startsWith('-') && word != "tlh") word = place.filePath(word);
    const Finished finished = run(QStringList{"report", place.filePath("input.html")} + words);
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY2(finished.error.contains(reason.toUtf8()), finished.error);
    QCOMPARE(finished.error.count('\n'), 1);
    QCOMPARE(contents(place.path()), before);
    QCOMPARE(read(place.filePath("file")), QByteArray("mine"));
}

void TestReport::existingFilesAreOverwrittenOnlyOnRequest() {
    const QTemporaryDir place;
    for (const QString& name : {QString("a.html"), QString("out")}) {
        const QStringList words{"report", "paper_fig4a", "-o", place.filePath(name)};
        output(words);
        const Finished again = run(words);
        QCOMPARE(again.exitCode, 4);
        QVERIFY2(again.error.contains("--force"), again.error);
        QCOMPARE(run(words + QStringList{"--force"}).exitCode, 0);
    }
    QCOMPARE(contents(place.filePath("out")), (QStringList{"report.html", "report.pdf"}));
}

void TestReport::whatCannotBeSolvedLeavesNothing() {
    const QTemporaryDir place;
    const Finished finished =
        run({"report", "paper_fig4a", "--set", "beta=1e-300", "-o", place.filePath("out")});
    QCOMPARE(finished.exitCode, 6);
    QVERIFY2(finished.error.contains("could not be solved"), finished.error);
    QCOMPARE(contents(place.path()), QStringList());
}

void TestReport::reportsWithoutPlotsNeedNoWindow() {
    // A copy has no drillwave-window beside it, as where the commands alone are installed.
    const QTemporaryDir place;
    const QString bare = place.filePath("drillwave"), folder = place.filePath("out");
    QVERIFY(QFile::copy(QStringLiteral(DRILLWAVE_PROGRAM), bare));
    const auto runBare = [&bare](const QStringList& words) {
        QProcess process;
        process.start(bare, words);
        return process.waitForFinished(60000) ? Finished{process.exitCode(), process.readAllStandardOutput(),
                                                         process.readAllStandardError()}
                                              : Finished{};
    };
    const Finished refused = runBare({"report", "t38_medium_rock", "-o", folder});
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.error.contains("install the package drillwave") && refused.error.contains("--no-plots"),
             refused.error);
    QCOMPARE(runBare({"report", "t38_medium_rock", "--no-plots", "-o", folder}).exitCode, 0);
    QCOMPARE(contents(folder), QStringList{"report.html"});
    const QByteArray html = read(folder + "/report.html");
    QVERIFY(html.contains("written with --no-plots, so it has no plots") && !html.contains("<img"));
    QCOMPARE(json({"run", folder + "/report.html"})["si"], json({"run", "t38_medium_rock"})["si"]);
    const Finished pdf = run({"report", "t38_medium_rock", "--no-plots", "-o", place.filePath("a.pdf")});
    QCOMPARE(pdf.exitCode, 2);
    QVERIFY2(pdf.error.contains("give -o FILE.html"), pdf.error);
    // The PDF of an earlier report goes with the page that it belongs to.
    QCOMPARE(run({"report", "t38_medium_rock", "--force", "-o", folder}).exitCode, 0);
    QCOMPARE(contents(folder), (QStringList{"report.html", "report.pdf"}));
    QCOMPARE(run({"report", "t38_medium_rock", "--no-plots", "--force", "-o", folder}).exitCode, 0);
    QCOMPARE(contents(folder), QStringList{"report.html"});
}

void TestReport::withoutFontsPicturesAreRefused() {
    const QTemporaryDir place;
    write(place.filePath("fonts.conf"), "<fontconfig/>");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("FONTCONFIG_FILE", place.filePath("fonts.conf"));
    const QString paper = example("paper_fig4a");
    for (const QStringList& words : {QStringList{"report", paper, "-o", "out"},
                                     {"run", paper, "--plots", "png", "-o", "out"},
                                     {"figures", "-o", "out"},
                                     {"gap", paper, "--plots", "svg", "-o", "out.csv"}}) {
        QStringList there = words;
        there.last() = place.filePath(there.last());
        const Finished refused = run(there, environment);
        QCOMPARE(refused.exitCode, 4);
        QVERIFY2(refused.error.contains("there are no fonts") && refused.error.contains("fonts-dejavu-core"),
                 refused.error);
        QCOMPARE(QDir(place.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 1);
    }
    QCOMPARE(run({"run", paper, "-o", place.filePath("out")}, environment).exitCode, 0);
}

QTEST_GUILESS_MAIN(TestReport)
#include "tst_report.moc"

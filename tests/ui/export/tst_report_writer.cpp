// SPDX-License-Identifier: GPL-3.0-or-later
// The window's report is that of the command line, in the numbers and units of the window.
#include <QDir>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QToolBar>

#include "core/model/scales.h"
#include "core/report/blow_report.h"
#include "core/report/report_html.h"
#include "core/text/decimal_text.h"
#include "tests/support/files.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/document/measured_list.h"
#include "ui/export/report_preview.h"
#include "ui/export/report_writer.h"
#include "ui/job/study_status.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/design/design_page.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/text/settings.h"
#include "ui/text/unit_choice.h"
#include "ui/window/file_menu.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/units_choice.h"

using namespace drillwave;
using namespace drillwave::test;

class TestReportWriter : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cleanup() { m_window.reset(); }
    void theReportIsWhatTheCommandLineWrites_data();
    void theReportIsWhatTheCommandLineWrites();
    void groupsOnShowDoNotMatter();
    void unitsAndNumbersAreThoseOfTheWindow_data();
    void unitsAndNumbersAreThoseOfTheWindow();
    void cellsOfTablesAreNotBrokenOnPaper();
    void aReportOpensAgain();
    void menuAndToolBarOfferIt();
    void ctrlPPrintsThePagesOfThePdf();
    void thePreviewHasThePagesAndKeepsTheHead();
    void pinnedRunsStandBesideTheBlow();
    void finishedStudiesOfThePresentScenarioAreInTheReport();
    void whatWasMeasuredIsLaidOverTheCurves();
    void noPaperIsTold();
    void noPrinterIsNothingToTell();
    void anotherEndingIsRefused();
    void aFileThatCannotBeWrittenIsTold();
    void aStoppedReportIsNotWritten();
    void aBlowThatIsNotSolvedIsTold();

  private:
    MainWindow& window() { return *m_window; }
    ReportWriter& writer() { return part<ReportWriter>(window()); }
    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    /// Writes and waits for the end.
    void writeTo(const QString& to);

    std::unique_ptr<QTemporaryDir> m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestReportWriter::init() {
    QLocale::setDefault(QLocale::c());  // the command writes so; tests of others choose theirs
    m_folder = std::make_unique<QTemporaryDir>();
    keepSettingsIn(path("settings"));
    m_answers = {};
    m_window = newWindow(m_answers);
    m_window->show();
}

void TestReportWriter::writeTo(const QString& to) {
    m_answers.exportTo = to;
    QSignalSpy ended(&writer(), &ReportWriter::ended);
    writer().action()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, 60000);
}

void TestReportWriter::theReportIsWhatTheCommandLineWrites_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<bool>("edited");
    QTest::newRow("in SI units") << QStringLiteral("t38_medium_rock") << false;
    QTest::newRow("by groups") << QStringLiteral("paper_fig4b") << false;
    QTest::newRow("of a string") << QStringLiteral("t38_string") << false;
    QTest::newRow("with unsaved edits") << QStringLiteral("t38_medium_rock") << true;
}

void TestReportWriter::theReportIsWhatTheCommandLineWrites() {
    QFETCH(QString, example);
    QFETCH(bool, edited);
    QVERIFY(window().openFile(test::example(example)));
    QStringList words{QStringLiteral("report"), test::example(example)};
    if (edited) {
        window().document().assign(*findParameter("rod.length"), 4.5, 1);
        words << QStringLiteral("--set") << QStringLiteral("rod.length=4.5 m");
    }
    for (const char* format : {"html", "pdf"}) {
        const QString ending = QStringLiteral(".") + QLatin1String(format);
        writeTo(path("window") + ending);
        QCOMPARE(m_answers.told, QStringList());
        const test::Finished finished =
            test::run(words + QStringList{QStringLiteral("-o"), path("command") + ending});
        QVERIFY2(finished.exitCode == 0, finished.error);
        QVERIFY(read(path("window") + ending) == read(path("command") + ending));
    }
}

void TestReportWriter::groupsOnShowDoNotMatter() {
    writeTo(path("si.html"));
    part<UnitsChoice>(window()).choose(UnitSystem::dimensionless);
    writeTo(path("groups.html"));
    QVERIFY(read(path("si.html")) == read(path("groups.html")));
}

void TestReportWriter::unitsAndNumbersAreThoseOfTheWindow_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<bool>("us");
    QTest::addColumn<QStringList>("there");
    QTest::addColumn<QStringList>("absent");
    const QString rod = QStringLiteral("t38_medium_rock"), string = QStringLiteral("t38_string");
    QTest::newRow("US")
        << rod << true
        << QStringList{"A feed force of 1798 lbf is enough for a single blow at any gap (1631 lbf required).",
                       "12.0079 ft",
                       "1.49606 in",
                       "in US units",
                       " ksi",
                       " lbf s",
                       "3600 bpm"}
        << QStringList{" kN<", " MPa<", " mm<"};
    QTest::newRow("a string, US") << string << true
                                  << QStringList{"lbf is enough for this blow and for rigid rock", " ksi at ",
                                                 " ft lbf"}
                                  << QStringList{" kN<", " MPa at", " MPa<"};
    QTest::newRow("German")
        << rod << false
        << QStringList{"A feed force of 8 kN is enough for a single blow at any gap (7,253 kN required).",
                       ">3,66 m<", "+10,3 %"}
        << QStringList{">3.66 m<", "66.1 Hz", "10.3 %"};
}

// Every number in full stands behind its cell all the same, in SI and with a point.
void TestReportWriter::unitsAndNumbersAreThoseOfTheWindow() {
    QFETCH(QString, example);
    QFETCH(bool, us);
    QFETCH(QStringList, there);
    QFETCH(QStringList, absent);
    QVERIFY(window().openFile(test::example(example)));
    const QLocale before;
    const auto restore = qScopeGuard([&] {
        QLocale::setDefault(before);
        window().document().units().choose(UnitSystem::si);
    });
    const auto behindCells = [](const QString& page) {
        QStringList numbers;
        QRegularExpressionMatchIterator found =
            QRegularExpression(QStringLiteral("data-value=\"([^\"]*)\"")).globalMatch(page);
        while (found.hasNext()) numbers << found.next().captured(1);
        return numbers;
    };
    writeTo(path("plain.html"));
    if (us)
        window().document().units().choose(UnitSystem::us);
    else
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    writeTo(path("own.html"));
    writeTo(path("own.pdf"));
    QCOMPARE(m_answers.told, QStringList());
    const QString page = QString::fromUtf8(read(path("own.html"))),
                  plain = QString::fromUtf8(read(path("plain.html")));
    QCOMPARE(behindCells(page), behindCells(plain));
    const QString words =
        page.section(QStringLiteral("<h2>Scenario</h2>"), 0, 0).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    for (const QString& text : there) QVERIFY2(words.contains(text), qPrintable(text));
    for (const QString& text : absent)
        QVERIFY2(!words.contains(text), qPrintable(words.mid(words.indexOf(text) - 60, 120)));
    QVERIFY(page.contains(QStringLiteral("</h1>\n<p class=\"decision\">")));
    QVERIFY(read(path("own.pdf")).count("/Type /Page\n") <= 5);
}

// Begins with the mechanism: words without blanks between them, which were broken anywhere where a rounding
// left a column too narrow.
void TestReportWriter::cellsOfTablesAreNotBrokenOnPaper() {
    const BlowReport report = studyReport(window().document().scenario());
    QTextDocument paper;
    paper.setHtml(QString::fromStdString(reportHtml(report, {}, ReportMedium::paper)));
    int cells = 0;
    for (QTextBlock block = paper.begin(); block.isValid(); block = block.next()) {
        if (!block.text().contains(QChar(QChar::Nbsp)) || block.text().contains(u' ')) continue;
        QVERIFY2(block.blockFormat().nonBreakableLines(), qPrintable(block.text()));
        ++cells;
    }
    QVERIFY(cells > 10);
}

void TestReportWriter::aReportOpensAgain() {
    window().document().assign(*findParameter("rod.length"), 4.5, 1);
    writeTo(path("a.html"));
    const Scenario reported = window().document().scenario();
    window().document().start();
    QVERIFY(!(window().document().scenario() == reported));
    QVERIFY(window().openFile(path("a.html")));
    QVERIFY(window().document().scenario() == reported);
}

void TestReportWriter::menuAndToolBarOfferIt() {
    QVERIFY(part<FileMenu>(window()).actions().contains(writer().action()));
    bool isInBar = false;
    for (const QToolBar* bar : window().findChildren<QToolBar*>())
        isInBar |= bar->actions().contains(writer().action());
    QVERIFY(isInBar);
}

void TestReportWriter::ctrlPPrintsThePagesOfThePdf() {
    const auto pages = [this](const char* name) { return read(path(name)).count("/Type /Page\n"); };
    m_answers.printTo = path("printed.pdf");
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    QSignalSpy ended(&writer(), &ReportWriter::ended);
    QSignalSpy written(&writer(), &ReportWriter::written);
    QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, 60000);
    QCOMPARE(m_answers.told, QStringList());
    QCOMPARE(written.size(), 1);
    QVERIFY(part<FileMenu>(window()).actions().contains(writer().printAction()));
    writeTo(path("written.pdf"));
    QCOMPARE(pages("printed.pdf"), pages("written.pdf"));
    QVERIFY(pages("printed.pdf") >= 2);
}

void TestReportWriter::thePreviewHasThePagesAndKeepsTheHead() {
    QVERIFY(part<FileMenu>(window()).actions().contains(writer().previewAction()));
    QSignalSpy ended(&writer(), &ReportWriter::ended);
    writer().previewAction()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, 60000);
    auto* preview = window().findChild<ReportPreview*>();
    QVERIFY(preview && preview->isVisible());
    QTRY_VERIFY(preview->pageCount() >= 2 && preview->pageCount() <= 5);
    auto* customer = preview->findChild<QLineEdit*>(QStringLiteral("report/customer"));
    QVERIFY(customer);
    QTest::keyClicks(customer, QStringLiteral("Gruva AB"));
    writeTo(path("headed.html"));
    QVERIFY(read(path("headed.html")).contains("<th>Customer</th><td>Gruva AB</td>"));
    QCOMPARE(rememberedHead().customer, std::string("Gruva AB"));
    QVERIFY(rememberedHead().date.empty());
    // The preview shows the scenario before an edit, until it is updated.
    auto* update = preview->findChild<QPushButton*>();
    QVERIFY(!update->isEnabled());
    window().document().assign(*findParameter("rod.length"), 4.5, 1);
    QVERIFY(update->isEnabled());
    update->click();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 3, 60000);
    QVERIFY(!update->isEnabled());
    Settings().remove(QStringLiteral("report/customer"));
}

void TestReportWriter::pinnedRunsStandBesideTheBlow() {
    writeTo(path("alone.html"));
    QVERIFY(!read(path("alone.html")).contains("Comparison with other runs"));
    QTRY_VERIFY_WITH_TIMEOUT(part<SolveStatus>(window()).isCurrent(), 60000);
    const double before = window().shown()->summary.cor;
    part<PinnedRuns>(window()).pinAction()->trigger();
    window().document().assign(*findParameter("rod.length"), 4.5, 1);
    writeTo(path("beside.html"));
    const QByteArray page = read(path("beside.html"));
    const QByteArray table = page.mid(page.indexOf("id=\"runs-table\""));
    QVERIFY2(table.contains("<th>this report</th><th>A  "), page.mid(page.indexOf("runs-table"), 200));
    QVERIFY(table.contains("<td data-value=\"4.5\">4.5</td><td data-value=\"3.66\">3.66</td>"));
    QVERIFY(table.contains("<td data-value=\"" + QByteArray::fromStdString(formatNumber(before)) + "\">"));
    // Both have the margin, which the window knows only for its own blow.
    static const QRegularExpression margins(
        QStringLiteral("feed force margin at every gap \\[%\\]</td><td data-value=\"[^\"]+\">[^<]+</td>"
                       "<td data-value=\"10\\.29[^\"]*\">\\+10\\.292</td>"));
    QVERIFY2(margins.match(QString::fromUtf8(table)).hasMatch(),
             table.mid(table.indexOf("feed force margin at every gap [%]"), 250));
}

void TestReportWriter::finishedStudiesOfThePresentScenarioAreInTheReport() {
    QVERIFY(window().openFile(test::example(QStringLiteral("t38_medium_rock"))));
    Document& document = window().document();
    document.assign(*findParameter("drill.blows"), 60, 1);
    DesignSetup design;
    design.uncertain = {"bit_rock.gap=0mm:1mm"};
    design.choose = {"pulse.duration=150us:250us:3"};
    design.aims = {"max:efficiency@q05"};
    design.samples = 64;
    document.setDesign(design);
    const auto finish = [&](StudyPage& page) {
        part<PageTabs>(window()).setCurrentWidget(&page);
        QTRY_VERIFY_WITH_TIMEOUT(
            page.activity()->isCurrent() && page.activity()->state() == StudyState::finished, 120'000);
    };
    const auto sections = [&] {
        writeTo(path("studies.html"));
        const QByteArray page = read(path("studies.html"));
        QStringList found;
        for (const char* name : {"drilling", "design"})
            if (page.contains("<figure id=\"" + QByteArray(name) + "\">")) found << QLatin1String(name);
        return found;
    };
    QCOMPARE(sections(), QStringList());
    auto& drilling = part<DrillingPage>(window());
    finish(drilling);
    QCOMPARE(sections(), QStringList{"drilling"});
    finish(part<DesignPage>(window()));
    QCOMPARE(sections(), (QStringList{"drilling", "design"}));
    // Both are out of sight, and of an earlier scenario, until it comes back.
    part<PageTabs>(window()).setCurrentWidget(&part<BlowPage>(window()));
    document.assign(*findParameter("rod.length"), 4, 2);
    QCOMPARE(sections(), QStringList());
    document.undoStack().undo();
    QCOMPARE(sections(), (QStringList{"drilling", "design"}));
}

void TestReportWriter::whatWasMeasuredIsLaidOverTheCurves() {
    writeTo(path("computed.html"));
    const QByteArray computed = read(path("computed.html"));
    QVERIFY(!computed.contains("Comparison with measurements") &&
            computed.contains("at the middle of the rod"));
    QTRY_VERIFY_WITH_TIMEOUT(part<SolveStatus>(window()).isCurrent(), 60000);
    // Ten times what is computed at most: the axis that has it says so.
    const double peak =
        10 * window().shown()->summary.peakForce * scalesOf(window().document().scenario()).force;
    part<MeasuredList>(window()).add({.name = "gauge <3>",
                                      .quantity = MeasuredQuantity::normalForce,
                                      .place = 1.22,
                                      .points = {{0, 0}, {1e-4, -peak}, {2e-4, 0}}});
    writeTo(path("measured.html"));
    const QByteArray page = read(path("measured.html"));
    const QByteArray table = page.mid(page.indexOf("id=\"measured-table\""));
    QVERIFY2(table.contains("<td>gauge &lt;3&gt;</td><td>force N at 1.22\u00a0m</td>"), table.left(600));
    QVERIFY(page.contains("The force N where &quot;gauge &lt;3&gt;&quot; was measured"));
    QVERIFY(page.contains("Measured signals are dashed."));
    const auto picture = [](const QByteArray& html) {
        const auto at = html.indexOf("<img", html.indexOf("id=\"blow\""));
        return html.mid(at, html.indexOf('>', at) - at);
    };
    QVERIFY(picture(page) != picture(computed));
    // Without units there is nothing to compare it with.
    QVERIFY(window().document().open(example(QStringLiteral("paper_fig4a"))).isEmpty());
    part<MeasuredList>(window()).add({.name = "late", .points = {{0, 0}, {1e-4, -peak}}});
    writeTo(path("groups.html"));
    QVERIFY(!read(path("groups.html")).contains("measured-table"));
}

void TestReportWriter::noPaperIsTold() {
    m_answers.printTo = path("none/there.pdf");
    QSignalSpy ended(&writer(), &ReportWriter::ended);
    writer().printAction()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, 60000);
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY(m_answers.told.first().startsWith(QStringLiteral("The report has not been printed.")));
}

void TestReportWriter::noPrinterIsNothingToTell() {
    QSignalSpy begun(&writer(), &ReportWriter::begun);
    writer().printAction()->trigger();
    QCOMPARE(begun.size(), 0);
    QCOMPARE(m_answers.told, QStringList());
}

void TestReportWriter::anotherEndingIsRefused() {
    m_answers.exportTo = path("report.docx");
    writer().action()->trigger();
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY(m_answers.told.first().contains(QStringLiteral(".html or .pdf")));
    QVERIFY(!QFile::exists(path("report.docx")));
}

void TestReportWriter::aFileThatCannotBeWrittenIsTold() {
    writeTo(path("none/there.html"));
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY(m_answers.told.first().contains(QStringLiteral("there.html")));
}

void TestReportWriter::aStoppedReportIsNotWritten() {
    m_answers.exportTo = path("a.html");
    QSignalSpy ended(&writer(), &ReportWriter::ended);
    writer().action()->trigger();
    QCOMPARE(writer().activity().state(), StudyState::running);
    writer().activity().cancel();
    QCOMPARE(ended.size(), 1);
    QVERIFY(!QFile::exists(path("a.html")));
    QCOMPARE(m_answers.told, QStringList());
}

void TestReportWriter::aBlowThatIsNotSolvedIsTold() {
    QVERIFY(window().openFile(test::example(QStringLiteral("paper_fig4a"))));
    window().document().assign(*findParameter("beta"), 1e-300, 1);
    writeTo(path("a.html"));
    QCOMPARE(m_answers.told.size(), 1);
    QVERIFY(m_answers.told.first().contains(QStringLiteral("could not be solved")));
    QVERIFY(!QFile::exists(path("a.html")));
}

QTEST_MAIN(TestReportWriter)
#include "tst_report_writer.moc"

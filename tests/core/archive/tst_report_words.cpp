// SPDX-License-Identifier: GPL-3.0-or-later
// The report in the language of its reader: every word of the program can be translated.
#include <QRegularExpression>
#include <QTest>

#include "core/archive/report_file.h"
#include "core/model/version.h"
#include "core/report/report_html.h"
#include "core/yaml/examples.h"
#include "tests/support/marked_style.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Returns the visible text of the page without the scenario.
QString seenOf(const std::string& page) {
    QString text = QString::fromStdString(page);
    const auto drop = [&](const char* what) {
        text.replace(
            QRegularExpression(QString::fromUtf8(what), QRegularExpression::DotMatchesEverythingOption),
            QStringLiteral("\n"));
    };
    for (const char* what : {"<head>.*?</head>", "<pre.*?</pre>", "<h1>.*?</h1>", "<[^>]*>"}) drop(what);
    return text;
}

}  // namespace

class TestReportWords : public QObject {
    Q_OBJECT

  private slots:
    void everyWordCanBeTranslated_data();
    void everyWordCanBeTranslated();
};

void TestReportWords::everyWordCanBeTranslated_data() {
    QTest::addColumn<QString>("example");
    for (const Example& example : builtInExamples())
        QTest::newRow(example.name.data())
            << QString::fromUtf8(example.name.data(), qsizetype(example.name.size()));
}

// Names are as they are everywhere: keys of files, methods, presets and sections, and what the one who wrote
// the scenario remarks.
void TestReportWords::everyWordCanBeTranslated() {
    QFETCH(QString, example);
    const ScenarioDocument document =
        parseScenario(findExample(example.toStdString())->text, example.toStdString());
    BlowReport report = reportOn(document);
    report.head = {"A", "B", "C", "D"};
    QStringList names;
    const auto named = [&](const std::string& text) {
        names << QString::fromStdString(text).split(QRegularExpression(QStringLiteral("[^\\p{L}_.]+")));
    };
    const auto ofSource = [&](const auto& self, const Message& source) -> void {
        if (source.isWords) named(source.pattern);
        for (const Message& part : source.arguments) self(self, part);
    };
    for (const ReportInput& input : report.inputs) {
        named(input.key);
        named(input.value);
        ofSource(ofSource, input.source);
    }
    for (const ReportSection& section : report.sections) {
        named(section.name);
        ofSource(ofSource, section.source);
    }
    named(std::string(versionText));
    names << "Drillwave"
          << "MPa"
          << "GPa"
          << "min";
    const MarkedStyle style;
    for (const ReportMedium medium : {ReportMedium::screen, ReportMedium::paper}) {
        QStringList words = wordsOutsideMarks(seenOf(reportHtml(report, {}, medium, style)));
        words.removeIf([&](const QString& word) { return names.contains(word); });
        QVERIFY2(words.isEmpty(), qPrintable(words.join(QLatin1String(", "))));
    }
}

QTEST_GUILESS_MAIN(TestReportWords)
#include "tst_report_words.moc"

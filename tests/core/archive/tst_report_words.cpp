// SPDX-License-Identifier: GPL-3.0-or-later
// The report in the language of its reader: every word of the program can be translated.
#include <QRegularExpression>
#include <QtTest>

#include "core/archive/report_file.h"
#include "core/report/report_html.h"
#include "core/yaml/examples.h"

using namespace drillwave;

namespace {

/// A language in which every text of the program stands between marks; what stands outside is in all of them.
class MarkedStyle : public ReadingStyle {
  public:
    std::string patternFor(const std::string& english) const override {
        QString text;
        for (const QString& part :
             QString::fromStdString(english).split(QRegularExpression("(?=%\\d)|(?<=%\\d)")))
            text += part.startsWith(u'%') && part.size() == 2 ? part : QStringLiteral("⟦%1⟧").arg(part);
        return text.toStdString();
    }
    std::string language() const override { return "mark"; }
};

/// What a reader sees of the page but for the scenario, without what stands between marks.
QStringList wordsOutsideMarks(const std::string& page) {
    QString text = QString::fromStdString(page);
    const auto drop = [&](const char* what) {
        text.replace(
            QRegularExpression(QString::fromUtf8(what), QRegularExpression::DotMatchesEverythingOption),
            QStringLiteral("\n"));
    };
    for (const char* what : {"<head>.*?</head>", "<pre.*?</pre>", "<h1>.*?</h1>", "<[^>]*>", "⟦[^⟧]*⟧"})
        drop(what);
    QStringList words;
    static const QRegularExpression word(QStringLiteral("[\\p{L}_.]*\\p{L}{3,}[\\p{L}_.]*"));
    for (const auto& found : word.globalMatch(text)) words << found.captured();
    return words;
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
    names << "Drillwave"
          << "MPa"
          << "GPa"
          << "exact";
    const MarkedStyle style;
    for (const ReportMedium medium : {ReportMedium::screen, ReportMedium::paper}) {
        QStringList words = wordsOutsideMarks(reportHtml(report, {}, medium, style));
        words.removeIf([&](const QString& word) { return names.contains(word); });
        QVERIFY2(words.isEmpty(), qPrintable(words.join(QLatin1String(", "))));
    }
}

QTEST_GUILESS_MAIN(TestReportWords)
#include "tst_report_words.moc"

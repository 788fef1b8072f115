// SPDX-License-Identifier: GPL-3.0-or-later
// The report in every language of the program: its words are translated, and those in its plots have room.
#include <qcustomplot.h>

#include <QtTest>

#include "core/archive/report_file.h"
#include "core/text/languages.h"
#include "core/yaml/examples.h"
#include "ui/export/report_export.h"
#include "ui/export/report_plots.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;

namespace {

BlowReport reportOf(const char* example) {
    return reportOn(parseScenario(findExample(example)->text, example));
}

PaperReader readerOf(const Language& language) {
    return {.locale = QLocale(fromView(language.code)), .isSpokenTo = true};
}

/// Speaks a language as long as it lives.
class Spoken {
  public:
    explicit Spoken(const Language& language) : m_catalogue(language) {
        QCoreApplication::installTranslator(&m_catalogue);
    }
    ~Spoken() { QCoreApplication::removeTranslator(&m_catalogue); }
    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

  private:
    Catalogue m_catalogue;
};

/// Texts and legends of the plot that are wider than what they have.
QStringList cutOff(QCustomPlot& plot) {
    constexpr int rounding = 2;  // [px]
    QStringList found;
    for (QCPLayoutElement* element : plot.plotLayout()->elements(true)) {
        if (!element || !element->visible()) continue;
        const int room = element->outerRect().width() + rounding;
        if (const auto* text = qobject_cast<QCPTextElement*>(element)) {
            for (const QString& line : text->text().split(u'\n'))
                if (QFontMetrics(text->font()).horizontalAdvance(line) > room) found << line;
        } else if (auto* entry = qobject_cast<QCPPlottableLegendItem*>(element)) {
            const QCPLegend& legend = *qobject_cast<QCPLegend*>(entry->layout());
            const int name = QFontMetrics(entry->font()).horizontalAdvance(entry->plottable()->name());
            if (name + legend.iconSize().width() + legend.iconTextPadding() > room)
                found << entry->plottable()->name();
        }
    }
    return found;
}

void addCases() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QByteArray>("example");
    for (const Language& language : languages)
        for (const char* example : {"t38_medium_rock", "t51_soft_rock", "t38_string"})
            QTest::addRow("%s in %s", example, language.code.data())
                << fromView(language.code) << QByteArray(example);
}

}  // namespace

class TestReportLanguage : public QObject {
    Q_OBJECT

  private slots:
    void wordsInPlotsHaveRoom_data() { addCases(); }
    void wordsInPlotsHaveRoom();
    void theReportSpeaksTheLanguageOfItsReader_data();
    void theReportSpeaksTheLanguageOfItsReader();
    void withoutALanguageItIsInEnglishWhateverIsSpoken();
    void aWindowWritesItsOwn();
};

void TestReportLanguage::wordsInPlotsHaveRoom() {
    QFETCH(QString, code);
    const Language& language = *findLanguage(code.toStdString());
    QFETCH(QByteArray, example);
    const Spoken spoken(language);
    const std::vector<ReportPlot> plots = reportPlots(reportOf(example), readerOf(language), {});
    QVERIFY(plots.size() >= 4);
    for (const ReportPlot& plot : plots) {
        const QByteArray svg = renderPlot(*plot.paper.plot, plot.paper.size, QStringLiteral("svg"), {});
        QVERIFY(!svg.isEmpty());
        const QStringList found = cutOff(*plot.paper.plot);
        QVERIFY2(found.isEmpty(), qPrintable(found.join(QStringLiteral(" | "))));
    }
}

void TestReportLanguage::theReportSpeaksTheLanguageOfItsReader_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("feed");
    QTest::newRow("German") << "de"
                            << "Urteil über den Vorschub";
    QTest::newRow("Swedish") << "sv"
                             << "Omdöme om matningen";
}

void TestReportLanguage::theReportSpeaksTheLanguageOfItsReader() {
    QFETCH(QString, code);
    const Language& language = *findLanguage(code.toStdString());
    QFETCH(QString, feed);
    const Spoken spoken(language);
    const Pictures drawn =
        drawReport(reportOf("t38_medium_rock"), {"report", {"html"}, {}}, readerOf(language));
    const QString page = QString::fromStdString(drawn.files.front().bytes);
    QVERIFY(page.contains(QStringLiteral("<h2>%1</h2>").arg(feed)));
    QVERIFY(page.contains(QStringLiteral("0,429738")) &&
            page.contains(QStringLiteral("data-value=\"0.4297381")));
    QVERIFY(!page.contains(QStringLiteral("Verdict on the feed")));
}

void TestReportLanguage::withoutALanguageItIsInEnglishWhateverIsSpoken() {
    const BlowReport report = reportOf("t38_medium_rock");
    const auto page = [&] { return drawReport(report, {"report", {"html"}, {}}).files.front().bytes; };
    const std::string english = page();
    QVERIFY(english.find("Verdict on the feed") != english.npos &&
            english.find("lang=\"en\"") != english.npos);
    const Spoken spoken(*findLanguage("de"));
    QVERIFY(page() == english);
}

// Once it is spoken, a language stays: the last one.
void TestReportLanguage::aWindowWritesItsOwn() {
    const UnitChoice units;
    QVERIFY(!PaperReader::of(units).isSpokenTo);
    speak(*findLanguage("sv"));
    const PaperReader reader = PaperReader::of(units);
    QVERIFY(reader.isSpokenTo && !reader.isPlain());
    const Pictures drawn = drawReport(reportOf("t38_string"), {"report", {"html"}, {}}, reader);
    const std::string page = drawn.files.front().bytes;
    QVERIFY(page.find("lang=\"sv\"") != page.npos && page.find("Hammare och sträng") != page.npos);
    const EnglishTexts english;
    QVERIFY(!PaperReader::of(units).isSpokenTo);
}

QTEST_MAIN(TestReportLanguage)
#include "tst_report_language.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The report in every language of the program: its words are translated, and those in its plots have room.
#include <qcustomplot.h>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPdfWriter>
#include <QTest>
#include <QTextBlock>
#include <QTextFrame>
#include <QTextLayout>
#include <cmath>

#include "core/archive/report_file.h"
#include "core/text/languages.h"
#include "core/yaml/examples.h"
#include "tests/support/tries.h"
#include "ui/export/report_document.h"
#include "ui/export/report_export.h"
#include "ui/export/report_plots.h"
#include "ui/plot/label_places.h"
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
    void nothingRunsOffAPageAndNoneIsAlmostEmpty_data();
    void nothingRunsOffAPageAndNoneIsAlmostEmpty();
    void numbersOfTheRodDoNotLieOnEachOther_data();
    void numbersOfTheRodDoNotLieOnEachOther();
    void pagesHaveTheSignsOfPrint_data();
    void pagesHaveTheSignsOfPrint();
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

void TestReportLanguage::nothingRunsOffAPageAndNoneIsAlmostEmpty_data() {
    QTest::addColumn<QString>("code");
    for (const Language& language : languages) QTest::newRow(language.code.data()) << fromView(language.code);
}

// Neither cells of words without a blank to break at, which were wider than the page, nor a last page of some
// lines.
void TestReportLanguage::nothingRunsOffAPageAndNoneIsAlmostEmpty() {
    QFETCH(QString, code);
    const Language& language = *findLanguage(code.toStdString());
    const Spoken spoken(language);
    const PaperReader reader = readerOf(language);
    const LocalStyle style(reader.locale, reader.system, reader.chosen);
    int tables = 0, headings = 0, number = 0, read = 0;
    for (const Example& example : builtInExamples()) {
        if (!test::isChosen(number++, 5)) continue;
        ++read;
        const BlowReport report = reportOf(example.name.c_str());
        const std::vector<ReportPlot> plots = reportPlots(report, reader, {});
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(15, 15, 15, 15), QPageLayout::Millimeter);
        ReportDocument document(report, plots, style, writer,
                                {double(writer.width()), writer.height() * 0.94});
        const QAbstractTextDocumentLayout& layout = *document.text().documentLayout();
        const QSizeF page = document.text().pageSize();
        const double rounding = writer.resolution() / 50.0;  // half a millimetre: margins are whole points
        for (QTextBlock block = document.text().begin(); block.isValid(); block = block.next()) {
            const QString about = QString::fromStdString(example.name) + u' ' + block.text();
            for (int i = 0; i < block.layout()->lineCount(); ++i) {
                const QTextLine line = block.layout()->lineAt(i);
                const double end = layout.blockBoundingRect(block).left() + line.naturalTextRect().right();
                QVERIFY2(end <= page.width() + rounding, qPrintable(about));
            }
            if (block.blockFormat().headingLevel() == 0 || !block.next().isValid()) continue;
            const auto pageOf = [&](const QTextBlock& of) {
                return std::floor((layout.blockBoundingRect(of).top() + of.layout()->lineAt(0).y()) /
                                  page.height());
            };
            QVERIFY2(pageOf(block) == pageOf(block.next()), qPrintable(about));
            ++headings;
        }
        const double end = layout.blockBoundingRect(document.text().lastBlock()).bottom() / page.height();
        QVERIFY2(end - (document.text().pageCount() - 1) >= 0.4, example.name.c_str());
        for (QTextFrame* frame : document.text().rootFrame()->childFrames()) {
            QVERIFY(layout.frameBoundingRect(frame).right() <= page.width() + rounding);
            ++tables;
        }
    }
    QVERIFY(read > 0 && tables >= 5 * read && headings >= 8 * read);
}

void TestReportLanguage::numbersOfTheRodDoNotLieOnEachOther_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("bore");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("gamma");
    QTest::newRow("two peaks at one place")
        << QByteArray("t38_medium_rock") << 4.27 << 0.012 << 160e6 << 0.25;
    QTest::newRow("hard rock") << QByteArray("r32_hard_rock") << 4.2672 << 0.0 << 150e6 << 0.3;
    QTest::newRow("as it is") << QByteArray("t38_medium_rock") << 3.66 << 0.0145 << 105e6 << 0.1;
}

void TestReportLanguage::numbersOfTheRodDoNotLieOnEachOther() {
    QFETCH(QByteArray, example);
    QFETCH(double, length);
    QFETCH(double, bore);
    QFETCH(double, stiffness);
    QFETCH(double, gamma);
    Scenario scenario = parseScenario(findExample(example.data())->text, example.data()).scenario;
    scenario.rod.length = length;
    if (bore > 0) scenario.rod.bore = bore;
    scenario.bitRock.stiffness = stiffness;
    scenario.bitRock.gamma = gamma;
    const PaperPlot paper = rodPaperPlot(studyReport(scenario).blow, {}, {});
    QVERIFY(!renderPlot(*paper.plot, {180, 84}, QStringLiteral("svg"), {}).isEmpty());
    QVector<QRectF> found;
    for (int i = 0; i < paper.plot->itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(paper.plot->item(i)); text && text->visible())
            if (text->text().contains(QStringLiteral("MPa"))) found << rectOf(*text);
    QVERIFY(found.size() >= 4);
    for (qsizetype i = 0; i < found.size(); ++i)
        for (qsizetype j = 0; j < i; ++j) QVERIFY(!found[i].intersects(found[j]));
}

void TestReportLanguage::pagesHaveTheSignsOfPrint_data() {
    QTest::addColumn<QString>("code");
    for (const Language& language : languages) QTest::newRow(language.code.data()) << fromView(language.code);
}

void TestReportLanguage::pagesHaveTheSignsOfPrint() {
    QFETCH(QString, code);
    const Language& language = *findLanguage(code.toStdString());
    const Spoken spoken(language);
    static const QRegularExpression plain(
        QStringLiteral("[0-9]e-[0-9]|\\^[23]|[0-9] u[sm]\\b|\\+-|\\.\\.\\.|\\bd0\\b|`drill"));
    for (const char* example : {"t38_medium_rock", "t38_string", "paper_fig4b"}) {
        const PaperReader reader = isEnglish(language) ? PaperReader() : readerOf(language);
        QString page = QString::fromStdString(
            drawReport(reportOf(example), {"report", {"html"}, {}}, reader).files.front().bytes);
        page.remove(QRegularExpression(
            QStringLiteral(
                "<pre.*</pre>|<script.*</script>|<style.*</style>| src=\"[^\"]*\"|data-value=\"[^\"]*\""),
            QRegularExpression::DotMatchesEverythingOption | QRegularExpression::InvertedGreedinessOption));
        const QRegularExpressionMatch match = plain.match(page);
        QVERIFY2(!match.hasMatch(), qPrintable(page.mid(match.capturedStart() - 60, 120)));
        if (QLatin1String(example) != QLatin1String("t38_medium_rock")) continue;
        QVERIFY(page.contains(QStringLiteral(" m/min</td>")));
        QCOMPARE(page.contains(QStringLiteral(">rectangular<")), isEnglish(language));
    }
}

void TestReportLanguage::theReportSpeaksTheLanguageOfItsReader_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("feed");
    QTest::newRow("German") << "de"
                            << "Erforderlicher Andruck";
    QTest::newRow("Swedish") << "sv"
                             << "Matningskraft som krävs";
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
    QVERIFY(!page.contains(QStringLiteral("Required feed")));
}

void TestReportLanguage::withoutALanguageItIsInEnglishWhateverIsSpoken() {
    const BlowReport report = reportOf("t38_medium_rock");
    const auto page = [&] { return drawReport(report, {"report", {"html"}, {}}).files.front().bytes; };
    const std::string english = page();
    QVERIFY(english.find("Required feed") != english.npos && english.find("lang=\"en\"") != english.npos);
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

// SPDX-License-Identifier: GPL-3.0-or-later
// The manual as blocks, and as text for a terminal.
#include <QTest>

#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/manual/plain_text.h"
#include "core/manual/reference.h"
#include "core/manual/word_places.h"

using namespace drillwave;

namespace {

using Kind = ManualBlock::Kind;

std::vector<Kind> kindsOf(std::string_view markdown) {
    std::vector<Kind> kinds;
    for (const ManualBlock& block : readMarkdown(markdown)) kinds.push_back(block.kind);
    return kinds;
}

QString plain(std::string_view markdown, std::size_t width = 80) {
    return QString::fromStdString(plainText(readMarkdown(markdown), width));
}

}  // namespace

class TestManualText : public QObject {
    Q_OBJECT

  private slots:
    void linesThatBelongTogetherAreOneBlock();
    void codeKeepsItsLines();
    void cellsAreWhatStandsBetweenBars();
    void aSectionEndsWhereTheNextOneBegins();
    void marksAreTakenOffAndWordsStay_data();
    void marksAreTakenOffAndWordsStay();
    void linesAreBrokenAtBlanks();
    void tablesAreColumnsWithinTheWidth();
    void everyChapterIsThere();
    void noTextOfAChapterIsLost();
    void aParameterIsToldWithItsPresetsAndTheirSources();
    void wholeWordsAreCountedInSingularAndPlural();
    void titlesComeBeforeTermsAndText();
};

void TestManualText::linesThatBelongTogetherAreOneBlock() {
    const auto blocks = readMarkdown("# Title\n\nfirst line\nsecond line\n\n- one\n  more of one\n- two\n");
    QCOMPARE(blocks.size(), 4U);
    QCOMPARE(blocks[0].text, std::string("Title"));
    QCOMPARE(blocks[1].text, std::string("first line second line"));
    QCOMPARE(blocks[2].text, std::string("one more of one"));
    QCOMPARE(blocks[3].mark, std::string("-"));
}

void TestManualText::codeKeepsItsLines() {
    const auto blocks =
        readMarkdown("```sh\ndrillwave run  x\n\n# no heading\n```\n\n    c = 2   (T1)\n    Z = 3\n");
    QCOMPARE(blocks.size(), 2U);
    QCOMPARE(blocks[0].text, std::string("drillwave run  x\n\n# no heading\n"));
    QCOMPARE(blocks[1].text, std::string("c = 2   (T1)\nZ = 3\n"));
    // Behind an item what is indented by four belongs to it, and so does its code.
    QCOMPARE(kindsOf("1. one\n\n   ```sh\n   x\n   ```\n\n   more\n"),
             (std::vector{Kind::item, Kind::code, Kind::paragraph}));
}

void TestManualText::cellsAreWhatStandsBetweenBars() {
    const auto blocks = readMarkdown("| a | b |\n|---|---|\n| `x|y` | |\n");
    QCOMPARE(blocks.size(), 1U);
    QCOMPARE(blocks[0].rows.size(), 2U);
    QCOMPARE(blocks[0].rows[1][0], std::string("`x|y`"));
    QCOMPARE(blocks[0].rows[1][1], std::string());
}

void TestManualText::aSectionEndsWhereTheNextOneBegins() {
    const auto blocks = readMarkdown("# T\n## §1 One\na\n### §1.1 Deeper\nb\n## §2 Two\nc\n");
    QCOMPARE(sectionOf(blocks, "§1").size(), 4U);
    QCOMPARE(sectionOf(blocks, "§1.1").size(), 2U);
    QCOMPARE(sectionOf(blocks, "§2 Two").back().text, std::string("c"));
    QVERIFY(sectionOf(blocks, "§3").empty());
    QVERIFY(sectionOf(blocks, "").empty());
}

void TestManualText::marksAreTakenOffAndWordsStay_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("shown");
    QTest::newRow("bold") << "**Rock**: *slanted*"
                          << "Rock: slanted";
    QTest::newRow("a product") << "2 * 3"
                               << "2 * 3";
    QTest::newRow("code") << "`2*3 [x](y)`"
                          << "`2*3 [x](y)`";
    QTest::newRow("a link") << "see [Theory](theory.md), §1"
                            << "see Theory, §1";
    QTest::newRow("brackets") << "from [0, 1) and `[NAME]`"
                              << "from [0, 1) and `[NAME]`";
    QTest::newRow("a picture") << "![the window](x.png)"
                               << "the window";
}

void TestManualText::marksAreTakenOffAndWordsStay() {
    QFETCH(QString, line);
    QFETCH(QString, shown);
    QCOMPARE(QString::fromStdString(withoutMarks(line.toStdString())), shown);
}

void TestManualText::linesAreBrokenAtBlanks() {
    QCOMPARE(wrapped("γ is one column wide", 8), (std::vector<std::string>{"γ is one", "column", "wide"}));
    QCOMPARE(wrapped("", 8), std::vector<std::string>{""});
    QCOMPARE(wrapped("unbreakable", 4), std::vector<std::string>{"unbreakable"});
}

void TestManualText::tablesAreColumnsWithinTheWidth() {
    const QString table =
        plain("| key | meaning |\n|---|---|\n| `a` | one two three four five six seven |\n", 24);
    for (const QString& line : table.split(u'\n')) QVERIFY2(line.size() <= 24, qPrintable(line));
    QVERIFY(table.startsWith(QStringLiteral("key  meaning\n---  ----")));
}

void TestManualText::everyChapterIsThere() {
    const std::vector<Chapter> manual = manualChapters(plainStyle());
    for (const char* name : {"tutorial", "window", "files", "commands", "parameters", "outputs", "glossary",
                             "theory", "strings", "drilling", "evidence", "upgrading"})
        QVERIFY2(findChapter(manual, name), name);
    for (const Chapter& chapter : manual) QVERIFY(chapter.title != chapter.name);
    QVERIFY(!findChapter(manual, "nothing"));
    QCOMPARE(manual.size(), chapterNames().size());
}

// Words of every chapter, in order: what a reader of Markdown drops would be gone from the terminal.
void TestManualText::noTextOfAChapterIsLost() {
    for (const Chapter& chapter : manualChapters(plainStyle())) {
        const QString shown = plain(chapter.text).simplified();
        for (const ManualBlock& block : readMarkdown(chapter.text)) {
            if (block.kind == Kind::table) continue;
            const QString text =
                QString::fromStdString(block.kind == Kind::code ? block.text : withoutMarks(block.text));
            QVERIFY2(shown.contains(text.simplified()), qPrintable(text));
        }
    }
}

void TestManualText::aParameterIsToldWithItsPresetsAndTheirSources() {
    const QString text = plain(referenceOf(*findParameter("bit_rock.gamma"), plainStyle()), 200);
    QVERIFY(text.contains(QStringLiteral("range: in (0, 1]\n")));
    QVERIFY(text.contains(QStringLiteral("usual: 0.01 – 1\n")));
    QVERIFY(plain(referenceOf(*findParameter("rod.length"), plainStyle()))
                .contains(QStringLiteral("greater than 0")));
    QVERIFY(plain(referenceOf(*findParameter("bit_rock.gap"), plainStyle()))
                .contains(QStringLiteral("at least 0")));
    QVERIFY(text.contains(
        QStringLiteral("0.1: soft rock; medium rock (the paper's value for percussive drilling)")));
    QVERIFY(plain(referenceOf(*findParameter("string.rod.length"), plainStyle()))
                .contains(QStringLiteral("1 um – 100000 m")));
}

void TestManualText::wholeWordsAreCountedInSingularAndPlural() {
    QCOMPARE(countOfWord("Units; a unit, united", "units"), 2U);
    QCOMPARE(countOfWord("a unit", "UNIT"), 1U);
    QCOMPARE(countOfWord("loss, los", "loss"), 1U);
    QCOMPARE(countOfWord("Stöße, Stößel", "Stöße"), 1U);
    QCOMPARE(countOfWord("`--set`, --settle", "--set"), 1U);
    QVERIFY(hasWords("Exit codes", "code exit") && !hasWords("Exit codes", "code other") &&
            hasWords("x", ""));
}

void TestManualText::titlesComeBeforeTermsAndText() {
    const std::vector<Chapter> manual{
        chapterOf("commands", "# Commands\n\nA *feed* here, a feed there.\n\n## §1 Other\n\none feed\n"),
        chapterOf("glossary",
                  "# Glossary\n\n## §1 Terms\n\n- **feed force**: it pushes\n- **bit**: no feed\n"),
        chapterOf("files",
                  "# Files\n\n## §1 The feed\n\n## §2 Feed\n\n## §3 X\n\n| a | b |\n|-|-|\n| feed | c |\n")};
    QStringList found;
    for (const WordPlace& place : placesOfWords(manual, "feed"))
        found.append(QString::fromStdString(place.chapter + " " + place.number + ": " + place.shown));
    QCOMPARE(found, (QStringList{"files 2: Feed", "files 1: The feed", "glossary 1: feed force: it pushes",
                                 "glossary 1: bit: no feed", "files 3: feed: c",
                                 "commands : Commands: A feed here, a feed there. ",
                                 "commands 1: Other: one feed "}));
    QVERIFY(placesOfWords(manual, "").empty() && placesOfWords(manual, "nothing").empty());
}

QTEST_APPLESS_MAIN(TestManualText)
#include "tst_manual_text.moc"

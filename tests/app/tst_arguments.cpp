// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a command line sorted into options and operands, in process.
#include <QProcess>
#include <QTest>

#include "app/arguments.h"
#include "app/command_error.h"

using namespace drillwave;

namespace {

using Words = std::vector<std::string>;

const std::vector<OptionSpec> specs{
    {"set", "KEY=VALUE", "a list", OptionSpec::Times::list},
    {"level", "X", "repeated", OptionSpec::Times::repeated},
    {"json", "", "a switch"},
    {"j", "N", "a number"},
    {"o", "FILE", "a name"},
};

/// What the words are refused with; empty where they are not.
std::string refusal(const Words& words) {
    try {
        Arguments::parse(words, specs);
    } catch (const CommandError& error) {
        return error.code() == ExitCode::usage ? error.lines().front() : "other exit code";
    }
    return {};
}

/// The words that a shell makes of a text.
QList<QByteArray> wordsOfShell(const std::string& text) {
    QProcess shell;
    shell.start("sh", {"-c", "printf '%s\\0' " + QString::fromStdString(text)});
    if (!shell.waitForFinished()) qFatal("no shell");
    QList<QByteArray> words = shell.readAllStandardOutput().split('\0');
    words.removeLast();
    return words;
}

}  // namespace

class TestArguments : public QObject {
    Q_OBJECT

  private slots:
    void everySpellingOfAnOptionIsRead_data();
    void everySpellingOfAnOptionIsRead();
    void aListTakesTheAssignmentsBehindIt();
    void twoHyphensEndTheOptions();
    void outputAndOutputsAreOneOption();
    void mistakesAreNamed_data();
    void mistakesAreNamed();
    void whatOnlyLooksLikeAnOptionIsAValue();
    void aShellGivesTheWordsBack();
    void theWordsOfALineAreThoseOfAShell();
    void aNumberIsWholeAndInItsRange();
};

void TestArguments::everySpellingOfAnOptionIsRead_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("a word of its own") << QStringList{"-j", "4"};
    QTest::newRow("attached") << QStringList{"-j4"};
    QTest::newRow("attached with =") << QStringList{"-j=4"};
}

void TestArguments::everySpellingOfAnOptionIsRead() {
    QFETCH(QStringList, words);
    Words plain{"file"};
    for (const QString& word : words) plain.push_back(word.toStdString());
    const Arguments arguments = Arguments::parse(plain, specs);
    QCOMPARE(arguments.value("j").value(), std::string("4"));
    QCOMPARE(arguments.number("j", 1, 1, 10), 4L);
    QCOMPARE(arguments.operands(), Words{"file"});
}

void TestArguments::aListTakesTheAssignmentsBehindIt() {
    const Arguments arguments =
        Arguments::parse(Words{"--set", "a=1", "b=2", "file", "c=3", "--level=5", "--level", "6"}, specs);
    QCOMPARE(arguments.values("set"), (Words{"a=1", "b=2"}));
    QCOMPARE(arguments.operands(), (Words{"file", "c=3"}));
    QCOMPARE(arguments.values("level"), (Words{"5", "6"}));
    QVERIFY(!arguments.has("json"));
}

void TestArguments::twoHyphensEndTheOptions() {
    const Arguments arguments = Arguments::parse(Words{"--json", "--", "--json", "-"}, specs);
    QVERIFY(arguments.has("json"));
    QCOMPARE(arguments.operands(), (Words{"--json", "-"}));
}

void TestArguments::outputAndOutputsAreOneOption() {
    const std::array many{OptionSpec{"outputs", "A,B", ""}, OptionSpec{"o", "FILE", ""}};
    const std::array one{OptionSpec{"output", "A", ""}};
    QCOMPARE(Arguments::parse(Words{"--output", "cor"}, many).value("outputs").value(), std::string("cor"));
    QCOMPARE(Arguments::parse(Words{"--outputs=cor"}, one).value("output").value(), std::string("cor"));
    QVERIFY_EXCEPTION_THROWN(Arguments::parse(Words{"--output=cor", "--outputs=cor"}, many), CommandError);
}

void TestArguments::mistakesAreNamed_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("line");
    QTest::newRow("nearly an option")
        << QStringList{"--jsn"} << "unknown option `--jsn`; did you mean `--json`?";
    QTest::newRow("as other programs call it")
        << QStringList{"--threads", "4"} << "unknown option `--threads`; did you mean `-j`?";
    QTest::newRow("a letter") << QStringList{"-x"} << "unknown option `-x`; --help lists the options";
    QTest::newRow("twice") << QStringList{"-j", "1", "-j2"} << "`-j` is given twice; give it once";
    QTest::newRow("a switch with a value") << QStringList{"--json=yes"} << "`--json` takes no value";
    QTest::newRow("without its value") << QStringList{"-o"} << "`-o` needs a value: FILE";
    QTest::newRow("an option in place of its value")
        << QStringList{"-o", "--json"}
        << "`-o` needs a value: FILE; `--json` after it is an option; write ./--json for a file of that name";
    QTest::newRow("a letter in place of its value")
        << QStringList{"--level", "-j4"} << "`--level` needs a value: X; `-j4` after it is an option";
    QTest::newRow("the end in place of its value")
        << QStringList{"--level", "--"} << "`--level` needs a value: X; `--` after it is an option";
}

void TestArguments::mistakesAreNamed() {
    QFETCH(QStringList, words);
    QFETCH(QString, line);
    Words plain;
    for (const QString& word : words) plain.push_back(word.toStdString());
    QCOMPARE(QString::fromStdString(refusal(plain)), line);
}

void TestArguments::aShellGivesTheWordsBack() {
    const Arguments arguments = Arguments::parse(
        Words{"my file's.yaml", "--set", "title=a \"b\" $c `d` \\e", "--json", "-j", "4", "-o", "out"},
        specs);
    const std::vector<std::string_view> without{"j", "o"};
    const QList<QByteArray> expected{"my file's.yaml", "--set", "title=a \"b\" $c `d` \\e", "--json"};
    QCOMPARE(wordsOfShell(arguments.shellText(without)), expected);
    const Arguments odd = Arguments::parse(Words{"--json", "--", "-x", ""}, specs);
    QCOMPARE(wordsOfShell(odd.shellText({})), (QList<QByteArray>{"--json", "--", "-x", ""}));
}

void TestArguments::whatOnlyLooksLikeAnOptionIsAValue() {
    const Arguments arguments =
        Arguments::parse(Words{"--level", "-1.5", "--level=--json", "-o", "-"}, specs);
    QCOMPARE(arguments.values("level"), (Words{"-1.5", "--json"}));
    QCOMPARE(arguments.value("o"), std::string("-"));
}

void TestArguments::theWordsOfALineAreThoseOfAShell() {
    const Words words{"my file's.yaml", "--set", "title=a \"b\" $c `d` \\e '", "--json", "", "--", "-x"};
    const std::string line = Arguments::parse(words, specs).shellText({});
    Words expected;
    for (const QByteArray& word : wordsOfShell(line)) expected.push_back(word.toStdString());
    QCOMPARE(shellWords(line), expected);
    QCOMPARE(shellWords("  two   words  "), (Words{"two", "words"}));
    QCOMPARE(Arguments::parse(Words{"x", "--json", "-j4"}, specs).optionsText({}),
             std::string("--json -j 4"));
}

void TestArguments::aNumberIsWholeAndInItsRange() {
    for (const char* text : {"", "4x", "4.5", "0", "11", "99999999999999999999"}) {
        const Arguments arguments = Arguments::parse(Words{"-j", text}, specs);
        try {
            arguments.number("j", 1, 1, 10);
            QFAIL(text);
        } catch (const CommandError& error) {
            QCOMPARE(error.code(), ExitCode::usage);
            QVERIFY(error.lines().front().ends_with("(must be a whole number from 1 to 10)"));
        }
    }
    QCOMPARE(Arguments::parse(Words{}, specs).number("j", 7, 1, 10), 7L);
}

QTEST_GUILESS_MAIN(TestArguments)
#include "tst_arguments.moc"

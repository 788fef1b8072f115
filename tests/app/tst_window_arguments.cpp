// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line without a command.
#include <QDir>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTest>

#include "app/command_error.h"
#include "app/window_arguments.h"

using namespace drillwave;

namespace {

using Words = std::vector<std::string>;

}  // namespace

class TestWindowArguments : public QObject {
    Q_OBJECT

  private slots:
    void aFileIsOpened();
    void anExampleIsOpenedByItsName();
    void aLanguageIsSpoken();
    void otherWordsAreRefused_data();
    void otherWordsAreRefused();
};

void TestWindowArguments::aFileIsOpened() {
    QTemporaryFile file;
    QVERIFY(file.open());
    const std::string path = file.fileName().toStdString();
    QVERIFY(windowArguments(Words{}).file.empty());
    QCOMPARE(windowArguments(Words{path}).file, path);
    QVERIFY(!windowArguments(Words{path}).resetsUi);
    QCOMPARE(windowArguments(Words{"--reset-ui", path}).file, path);
    QVERIFY(windowArguments(Words{path, "--reset-ui"}).resetsUi);
    QVERIFY_EXCEPTION_THROWN(windowArguments(Words{path, path}), CommandError);
}

// As FILE of a command.
void TestWindowArguments::anExampleIsOpenedByItsName() {
    QVERIFY(!windowArguments(Words{}).example);
    for (const Example& example : builtInExamples()) {
        const WindowArguments arguments = windowArguments(Words{example.name});
        QCOMPARE(arguments.example, &example);
        QVERIFY(arguments.file.empty());
        QVERIFY_EXCEPTION_THROWN(windowArguments(Words{example.name, example.name}), CommandError);
    }
    // A file of that name goes first.
    const QTemporaryDir folder;
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder.path()));
    QFile file(QString::fromStdString(builtInExamples().front().name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const WindowArguments arguments = windowArguments(Words{builtInExamples().front().name});
    QVERIFY(QDir::setCurrent(before));
    QCOMPARE(arguments.file, builtInExamples().front().name);
    QVERIFY(!arguments.example);
}

void TestWindowArguments::aLanguageIsSpoken() {
    QVERIFY(!windowArguments(Words{}).language);
    for (const Language& language : languages) {
        const std::string code(language.code);
        QCOMPARE(windowArguments(Words{"--language", code}).language, &language);
        const WindowArguments both = windowArguments(Words{"t38_string", "--language", code, "--reset-ui"});
        QCOMPARE(both.language, &language);
        QCOMPARE(both.example, findExample("t38_string"));
        QVERIFY(both.resetsUi);
    }
    for (const Words& words :
         {Words{"--language"}, Words{"--language", "tlh"}, Words{"--language", "--reset-ui"}})
        try {
            windowArguments(words);
            QFAIL("not refused");
        } catch (const CommandError& error) {
            QCOMPARE(error.code(), ExitCode::usage);
            QVERIFY2(error.lines().front().find("en, de, sv") != std::string::npos,
                     error.lines().front().c_str());
        }
}

void TestWindowArguments::otherWordsAreRefused_data() {
    QTest::addColumn<QString>("word");
    QTest::addColumn<ExitCode>("code");
    QTest::addColumn<QString>("part");
    QTest::newRow("nearly a command") << "swep" << ExitCode::usage << "did you mean `drillwave sweep`?";
    QTest::newRow("nearly an example")
        << "t38_medium_rok" << ExitCode::usage << "did you mean `drillwave t38_medium_rock`?";
    QTest::newRow("an option") << "--set" << ExitCode::usage << "unknown option `--set`";
    QTest::newRow("no file") << "nowhere/at/all.yaml" << ExitCode::unreadableInput << "No such file";
}

void TestWindowArguments::otherWordsAreRefused() {
    QFETCH(QString, word);
    QFETCH(ExitCode, code);
    QFETCH(QString, part);
    try {
        windowArguments(Words{word.toStdString()});
        QFAIL("not refused");
    } catch (const CommandError& error) {
        QCOMPARE(error.code(), code);
        QVERIFY2(QString::fromStdString(error.lines().front()).contains(part), error.lines().front().c_str());
    }
}

QTEST_GUILESS_MAIN(TestWindowArguments)
#include "tst_window_arguments.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Manual page and completions against the help of every command, and as bash and man take them.
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "app/describe/completions.h"
#include "app/describe/man_page.h"
#include "app/help_text.h"
#include "app/language_option.h"

using namespace drillwave;

namespace {

/// "--set", "-o" of the lines of a help that tell of options.
QStringList optionsIn(const QString& help) {
    static const QRegularExpression line("^  (--?[a-z][a-z-]*)", QRegularExpression::MultilineOption);
    QStringList options;
    const qsizetype begin = help.indexOf("\nOptions:\n");
    const qsizetype end = help.indexOf("\n\n", begin + 1);
    for (auto match = line.globalMatch(help.mid(begin, end - begin)); match.hasNext();)
        options.append(match.next().captured(1));
    options.removeOne("-h");
    options.removeOne("--version");
    return options;
}

QString helpOf(const Command& command) {
    return QString::fromStdString(commandHelp(command));
}

/// Without the marks of man(7).
QString pageText() {
    QString page = QString::fromStdString(manPage("2000-01-01"));
    return page.replace("\\-", "-")
        .replace("\\(aq", "'")
        .replace("\\(ha", "^")
        .replace("\\(ti", "~")
        .remove("\\fB")
        .remove("\\fR")
        .remove("\\&");
}

/// The part of a page between the title of a command and the next one.
QString pagePart(const QString& page, std::string_view command) {
    const qsizetype begin = page.indexOf(".SS " + QString::fromUtf8(command.data(), command.size()) + "\n");
    return begin < 0 ? QString() : page.mid(begin, page.indexOf("\n.S", begin + 1) - begin);
}

/// Returns the offers of bash for a line that ends in the last of the words.
QStringList offered(const QStringList& words) {
    QProcess bash;
    bash.setWorkingDirectory("/");
    const QString script = QString::fromStdString(bashCompletion()) +
                           "\ncompopt() { :; }\nCOMP_WORDS=(\"$@\")\nCOMP_CWORD=$(($# - 1))\n_drillwave\n"
                           "printf '%s\\n' \"${COMPREPLY[@]}\"\n";
    bash.start("bash", QStringList{"--norc", "-c", script, "bash"} + words);
    if (!bash.waitForFinished(60000) || bash.exitCode() != 0)
        return {"failed: " + bash.readAllStandardError()};
    return QString::fromUtf8(bash.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
}

}  // namespace

class TestDescriptions : public QObject {
    Q_OBJECT

  private slots:
    void thePageTellsOfEveryCommandAndOption() {
        const QString page = pageText();
        for (const Command* command : commands()) {
            const QString part = pagePart(page, command->name);
            QVERIFY2(part.contains(QString::fromUtf8(command->summary.data())), command->name.data());
            const QStringList options = optionsIn(helpOf(*command));
            QCOMPARE(options.size(), qsizetype(optionsOf(*command).size()));
            for (const QString& option : options)
                QVERIFY2(option == languageOption.text().c_str() || part.contains("\n.TP\n" + option),
                         qPrintable(command->name.data() + (" " + option)));
        }
    }

    void thePageHasAllWordsOfTheDetails() {
        static const QRegularExpression blanks("\\s+");
        const QString page = pageText();
        for (const Command* command : commands()) {
            const QString part = pagePart(page, command->name);
            const std::string details = detailsOf(*command);
            for (const QString& word : QString::fromStdString(details)
                                           .remove('`')
                                           .replace("…", "...")
                                           .split(blanks, Qt::SkipEmptyParts))
                QVERIFY2(part.contains(word), qPrintable(command->name.data() + (" " + word)));
        }
    }

    void manSetsThePageWithoutAWarning() {
        if (QStandardPaths::findExecutable("man").isEmpty()) QSKIP("no man here");
        for (const std::string& page : {manPage("2000-01-01"), windowManPage("2000-01-01")}) {
            QTemporaryDir folder;
            QFile file(folder.filePath("page.1"));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(page.c_str()) > 0);
            file.close();
            QProcess man;
            man.start("man", {"--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", file.fileName()});
            QVERIFY(man.waitForFinished(60000));
            QCOMPARE(man.readAllStandardError(), QByteArray());
        }
    }

    void manWithoutUtf8LosesNothing() {
        if (QStandardPaths::findExecutable("man").isEmpty()) QSKIP("no man here");
        QTemporaryDir folder;
        QFile file(folder.filePath("page.1"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(manPage("2000-01-01").c_str()) > 0);
        file.close();
        QProcess man;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"LC_ALL", "LANG"}) environment.insert(name, "C");
        man.setProcessEnvironment(environment);
        man.start("man", {"--warnings", "-l", file.fileName()});
        QVERIFY(man.waitForFinished(60000));
        QCOMPARE(man.readAllStandardError(), QByteArray());
        QVERIFY(man.readAllStandardOutput().contains("drillwave run FILE [OPTION]..."));
    }

    void theLanguageOfThePageIsKeptFromText() {
        QCOMPARE(manText("FILE…\n… x"), std::string("FILE...\n\\&... x"));
        QCOMPARE(manText(".x -y"), std::string("\\&.x \\-y"));
        QCOMPARE(manText("it's\n'a` b`\\"), std::string("it\\(aqs\n\\&\\(aqa\\fB b\\fR\\e"));
        QCOMPARE(manDetails("Two\nlines:\n  key  what\n       more\nEnd"),
                 std::string(".PP\nTwo\n.PP\nlines:\n.TP\n\\fBkey\\fR\nwhat\nmore\n.PP\nEnd\n"));
    }

    void bashOffersEveryCommandAndOption() {
        const QStringList names = offered({"drillwave", ""});
        for (const Command* command : commands()) {
            QVERIFY2(names.contains(command->name.data()), command->name.data());
            QStringList options = offered({"drillwave", command->name.data(), "-"});
            QStringList expected = optionsIn(helpOf(*command)) + QStringList{"--help"};
            QCOMPARE(QSet(options.begin(), options.end()), QSet(expected.begin(), expected.end()));
        }
    }

    void zshKnowsEveryCommandAndOption() {
        const QString script = QString::fromStdString(zshCompletion());
        for (const Command* command : commands()) {
            const QString name = command->name.data();
            QVERIFY2(script.contains("\n        '" + name + ":"), command->name.data());
            const qsizetype begin = script.indexOf("\n        " + name + ")\n");
            QVERIFY2(begin >= 0, command->name.data());
            const QString part = script.mid(begin, script.indexOf("\n            ;;\n", begin) - begin);
            for (const QString& option : optionsIn(helpOf(*command)))
                QVERIFY2(part.contains("'" + option + "[") || part.contains("'*" + option + "["),
                         qPrintable(name + " " + option));
        }
    }

    void fishKnowsEveryCommandAndOption() {
        const QStringList lines = QString::fromStdString(fishCompletion()).split('\n');
        for (const Command* command : commands()) {
            const QString name = command->name.data();
            QCOMPARE(lines.filter("use_subcommand -a " + name + " ").size(), 1);
            const QStringList own = lines.filter("seen_subcommand_from " + name + "'");
            for (const QString& option : optionsIn(helpOf(*command))) {
                const bool isLong = option.startsWith("--");
                QCOMPARE(own.filter((isLong ? " -l " : " -s ") + option.mid(isLong ? 2 : 1) + " ").size(), 1);
            }
        }
    }

    void bashOffersWhatAnOptionTakes_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QStringList>("expected");
        QTest::newRow("a parameter") << QStringList{"run", "x", "--set", "rod.le"}
                                     << QStringList{"rod.length="};
        // Bash splits at "=".
        QTest::newRow("a second one")
            << QStringList{"run", "--set", "rod.length", "=", "4m", "bet"} << QStringList{"beta="};
        QTest::newRow("its value") << QStringList{"run", "--set", "rod.length", "="} << QStringList{};
        QTest::newRow("one of the words that a parameter may be")
            << QStringList{"run", "x", "--set", "pulse.shape", "=", "half"} << QStringList{"half_sine"};
        QTest::newRow("a word where bash does not split")
            << QStringList{"run", "x", "--set", "bit_rock.law=po"} << QStringList{"power"};
        QTest::newRow("true or false")
            << QStringList{"run", "x", "--set", "hammer.restrike", "="} << QStringList{"true", "false"};
        QTest::newRow("a section of a string") << QStringList{"run", "x", "--set", "string.coupling.diam"}
                                               << QStringList{"string.coupling.diameter="};
        QTest::newRow("a key after an axis with colons")
            << QStringList{"sweep", "x", "--vary", "beta", "=", "0.1", ":", "10", ":", "5", "pulse.sh"}
            << QStringList{"pulse.shape="};
        QTest::newRow("a bit that is chosen")
            << QStringList{"design", "x", "--choose", "bit", "=", "T51"} << QStringList{"T51\\,\\ 100\\ mm"};
        QTest::newRow("a preset that is chosen") << QStringList{"design", "x", "--choose", "rod", "=", "T45"}
                                                 << QStringList{"T45\\,\\ round\\ 46\\ mm"};
        QTest::newRow("a preset whose name is begun")
            << QStringList{"design", "x", "--choose", "hammer", "=", "medium\\ drifter\\,"}
            << QStringList{"medium\\ drifter\\,\\ piston"};
        QTest::newRow("the sense of an aim")
            << QStringList{"design", "x", "--aim", "m"} << QStringList{"max:", "min:"};
        QTest::newRow("its output") << QStringList{"design", "x", "--aim", "max", ":", "rock_w"}
                                    << QStringList{"rock_work@"};
        QTest::newRow("its statistic")
            << QStringList{"design", "x", "--aim", "max", ":", "cor", "@", "q0"} << QStringList{"q05"};
        QTest::newRow("a limit") << QStringList{"design", "x", "--at-most", "peak_fo"}
                                 << QStringList{"peak_force@"};
        QTest::newRow("its statistic, a value follows")
            << QStringList{"design", "x", "--at-most", "cor", "@", "m"}
            << QStringList{"mean=", "min=", "max="};
        QTest::newRow("a second limit")
            << QStringList{"design", "x", "--at-most", "cor", "@", "mean", "=", "1", "peak_fo"}
            << QStringList{"peak_force@"};
        QTest::newRow("an option of the program")
            << QStringList{"--"} << QStringList{"--help", "--version", "--language", "--reset-ui"};
        QTest::newRow("a language before a command") << QStringList{"--language", "s"} << QStringList{"sv"};
        QTest::newRow("a command after a language")
            << QStringList{"--language", "de", "stab"} << QStringList{"stability"};
        QTest::newRow("an axis") << QStringList{"map", "x", "--y", "delt"} << QStringList{"delta="};
        QTest::newRow("an output") << QStringList{"sweep", "x", "--outputs", "rebound_e"}
                                   << QStringList{"rebound_energy"};
        QTest::newRow("one more") << QStringList{"sweep", "x", "--outputs", "cor,rebound_e"}
                                  << QStringList{"cor,rebound_energy"};
        QTest::newRow("an output of many blows")
            << QStringList{"sweep", "x", "--outputs", "drill_gap_d"} << QStringList{"drill_gap_deviation"};
        QTest::newRow("formats not given yet")
            << QStringList{"run", "x", "--plots", "png,"} << QStringList{"png,svg", "png,pdf"};
        QTest::newRow("a format") << QStringList{"run", "x", "--plots", "png,s"} << QStringList{"png,svg"};
        QTest::newRow("a study of reports")
            << QStringList{"report", "x", "--with", "drill,d"} << QStringList{"drill,design"};
        QTest::newRow("a method") << QStringList{"run", "x", "--method", "c"} << QStringList{"closed_form"};
        QTest::newRow("a rod") << QStringList{"run", "x", "--rod", "T45"}
                               << QStringList{"T45\\,\\ round\\ 46\\ mm"};
        QTest::newRow("a number") << QStringList{"sweep", "x", "-j", ""} << QStringList{};
        QTest::newRow("an example as FILE") << QStringList{"run", "t38_m"} << QStringList{"t38_medium_rock"};
        QTest::newRow("an example for the window") << QStringList{"t38_m"} << QStringList{"t38_medium_rock"};
        QTest::newRow("a command to be helped with")
            << QStringList{"help", "stab"} << QStringList{"stability"};
        QTest::newRow("a chapter") << QStringList{"help", "glos"} << QStringList{"glossary"};
        QTest::newRow("a parameter to be told of")
            << QStringList{"help", "bit_rock.gam"} << QStringList{"bit_rock.gamma"};
    }

    void bashOffersWhatAnOptionTakes() {
        QFETCH(QStringList, words);
        QFETCH(QStringList, expected);
        QCOMPARE(offered(QStringList{"drillwave"} + words), expected);
    }

    // With "-o filenames" bash would write pulse.shape\=.
    void bashTakesNoKeyForAFile() {
        QProcess bash;
        const QString script =
            QString::fromStdString(bashCompletion()) +
            "\ncompopt() { [[ $2 != filenames ]] || echo asked; }\nCOMP_WORDS=(drillwave run --set "
            "a = 1 '')\nCOMP_CWORD=6\n_drillwave\n";
        bash.setWorkingDirectory("/");
        bash.start("bash", {"--norc", "-c", script});
        QVERIFY(bash.waitForFinished(60000));
        QCOMPARE(bash.readAllStandardOutput(), QByteArray());
    }

    // Interactive shells are not driven here: what their scripts say is.
    void fishAndZshOfferTheSameStages() {
        const QString fish = QString::fromStdString(fishCompletion()),
                      zsh = QString::fromStdString(zshCompletion());
        QVERIFY(fish.contains("run; and __drillwave_follows --set' -a '(__drillwave_parameter)'"));
        QVERIFY(fish.contains("-n __drillwave_use_subcommand -l language -x"));
        QVERIFY(zsh.contains(":*-*:KEY=VALUE:_drillwave_parameter'"));
        QVERIFY(zsh.contains("compadd -- --help --version --language --reset-ui"));
        for (const QString& script : {fish, zsh})
            for (const char* word : {"'pulse.shape=half_sine'", "'string.coupling.diameter='", "'max:cor@'",
                                     "'hammer=medium drifter, piston'"})
                QVERIFY2(script.contains(word), word);
    }

    void shellsReadTheirScripts() {
        QTemporaryDir folder;
        const std::pair<const char*, std::string> scripts[]{
            {"bash", bashCompletion()}, {"zsh", zshCompletion()}, {"fish", fishCompletion()}};
        for (const auto& [shell, script] : scripts) {
            if (QStandardPaths::findExecutable(shell).isEmpty()) continue;
            QFile file(folder.filePath(shell));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(script.c_str()) > 0);
            file.close();
            QProcess process;
            process.start(shell, {"-n", file.fileName()});
            QVERIFY(process.waitForFinished(60000));
            const QByteArray said = process.readAllStandardError();
            QVERIFY2(process.exitCode() == 0 && said.isEmpty(), said);
        }
    }
};

QTEST_GUILESS_MAIN(TestDescriptions)
#include "tst_descriptions.moc"

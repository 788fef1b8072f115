// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/command_error.h"
#include "app/language_option.h"

using namespace drillwave;

namespace {

using Words = std::vector<std::string>;

/// The line of the refusal, empty where there is none.
QString refusal(Words words) {
    try {
        if (!takeLanguage(words)) checkLanguageVariable();
    } catch (const CommandError& error) {
        return error.code() == ExitCode::usage ? QString::fromStdString(error.lines().front())
                                               : QStringLiteral("another exit code");
    }
    return {};
}

}  // namespace

class TestLanguageOption : public QObject {
    Q_OBJECT

  private slots:
    void init() { qunsetenv(languageVariable); }
    void cleanup() { qunsetenv(languageVariable); }

    void itIsTakenFromAnyPlace() {
        for (const Words& words :
             {Words{"--language", "de", "run", "x"}, Words{"run", "--language", "de", "x"},
              Words{"run", "x", "--language=de"}, Words{"run", "x", "--language", "de"}}) {
            Words rest = words;
            QCOMPARE(takeLanguage(rest), findLanguage("de"));
            QCOMPARE(rest, (Words{"run", "x"}));
        }
    }

    void behindTheEndOfOptionsItIsAName() {
        Words words{"run", "--", "--language", "de"};
        QVERIFY(!takeLanguage(words));
        QCOMPARE(words.size(), std::size_t(4));
    }

    void theVariableNamesOneForAllCommands() {
        QVERIFY(isEnglish(languageOfEnvironment()));
        for (const char* none : {"", "Deutsch"}) {
            qputenv(languageVariable, none);
            QVERIFY(isEnglish(languageOfEnvironment()));
        }
        qputenv(languageVariable, "sv");
        QCOMPARE(&languageOfEnvironment(), findLanguage("sv"));
        QCOMPARE(refusal({"run"}), QString());
    }

    void localesOfSystemsNameALanguage_data() {
        QTest::addColumn<QByteArray>("word");
        QTest::addColumn<QByteArray>("code");
        for (const auto& [word, code] : {std::pair{"DE", "de"},
                                         {"de_DE.UTF-8", "de"},
                                         {"sv_SE", "sv"},
                                         {"sv-SE", "sv"},
                                         {"de@euro", "de"},
                                         {"en_GB.UTF-8", "en"}})
            QTest::newRow(word) << QByteArray(word) << QByteArray(code);
    }

    void localesOfSystemsNameALanguage() {
        QFETCH(QByteArray, word);
        QFETCH(QByteArray, code);
        qputenv(languageVariable, word);
        QCOMPARE(&languageOfEnvironment(), findLanguage(code.toStdString()));
        QCOMPARE(refusal({"run"}), QString());
        Words words{"run", "--language", word.toStdString()};
        QCOMPARE(takeLanguage(words), findLanguage(code.toStdString()));
    }

    void othersAreRefused() {
        QCOMPARE(refusal({"run", "--language"}), QString("--language needs one of en, de, sv"));
        QCOMPARE(refusal({"run", "--language="}), QString("--language needs one of en, de, sv"));
        QCOMPARE(refusal({"--language", "fr"}), QString("--language: `fr` is not one of en, de, sv"));
        QCOMPARE(refusal({"--language", "_DE"}), QString("--language: `_DE` is not one of en, de, sv"));
        QCOMPARE(refusal({"--language", "de", "--language=de"}),
                 QString("`--language` is given twice; give it once"));
        qputenv(languageVariable, "Deutsch");
        QCOMPARE(refusal({"run"}), QString("DRILLWAVE_LANGUAGE: `Deutsch` is not one of en, de, sv"));
        QCOMPARE(refusal({"run", "--language", "en"}), QString());  // which overrules it
    }
};

QTEST_GUILESS_MAIN(TestLanguageOption)
#include "tst_language_option.moc"

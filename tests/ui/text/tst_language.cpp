// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>
#include <thread>

#include "tests/support/window.h"
#include "ui/text/language.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// The application speaks a language as long as one lives.
class Speaking {
  public:
    explicit Speaking(std::string_view code) : m_catalogue(*findLanguage(code)) {
        QCoreApplication::installTranslator(&m_catalogue);
    }

  private:
    Catalogue m_catalogue;  // takes itself away
};

}  // namespace

class TestLanguage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { keepSettingsIn(m_folder.path()); }
    void cleanup() { Settings().clear(); }
    void theFirstThatIsThereIsTaken_data();
    void theFirstThatIsThereIsTaken();
    void whatIsChosenGoesBeforeTheSystem();
    void everyLanguageHasItsTexts();
    void filesAreInEnglish();

  private:
    QTemporaryDir m_folder;
};

void TestLanguage::theFirstThatIsThereIsTaken_data() {
    QTest::addColumn<QStringList>("wanted");
    QTest::addColumn<QString>("code");
    QTest::newRow("Swedish of Finland") << QStringList{"sv-FI", "sv", "fi"} << "sv";
    QTest::newRow("German with its script") << QStringList{"de-Latn-AT"} << "de";
    QTest::newRow("as POSIX writes it") << QStringList{"de_CH"} << "de";
    QTest::newRow("English before Swedish") << QStringList{"en-GB", "sv"} << "en";
    QTest::newRow("Finnish, then Swedish") << QStringList{"fi", "sv"} << "sv";
    QTest::newRow("none that is there") << QStringList{"fi", "ja-JP"} << "en";
    QTest::newRow("no language") << QStringList{"C"} << "en";
    QTest::newRow("nothing") << QStringList{} << "en";
}

void TestLanguage::theFirstThatIsThereIsTaken() {
    QFETCH(QStringList, wanted);
    QFETCH(QString, code);
    QCOMPARE(QString::fromLatin1(firstLanguage(wanted).code.data()), code);
}

void TestLanguage::whatIsChosenGoesBeforeTheSystem() {
    QVERIFY(!chosenLanguage());
    QCOMPARE(&languageToSpeak(), &firstLanguage(QLocale::system().uiLanguages()));
    for (const Language& language : languages) {
        chooseLanguage(&language);
        QCOMPARE(chosenLanguage(), &language);
        QCOMPARE(&languageToSpeak(), &language);
    }
    chooseLanguage(nullptr);
    QVERIFY(!chosenLanguage());
    Settings().setValue(QStringLiteral("language"), QStringLiteral("tlh"));
    QVERIFY(!chosenLanguage());
}

void TestLanguage::everyLanguageHasItsTexts() {
    QCOMPARE(drillwave::tr("elastic hammer"), QStringLiteral("elastic hammer"));
    const auto said = [](std::string_view code) {
        const Speaking speaking(code);
        return drillwave::tr("elastic hammer") + u' ' + coreName("half_sine");
    };
    QCOMPARE(said("en"), QStringLiteral("elastic hammer half sine"));
    QCOMPARE(said("de"), QStringLiteral("elastischer Hammer Halbsinus"));
    QCOMPARE(said("sv"), QStringLiteral("elastisk hammare halvsinus"));
}

void TestLanguage::filesAreInEnglish() {
    const Speaking speaking("sv");
    QCOMPARE(drillwave::tr("elastic hammer"), QStringLiteral("elastisk hammare"));
    {
        const EnglishTexts english;
        QCOMPARE(drillwave::tr("elastic hammer"), QStringLiteral("elastic hammer"));
        { const EnglishTexts again; }
        QCOMPARE(drillwave::tr("elastic hammer"), QStringLiteral("elastic hammer"));
        // Other threads still use the language of the window.
        QString elsewhere;
        std::thread([&] { elsewhere = drillwave::tr("elastic hammer"); }).join();
        QCOMPARE(elsewhere, QStringLiteral("elastisk hammare"));
    }
    QCOMPARE(drillwave::tr("elastic hammer"), QStringLiteral("elastisk hammare"));
}

QTEST_MAIN(TestLanguage)
#include "tst_language.moc"

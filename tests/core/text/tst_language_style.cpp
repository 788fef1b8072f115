// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the commands in another language, without Qt.
#include <QTest>

#include "core/text/languages.h"

using namespace drillwave;

namespace {

const Language& german = *findLanguage("de");

}  // namespace

class TestLanguageStyle : public QObject {
    Q_OBJECT

  private slots:
    void textsComeFromTheCatalogue() {
        QCOMPARE(inLanguage(german, "restitution e"), std::string("Stoßzahl e"));
        QCOMPARE(inLanguage(*findLanguage("sv"), "restitution e"), std::string("studstal e"));
        QCOMPARE(inLanguage(languages[0], "restitution e"), std::string("restitution e"));
        QCOMPARE(inLanguage(german, "in no catalogue"), std::string("in no catalogue"));
        QCOMPARE(inLanguage(german, ""), std::string(""));
    }

    void numbersHaveTheDecimalSign() {
        QCOMPARE(styleOf(german).number(0.125), std::string("0,125"));
        QCOMPARE(styleOf(german).quantity(4380, Quantity::force), std::string("4,38 kN"));
        QCOMPARE(styleOf(german).bound(2e-12), std::string("2,1e-12"));
        QCOMPARE(styleOf(german).signedPercent(0.125), std::string("+12,5 %"));
    }

    void theStyleOfEnglishIsThePlainOne() {
        QCOMPARE(&styleOf(languages[0]), &plainStyle());
        QCOMPARE(&styleOf(german), &styleOf(german));
    }

    void sentencesAreSaidWithTheirParts() {
        const Message inner = translatable("restitution e");
        QCOMPARE(styleOf(german).said({"%1: %2", {inner, std::string("beta")}}),
                 std::string("Stoßzahl e: beta"));
    }
};

QTEST_GUILESS_MAIN(TestLanguageStyle)
#include "tst_language_style.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Sections are counted by their names: "3rd rod".
#include <QTest>

#include "core/model/section_field.h"
#include "core/model/section_words.h"
#include "core/text/languages.h"

using namespace drillwave;

namespace {

Section named(const char* name) {
    Section section;
    section.name = name;
    section.length = 1;
    return section;
}

std::vector<std::string> texts(const std::vector<Message>& words) {
    std::vector<std::string> all;
    for (const Message& each : words) all.push_back(each.text());
    return all;
}

using Texts = std::vector<std::string>;

}  // namespace

class TestSectionWords : public QObject {
    Q_OBJECT

  private slots:
    void sectionsOfOneNameAreCounted() {
        DrillString drill;
        drill.hammer.sections = {named("piston"), named("")};
        drill.parts = {{.sections = {named("adapter")}},
                       {.sections = {named("rod")}},
                       {.repeat = 2, .group = true, .sections = {named("coupling"), named("rod")}},
                       {.sections = {named("")}}};
        QCOMPARE(texts(sectionWords(drill)),
                 (Texts{"hammer 1 (piston)", "hammer 2", "adapter", "1st rod", "1st coupling", "2nd rod",
                        "2nd coupling", "3rd rod", "section 7"}));
        QCOMPARE(texts(rowWords(drill)), (Texts{"hammer 1 (piston)", "hammer 2", "adapter", "1st rod",
                                                "1st and 2nd coupling", "2nd and 3rd rod", "section 7"}));
        QCOMPARE(stringWords(drill).text(), std::string("3 rods, 2 couplings, 2 other sections"));
    }

    void customaryNamesAreInTheLanguageOfTheReader() {
        DrillString drill;
        drill.parts = {{.sections = {named("adapter"), named("rod"), named("coupling"), named("rod")}},
                       {.sections = {named("bit skirt"), named("my rod")}}};
        const ReadingStyle& german = styleOf(*findLanguage("de"));
        std::vector<std::string> words;
        for (const Message& each : stringSectionWords(drill)) words.push_back(german.said(each));
        QCOMPARE(words, (Texts{"Einsteckende", "1. Stange", "Kupplungsmuffe", "2. Stange", "Kronenschaft",
                               "my rod"}));
    }

    void addressesAreCalledAsTheRowsAre() {
        DrillString drill;
        drill.hammer.sections = {named(""), named("")};
        drill.parts = {{.sections = {named("adapter")}},
                       {.repeat = 2, .group = true, .sections = {named("coupling"), named("rod")}},
                       {.sections = {named("")}}};
        const auto words = [&](const char* key) {
            return addressedWords(findSectionAddress(key).value(), drill).text();
        };
        QCOMPARE(words("hammer.2.length"), std::string("hammer 2"));
        QCOMPARE(words("string.1.length"), std::string("adapter"));
        for (const char* key : {"string.3.length", "string.5.length"})
            QCOMPARE(words(key), std::string("1st and 2nd rod"));
        QCOMPARE(words("string.rod.length"), std::string("rod"));
        QCOMPARE(words("string.6.length"), std::string("section 6"));
        QCOMPARE(words("string.9.length"), std::string("section 9"));
    }

    void rowsOfARepeatHaveAllTheirNumbers() {
        DrillString drill;
        drill.parts = {{.repeat = 4, .group = true, .sections = {named("rod"), named("")}},
                       {.repeat = 3, .group = true, .sections = {named("rod"), named("rod")}}};
        QCOMPARE(texts(rowWords(drill)),
                 (Texts{"1st to 4th rod", "sections 2, 4 … 8", "5th, 7th … 9th rod", "6th, 8th … 10th rod"}));
    }

    void ordinalsAreThoseOfEnglish() {
        DrillString drill;
        drill.parts = {{.repeat = 23, .group = true, .sections = {named("rod")}}};
        const Texts all = texts(stringSectionWords(drill));
        QCOMPARE(all[10], std::string("11th rod"));
        QCOMPARE(all[11], std::string("12th rod"));
        QCOMPARE(all[20], std::string("21st rod"));
        QCOMPARE(all[22], std::string("23rd rod"));
        QCOMPARE(stringWords(drill).text(), std::string("23 rods"));
    }
};

QTEST_GUILESS_MAIN(TestSectionWords)
#include "tst_section_words.moc"

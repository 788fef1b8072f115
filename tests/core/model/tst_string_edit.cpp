// SPDX-License-Identifier: GPL-3.0-or-later
// Sections come, go, move and repeat in a list of sections and repeats.
#include <QTest>

#include "core/model/string_edit.h"

using namespace drillwave;

namespace {

Section named(const char* name) {
    Section section;
    section.name = name;
    return section;
}

// Hammer p, q; string a, 3 × (b, c), d.
DrillString sample() {
    DrillString drill;
    drill.hammer.sections = {named("p"), named("q")};
    drill.parts = {{.sections = {named("a")}},
                   {.repeat = 3, .group = true, .sections = {named("b"), named("c")}},
                   {.sections = {named("d")}}};
    return drill;
}

// "p q | a 3(b c) d".
std::string text(const DrillString& drill) {
    std::string all;
    for (const Section& section : drill.hammer.sections) all += section.name + " ";
    all += "|";
    for (const StringPart& part : drill.parts) {
        all += part.group ? " " + std::to_string(part.repeat) + "(" : " ";
        for (std::size_t i = 0; i < part.sections.size(); ++i) all += (i ? " " : "") + part.sections[i].name;
        if (part.group) all += ")";
    }
    return all;
}

SectionSpot spotOf(const DrillString& drill, const std::string& name) {
    for (const SectionSpot& spot : sectionSpots(drill))
        if (sectionAt(drill, spot).name == name) return spot;
    return {.part = 99};
}

}  // namespace

class TestStringEdit : public QObject {
    Q_OBJECT

  private slots:
    void placesCountTheRepeats();
    void aSectionComesBehindAnother();
    void aSectionAfterARepeatIsNotRepeated();
    void sectionsAreReplacedInTheirPlace();
    void theLastOfARepeatTakesItAlong();
    void oneSectionAlwaysStays();
    void everyStepTowardsTheBitCanBeTakenBack();
    void theOnlySectionOfARepeatGoesWithIt();
    void hammerAndStringDoNotMix();
    void repeatsAreMadeOfNeighboursAlone();
    void onceIsNoRepeat();
};

void TestStringEdit::placesCountTheRepeats() {
    const DrillString drill = sample();
    QCOMPARE(sectionSpots(drill).size(), std::size_t(6));
    QCOMPARE(placeOf(drill, spotOf(drill, "q")), std::uint64_t(2));
    QCOMPARE(placeOf(drill, spotOf(drill, "c")), std::uint64_t(3));
    QCOMPARE(placeOf(drill, spotOf(drill, "d")), std::uint64_t(8));
    QCOMPARE(sectionAt(drill, placeOf(drill, spotOf(drill, "d")))->name, std::string("d"));
}

void TestStringEdit::aSectionComesBehindAnother() {
    DrillString drill = sample();
    const SectionSpot added = insertAfter(drill, spotOf(drill, "a"), named("x"));
    QCOMPARE(added, spotOf(drill, "x"));
    QCOMPARE(text(drill), std::string("p q | a x 3(b c) d"));
    insertAfter(drill, spotOf(drill, "b"), named("y"));
    insertAfter(drill, spotOf(drill, "q"), named("z"));
    QCOMPARE(text(drill), std::string("p q z | a x 3(b y c) d"));
}

void TestStringEdit::theLastOfARepeatTakesItAlong() {
    DrillString drill = sample();
    removeSection(drill, spotOf(drill, "b"));
    QCOMPARE(text(drill), std::string("p q | a 3(c) d"));
    removeSection(drill, spotOf(drill, "c"));
    QCOMPARE(text(drill), std::string("p q | a d"));
}

void TestStringEdit::oneSectionAlwaysStays() {
    DrillString drill = sample();
    removeSection(drill, spotOf(drill, "p"));
    QVERIFY(!canRemove(drill, spotOf(drill, "q")));
    for (const char* name : {"a", "d", "b"}) {
        QVERIFY(canRemove(drill, spotOf(drill, name)));
        removeSection(drill, spotOf(drill, name));
    }
    QVERIFY(!canRemove(drill, spotOf(drill, "c")));
}

void TestStringEdit::everyStepTowardsTheBitCanBeTakenBack() {
    DrillString drill = sample();
    const std::vector<std::string> way{"p q | a 3(b c) d", "p q | 3(a b c) d", "p q | 3(b a c) d",
                                       "p q | 3(b c a) d", "p q | 3(b c) a d", "p q | 3(b c) d a"};
    for (std::size_t i = 1; i < way.size(); ++i) {
        const auto spot = moveSection(drill, spotOf(drill, "a"), MoveTo::bit);
        QVERIFY(spot.has_value());
        QCOMPARE(text(drill), way[i]);
        QCOMPARE(*spot, spotOf(drill, "a"));
    }
    QVERIFY(!moveSection(drill, spotOf(drill, "a"), MoveTo::bit));
    for (std::size_t i = way.size() - 1; i-- > 0;) {
        const auto spot = moveSection(drill, spotOf(drill, "a"), MoveTo::rear);
        QVERIFY(spot.has_value());
        QCOMPARE(text(drill), way[i]);
        QCOMPARE(*spot, spotOf(drill, "a"));
    }
    QVERIFY(!moveSection(drill, spotOf(drill, "a"), MoveTo::rear));
}

void TestStringEdit::theOnlySectionOfARepeatGoesWithIt() {
    DrillString drill = sample();
    removeSection(drill, spotOf(drill, "b"));
    moveSection(drill, spotOf(drill, "c"), MoveTo::bit);
    QCOMPARE(text(drill), std::string("p q | a d 3(c)"));
}

void TestStringEdit::hammerAndStringDoNotMix() {
    DrillString drill = sample();
    QVERIFY(!moveSection(drill, spotOf(drill, "q"), MoveTo::bit));
    QVERIFY(moveSection(drill, spotOf(drill, "q"), MoveTo::rear));
    QCOMPARE(text(drill), std::string("q p | a 3(b c) d"));
}

void TestStringEdit::repeatsAreMadeOfNeighboursAlone() {
    DrillString drill = sample();
    const auto can = [&](const std::vector<const char*>& names) {
        std::vector<SectionSpot> spots;
        for (const char* name : names) spots.push_back(spotOf(drill, name));
        return canRepeat(drill, spots);
    };
    QVERIFY(!can({}));
    QVERIFY(!can({"a", "d"}));
    QVERIFY(!can({"b"}));
    QVERIFY(!can({"q"}));
    insertAfter(drill, spotOf(drill, "a"), named("x"));
    QVERIFY(can({"a", "x"}));
    repeatSections(drill, {spotOf(drill, "a"), spotOf(drill, "x")}, 4);
    QCOMPARE(text(drill), std::string("p q | 4(a x) 3(b c) d"));
}

void TestStringEdit::onceIsNoRepeat() {
    DrillString drill = sample();
    setRepeat(drill, 1, 5);
    QCOMPARE(text(drill), std::string("p q | a 5(b c) d"));
    setRepeat(drill, 1, 1);
    QCOMPARE(text(drill), std::string("p q | a b c d"));
}

void TestStringEdit::aSectionAfterARepeatIsNotRepeated() {
    DrillString drill = sample();
    const SectionSpot last = insertBehind(drill, spotOf(drill, "c"), {named("x"), named("y")});
    QCOMPARE(last, spotOf(drill, "y"));
    QCOMPARE(text(drill), std::string("p q | a 3(b c) x y d"));
    insertBehind(drill, spotOf(drill, "b"), {named("z")});
    insertBehind(drill, spotOf(drill, "p"), {named("w")});
    QCOMPARE(text(drill), std::string("p w q | a 3(b z c) x y d"));
}

void TestStringEdit::sectionsAreReplacedInTheirPlace() {
    const auto replaced = [](const std::vector<const char*>& names, const std::vector<Section>& by) {
        DrillString drill = sample();
        std::vector<SectionSpot> spots;
        for (const char* name : names) spots.push_back(spotOf(drill, name));
        if (!canReplace(drill, spots)) return std::string("no");
        const SectionSpot last = replaceSections(drill, spots, by);
        if (!(last == spotOf(drill, by.back().name))) return std::string("elsewhere");
        return text(drill);
    };
    const std::vector<Section> one{named("x")}, two{named("x"), named("y")};
    QCOMPARE(replaced({"a"}, two), std::string("p q | x y 3(b c) d"));
    QCOMPARE(replaced({"c"}, one), std::string("p q | a 3(b x) d"));
    QCOMPARE(replaced({"b", "c"}, two), std::string("p q | a 3(x y) d"));
    QCOMPARE(replaced({"b", "c"}, one), std::string("p q | a 3(x) d"));
    QCOMPARE(replaced({"q"}, two), std::string("p x y | a 3(b c) d"));
    QCOMPARE(replaced({"a", "b"}, one), std::string("no"));
    QCOMPARE(replaced({"a", "d"}, one), std::string("no"));
}

QTEST_GUILESS_MAIN(TestStringEdit)
#include "tst_string_edit.moc"

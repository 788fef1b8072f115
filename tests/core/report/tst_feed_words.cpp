// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the feed in words: it is that of the numbers beside it, it can be acted on, and no sentence
// says anything else than another.
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

#include "core/blow/blow.h"
#include "core/blow/thrust.h"
#include "core/report/feed_words.h"
#include "core/report/report_text.h"
#include "core/report/thrust_report.h"
#include "core/study/gap/gap_statistics.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario scenarioOf(const char* example) {
    return parseScenario(findExample(example)->text, example).scenario;
}

ThrustReport reportOf(const Scenario& scenario) {
    return {.scenario = scenario, .study = studyThrust(scenario), .along = {}, .scenarioText = {}};
}

QStringList sentencesOf(const ThrustReport& report) {
    QStringList sentences;
    for (const Message& sentence : verdictSentences(report.judged()))
        sentences << QString::fromStdString(sentence.text());
    return sentences;
}

FeedDecision decisionOf(const Scenario& scenario) {
    return decisionOf(reportOf(scenario).judged());
}

/// A blow that is studied once: what follows from its e at other feeds and frequencies.
class StudiedBlow {
  public:
    explicit StudiedBlow(const Scenario& scenario) : m_report(reportOf(scenario)) {
        if (!isString(scenario)) m_rock = rockCurve(problemOf(scenario), {}, {});
    }

    const ThrustStudy& study() const { return m_report.study; }
    ThrustReport at(double thrust, double frequency) const {
        ThrustReport report = m_report;
        Scenario& scenario = report.scenario;
        scenario.drill.thrust = thrust;
        scenario.drill.blowFrequency = frequency;
        ThrustStudy& study = report.study;
        const Estimate cor = study.need(ThrustCase::scenario).cor;
        study.needs = m_rock ? thrustNeeds(scenario, cor, study.rebounds)
                             : stringThrustNeeds(scenario, cor, study.transferred);
        study.verdict = *judgeFeed(scenario, cor.value, study.transferred);
        if (m_rock)
            study.shareFull =
                1 - shareAbove(*m_rock, *study.verdict.effective() / study.verdict.balance - 1).value;
        return report;
    }
    FeedDecision decisionAt(double thrust, double frequency) const {
        return decisionOf(at(thrust, frequency).judged());
    }

  private:
    ThrustReport m_report;
    std::optional<GapCurve> m_rock;  // of a rod
};

/// The quantity behind those words, in SI; nothing where they are not there.
std::optional<double> behind(const QString& words, const QString& sentence, Quantity quantity) {
    const QRegularExpressionMatch match =
        QRegularExpression(QRegularExpression::escape(words) + QStringLiteral(" ([-0-9.e+]+ [A-Za-z]+)"))
            .match(sentence);
    if (!match.hasMatch()) return std::nullopt;
    return parseQuantity(match.captured(1).toStdString(), quantity).si;
}

bool isEnoughForBlow(const FeedDecision& decision) {
    return decision.kind == FeedDecision::Kind::enough || decision.kind == FeedDecision::Kind::enoughThisBlow;
}

/// With a comma, and forces in thousands of pounds.
class OtherReader : public ReadingStyle {
  public:
    std::string number(double value, int digits) const override {
        std::string text = rounded(value, digits);
        std::ranges::replace(text, '.', ',');
        return text;
    }
    ReadUnit unitFor(double si, Quantity quantity) const override {
        if (quantity != Quantity::force) return ReadingStyle::unitFor(si, quantity);
        return {findUnit(Quantity::force, "kip"), "kip"};
    }
};

}  // namespace

class TestFeedWords : public QObject {
    Q_OBJECT

  private slots:
    void theDecisionSaysWhatToDo_data();
    void theDecisionSaysWhatToDo();
    void whatIsMissingIsSaid_data();
    void whatIsMissingIsSaid();
    void noSentenceContradictsTheNumbers_data();
    void noSentenceContradictsTheNumbers();
    void whatIsAdvisedIsEnough_data();
    void whatIsAdvisedIsEnough();
    void aHairBelowIsToldInMoreDigits();
    void theWeightAlongTheHoleIsNoThrustToInstall();
    void numbersAreThoseOfTheReader();
    void noLineEndsBetweenANumberAndItsUnit();

  private:
    static void addScenes();
};

void TestFeedWords::theDecisionSaysWhatToDo_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::addColumn<double>("thrust");
    QTest::addColumn<QString>("text");
    QTest::newRow("enough") << QByteArray("t38_medium_rock") << 8e3
                            << "8 kN is enough at every gap up to 66.1 Hz.";
    QTest::newRow("for this blow") << QByteArray("t38_medium_rock") << 6e3
                                   << "6 kN is enough for this blow up to 82.2 Hz, but not at the worst gap "
                                      "on elastic rock: that takes at "
                                      "least 7.26 kN at 60 Hz, or at most 49.6 Hz.";
    QTest::newRow("not enough")
        << QByteArray("t38_medium_rock") << 4e3
        << "4 kN is not enough: at least 4.38 kN at 60 Hz, or at most 54.8 Hz; at every "
           "gap at least 7.26 kN.";
    QTest::newRow("nothing")
        << QByteArray("t38_medium_rock") << 0.0
        << "0 N is not enough: at least 4.38 kN at 60 Hz; at every gap at least 7.26 kN.";
    QTest::newRow("a string") << QByteArray("t38_string") << 10e3
                              << "10 kN is enough for this blow and on rigid rock up to 66.8 Hz.";
    QTest::newRow("a string in this rock") << QByteArray("t38_string") << 8e3
                                           << "8 kN is enough for this blow up to 71.2 Hz, but not on rigid "
                                              "rock: that takes at least 8.98 kN at "
                                              "60 Hz, or at most 53.4 Hz.";
    QTest::newRow("a string that bounces") << QByteArray("t38_string") << 6e3
                                           << "6 kN is not enough: at least 6.74 kN at 60 Hz, or at most "
                                              "53.4 Hz; on rigid rock at least 8.98 kN.";
}

void TestFeedWords::theDecisionSaysWhatToDo() {
    QFETCH(QByteArray, example);
    QFETCH(double, thrust);
    QFETCH(QString, text);
    Scenario scenario = scenarioOf(example.constData());
    scenario.drill.thrust = thrust;
    QCOMPARE(sentencesOf(reportOf(scenario)).front(), text);
}

void TestFeedWords::whatIsMissingIsSaid_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::addColumn<bool>("frequency");
    QTest::addColumn<bool>("thrust");
    QTest::addColumn<QString>("text");
    QTest::newRow("units")
        << QByteArray("paper_fig4a") << false << false
        << "The feed is not judged: the scenario is given by its dimensionless groups, not in "
           "physical units.";
    QTest::newRow("units of the reference case") << QByteArray("reference_case") << false << false
                                                 << "The feed is not judged: the scenario is given by its "
                                                    "dimensionless groups, not in physical units.";
    QTest::newRow("frequency") << QByteArray("t38_medium_rock") << false << true
                               << "The feed is not judged: no blow frequency is given.";
    QTest::newRow("both") << QByteArray("t38_medium_rock") << false << false
                          << "The feed is not judged: neither blow frequency nor thrust is given.";
    QTest::newRow("thrust") << QByteArray("t38_medium_rock") << true << false
                            << "No thrust is given: this blow needs at least 4.38 kN at 60 Hz.";
    QTest::newRow("thrust of a string")
        << QByteArray("t38_string") << true << false
        << "No thrust is given: this blow needs at least 6.74 kN at 60 Hz; on rigid rock at least 8.98 kN.";
}

// Of the blow alone, as `run` tells it.
void TestFeedWords::whatIsMissingIsSaid() {
    QFETCH(QByteArray, example);
    QFETCH(bool, frequency);
    QFETCH(bool, thrust);
    QFETCH(QString, text);
    Scenario scenario = scenarioOf(example.constData());
    if (!frequency) scenario.drill.blowFrequency.reset();
    if (!thrust) scenario.drill.thrust.reset();
    QCOMPARE(QString::fromStdString(feedDecisionText(solveBlow(scenario, {}, Detail::ledger).decision())),
             text);
}

// Rods and strings, stiff and soft rock, e below and above 1, from no thrust to more than enough.
void TestFeedWords::addScenes() {
    QTest::addColumn<QByteArray>("example");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("gap");
    QTest::addColumn<double>("inclination");
    const auto add = [](const char* example, double stiffness, double gamma, double gap, double inclination) {
        QTest::addRow("%s, %g MN/m, gamma %g, gap %g mm, %g degrees", example, stiffness / 1e6, gamma,
                      1e3 * gap, inclination)
            << QByteArray(example) << stiffness << gamma << gap << inclination;
    };
    for (const double stiffness : {50e6, 105e6, 333e6, 900e6})
        for (const double gamma : {0.01, 0.1, 0.6, 1.0}) {
            add("t38_medium_rock", stiffness, gamma, 0, 0);
            add("t38_string", stiffness, gamma, 0, 0);
        }
    for (const double gap : {0.4e-3, 1.1e-3, 2.2e-3}) {
        add("t38_medium_rock", 140e6, 0.8, gap, 0);
        add("r32_hard_rock", 300e6, 0.3, gap, 0);
    }
    add("t38_medium_rock", 105e6, 0.1, 0, 90);
    add("t38_medium_rock", 105e6, 0.1, 0, -90);
    add("t38_string", 105e6, 0.1, 0, -45);
}

namespace {

Scenario sceneOf(const QByteArray& example, double stiffness, double gamma, double gap, double inclination) {
    Scenario scenario = scenarioOf(example.constData());
    scenario.bitRock.stiffness = stiffness;
    scenario.bitRock.gamma = gamma;
    scenario.bitRock.gap = gap;
    if (inclination != 0) {
        scenario.drill.inclination = inclination;
        scenario.drill.machineMass = 120;
    }
    return scenario;
}

constexpr double shares[] = {0, 0.6, 0.71, 0.9, 0.9999999, 1, 1.0000001, 1.1, 1.3, 1.5, 1.8, 2.4, 4};

}  // namespace

void TestFeedWords::noSentenceContradictsTheNumbers_data() {
    addScenes();
}

void TestFeedWords::noSentenceContradictsTheNumbers() {
    QFETCH(QByteArray, example);
    QFETCH(double, stiffness);
    QFETCH(double, gamma);
    QFETCH(double, gap);
    QFETCH(double, inclination);
    const Scenario base = sceneOf(example, stiffness, gamma, gap, inclination);
    const StudiedBlow blow(base);
    QCOMPARE(blow.study().reason.text(), std::string());
    const double need = blow.study().need(ThrustCase::scenario).thrust;
    const double weight = weightAlongHole(base).value_or(0);
    for (const double share : shares) {
        const ThrustReport report = blow.at(std::max(share * need - weight, 0.0), *base.drill.blowFrequency);
        const ThrustStudy& study = report.study;
        const QStringList sentences = sentencesOf(report);
        const QString all = sentences.join(QLatin1Char(' '));
        const ThrustNeed& own = study.need(ThrustCase::scenario);
        bool allMet = true;
        for (const ThrustNeed& each : study.needs)
            if (each.known) allMet &= *each.margin >= 0;
        const QString& first = sentences.front();
        QCOMPARE(first.contains(" is not enough"), *own.margin < 0);
        QCOMPARE(first.contains(" is enough for this blow up to"), *own.margin >= 0 && !allMet);
        QCOMPARE(first.contains(" is enough at every gap") || first.contains("and on rigid rock up to"),
                 allMet);
        if (allMet && study.shareFull) QCOMPARE(*study.shareFull, 1.0);
        // What is said of the bit is what the column of gaps has.
        const GapAtBlow& found = *own.gapAtBlow;
        const bool hangs = found.motion.kind == UndampedMotion::Kind::bouncing && found.motion.stable;
        QCOMPARE(all.contains("off the rock when the hammer strikes"), hangs);
        QCOMPARE(all.contains("rests on the rock before every blow"), own.feed == Feed::resting);
        QCOMPARE(own.feed == Feed::resting, found.motion.kind == UndampedMotion::Kind::resting);
        QCOMPARE(all.contains("without ever becoming steady"),
                 found.motion.kind == UndampedMotion::Kind::bouncing && !found.motion.stable);
        QCOMPARE(all.contains("even if nothing damps"), own.feed == Feed::resting);
        QCOMPARE(all.contains("Penetration is lost"), own.feed == Feed::penetrationLost);
        QCOMPARE(all.contains("push the machine back"), own.feed == Feed::pushedBack);
        for (const ThrustNeed& each : study.needs) {
            if (!each.known) continue;
            const std::string_view word = feedWord(each.feed);
            QCOMPARE(word.starts_with("enough"), *each.margin >= 0);
            QCOMPARE(word == "enough, bit stays on rock",
                     each.gapAtBlow->motion.kind == UndampedMotion::Kind::resting);
        }
        // Formulas are for the manual.
        for (const char* symbol : {"I0", "(1+", "d0", "f I"})
            QVERIFY2(!all.contains(symbol), qPrintable(all));
    }
}

void TestFeedWords::whatIsAdvisedIsEnough_data() {
    addScenes();
}

// What is said to be enough is, as it is written; and less would not be by more than the last digit.
void TestFeedWords::whatIsAdvisedIsEnough() {
    QFETCH(QByteArray, example);
    QFETCH(double, stiffness);
    QFETCH(double, gamma);
    QFETCH(double, gap);
    QFETCH(double, inclination);
    const Scenario base = sceneOf(example, stiffness, gamma, gap, inclination);
    const StudiedBlow blow(base);
    QCOMPARE(blow.study().reason.text(), std::string());
    const double weight = weightAlongHole(base).value_or(0);
    const double frequency = *base.drill.blowFrequency;
    constexpr double noise = 1e-12;  // that a round number may be off
    for (const double share : shares) {
        const double installed =
            std::max(share * blow.study().need(ThrustCase::scenario).thrust - weight, 0.0);
        const FeedDecision decision = blow.decisionAt(installed, frequency);
        const QString text = QString::fromStdString(feedDecisionText(decision));
        const auto withThrust = [&](double thrust) { return blow.decisionAt(thrust, frequency); };
        const auto withFrequency = [&](double other) { return blow.decisionAt(installed, other); };
        const bool isWide = decision.kind == FeedDecision::Kind::enoughThisBlow;
        const auto isServed = [&](const FeedDecision& other) {
            return isWide ? other.kind == FeedDecision::Kind::enough : isEnoughForBlow(other);
        };
        if (const auto thrust = behind("at least", text, Quantity::force)) {
            QVERIFY2(*thrust > installed, qPrintable(text));
            QVERIFY2(isServed(withThrust(*thrust * (1 + noise))), qPrintable(text));
            QVERIFY2(!isServed(withThrust(0.989 * *thrust)) || *thrust < 0.1 * decision.need,
                     qPrintable(text));
        }
        if (const auto lower = behind("or at most", text, Quantity::frequency)) {
            QVERIFY2(*lower < frequency, qPrintable(text));
            QVERIFY2(isServed(withFrequency(*lower * (1 - noise))), qPrintable(text));
        }
        if (const auto limit = behind("up to", text, Quantity::frequency)) {
            QVERIFY2(*limit >= frequency, qPrintable(text));
            const FeedDecision at = withFrequency(*limit * (1 - noise));
            QVERIFY2(
                decision.kind == FeedDecision::Kind::enough ? at.kind == decision.kind : isEnoughForBlow(at),
                qPrintable(text));
            QVERIFY2(withFrequency(1.011 * *limit).kind != decision.kind, qPrintable(text));
        }
    }
}

void TestFeedWords::aHairBelowIsToldInMoreDigits() {
    const auto decision = [](double thrust) {
        return FeedDecision{.kind = FeedDecision::Kind::notEnough,
                            .force = FeedForce{thrust, {}},
                            .frequency = 60,
                            .need = 8000.9};
    };
    QCOMPARE(feedDecisionText(decision(8000)),
             std::string("8 kN is not enough: at least 8.0009 kN at 60 Hz, or at most 59.993 Hz."));
    QCOMPARE(feedDecisionText(decision(8000.8)),
             std::string("8.0008 kN is not enough: at least 8.0009 kN at 60 Hz, or at most 59.9992 Hz."));
    FeedDecision just = decision(8000.9);
    just.kind = FeedDecision::Kind::enoughThisBlow;
    QCOMPARE(feedDecisionText(just),
             std::string("8.0009 kN is enough for this blow up to 60 Hz; other gaps were not looked at."));
}

// Straight up half a ton is to be carried besides; straight down it does what the feed need not.
void TestFeedWords::theWeightAlongTheHoleIsNoThrustToInstall() {
    FeedDecision decision{.kind = FeedDecision::Kind::notEnough,
                          .force = FeedForce{6000, -1000},
                          .weight = -1000,
                          .frequency = 50,
                          .need = 8000};
    QCOMPARE(feedDecisionText(decision),
             std::string("6 kN (5 kN with the weight along the hole) is not enough: "
                         "at least 9 kN at 50 Hz, or at most 31.2 Hz."));
    decision = {.kind = FeedDecision::Kind::noThrust, .weight = 9000, .frequency = 50, .need = 8000};
    QCOMPARE(
        feedDecisionText(decision),
        std::string("No thrust is given: the weight along the hole alone is enough for this blow at 50 Hz."));
}

void TestFeedWords::numbersAreThoseOfTheReader() {
    Scenario scenario = scenarioOf("t38_medium_rock");
    const OtherReader reader;
    QCOMPARE(feedDecisionText(decisionOf(scenario), reader),
             std::string("1,798 kip is enough at every gap up to 66,1 Hz."));
    scenario.drill.thrust = 5000;
    QCOMPARE(
        feedDecisionText(decisionOf(scenario), reader),
        std::string("1,124 kip is enough for this blow up to 68,5 Hz, but not at the worst gap on elastic "
                    "rock: that takes at least 1,64 kip at 60 Hz, or at most 41,3 Hz."));
    for (const Message& sentence : verdictSentences(reportOf(scenario).judged(), reader))
        QVERIFY2(!QString::fromStdString(sentence.text()).contains(QRegularExpression("[0-9]\\.[0-9]")),
                 sentence.text().c_str());
}

void TestFeedWords::noLineEndsBetweenANumberAndItsUnit() {
    for (int blanks = 80; blanks < 100; ++blanks)
        for (const QString& line :
             QString::fromStdString(paragraph(std::string(blanks, 'x') + " at 7.26 kN now"))
                 .split(QLatin1Char('\n')))
            QVERIFY2(!line.endsWith(QLatin1String("7.26")), qPrintable(line));
}

QTEST_GUILESS_MAIN(TestFeedWords)
#include "tst_feed_words.moc"

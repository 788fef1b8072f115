// SPDX-License-Identifier: GPL-3.0-or-later
// The required feed in words: each sentence is that of the state beside it, and of its numbers.
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

#include "core/blow/blow.h"
#include "core/blow/feed_estimate.h"
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
    return {.scenario = scenario, .study = studyThrust(scenario)};
}

QStringList sentencesOf(const ThrustReport& report, const ReadingStyle& style = plainStyle()) {
    QStringList sentences;
    for (const Message& sentence :
         thrustSentences(report.scenario, report.study.feed, report.study.shareFull, style))
        sentences << QString::fromStdString(style.said(sentence));
    return sentences;
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
        study.feed = *feedEstimate(scenario, study.need(ThrustCase::scenario).cor, study.transferred,
                                   m_rock ? study.rebounds->known() : std::nullopt);
        if (m_rock)
            study.shareFull = 1 - shareAbove(*m_rock, *study.feed.effective() / study.feed.balance - 1).value;
        return report;
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
    void eachStateHasItsSentence_data();
    void eachStateHasItsSentence();
    void whatIsMissingIsSaid_data();
    void whatIsMissingIsSaid();
    void noSentenceContradictsTheNumbers_data();
    void noSentenceContradictsTheNumbers();
    void theRemedyCoversTheBlow_data();
    void theRemedyCoversTheBlow();
    void aHairBelowIsPrintedWithMoreDigits();
    void theWeightAlongTheHoleIsNoThrustToInstall();
    void numbersAreThoseOfTheReader();
    void noLineEndsBetweenANumberAndItsUnit();

  private:
    static void addScenes();
};

void TestFeedWords::eachStateHasItsSentence_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::addColumn<double>("thrust");
    QTest::addColumn<double>("frequency");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("more");
    const auto row = [](const char* name, const char* example, double thrust, const char* text,
                        const char* more, double frequency = 60) {
        QTest::newRow(name) << QByteArray(example) << thrust << frequency << QString(text) << QString(more);
    };
    row("pushed back", "t38_medium_rock", 2e3,
        "The feed force of 2 kN is less than the mean force of the blows, 3.06 kN: the machine is pushed "
        "back.",
        "Raise the feed force by 2.38 kN to have enough for this blow, by 5.26 kN for every gap between bit "
        "and rock.");
    row("below required", "t38_medium_rock", 3.5e3,
        "A feed force of 3.5 kN is below the 4.375 kN that this blow requires: penetration will probably be "
        "lost.",
        "Raise the feed force by 875 N to have enough for this blow, by 3.76 kN for every gap between bit "
        "and rock.");
    row("required at this gap", "t38_medium_rock", 6e3,
        "A feed force of 6 kN is enough for this blow (4.375 kN required), but not for every gap between bit "
        "and rock "
        "(up to 7.253 kN required).",
        "Raise the feed force by 1.26 kN to have enough for every gap between bit and rock.");
    row("required met", "t38_medium_rock", 8e3,
        "A feed force of 8 kN is enough for a single blow at any gap (7.253 kN required).",
        "A feed force of at least 11.5 kN would even return an undamped rod to the rock before each next "
        "blow.");
    row("return met", "t38_medium_rock", 12e3,
        "A feed force of 12 kN is enough for a single blow at any gap. It even returns an undamped rod to "
        "the "
        "rock before the next blow (this requires 11.45 kN).",
        "No larger feed force is required.");
    row("a string, at this gap", "t38_string", 8e3,
        "A feed force of 8 kN is enough for this blow (4.509 kN required), but not for rigid rock (9.017 kN "
        "required). Other gaps between bit and rock were not examined.",
        "Raise the feed force by 1.02 kN to have enough for rigid rock.");
    row("a string, required met", "t38_string", 10e3,
        "A feed force of 10 kN is enough for this blow and for rigid rock (9.017 kN required); other gaps "
        "between bit "
        "and rock were not examined.",
        "A feed force of at least 13.6 kN would even return an undamped rod to the rock before each next "
        "blow.");
    row("a string, return met", "t38_string", 14e3,
        "A feed force of 14 kN is enough for this blow and for rigid rock. It even returns an undamped rod "
        "to the rock before the next blow (this requires 13.53 kN). Other gaps between bit and rock were not "
        "examined.",
        "No larger feed force is required.");
    row("waves on their way", "t38_string", 14e3,
        "The single-blow estimate does not apply: the waves of a blow are still in the string at the next "
        "blow.",
        "", 250);
}

void TestFeedWords::eachStateHasItsSentence() {
    QFETCH(QByteArray, example);
    QFETCH(double, thrust);
    QFETCH(double, frequency);
    QFETCH(QString, text);
    QFETCH(QString, more);
    Scenario scenario = scenarioOf(example.constData());
    scenario.drill.thrust = thrust;
    scenario.drill.blowFrequency = frequency;
    QStringList sentences = sentencesOf(reportOf(scenario));
    QCOMPARE(sentences.takeFirst(), text);
    if (!more.isEmpty()) QCOMPARE(sentences.takeFirst(), more);
    QCOMPARE(
        sentences.front(),
        QString("The required feed force is estimated from single blows; `drill` solves consecutive blows."));
}

void TestFeedWords::whatIsMissingIsSaid_data() {
    QTest::addColumn<QByteArray>("example");
    QTest::addColumn<bool>("frequency");
    QTest::addColumn<bool>("thrust");
    QTest::addColumn<QString>("text");
    QTest::newRow("units") << QByteArray("paper_fig4a") << false << false
                           << "The feed cannot be judged: the scenario has only dimensionless groups. Enter "
                              "the scenario in physical units.";
    QTest::newRow("units of the reference case")
        << QByteArray("reference_case") << false << false
        << "The feed cannot be judged: the scenario has only dimensionless groups. Enter the scenario in "
           "physical units.";
    QTest::newRow("frequency") << QByteArray("t38_medium_rock") << false << true
                               << "The feed cannot be judged: give a blow frequency.";
    QTest::newRow("both") << QByteArray("t38_medium_rock") << false << false
                          << "The feed cannot be judged: give a blow frequency and a feed force.";
    QTest::newRow("thrust") << QByteArray("t38_medium_rock") << true << false
                            << "No feed force is given. At a blow frequency of 60 Hz, this blow requires at "
                               "least 4.38 kN, and rigid rock at least 6.12 kN.";
    QTest::newRow("thrust of a string") << QByteArray("t38_string") << true << false
                                        << "No feed force is given. At a blow frequency of 60 Hz, this blow "
                                           "requires at least 4.51 kN, and rigid rock at least 9.02 kN.";
}

// Estimates of the blow itself, as `run` prints them.
void TestFeedWords::whatIsMissingIsSaid() {
    QFETCH(QByteArray, example);
    QFETCH(bool, frequency);
    QFETCH(bool, thrust);
    QFETCH(QString, text);
    Scenario scenario = scenarioOf(example.constData());
    if (!frequency) scenario.drill.blowFrequency.reset();
    if (!thrust) scenario.drill.thrust.reset();
    const Blow blow = solveBlow(scenario, {}, Detail::ledger);
    QCOMPARE(QString::fromStdString(requiredFeedMessage(scenario, blow.feed).text()), text);
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
        const FeedEstimate& feed = report.study.feed;
        const QStringList sentences = sentencesOf(report);
        const QString all = sentences.join(QLatin1Char(' '));
        const QString& first = sentences.front();
        if (feed.roundTrips < 1) {
            QVERIFY(first.contains("does not apply"));
            continue;
        }
        const double installed = *feed.effective() * (1 + 1e-12),
                     own = feed.need(ThrustCase::scenario).thrust;
        double required = 0, inTime = 0;
        for (const ThrustNeed& each : feed.needs)
            if (each.known) {
                required = std::max(required, each.thrust);
                inTime = std::max(inTime, each.thrustUndamped);
            }
        QCOMPARE(first.contains("pushed back"), installed < feed.balance);
        QCOMPARE(first.contains("will probably be lost"), installed >= feed.balance && installed < own);
        QCOMPARE(first.contains("is enough for this blow (") && first.contains("but not "),
                 installed >= own && installed < required);
        QCOMPARE(first.contains("is enough for a single blow at any gap") ||
                     first.contains("this blow and for rigid rock"),
                 installed >= required);
        QCOMPARE(first.contains("even returns an undamped rod"), installed >= inTime);
        QCOMPARE(first.contains("gaps between bit and rock were not examined"),
                 !feed.isOfAllGaps() && installed >= own);
        if (installed >= required && report.study.shareFull) QCOMPARE(*report.study.shareFull, 1.0);
        // An estimate says nothing of what the bit does.
        for (const char* word : {"rests", "bounces", "full rate", "off the rock"})
            QVERIFY2(!all.contains(word), qPrintable(all));
        // Formulas are for the manual.
        for (const char* symbol : {"I0", "(1+", "d0", "f I"})
            QVERIFY2(!all.contains(symbol), qPrintable(all));
    }
}

void TestFeedWords::theRemedyCoversTheBlow_data() {
    addScenes();
}

// The remedy as printed covers the blow; less would not by more than the last digit.
void TestFeedWords::theRemedyCoversTheBlow() {
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
        const FeedEstimate feed = blow.at(installed, frequency).study.feed;
        if (!feed.isTooLittle()) continue;
        const QString text = QString::fromStdString(feedRemedy(feed).text());
        const auto isCovered = [&](double thrust, double other) {
            return !blow.at(thrust, other).study.feed.isTooLittle();
        };
        const std::optional<double> thrust = behind("at least", text, Quantity::force);
        QVERIFY2(thrust && *thrust > installed, qPrintable(text));
        QVERIFY2(isCovered(*thrust * (1 + noise), frequency), qPrintable(text));
        QVERIFY2(!isCovered(0.989 * *thrust, frequency) || *thrust < 0.1 * feed.balance, qPrintable(text));
        if (const auto lower = behind("blow frequency at most", text, Quantity::frequency)) {
            QVERIFY2(*lower < frequency, qPrintable(text));
            QVERIFY2(isCovered(installed, *lower * (1 - noise)), qPrintable(text));
        }
    }
}

namespace {

/// An estimate with one requirement for all cases.
FeedEstimate estimateOf(const std::optional<FeedForce>& force, double required) {
    FeedEstimate feed;
    feed.force = force;
    feed.weight = force ? force->weight.value_or(0) : 9000;
    feed.frequency = 50;
    feed.balance = 1000;
    feed.roundTrips = 10;
    for (ThrustNeed& need : feed.needs) need.thrust = need.thrustUndamped = required;
    return feed;
}

std::string sentenceOf(const FeedEstimate& feed) {
    return requiredFeedMessage({}, feed).text();
}

}  // namespace

void TestFeedWords::aHairBelowIsPrintedWithMoreDigits() {
    QCOMPARE(sentenceOf(estimateOf(FeedForce{8000, {}}, 8000.9)),
             std::string("A feed force of 8 kN is below the 8.0009 kN that this blow requires: penetration "
                         "will probably be lost."));
    QCOMPARE(sentenceOf(estimateOf(FeedForce{8000.8, {}}, 8000.9)),
             std::string("A feed force of 8.0008 kN is below the 8.0009 kN that this blow requires: "
                         "penetration will probably be lost."));
    QCOMPARE(feedRemedy(estimateOf(FeedForce{8000.8, {}}, 8000.9)).text(),
             std::string("For this blow, the feed force must be at least 8.0009 kN at 50 Hz, or the "
                         "blow frequency at most 49.9993 Hz with the present feed force."));
}

// Straight up half a ton is to be carried besides; straight down it does what the feed need not.
void TestFeedWords::theWeightAlongTheHoleIsNoThrustToInstall() {
    const FeedEstimate up = estimateOf(FeedForce{6000, -1000}, 8000);
    QCOMPARE(sentenceOf(up),
             std::string("A feed force of 6 kN (5 kN with the weight along the hole) is below the 8 kN that "
                         "this blow requires: penetration will probably be lost."));
    QCOMPARE(feedRemedy(up).text(),
             std::string("For this blow, the feed force must be at least 9 kN at 50 Hz, or the blow "
                         "frequency at most 31.2 Hz with the present feed force."));
    QCOMPARE(sentenceOf(estimateOf({}, 8000)),
             std::string("No feed force is given. At a blow frequency of 50 Hz, the weight of machine and "
                         "rod along the hole is already enough for this blow and for rigid rock."));
}

void TestFeedWords::numbersAreThoseOfTheReader() {
    Scenario scenario = scenarioOf("t38_medium_rock");
    const OtherReader reader;
    QCOMPARE(
        sentencesOf(reportOf(scenario), reader).front(),
        QString("A feed force of 1,798 kip is enough for a single blow at any gap (1,631 kip required)."));
    scenario.drill.thrust = 5000;
    QCOMPARE(
        sentencesOf(reportOf(scenario), reader).front(),
        QString(
            "A feed force of 1,124 kip is enough for this blow (0,9835 kip required), but not for every gap "
            "between bit and rock (up to 1,631 kip required)."));
    for (const QString& sentence : sentencesOf(reportOf(scenario), reader))
        QVERIFY2(!sentence.contains(QRegularExpression("[0-9]\\.[0-9]")), qPrintable(sentence));
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
